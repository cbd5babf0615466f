// POV-Ray's options and its own animation loop: reference manual, section 3.2.
#include <fmt/format.h>

#include <algorithm>

#include "scene/povray.hpp"
#include "scene/povray_quality.hpp"

namespace mien {

namespace {

std::string quote_ini(const std::filesystem::path& path) {
  return fmt::format("\"{}\"", path.generic_string());
}

}  // namespace

// Measured at 480 x 600 on one core, reading the scene included: 1.4, 3.8 and 10.3 seconds a frame.
PovrayQuality find_povray_quality(Quality quality) {
  switch (quality) {
    case Quality::sketch:  // which is not POV-Ray's; its text is read, and these numbers are not
    case Quality::draft:
      return {1, 0, "0.2", 2};
    case Quality::good:
      return {5, 0, "0.12", 3};
    case Quality::best:
      break;
  }
  return {9, 0, "0.06", 4};
}

std::string build_povray_loop() {
  return "#version 3.7;  // the scene of the frame that is being rendered\n"
         "#include concat(\"f\", str(frame_number, -4, 0), \".pov\")\n";
}

std::string build_povray_ini(const RenderSpec& render, const std::string& name, int frame_count,
                             const std::filesystem::path& clip_folder, std::pair<int, int> range) {
  // POV-Ray glues the frame's number to the stem with as many digits as the last frame has; zeros fill up to
  // four.
  const std::size_t digits = std::to_string(frame_count).size();
  const std::string zeros(digits < 4 ? 4 - digits : 0, '0');
  std::string text = fmt::format("; From the folder that holds {0}: povray {0}\n",
                                 (clip_folder / "scenes" / (name + ".ini")).generic_string());
  text += fmt::format("Input_File_Name={}\nLibrary_Path={}\nOutput_File_Name={}\n", quote_ini("loop.pov"),
                      quote_ini(clip_folder / "scenes"),
                      quote_ini(clip_folder / fmt::format("frames/f{}.png", zeros)));
  // A clip that ends with its first frame is none to POV-Ray: the picture would have no number.
  const int last_frame = std::max(frame_count, 2);
  text += fmt::format("Initial_Frame=1\nFinal_Frame={}\nWidth={}\nHeight={}\n", last_frame, render.width_px,
                      render.height_px);
  // The first and last frame stay the clip's, since they decide on the number of digits.
  if (range != std::pair(1, last_frame))
    text += fmt::format("Subset_Start_Frame={}\nSubset_End_Frame={}\n", range.first, range.second);
  text += "Output_File_Type=N8\nDisplay=off\nPause_When_Done=off\n";
  for (const std::string& option : list_quality_options(render)) text += fmt::format("{}\n", option);
  return text;
}

std::vector<std::string> list_quality_options(const RenderSpec& render) {
  const PovrayQuality settings = find_povray_quality(render.quality);
  std::vector<std::string> options{
      "+AM1", fmt::format("+A{}", settings.threshold), fmt::format("+R{}", settings.depth), "-J",
      "+AG1",  // differences are of light, not of what the eye makes of it: else every dark hair asks for all
               // rays
      "+THB4"};  // ordered dithering: a dark background shows no bands and does not swarm
  if (has_alpha(render)) options.emplace_back("+UA");
  return options;
}

}  // namespace mien

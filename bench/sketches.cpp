#include "sketches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "children.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "render/picture.hpp"
#include "render/process.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

struct Cost {
  double core_s = 0, wall_s = 0;
};

Cost run_program(const fs::path& folder, const std::vector<std::string>& words) {
  const double before_s = read_children_s();
  const ProcessResult result = run_process(words, folder);
  if (result.exit_code != 0)
    throw RunError(format_failure(words.front() + " failed", quote_command(words), result.output));
  return {read_children_s() - before_s, result.wall_s};
}

double measure_difference(const Pixels& a, const Pixels& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(int{a.rgb[i]} - int{b.rgb[i]});
  return sum / static_cast<double>(a.rgb.size());
}

}  // namespace

void measure_sketches(
    const fs::path& data, const fs::path& folder, const std::string& program,
    const std::function<void(const std::string&, const std::string&, const std::string&)>& print_row) {
  const std::string hello = (data / "configs/hello.yaml").string();
  // 4 s on twos: all drawings but one cost their tracing, reading and encoding; what begins a run is in both.
  constexpr int kDrawings = 48;
  const auto sketch = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{program, "render", hello, "--quality", "sketch", "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(folder, words);
  };
  double frame_s = 1e9, clip_s = 1e9, draft_s = 1e9;
  for (int round = 0; round < 2; ++round) {  // turn about: the better of two is less of the machine's mood
    const Cost all = sketch({"--jobs", "1"}), one = sketch({"--jobs", "1", "--frames", "1-2"});
    frame_s = std::min(frame_s, (all.core_s - one.core_s) / (kDrawings - 1));
    clip_s = std::min(clip_s, sketch({}).wall_s);
    run_program(folder, {program, "frames", hello, "--quality", "draft", "--frames", "25-25", "--quiet"});
    draft_s = std::min(draft_s, run_program(folder / "out/hello/scenes",
                                            {"povray", "+If0025.pov", "+Odraft.png", "+W480", "+H600", "-D",
                                             "+WT1", "-GA", "+AM1", "+A0.2", "+R2", "-J", "+AG1", "+THB4"})
                                    .core_s);
  }
  print_row("a sketch", fmt::format("{:.2f} s", frame_s),
            "a drawing of hello.yaml at 480x600, of one core, encoding included (target 0.3)");
  print_row("POV-Ray's draft of it", fmt::format("{:.2f} s", draft_s),
            fmt::format("{:.1f} times a sketch (target 10)", draft_s / frame_s));
  print_row("hello.yaml, sketched", fmt::format("{:.1f} s", clip_s),
            "mien render, from the file to the clip (target 10)");
  double worst = 0;
  for (const char* face : {"smile", "surprise", "anger"}) {
    for (const char* quality : {"sketch", "good"})
      run_program(folder, {program, "still", hello, "--express", face, "--angle", "25", "--quality", quality,
                           "-o", std::string(quality) + ".png", "--quiet"});
    worst = std::max(
        worst, measure_difference(read_pixels(folder / "sketch.png"), read_pixels(folder / "good.png")));
  }
  print_row("from the good picture", fmt::format("{:.2f}", worst),
            "mean difference a channel, of 255 (target 6)");
  fs::remove_all(folder / "out");
}

}  // namespace mien

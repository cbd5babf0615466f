#include "bust/write_bust.hpp"

#include "clip/pictures.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "render/driver.hpp"
#include "render/failure.hpp"
#include "render/process.hpp"
#include "render/work_folder.hpp"
#include "scene/mesh_files.hpp"
#include "scene/openscad.hpp"
#include "scene/openscad_check.hpp"
#include "scene/povray.hpp"
#include "scene/povray_bust.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kStlTriangle_bytes = 50;  // in a binary file

// The STL that OpenSCAD makes of the source, read back and compared with what we meant.
void compare_with_openscad(const MadeBust& made, const fs::path& source, const FileWritten& written) {
  const WorkFolder work(source.parent_path());
  const fs::path stl = work.path / "made.stl";
  const auto command = list_openscad_command(fs::absolute(source), stl);
  const ProcessResult result = run_process(command, work.path);
  const std::string complaint = find_openscad_complaint(result.output);
  const fs::path kept = fs::path(source).replace_extension() += "_openscad.stl";
  if (result.exit_code != 0 || !complaint.empty() || !fs::exists(stl)) {
    require_space(work.path, made.mesh.triangles.size() * kStlTriangle_bytes, kept);
    const std::string what = result.exit_code != 0 ? describe_end("openscad", result)
                             : complaint.empty()   ? "openscad has written nothing"
                                                   : "openscad complains: " + complaint;
    throw RunError(
        format_failure(fmt::format("{}: {}", source.string(), what), quote_command(command), result.output));
  }
  verify_print(measure_stl(made.mesh), check_stl(stl),
               fmt::format("what OpenSCAD makes of {}", source.string()));
  std::error_code error;
  fs::rename(stl, kept, error);
  if (error) throw RunError(fmt::format("cannot write {}: {}", kept.string(), error.message()));
  written("openscad", kept);
}

void render_preview(const MadeBust& made, const fs::path& picture, const Templates& templates) {
  constexpr int kWidth_px = 640, kHeight_px = 800;
  const WorkFolder work(picture.parent_path());
  write_file(work.path / "bust.pov",
             build_plaster_scene(made.mesh, double(kWidth_px) / kHeight_px, templates));
  RenderSpec render;
  render.width_px = kWidth_px;
  render.height_px = kHeight_px;
  render_frames({{1, work.path / "bust.pov", picture, ""}}, list_settings(render, {work.path}, 1),
                {[](int, bool) {}});
}

}  // namespace

void write_bust(const MadeBust& made, const fs::path& folder, const Templates& templates,
                const Options& options, const FileWritten& written) {
  const fs::path source = folder / (made.stem + ".scad"), stl = folder / (made.stem + ".stl"),
                 report = folder / (made.stem + ".txt");
  write_file(source, build_openscad_bust(made.source, templates));
  written("source", source);
  if (options.has_stl) {
    write_file(stl, build_binary_stl(made.mesh, made.source.title));
    written("stl", stl);
  }
  write_file(report, describe_report(made.report));
  written("report", report);
  if (options.has_3mf) {
    const fs::path package = folder / (made.stem + ".3mf");
    write_file(package, build_3mf(made.source.title, {{made.stem, made.mesh, made.colours}}));
    written("3mf", package);
  }
  if (options.has_preview) {
    const fs::path picture = folder / (made.stem + ".png");
    render_preview(made, picture, templates);
    written("preview", picture);
  }
  if (options.has_openscad) compare_with_openscad(made, source, written);
}

std::vector<fs::path> list_bust_files(const std::vector<std::string>& stems, bool has_plates,
                                      const Options& options) {
  std::vector<std::string> endings{".scad", ".txt"};
  if (options.has_stl) endings.emplace_back(".stl");
  if (options.has_3mf) endings.emplace_back(".3mf");
  if (options.has_preview) endings.emplace_back(".png");
  if (options.has_openscad) endings.emplace_back("_openscad.stl");
  std::vector<fs::path> files;
  for (std::size_t i = 0; i < stems.size(); ++i) {
    for (const std::string& ending : endings) files.emplace_back(stems[i] + ending);
    if (has_plates) files.emplace_back(fmt::format("plate_{}.stl", i + 1));  // no more than busts
  }
  return files;
}

int count_bust_files(const Options& options) {
  return 2 + options.has_stl + options.has_3mf + options.has_preview + options.has_openscad;
}

void write_plates(const std::vector<Mesh>& plates, const fs::path& folder, const FileWritten& written) {
  for (std::size_t i = 0; i < plates.size(); ++i) {
    const fs::path path = folder / fmt::format("plate_{}.stl", i + 1);
    write_file(path, build_binary_stl(plates[i], fmt::format("plate {}", i + 1)));
    written("plate", path);
  }
}

}  // namespace mien

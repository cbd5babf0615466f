// `mien mesh`.
#include <fmt/format.h>

#include <algorithm>

#include "clip/moment.hpp"
#include "clip/outputs.hpp"
#include "commands/report.hpp"
#include "commands/table.hpp"
#include "core/data.hpp"
#include "core/text.hpp"
#include "head/landmarks.hpp"
#include "head/own_half.hpp"
#include "render/work_folder.hpp"
#include "scene/mesh_files.hpp"
#include "scene/wavefront.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

// The mesh, and the landmarks where they are asked for.
std::vector<OutputFile> list_outputs(const Options& options, const Spec& spec) {
  std::vector<OutputFile> files{find_output_file(options, fs::path("out") / spec.name / "mesh.obj")};
  check_ending(files[0], "mesh", options.is_half ? Names{".obj"} : list_mesh_endings());
  if (options.landmarks) {
    files.push_back({"--landmarks", *options.landmarks});
    check_ending(files[1], "landmarks", {".json"});
  }
  check_output_files(files, spec);
  return files;
}

// The neutral head's left half as people edit it, for `head: {mesh: FILE}`.
std::string build_half_text(const HeadStock& stock, const HeadSpec& head) {
  std::string text;
  append_wavefront(
      text, compute_half_places(stock, build_form(stock, head).points), compute_half_quads(stock), "half",
      {"The left half of a head (x >= 0): millimetres; x to the character's left, y up, z forward.",
       "Move its points, keep their order and the faces, and name the file: head: {mesh: my_half.obj}"});
  return text;
}

void run_mesh(const Options& options) {
  const Resources resources = load_resources(find_data_folder());
  const Clip clip = open_clip(options, *resources.stock.language);
  const Spec& spec = clip.spec;
  const Actor& actor = find_actor(clip, options);
  const HeadSpec head = find_asked_head(clip, actor, options);
  const std::vector<OutputFile> outputs = list_outputs(options, spec);
  for (const OutputFile& output : outputs) remove_left_parts_of(output.path);
  const fs::path& path = outputs[0].path;
  if (options.is_half) {
    const std::string half = build_half_text(resources.heads, head);
    report_starts(options, {head}, resources.heads);
    write_file(path, half);
    return report_result(options, "half", path);
  }
  const Figure figure = build_figure(resources.heads, head);
  std::vector<Held> held;
  const Drawing drawing = draw_moment(figure, compute_moment(options, clip, actor, figure, held));
  report_starts(options, {head}, resources.heads);
  report_held(options, std::move(held));
  write_file(path, build_mesh_file(find_ending(path), figure.model, drawing,
                                   spec.title.empty() ? spec.name : spec.title));
  report_result(options, "mesh", path);
  if (!options.landmarks) return;
  write_file(*options.landmarks, build_landmarks_json(measure_landmarks(
                                     figure.head, find_landmarks(figure.head), figure.model, drawing)));
  report_result(options, "landmarks", *options.landmarks);
}

}  // namespace

const CommandInfo command_mesh{
    "mesh",
    "Shapes",
    "FILE",
    "one head as OBJ, PLY or STL, its landmarks as JSON",
    "Writes one head in millimetres, right-handed (x to the character's left, y up, z forward), in the\n"
    "format that the name after -o ends in: .obj (one group a part), .ply (with colours and each face's\n"
    "part) or .stl.",
    "at express actor landmarks half",
    "mien mesh configs/hello.yaml --express smile -o face.obj --landmarks face.json\n"
    "mien mesh configs/hello.yaml --half -o my_half.obj",
    run_mesh};

}  // namespace mien

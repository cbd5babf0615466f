// `mien export`.
#include <fmt/format.h>

#include <algorithm>

#include "clip/outputs.hpp"
#include "clip/view.hpp"
#include "commands/report.hpp"
#include "commands/table.hpp"
#include "core/data.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "exchange/exports.hpp"
#include "exchange/skin_paint.hpp"
#include "exchange/target_sets.hpp"
#include "frames/figure_atlas.hpp"
#include "render/work_folder.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

std::pair<int, int> find_frames(const Options& options, const Clip& clip) {
  if (!options.frames) return {1, clip.frame_count};
  return {options.frames->first, std::min(options.frames->second, clip.frame_count)};
}

bool is_layout_alone(const Options& options) { return options.uv && !options.output; }

// The files that -o stands for: one, one a frame, or two.
void add_export_files(const Options& options, const Clip& clip, const OutputFile& output,
                      std::vector<OutputFile>& files) {
  check_ending(output, "export", list_export_endings());
  const std::string ending = find_ending(output.path);
  check_export_options(ending, options);
  if (is_sequence(ending)) {
    const auto [first, last] = find_frames(options, clip);
    for (int frame = first; frame <= last; ++frame)
      files.push_back({output.option, name_frame_file(output.path, frame)});
    return;
  }
  files.push_back(output);
  if (const fs::path companion = find_companion(output.path); !companion.empty())
    files.push_back({"-o", companion});
}

// All files of it, judged before anything is computed.
fs::path take_output(const Options& options, const Clip& clip) {
  const OutputFile output =
      find_output_file(options, fs::path("out") / clip.spec.name / (clip.spec.name + ".glb"));
  std::vector<OutputFile> files;
  if (options.uv) {
    files.push_back({"--uv", *options.uv});
    check_ending(files.back(), "picture", {".png"});
  }
  if (!is_layout_alone(options)) add_export_files(options, clip, output, files);
  check_output_files(files, clip.spec);
  for (const OutputFile& file : files) remove_left_parts_of(file.path);
  return output.path;
}

void run_export(const Options& options) {
  const Resources resources = load_resources(find_data_folder());
  const Clip clip = plan_clip(options, *resources.stock.language);
  const Actor& actor = find_actor(clip, options);
  if (!actor.performance.clip.head.empty())
    throw InputError(
        fmt::format("{}: the head changes in time, and one that is exported stays as it is; expected a "
                    "clip without keys of 'head'",
                    clip.spec.file.string()));
  build_target_set(options.targets, clip.spec);  // a mistake is told before anything is built
  const fs::path path = take_output(options, clip);
  const Figure figure = build_figure(resources.heads, actor.head);
  const auto [first, last] = find_frames(options, clip);
  ExportWork work{options,           clip,  actor.head, figure, resources.stock.templates,
                  actor.performance, first, last};
  work.performance.idle.eyes = compute_eyes(figure, clip.spec.render);
  report_starts(options, {actor.head}, resources.heads);
  if (options.uv) {
    write_file(*options.uv, build_png(draw_layout(figure.model.parts.front(), build_figure_atlas(figure),
                                                  kLayoutSize_px)));
    report_result(options, "layout", *options.uv);
  }
  if (is_layout_alone(options)) return;
  const ExportNotes notes = write_export(work, path);
  report_result(options, "export", path);
  if (options.is_quiet) return;
  for (const std::string& note : notes) {
    if (options.is_json)
      fmt::print("{}\n", format_object(nlohmann::ordered_json{{"kind", "note"}, {"message", note}}));
    else
      fmt::print("        {}\n", note);
  }
}

}  // namespace

const CommandInfo command_export{
    "export",
    "Shapes",
    "FILE",
    "the face and what it plays, for other programs",
    "Writes the face and its clip in the format that the name after -o ends in: .glb or .gltf (a rig with\n"
    "a target for each move, joints, and the clip as its animation; how far it is from mien's own face is\n"
    "told), .vrm (for avatars), .usda (as .glb), .py (a script\n"
    "for Blender and its .glb), .obj, .ply or .stl (a mesh a frame: face_%04d.obj), .pc2 or .mdd (a cache of "
    "points for the mesh\n"
    "of 'mien mesh'), .csv (the moves by frame, as 'tracks' takes\n"
    "them; with --targets arkit as Live Link Face writes it), or .json (MPFB's expression, of one frame).",
    "actor targets exact uv",
    "mien export configs/hello.yaml -o hello.glb\n"
    "mien export configs/hello.yaml -o 'face_%04d.obj' --frames 1-24",
    run_export};

}  // namespace mien

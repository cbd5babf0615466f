// `mien still`.
#include <fmt/format.h>

#include "clip/outputs.hpp"
#include "clip/pictures.hpp"
#include "clip/scenes.hpp"
#include "clip/sketches.hpp"
#include "commands/report.hpp"
#include "commands/table.hpp"
#include "core/data.hpp"
#include "core/text.hpp"
#include "render/process.hpp"
#include "render/work_folder.hpp"
#include "sheet/wire_sheet.hpp"

namespace mien {

namespace {

// The moment that is asked for, and who is in it: with --actor or --express one alone, in the middle. What
// limits hold back of an expression is added to `held`.
Still stage_still(const Options& options, Clip& clip, std::vector<Held>& held) {
  Still still{compute_time_s(clip, options), {}, {}, {}};
  still.camera = sample_performance(clip.performance, still.time_s).camera;
  still.stage = sample_stage(clip.spec.clip, still.time_s);
  if (options.actor || options.express) {
    Actor actor = find_actor(clip, options);
    if (options.express) {
      actor.performance.clip.head.clear();
      still.camera = {};
      still.stage = {};
    }
    actor.place = {};
    actor.performance.clip.place.clear();
    actor.performance.clip.enters_s = 0;
    actor.performance.clip.leaves_s = kForever_s;
    still.stage.aims.clear();
    clip.actors = {std::move(actor)};
  }
  if (options.camera_angle_deg) still.camera.angle_deg = *options.camera_angle_deg;
  if (options.express) {
    const Expression expression = take_expression(clip.spec, *options.express);
    still.pose = expression.pose;
    held = expression.held;
  }
  return still;
}

void report_still(const Options& options, const Clip& clip, const Resources& resources,
                  std::vector<Held> held, const std::vector<Held>& more) {
  held.insert(held.end(), more.begin(), more.end());
  report_starts(options, list_heads(clip), resources.heads);
  report_held(options, std::move(held));
}

void render_still(const Options& options, const Clip& clip, const Cast& cast, const Still& still,
                  const Resources& resources, std::vector<Held> held, const std::filesystem::path& picture) {
  const WorkFolder work(picture.has_parent_path() ? picture.parent_path() : ".");
  const StillScene scene = build_still_scene(clip, cast, still, resources);
  report_still(options, clip, resources, std::move(held), scene.held);
  write_file(work.path / "still.pov", scene.text);
  write_file(work.path / "head.inc", scene.include);
  for (const auto& over : scene.pictures) write_part_picture(*over, work.path);
  render_frames({{1, work.path / "still.pov", picture, ""}}, list_settings(clip.spec.render, {work.path}, 1),
                {[](int, bool) {}});
}

void write_sketch(const Options& options, const Clip& clip, const Cast& cast, const Still& still,
                  const Resources& resources, std::vector<Held> held, const std::filesystem::path& picture) {
  const SketchedStill sketched = sketch_still(clip, cast, still, resources);
  report_still(options, clip, resources, std::move(held), sketched.held);
  write_file(picture, build_png(sketched.picture));
}

void check_wire_options(const WireOptions& wire) {
  for (const auto& [is_given, name] :
       {std::pair(wire.has_cage, "cage"), {wire.has_guides, "guides"}, {wire.has_limits, "limits"}})
    if (is_given && !wire.is_on)
      throw InputError(fmt::format("--{} is of a line drawing; expected it with --wire", name));
}

void write_wire(const Options& options, Clip& clip, const Still& still, const Resources& resources,
                std::vector<Held> held) {
  const std::vector<std::filesystem::path> paths = list_wire_files(options, clip.spec, "still_wire");
  clip.spec.render.style = Style::studio;  // ink's flat eyes are no solids
  const Cast cast = build_cast(clip, resources.heads);
  const Heads heads = build_heads(clip, cast, still.time_s, resources.heads);
  report_still(options, clip, resources, std::move(held), list_still_held(heads, still));
  write_papers(draw_wire_still(options, clip, cast, still, resources.heads), paths,
               resources.stock.templates);
  for (const std::filesystem::path& path : paths) report_result(options, "drawing", path);
}

void run_still(const Options& options) {
  check_wire_options(options.wire);
  const Resources resources = load_resources(find_data_folder());
  Clip clip = open_clip(options, *resources.stock.language);
  std::vector<Held> held;
  const Still still = stage_still(options, clip, held);
  if (options.wire.is_on) return write_wire(options, clip, still, resources, std::move(held));
  const OutputFile output =
      find_output_file(options, std::filesystem::path("out") / clip.spec.name /
                                    (is_sketch(clip.spec.render) ? "still_sketch.png" : "still.png"));
  check_ending(output, "picture", {".png"});
  check_output_files({output}, clip.spec);
  if (!is_sketch(clip.spec.render)) require_programs({{"povray", "povray"}});
  const Cast cast = build_cast(clip, resources.heads);
  const std::filesystem::path& picture = output.path;
  remove_left_parts_of(picture);
  if (is_sketch(clip.spec.render))
    write_sketch(options, clip, cast, still, resources, std::move(held), picture);
  else
    render_still(options, clip, cast, still, resources, std::move(held), picture);
  report_result(options, "picture", picture);
}

}  // namespace

const CommandInfo command_still{
    "still",
    "Pictures",
    "FILE",
    "one picture, of a time or of an expression",
    "Renders one picture: the clip at a time, or the head with one expression. With "
    "--wire it is a\nline drawing, without hair, as .svg and as .png, or as -o ends.",
    "at express actor angle wire cage guides limits",
    "mien still configs/hello.yaml --at 1.2s -o face.png\n"
    "mien still configs/hello.yaml --express surprise --angle 30 -o face.png\n"
    "mien still configs/hello.yaml --wire --guides -o face.svg",
    run_still};

}  // namespace mien

#include "clip/scenes.hpp"

#include <fmt/format.h>

#include "clip/staging.hpp"
#include "core/error.hpp"
#include "core/pool.hpp"
#include "core/text.hpp"
#include "render/process.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

std::string build_parts(const std::vector<FigurePointer>& figures, const Templates& templates) {
  std::string parts;
  for (const FigurePointer& figure : figures)
    if (figure) parts += build_povray_parts(figure->get_drawn_model(), templates);
  return parts;
}

// What the pixels of every frame depend on besides its own scene.
std::string hash_settings(const std::string& include, const RenderSpec& render) {
  std::string text = fmt::format("{} {}x{}", MIEN_VERSION, render.width_px, render.height_px);
  for (const std::string& option : list_quality_options(render.quality)) text += " " + option;
  return hash_hex(text + "\n" + include);
}

// Everybody at a time, as `view` sees them; with `pose` doing that instead.
void append_actors(const Heads& heads, double time_s, const std::optional<Pose>& pose, const InkView& view,
                   SceneBuffers& buffers) {
  for (std::size_t i = 0; i < heads.figures.size(); ++i) {
    draw_actor(heads, i, time_s, pose, view, buffers.draw, buffers.drawing);
    append_povray_figure(buffers.text, heads.figures[i]->get_drawn_model(), buffers.drawing);
  }
}

double find_time_s(const SceneRun& run, std::size_t drawing) {
  return compute_drawing_time_s(run.clip.spec.clip, run.clip.plan.drawings[drawing] - 1);
}

DrawnHeads build_drawn_heads(const SceneRun& run, std::size_t group) {
  const std::size_t first = run.groups.first[group];
  DrawnHeads drawn{build_heads(run.clip, run.cast, find_time_s(run, first), run.resources.heads), {}, {}, {}};
  drawn.parts = build_parts(drawn.heads.changing, run.resources.stock.templates);
  if (drawn.parts.empty()) return drawn;
  drawn.include = name_heads(run.clip.plan.drawings[first]);
  drawn.key = hash_hex(drawn.parts);
  return drawn;
}

void write_held_frames(const Clip& clip) {
  for (std::size_t i = 0; i < clip.plan.frames.size(); ++i) {
    const int frame = clip.plan.frames[i], drawn_as = clip.plan.drawn_as[i];
    if (frame == drawn_as) continue;
    write_file(clip.files.scene(frame), fmt::format("// holds the drawing of frame {}\n#include \"{}.pov\"\n",
                                                    drawn_as, name_frame(drawn_as)));
  }
}

void write_shared_files(const SceneRun& run) {
  const Clip& clip = run.clip;
  std::error_code error;
  for (const fs::path& stale : find_stale_files(clip.files, clip.frame_count)) fs::remove(stale, error);
  const fs::path frames = clip.files.folder / "frames";
  fs::create_directories(frames, error);  // POV-Ray alone would not
  if (error) throw RunError(fmt::format("cannot write in {}: {}", frames.string(), error.message()));
  write_file(clip.files.scenes() / kHeadInclude, run.include);
  write_file(clip.files.scenes() / "loop.pov", build_povray_loop());
  write_file(clip.files.scenes() / (clip.files.name + ".ini"),
             build_povray_ini(clip.spec.render, clip.files.name, clip.frame_count, clip.files.folder,
                              {clip.plan.frames.front(), clip.plan.frames.back()}));
}

}  // namespace

SceneRun::SceneRun(const Clip& clip_, const Cast& cast_, const Resources& resources_, int jobs)
    : clip(clip_),
      cast(cast_),
      resources(resources_),
      include(build_povray_stage(build_parts(cast.figures, resources.stock.templates), clip.spec.render,
                                 resources.stock.templates, list_sets(clip.spec.clip))),
      key(hash_settings(include, clip.spec.render)),
      groups(group_drawings(clip)),
      heads(static_cast<std::size_t>(jobs) + 1),
      buffers(static_cast<std::size_t>(jobs)) {}

SceneText build_scene(SceneRun& run, std::size_t drawing, int worker) {
  const Clip& clip = run.clip;
  const std::size_t group = run.groups.group[drawing];
  SceneText scene;
  scene.heads =
      share_thing<DrawnHeads>(run.heads, group, [&run, group] { return build_drawn_heads(run, group); });
  const double time_s = find_time_s(run, drawing);
  FrameStart start = build_start(clip, run.cast, sample_performance(clip.performance, time_s).camera,
                                 sample_stage(clip.spec.clip, time_s));
  // What the heads' file is called is nothing that pixels depend on.
  SceneBuffers& mine = run.buffers[static_cast<std::size_t>(worker)];
  mine.text.clear();
  append_povray_start(mine.text, start);
  const std::size_t start_size = mine.text.size();
  append_actors(scene.heads->heads, time_s, {}, compute_ink_view(start.view, clip.spec.render, start.lamp),
                mine);
  scene.key = hash_hex(run.key + scene.heads->key + mine.text);
  if (!scene.heads->include.empty()) {
    start.includes = {scene.heads->include};
    append_povray_start(scene.text, start);
  }
  scene.text.append(mine.text, scene.text.empty() ? 0 : start_size);
  return scene;
}

std::vector<std::string> write_scenes(const Clip& clip, const Cast& cast, const Resources& resources,
                                      int jobs, const SceneWritten& written) {
  SceneRun run(clip, cast, resources, jobs);
  write_shared_files(run);
  std::vector<std::string> keys(clip.plan.drawings.size());
  for_each_index(keys.size(), jobs, [&](std::size_t turn, int worker) {
    throw_if_interrupted();
    const std::size_t drawing = run.groups.order[turn];
    const int frame = clip.plan.drawings[drawing];
    const SceneText scene = build_scene(run, drawing, worker);
    write_scene(scene, clip.files.scene(frame));
    keys[drawing] = scene.key;
    written(frame);
  });
  write_held_frames(clip);
  return keys;
}

void write_scene(const SceneText& scene, const fs::path& path) {
  if (!scene.heads->include.empty())
    write_file(path.parent_path() / scene.heads->include, scene.heads->parts);
  write_file(path, scene.text);
}

StillScene build_still_scene(const Clip& clip, const Cast& cast, const Still& still,
                             const Resources& resources) {
  const Templates& templates = resources.stock.templates;
  const Heads heads = build_heads(clip, cast, still.time_s, resources.heads);
  StillScene scene;
  scene.include =
      build_povray_stage(build_parts(cast.figures, templates) + build_parts(heads.changing, templates),
                         clip.spec.render, templates, list_sets(clip.spec.clip));
  SceneBuffers buffers;
  const FrameStart start = build_start(clip, cast, still.camera, still.stage);
  append_povray_start(buffers.text, start);
  append_actors(heads, still.time_s, still.pose, compute_ink_view(start.view, clip.spec.render, start.lamp),
                buffers);
  scene.text = std::move(buffers.text);
  scene.held = list_still_held(heads, still);
  return scene;
}

}  // namespace mien

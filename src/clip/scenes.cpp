#include "clip/scenes.hpp"

#include <fmt/format.h>

#include "clip/staging.hpp"
#include "core/error.hpp"
#include "core/pool.hpp"
#include "core/text.hpp"
#include "render/process.hpp"
#include "sketch/casters.hpp"
#include "sketch/stage.hpp"

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

// What is drawn of everybody at a time.
struct DrawnTime {
  double time_s = 0;
  std::optional<Pose> pose;  // instead of what they do then
  FrameStart start;
};

// Everybody, as the camera sees them.
void draw_actors(const Heads& heads, const DrawnTime& drawn, const RenderSpec& render,
                 SceneBuffers& buffers) {
  const InkView view = compute_ink_view(drawn.start.view, render, drawn.start.lamp);
  buffers.drawings.resize(heads.figures.size());
  for (std::size_t i = 0; i < heads.figures.size(); ++i)
    draw_actor(heads, i, drawn.time_s, drawn.pose, view, buffers.draw, buffers.drawings[i]);
}

void append_actors(const Heads& heads, SceneBuffers& buffers) {
  for (std::size_t i = 0; i < heads.figures.size(); ++i)
    append_povray_figure(buffers.text, heads.figures[i]->get_drawn_model(), buffers.drawings[i]);
}

// The same with casters. `stage` is the text of head.inc without parts.
void append_quick_actors(const Heads& heads, const std::string& stage, const FrameStart& start,
                         const RenderSpec& render, SceneBuffers& buffers) {
  std::string text;
  append_povray_start(text, start);
  const SketchStage lamps = build_sketch_stage(stage, text, render.width_px, render.height_px);
  for (std::size_t i = 0; i < heads.figures.size(); ++i) {
    const Model& model = heads.figures[i]->get_drawn_model();
    const std::vector<Mesh> casters = build_casters(lamps, model, buffers.drawings[i]);
    append_povray_figure(buffers.text, model, buffers.drawings[i], &casters);
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

// A drawing's heads into `scene`, and what they do into the buffers, whose text is empty then.
DrawnTime draw_scene(SceneRun& run, std::size_t drawing, SceneBuffers& buffers, SceneText& scene) {
  const Clip& clip = run.clip;
  const std::size_t group = run.groups.group[drawing];
  scene.heads =
      share_thing<DrawnHeads>(run.heads, group, [&run, group] { return build_drawn_heads(run, group); });
  const double time_s = find_time_s(run, drawing);
  DrawnTime drawn{time_s,
                  {},
                  build_start(clip, run.cast, sample_performance(clip.performance, time_s).camera,
                              sample_stage(clip.spec.clip, time_s))};
  draw_actors(scene.heads->heads, drawn, clip.spec.render, buffers);
  buffers.text.clear();
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
      stage(build_povray_stage("", clip.spec.render, resources.stock.templates, list_sets(clip.spec.clip))),
      key(hash_settings(include, clip.spec.render)),
      groups(group_drawings(clip)),
      heads(static_cast<std::size_t>(jobs) + 1),
      buffers(static_cast<std::size_t>(jobs)) {}

SceneText build_scene(SceneRun& run, std::size_t drawing, int worker) {
  SceneText scene;
  SceneBuffers& mine = run.buffers[static_cast<std::size_t>(worker)];
  DrawnTime drawn = draw_scene(run, drawing, mine, scene);
  // What the heads' file is called is nothing that pixels depend on.
  append_povray_start(mine.text, drawn.start);
  const std::size_t start_size = mine.text.size();
  append_actors(scene.heads->heads, mine);
  scene.key = hash_hex(run.key + scene.heads->key + mine.text);
  if (!scene.heads->include.empty()) {
    drawn.start.includes = {scene.heads->include};
    append_povray_start(scene.text, drawn.start);
  }
  scene.text.append(mine.text, scene.text.empty() ? 0 : start_size);
  return scene;
}

SceneText build_quick_scene(SceneRun& run, std::size_t drawing, int worker) {
  if (run.clip.spec.render.style == Style::ink) return build_scene(run, drawing, worker);
  SceneText scene;
  SceneBuffers& mine = run.buffers[static_cast<std::size_t>(worker)];
  DrawnTime drawn = draw_scene(run, drawing, mine, scene);
  if (!scene.heads->include.empty()) drawn.start.includes = {scene.heads->include};
  append_povray_start(mine.text, drawn.start);
  drawn.start.includes.clear();
  append_quick_actors(scene.heads->heads, run.stage, drawn.start, run.clip.spec.render, mine);
  scene.text = std::move(mine.text);
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
  const DrawnTime drawn{still.time_s, still.pose, build_start(clip, cast, still.camera, still.stage)};
  draw_actors(heads, drawn, clip.spec.render, buffers);
  append_povray_start(buffers.text, drawn.start);
  if (clip.spec.render.style == Style::ink)
    append_actors(heads, buffers);
  else
    append_quick_actors(heads, build_povray_stage("", clip.spec.render, templates, list_sets(clip.spec.clip)),
                        drawn.start, clip.spec.render, buffers);
  scene.text = std::move(buffers.text);
  scene.held = list_still_held(heads, still);
  return scene;
}

}  // namespace mien

#include "clip/scenes.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "clip/staging.hpp"
#include "core/error.hpp"
#include "core/pool.hpp"
#include "core/text.hpp"
#include "render/picture.hpp"
#include "render/process.hpp"
#include "sketch/casters.hpp"
#include "sketch/stage.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr int kWhite = 255;

std::string build_parts(const std::vector<FigurePointer>& figures, const Templates& templates) {
  std::string parts;
  for (const FigurePointer& figure : figures)
    if (figure) parts += build_povray_parts(figure->get_drawn_model(), templates);
  return parts;
}

// The POV-Ray that would trace here: by its file, as asking for its version would start it. Empty where there
// is none.
std::string hash_povray() {
  const fs::path povray = find_program("povray");
  return povray.empty() || ::access(povray.c_str(), R_OK) != 0 ? "" : hash_hex(read_file(povray));
}

// What the pixels of every frame depend on besides its own scene.
std::string hash_settings(const std::string& include, const RenderSpec& render) {
  std::string text =
      fmt::format("{} {} {}x{}", MIEN_VERSION, hash_povray(), render.width_px, render.height_px);
  for (const std::string& option : list_quality_options(render)) text += " " + option;
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
    if (!buffers.drawings[i].is_away)
      append_povray_figure(buffers.text, heads.figures[i]->get_drawn_model(), buffers.drawings[i]);
}

std::vector<std::vector<bool>> list_all_castable(const Heads& heads) {
  std::vector<std::vector<bool>> castable;
  for (const FigurePointer& figure : heads.figures)
    castable.push_back(list_castable(figure->get_drawn_model()));
  return castable;
}

// The same with casters; ink has shadows of its own. `stage` is the text of head.inc without parts.
void append_cast_actors(const Heads& heads, const std::vector<std::vector<bool>>& castable,
                        const std::string& stage, const FrameStart& start, const RenderSpec& render,
                        SceneBuffers& buffers) {
  if (render.style == Style::ink) return append_actors(heads, buffers);
  std::string text;
  append_povray_start(text, start);
  const SketchStage lamps = build_sketch_stage(stage, text, render.width_px, render.height_px);
  for (std::size_t i = 0; i < heads.figures.size(); ++i) {
    if (buffers.drawings[i].is_away) continue;
    const Model& model = heads.figures[i]->get_drawn_model();
    const std::vector<Mesh> casters = build_casters(lamps, model, buffers.drawings[i], castable[i]);
    append_povray_figure(buffers.text, model, buffers.drawings[i], &casters);
  }
}

double find_time_s(const SceneRun& run, std::size_t drawing) {
  return compute_drawing_time_s(run.clip.spec.clip, run.clip.plan.drawings[drawing] - 1);
}

DrawnHeads build_drawn_heads(const SceneRun& run, std::size_t group) {
  const std::size_t first = run.groups.first[group];
  DrawnHeads drawn{
      build_heads(run.clip, run.cast, find_time_s(run, first), run.resources.heads), {}, {}, {}, {}};
  drawn.castable = list_all_castable(drawn.heads);
  drawn.parts = build_parts(drawn.heads.changing, run.resources.stock.templates);
  if (drawn.parts.empty()) return drawn;
  drawn.include = name_heads(run.clip.plan.drawings[first]);
  drawn.key = hash_hex(drawn.parts);
  return drawn;
}

std::shared_ptr<const DrawnHeads> find_heads(SceneRun& run, std::size_t drawing) {
  const std::size_t group = run.groups.group[drawing];
  return share_thing<DrawnHeads>(run.heads, group, [&run, group] { return build_drawn_heads(run, group); });
}

// A drawing of the plan into the buffers.
DrawnTime draw_scene(const SceneRun& run, std::size_t drawing, const DrawnHeads& heads,
                     SceneBuffers& buffers) {
  const Clip& clip = run.clip;
  const double time_s = find_time_s(run, drawing);
  DrawnTime drawn{time_s,
                  {},
                  build_start(clip, run.cast, sample_performance(clip.performance, time_s).camera,
                              sample_stage(clip.spec.clip, time_s))};
  draw_actors(heads.heads, drawn, clip.spec.render, buffers);
  return drawn;
}

// Of what is drawn in the buffers. Casters follow from it, and what the heads' file is called is nothing that
// pixels depend on.
std::string hash_scene(const SceneRun& run, const DrawnHeads& heads, const FrameStart& start,
                       SceneBuffers& buffers) {
  buffers.text.clear();
  append_povray_start(buffers.text, start);
  append_actors(heads.heads, buffers);
  return hash_hex(run.key + heads.key + buffers.text);
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

std::string compute_scene_key(SceneRun& run, std::size_t drawing, int worker) {
  SceneBuffers& mine = run.buffers[static_cast<std::size_t>(worker)];
  const std::shared_ptr<const DrawnHeads> heads = find_heads(run, drawing);
  return hash_scene(run, *heads, draw_scene(run, drawing, *heads, mine).start, mine);
}

SceneText build_scene(SceneRun& run, std::size_t drawing, int worker) {
  SceneBuffers& mine = run.buffers[static_cast<std::size_t>(worker)];
  SceneText scene;
  scene.heads = find_heads(run, drawing);
  const FrameStart start = draw_scene(run, drawing, *scene.heads, mine).start;
  scene.key = hash_scene(run, *scene.heads, start, mine);
  mine.text.clear();
  FrameStart told = start;
  if (!scene.heads->include.empty()) told.includes = {scene.heads->include};
  append_povray_start(mine.text, told);
  append_cast_actors(scene.heads->heads, scene.heads->castable, run.stage, start, run.clip.spec.render, mine);
  scene.text = mine.text;
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

void write_part_picture(const PartPicture& picture, const fs::path& folder) {
  const fs::path path = folder / picture.name;
  if (fs::exists(path)) return;  // it is named by what is in it
  Pixels pixels = read_pixels(picture.file);
  for (std::size_t i = 0; i < pixels.alpha.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint8_t& byte = pixels.rgb[3 * i + k];
      byte = static_cast<std::uint8_t>(kWhite - (kWhite - byte) * pixels.alpha[i] / kWhite);
    }
  pixels.alpha.clear();  // on white, as the skin is painted
  write_file(path, build_png(pixels));
}

void write_part_pictures(const Model& model, const fs::path& folder) {
  for (const Part& part : model.parts)
    if (part.picture) write_part_picture(*part.picture, folder);
}

void write_scene(const SceneText& scene, const fs::path& path) {
  for (const FigurePointer& figure : scene.heads->heads.figures)
    if (figure) write_part_pictures(figure->get_drawn_model(), path.parent_path());
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
  append_cast_actors(heads, list_all_castable(heads),
                     build_povray_stage("", clip.spec.render, templates, list_sets(clip.spec.clip)),
                     drawn.start, clip.spec.render, buffers);
  scene.text = std::move(buffers.text);
  scene.held = list_still_held(heads, still);
  for (const FigurePointer& figure : heads.figures)
    for (const Part& part : figure->get_drawn_model().parts)
      if (part.picture) scene.pictures.push_back(part.picture);
  return scene;
}

}  // namespace mien

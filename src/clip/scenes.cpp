#include "clip/scenes.hpp"

#include <fmt/format.h>

#include "clip/staging.hpp"
#include "core/error.hpp"
#include "core/pool.hpp"
#include "core/shared_cache.hpp"
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

struct SceneBuffers {
  DrawBuffers draw;
  Drawing drawing;
  std::string text;
};

// Everybody at a time, as `view` sees them; with `pose` doing that instead.
void append_actors(const Heads& heads, double time_s, const std::optional<Pose>& pose, const InkView& view,
                   SceneBuffers& buffers) {
  for (std::size_t i = 0; i < heads.figures.size(); ++i) {
    draw_actor(heads, i, time_s, pose, view, buffers.draw, buffers.drawing);
    append_povray_figure(buffers.text, heads.figures[i]->get_drawn_model(), buffers.drawing);
  }
}

// The heads of one group of drawings, and the file of those parts that are not in head.inc.
struct WrittenHeads {
  Heads heads;
  std::string include;  // "h0007.inc"; empty if there are no such parts
  std::string key;      // a hash of it
};

WrittenHeads write_heads(const Clip& clip, const Cast& cast, int first_frame, const Resources& resources) {
  WrittenHeads written;
  const double time_s = compute_drawing_time_s(clip.spec.clip, first_frame - 1);
  written.heads = build_heads(clip, cast, time_s, resources.heads);
  const std::string parts = build_parts(written.heads.changing, resources.stock.templates);
  if (parts.empty()) return written;
  written.include = name_heads(first_frame);
  written.key = hash_hex(parts);
  write_file(clip.files.scenes() / written.include, parts);
  return written;
}

// The text of one drawing's scene, into the buffers.
void build_scene(const Clip& clip, const Cast& cast, const WrittenHeads& written, double time_s,
                 SceneBuffers& buffers) {
  FrameStart start = build_start(clip, cast, sample_performance(clip.performance, time_s).camera,
                                 sample_stage(clip.spec.clip, time_s));
  if (!written.include.empty()) start.includes = {written.include};
  buffers.text.clear();
  append_povray_start(buffers.text, start);
  append_actors(written.heads, time_s, {}, compute_ink_view(start.view, clip.spec.render, start.lamp),
                buffers);
}

void write_held_frames(const Clip& clip) {
  for (std::size_t i = 0; i < clip.plan.frames.size(); ++i) {
    const int frame = clip.plan.frames[i], drawn_as = clip.plan.drawn_as[i];
    if (frame == drawn_as) continue;
    write_file(clip.files.scene(frame), fmt::format("// holds the drawing of frame {}\n#include \"{}.pov\"\n",
                                                    drawn_as, name_frame(drawn_as)));
  }
}

// What all frames share: the include file with what it holds, and the key of that and of how it is rendered.
struct SharedFiles {
  TracedFile include;
  std::string key;
};

SharedFiles write_shared_files(const Clip& clip, const Cast& cast, const Templates& templates) {
  const RenderSpec& render = clip.spec.render;
  std::error_code error;
  for (const fs::path& stale : find_stale_files(clip.files, clip.frame_count)) fs::remove(stale, error);
  const fs::path frames = clip.files.folder / "frames";
  fs::create_directories(frames, error);  // POV-Ray alone would not
  if (error) throw RunError(fmt::format("cannot write in {}: {}", frames.string(), error.message()));
  const std::string include =
      build_povray_stage(build_parts(cast.figures, templates), render, templates, list_sets(clip.spec.clip));
  SharedFiles shared{{clip.files.scenes() / "head.inc", hash_hex(include)}, hash_settings(include, render)};
  write_file(shared.include.path, include);
  write_file(clip.files.scenes() / "loop.pov", build_povray_loop());
  write_file(clip.files.scenes() / (clip.files.name + ".ini"),
             build_povray_ini(render, clip.files.name, clip.frame_count, clip.files.folder,
                              {clip.plan.frames.front(), clip.plan.frames.back()}));
  return shared;
}

}  // namespace

std::vector<WrittenScene> write_scenes(const Clip& clip, const Cast& cast, const Resources& resources,
                                       int jobs, const SceneWritten& written) {
  const SharedFiles shared = write_shared_files(clip, cast, resources.stock.templates);
  const std::vector<int>& drawings = clip.plan.drawings;
  const DrawingGroups groups = group_drawings(clip);
  SharedCache<WrittenHeads> cache(static_cast<std::size_t>(jobs) + 1);
  std::vector<WrittenScene> scenes(drawings.size());
  std::vector<SceneBuffers> buffers(static_cast<std::size_t>(jobs));
  for_each_index(drawings.size(), jobs, [&](std::size_t turn, int worker) {
    throw_if_interrupted();
    const std::size_t drawing = groups.order[turn], group = groups.group[drawing];
    const auto heads = share_thing<WrittenHeads>(
        cache, group, [&] { return write_heads(clip, cast, drawings[groups.first[group]], resources); });
    SceneBuffers& mine = buffers[static_cast<std::size_t>(worker)];
    build_scene(clip, cast, *heads, compute_drawing_time_s(clip.spec.clip, drawings[drawing] - 1), mine);
    const TracedFile scene{clip.files.scene(drawings[drawing]), hash_hex(mine.text)};
    write_file(scene.path, mine.text);
    scenes[drawing] = {hash_hex(shared.key + heads->key + mine.text), {shared.include, scene}};
    if (!heads->include.empty())
      scenes[drawing].files.push_back({clip.files.scenes() / heads->include, heads->key});
    written(drawings[drawing]);
  });
  write_held_frames(clip);
  return scenes;
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

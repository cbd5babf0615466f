#include "clip_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/pool.hpp"
#include "core/shelf.hpp"
#include "core/text.hpp"
#include "frames/place.hpp"
#include "head/form.hpp"
#include "render/process.hpp"
#include "render/progress.hpp"
#include "timeline/head_track.hpp"
#include "timeline/parts.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

using FigurePointer = std::shared_ptr<const Figure>;

bool is_growing(const Actor& actor) { return !actor.performance.clip.head.empty(); }

// With the actor's name in the names of its parts: one scene holds everybody's.
FigurePointer build_actor_figure(const Actor& actor, const HeadSpec& head, const fs::path& data) {
  Figure figure = build_figure(head, data);
  if (!actor.name.empty())
    for (Part& part : figure.model.parts) part.name += "_of_" + actor.name;
  return std::make_shared<const Figure>(std::move(figure));
}

// Everybody's figure as some drawings show it.
struct Heads {
  std::vector<FigurePointer> figures;     // one an actor
  std::vector<glm::dmat4> places;         // world from figure
  std::vector<Performance> performances;  // with the eyes of these figures
  std::string parts;                      // the text of those that are not in head.inc; until it is written
  std::string parts_key;
};

Heads build_heads(const Clip& clip, const Cast& cast, double time_s, const fs::path& data) {
  Heads heads{cast.figures, {}, {}, {}, {}};
  const RenderSpec& render = clip.spec.render;
  for (std::size_t i = 0; i < clip.actors.size(); ++i) {
    const Actor& actor = clip.actors[i];
    glm::dmat4& place = heads.places.emplace_back(find_place(actor.place));
    if (!heads.figures[i]) {
      heads.figures[i] = build_actor_figure(actor, find_head(actor, time_s), data);
      place[3].y += find_lowering_mm(*heads.figures[i], place, cast.framing, render);
      heads.parts += build_povray_parts(heads.figures[i]->model, data / "templates");
    }
    heads.performances.push_back(actor.performance);
    heads.performances.back().idle.eyes = find_eyes(*heads.figures[i], place, cast.framing, render);
  }
  return heads;
}

// Drawings that show the same heads are of one group: for each drawing the group's number, from 0 by time.
std::vector<std::size_t> group_drawings(const Clip& clip) {
  std::map<std::string, std::size_t> known;
  std::vector<std::size_t> groups;
  for (const int frame : clip.plan.drawings) {
    const double time_s = find_drawing_time_s(clip.spec.clip, frame - 1);
    std::string key;
    for (const Actor& actor : clip.actors)
      if (is_growing(actor)) key += find_head_key(find_head(actor, time_s));
    groups.push_back(known.emplace(key, known.size()).first->second);
  }
  return groups;
}

std::string build_fixed_parts(const Cast& cast, const fs::path& data) {
  std::string parts;
  for (const FigurePointer& figure : cast.figures)
    if (figure) parts += build_povray_parts(figure->model, data / "templates");
  return parts;
}

// What the pixels of every frame depend on besides its own scene.
std::string key_of_settings(const std::string& include, const RenderSpec& render) {
  std::string text = fmt::format("{} {}x{}", MIEN_VERSION, render.width_px, render.height_px);
  for (const std::string& option : list_quality_options(render.quality)) text += " " + option;
  return hash_hex(text + "\n" + include);
}

struct SceneBuffers {
  DeformBuffers deform;
  Drawing drawing;
  std::string text;
};

// Everybody at a time; with `pose` doing that instead.
void append_actors(const Heads& heads, double time_s, const std::optional<Pose>& pose,
                   SceneBuffers& buffers) {
  for (std::size_t i = 0; i < heads.figures.size(); ++i) {
    Moment moment{};
    if (pose)
      moment.pose = *pose;
    else
      moment = sample_performance(heads.performances[i], time_s);
    deform_figure(*heads.figures[i], moment.pose, moment.turn, buffers.deform, buffers.drawing);
    place_drawing(heads.places[i], buffers.drawing);
    append_povray_figure(buffers.text, heads.figures[i]->model, buffers.drawing);
  }
}

// What of templates/povray the clip's keys name.
StageSets list_sets(const ClipSpec& clip) {
  StageSets sets;
  for (const LightKey& key : clip.light) sets.lights.insert(key.set);
  for (const BackgroundKey& key : clip.background)
    if (!key.colour) sets.backgrounds.insert(key.name);
  return sets;
}

FrameStart build_start(const Clip& clip, const Cast& cast, const CameraKey& camera,
                       const StageMoment& stage) {
  return {{}, stage.lights, stage.backgrounds, find_view(cast.framing, camera, stage, clip.spec.render)};
}

// Adds where the landmarks lie that the camera looks at.
void add_places(const Clip& clip, const Actor& actor, const Figure& figure, const fs::path& data,
                Framing& framing) {
  for (const CameraKey& key : clip.spec.clip.camera)
    if (key.aim.kind == Aim::Kind::landmark && key.aim.actor == actor.name)
      framing.places[{actor.name, key.aim.landmark}] = glm::dvec3(
          find_place(actor.place) * glm::dvec4(find_resting_place(figure.head, key.aim.landmark, data), 1));
}

void write_held_frames(const Clip& clip) {
  for (std::size_t i = 0; i < clip.plan.frames.size(); ++i) {
    const int frame = clip.plan.frames[i], drawn_as = clip.plan.drawn_as[i];
    if (frame == drawn_as) continue;
    write_file(clip.files.scene(frame), fmt::format("// holds the drawing of frame {}\n#include \"{}.pov\"\n",
                                                    drawn_as, name_frame(drawn_as)));
  }
}

// The files that all frames share; returns the key of what they say.
std::string write_shared_files(const Clip& clip, const Cast& cast, const fs::path& data) {
  const RenderSpec& render = clip.spec.render;
  for (const fs::path& stale : find_stale_files(clip.files, clip.frame_count)) fs::remove(stale);
  fs::create_directories(clip.files.folder / "frames");  // POV-Ray alone would not
  const std::string include = build_povray_stage(build_fixed_parts(cast, data), render, data / "templates",
                                                 list_sets(clip.spec.clip));
  write_file(clip.files.scenes() / "head.inc", include);
  write_file(clip.files.scenes() / "loop.pov", build_povray_loop());
  write_file(clip.files.scenes() / (clip.files.name + ".ini"),
             build_povray_ini(render, clip.files.name, clip.frame_count, clip.files.folder,
                              {clip.plan.frames.front(), clip.plan.frames.back()}));
  return key_of_settings(include, render);
}

// Throws InputError unless every head that the actor has between its keys can be built.
void check_heads(const Clip& clip, const Actor& actor, const fs::path& data) {
  if (!is_growing(actor)) return;
  constexpr int kMostChecks =
      240;  // a form takes milliseconds; a day of growth needs no more than a minute's
  const HeadStock stock = load_head_stock(data);
  const int frames = clip.frame_count, step = 1 + frames / kMostChecks;
  std::set<std::string> seen;
  for (int frame = 0; frame < frames; frame += step) {
    const double time_s = find_drawing_time_s(clip.spec.clip, frame);
    const HeadSpec head = find_head(actor, time_s);
    if (!seen.insert(find_head_key(head)).second) continue;
    try {
      build_form(stock, head);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: the head{} at {:.4g}s: {}", clip.spec.file.string(),
                                   actor.name.empty() ? "" : " of " + actor.name, time_s, error.what()));
    }
  }
}

}  // namespace

Cast build_cast(const Clip& clip, const fs::path& data_folder) {
  Cast cast;
  for (const Actor& actor : clip.actors) {
    check_heads(clip, actor, data_folder);
    std::vector<HeadSpec> heads;  // that it is seen to have
    for (const HeadKey& key : actor.performance.clip.head) heads.push_back(key.head);
    if (!is_growing(actor)) heads.push_back(actor.head);
    std::set<std::string> seen;
    std::vector<FigurePointer> figures;
    std::vector<const Figure*> framed;
    for (const HeadSpec& head : heads) {
      throw_if_interrupted();
      if (!seen.insert(find_head_key(head)).second) continue;
      figures.push_back(build_actor_figure(actor, head, data_folder));
      framed.push_back(figures.back().get());
      add_places(clip, actor, *figures.back(), data_folder, cast.framing);
    }
    add_growing_figure(framed, find_place(actor.place), cast.framing);
    cast.figures.push_back(is_growing(actor) ? nullptr : figures.front());
  }
  return cast;
}

std::vector<Performance> list_performances(const Clip& clip, const Cast& cast, const fs::path& data_folder) {
  return build_heads(clip, cast, 0, data_folder).performances;
}

std::vector<std::string> write_scenes(const Clip& clip, const Cast& cast, const Options& options,
                                      const fs::path& data_folder) {
  const std::string settings_key = write_shared_files(clip, cast, data_folder);
  const std::vector<int>& drawings = clip.plan.drawings;
  const std::vector<std::size_t> groups = group_drawings(clip);
  // Group after group, so that few heads are in use at once.
  std::vector<std::size_t> order(drawings.size()), first_of_group;
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
    if (groups[i] == first_of_group.size()) first_of_group.push_back(i);
  }
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return groups[i]; });

  const int jobs = count_jobs(options);
  Shelf<Heads> shelf(static_cast<std::size_t>(jobs) + 1);
  std::vector<std::string> keys(drawings.size());
  std::vector<SceneBuffers> buffers(static_cast<std::size_t>(jobs));
  Progress progress(stderr, find_progress_style(stderr, options.is_quiet, options.is_json), "scenes",
                    static_cast<int>(drawings.size()));
  for_each_index(drawings.size(), jobs, [&](std::size_t turn, int worker) {
    throw_if_interrupted();
    const std::size_t i = order[turn];
    const int heads_frame = drawings[first_of_group[groups[i]]];
    const std::string heads_name = name_heads(heads_frame);
    const double time_s = find_drawing_time_s(clip.spec.clip, drawings[i] - 1);
    const auto heads = take_thing<Heads>(shelf, groups[i], [&] {
      Heads made = build_heads(clip, cast, time_s, data_folder);
      if (made.parts.empty()) return made;
      write_file(clip.files.scenes() / heads_name, made.parts);
      made.parts_key = hash_hex(made.parts);
      made.parts = {};
      return made;
    });
    SceneBuffers& mine = buffers[static_cast<std::size_t>(worker)];
    mine.text.clear();
    FrameStart start = build_start(clip, cast, sample_performance(clip.performance, time_s).camera,
                                   sample_stage(clip.spec.clip, time_s));
    if (!heads->parts_key.empty()) start.includes = {heads_name};
    append_povray_start(mine.text, start);
    append_actors(*heads, time_s, {}, mine);
    write_file(clip.files.scene(drawings[i]), mine.text);
    keys[i] = hash_hex(settings_key + heads->parts_key + mine.text);
    progress.advance(false, drawings[i]);
  });
  write_held_frames(clip);
  progress.finish();
  return keys;
}

StillScene build_still_scene(const Clip& clip, const Cast& cast, const Still& still,
                             const fs::path& data_folder) {
  const Heads heads = build_heads(clip, cast, still.time_s, data_folder);
  StillScene scene;
  scene.include = build_povray_stage(build_fixed_parts(cast, data_folder) + heads.parts, clip.spec.render,
                                     data_folder / "templates", list_sets(clip.spec.clip));
  SceneBuffers buffers;
  append_povray_start(buffers.text, build_start(clip, cast, still.camera, still.stage));
  append_actors(heads, still.time_s, still.pose, buffers);
  scene.text = std::move(buffers.text);
  for (const Performance& performance : heads.performances) {
    if (still.pose) break;
    const std::vector<Held> held = list_held_at(performance, still.time_s);
    scene.held.insert(scene.held.end(), held.begin(), held.end());
  }
  return scene;
}

}  // namespace mien

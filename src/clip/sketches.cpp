#include "clip/sketches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "clip/pictures.hpp"
#include "clip/slate.hpp"
#include "clip/staging.hpp"
#include "core/pool.hpp"
#include "core/shared_cache.hpp"
#include "core/text.hpp"
#include "render/process.hpp"
#include "sketch/sketch.hpp"

namespace mien {

namespace fs = std::filesystem;

namespace {

// The materials of one figure, as a stage has them.
struct KeptLook {
  const Model* model = nullptr;
  SketchLook look;
  std::string key;  // of all that never changes of it
};

// What one thread sketches with; looks are kept as long as the stage that they were read for.
struct SketchBench {
  SketchDesk desk;
  DrawBuffers draw;
  std::vector<Drawing> drawings;
  std::string start;  // the text of the desk's stage
  // A look is known by where its model lies: those of heads that have gone must not be taken for new ones.
  std::shared_ptr<const Heads> heads;
  std::vector<KeptLook> looks;
};

template <typename T>
std::string hash_values(const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  return hash_hex({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

std::string hash_model(const Model& model) {
  std::string all;
  for (const Part& part : model.parts) {
    all += fmt::format("{} {} {} {} {}", part.name, part.material, part.wear, part.is_rigid, part.is_outline);
    all += hash_values(part.rest.triangles) + hash_values(part.palette) + hash_values(part.shade) +
           hash_values(part.triangle_shade) + hash_values(part.grain);
    if (part.is_rigid) all += hash_values(part.rest.positions) + hash_values(part.rest.normals);
  }
  return hash_hex(all);
}

std::string hash_drawing(const Drawing& drawing) {
  std::string all;
  for (const PartShape& shape : drawing.parts) {
    all += hash_values(shape.positions) + hash_values(shape.normals) + hash_values(shape.triangles);
    all.append(reinterpret_cast<const char*>(&shape.world_from_rest), sizeof shape.world_from_rest);
  }
  return hash_hex(all);
}

void stage_moment(const Clip& clip, const std::string& include, const FrameStart& start, SketchBench& bench) {
  std::string text;
  append_povray_start(text, start);
  if (text == bench.start) return;
  set_stage(bench.desk,
            build_sketch_stage(include, text, clip.spec.render.width_px, clip.spec.render.height_px));
  bench.start = std::move(text);
  bench.looks.clear();
}

const KeptLook& find_look(const Model& model, SketchBench& bench) {
  for (const KeptLook& kept : bench.looks)
    if (kept.model == &model) return kept;
  bench.looks.push_back({&model, build_sketch_look(model, bench.desk.stage.names), hash_model(model)});
  return bench.looks.back();
}

// A moment of a clip, drawn but not traced.
struct DrawnMoment {
  std::string key;  // of all that its pixels depend on
  std::vector<SketchFigure> figures;
};

DrawnMoment draw_moment(const Clip& clip, const std::string& include, const FrameStart& start,
                        const Heads& heads, double time_s, const std::optional<Pose>& pose,
                        SketchBench& bench) {
  const RenderSpec& render = clip.spec.render;
  stage_moment(clip, include, start, bench);
  const InkView view = compute_ink_view(start.view, render, start.lamp);
  bench.drawings.resize(heads.figures.size());
  DrawnMoment drawn{
      fmt::format("{}x{} {} {}", render.width_px, render.height_px, hash_hex(include), bench.start), {}};
  for (std::size_t i = 0; i < heads.figures.size(); ++i) {
    draw_actor(heads, i, time_s, pose, view, bench.draw, bench.drawings[i]);
    if (bench.drawings[i].is_away) continue;
    drawn.key += find_look(heads.figures[i]->get_drawn_model(), bench).key + hash_drawing(bench.drawings[i]);
  }
  drawn.key = hash_hex(drawn.key);
  for (std::size_t i = 0; i < heads.figures.size(); ++i) {
    if (bench.drawings[i].is_away) continue;
    const Model& model = heads.figures[i]->get_drawn_model();
    drawn.figures.push_back({&model, &find_look(model, bench).look, &bench.drawings[i]});
  }
  return drawn;
}

std::string build_include(const Clip& clip, const Resources& resources) {
  return build_povray_stage("", clip.spec.render, resources.stock.templates, list_sets(clip.spec.clip));
}

// One clip on its way to pictures.
struct SketchRun {
  Staged staged;
  std::string include;
  DrawingGroups groups;
  std::unique_ptr<SharedCache<Heads>> cache;
  std::vector<SketchBench> benches;  // one a thread
};

PictureSize find_size(const Clip& clip) { return {clip.spec.render.width_px, clip.spec.render.height_px}; }

DrawnMoment draw_drawing(SketchRun& run, std::size_t drawing, SketchBench& bench,
                         const Resources& resources) {
  const Clip& clip = *run.staged.clip;
  const Cast& cast = *run.staged.cast;
  const auto find_time_s = [&](std::size_t i) {
    return compute_drawing_time_s(clip.spec.clip, clip.plan.drawings[i] - 1);
  };
  const std::size_t group = run.groups.group[drawing];
  auto heads = share_thing<Heads>(*run.cache, group, [&] {
    return build_heads(clip, cast, find_time_s(run.groups.first[group]), resources.heads);
  });
  if (bench.heads != heads) bench.looks.clear();
  bench.heads = heads;
  const double time_s = find_time_s(drawing);
  const FrameStart start = build_start(clip, cast, sample_performance(clip.performance, time_s).camera,
                                       sample_stage(clip.spec.clip, time_s));
  return draw_moment(clip, run.include, start, *heads, time_s, {}, bench);
}

// Pictures of one width after the other.
Pixels join_parts(const std::vector<Pixels>& parts) {
  if (parts.size() == 1) return parts.front();
  PictureSize size{0, parts.front().size.height_px};
  for (const Pixels& part : parts) size.width_px += part.size.width_px;
  Pixels whole = make_pixels(size);
  int left_px = 0;
  for (const Pixels& part : parts) {
    paste_pixels(whole, part, left_px, 0);
    left_px += part.size.width_px;
  }
  return whole;
}

struct FinishedSketch {
  std::string key;
  std::shared_ptr<const Pixels> picture;
  bool was_kept = false;
};

FinishedSketch finish_sketch(std::vector<SketchRun>& runs, std::size_t drawing, std::size_t worker,
                             const Resources& resources, const SketchStore* store) {
  FinishedSketch finished;
  std::vector<DrawnMoment> drawn;
  for (SketchRun& run : runs) {
    drawn.push_back(draw_drawing(run, drawing, run.benches[worker], resources));
    finished.key += drawn.back().key;
  }
  if (store)
    if (const auto kept = store->pictures.find(finished.key); kept != store->pictures.end()) {
      finished.picture = kept->second;
      finished.was_kept = true;
      return finished;
    }
  std::vector<Pixels> parts;
  for (std::size_t i = 0; i < runs.size(); ++i)
    parts.push_back(
        trace_sketch(runs[i].benches[worker].desk, drawn[i].figures, find_size(*runs[i].staged.clip)));
  finished.picture = std::make_shared<const Pixels>(join_parts(parts));
  return finished;
}

}  // namespace

SketchedStill sketch_still(const Clip& clip, const Cast& cast, const Still& still,
                           const Resources& resources) {
  const Heads heads = build_heads(clip, cast, still.time_s, resources.heads);
  SketchBench bench;
  const DrawnMoment drawn =
      draw_moment(clip, build_include(clip, resources), build_start(clip, cast, still.camera, still.stage),
                  heads, still.time_s, still.pose, bench);
  return {trace_sketch(bench.desk, drawn.figures, find_size(clip)), list_still_held(heads, still)};
}

void sketch_drawings(const std::vector<Staged>& parts, const Resources& resources, int jobs,
                     SketchStore* store, const SketchTaken& taken) {
  std::vector<SketchRun> runs(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    runs[i].staged = parts[i];
    runs[i].include = build_include(*parts[i].clip, resources);
    runs[i].groups = group_drawings(*parts[i].clip);
    runs[i].cache = std::make_unique<SharedCache<Heads>>(static_cast<std::size_t>(jobs) + 1);
    runs[i].benches.resize(static_cast<std::size_t>(jobs));
  }
  std::mutex order;
  std::map<std::size_t, FinishedSketch> waiting;  // for those before them
  std::size_t next = 0, bytes = 0;
  SketchStore fresh;
  for_each_index(parts.front().clip->plan.drawings.size(), jobs, [&](std::size_t drawing, int worker) {
    throw_if_interrupted();
    FinishedSketch finished =
        finish_sketch(runs, drawing, static_cast<std::size_t>(worker), resources, store);
    const std::lock_guard lock(order);
    waiting.emplace(drawing, std::move(finished));
    for (auto ready = waiting.begin(); ready != waiting.end() && ready->first == next; ++next) {
      const FinishedSketch& first = ready->second;
      taken(ready->first, *first.picture, first.was_kept);
      bytes += first.picture->rgb.size() + first.picture->alpha.size();
      if (store && bytes <= store->most_bytes) fresh.pictures.emplace(first.key, first.picture);
      ready = waiting.erase(ready);
    }
  });
  if (store) store->pictures = std::move(fresh.pictures);
}

std::string build_sketch_manifest(const Clip& clip) {
  nlohmann::ordered_json manifest;
  manifest["mien"] = MIEN_VERSION;
  manifest["name"] = clip.files.name;
  manifest["title"] = clip.spec.title;
  manifest["quality"] = "sketch";
  manifest["clip"] = list_video_paths(clip).front().filename().string();
  manifest["fps"] = clip.spec.clip.fps;
  manifest["frames"] = clip.plan.frames.size();
  manifest["drawings"] = clip.plan.drawings.size();
  manifest["width"] = clip.spec.render.width_px;
  manifest["height"] = clip.spec.render.height_px;
  return manifest.dump(1) + "\n";
}

namespace {

fs::path find_kept(const SketchVideos& videos, std::size_t drawing) {
  return videos.kept->path / fmt::format("{}.png", drawing);
}

// Those that are shown after a later one: the others are given when they are wanted, and not again.
std::vector<bool> find_kept_drawings(const SketchVideos& videos) {
  std::vector<bool> is_kept(videos.clip->plan.drawings.size(), false);
  for (const SketchVideo& video : videos.videos) {
    std::size_t latest = 0;
    for (const std::size_t frame : video.shown) {
      const std::size_t drawing = videos.drawing_of[frame];
      if (drawing < latest) is_kept[drawing] = true;
      latest = std::max(latest, drawing);
    }
  }
  return is_kept;
}

void append_shown(SketchVideos& videos, SketchVideo& video, std::size_t frame, const Pixels& picture) {
  if (!videos.clip->video.has_slate) return append_frame(video.stream, picture);
  Pixels slated = picture;
  draw_slate(slated, build_slate(*videos.clip, videos.clip->plan.frames[frame]), *videos.letters);
  append_frame(video.stream, slated);
}

}  // namespace

SketchVideos start_sketch_videos(const Clip& clip, const Letters& letters) {
  SketchVideos videos{&clip, &letters, {}, {}, {}, {}};
  const FramePlan& plan = clip.plan;
  for (const int drawn_as : plan.drawn_as)
    videos.drawing_of.push_back(
        static_cast<std::size_t>(std::ranges::lower_bound(plan.drawings, drawn_as) - plan.drawings.begin()));
  const VideoForm form{find_size(clip), clip.spec.clip.fps, has_alpha(clip.spec.render), true,
                       clip.video.plays};
  for (const fs::path& path : list_video_paths(clip)) {
    std::vector<std::size_t> shown = list_shown_frames(clip, path);
    VideoStream stream = start_video(form, path, find_shown_sound(clip, path), shown.size());
    videos.videos.push_back({std::move(stream), std::move(shown)});
  }
  videos.is_kept = find_kept_drawings(videos);
  if (std::ranges::find(videos.is_kept, true) != videos.is_kept.end())
    videos.kept = std::make_unique<WorkFolder>(clip.files.folder);
  return videos;
}

void append_drawing(SketchVideos& videos, std::size_t drawing, const Pixels& picture) {
  if (videos.is_kept[drawing]) write_file(find_kept(videos, drawing), build_png(picture));
  for (SketchVideo& video : videos.videos) {
    std::optional<std::size_t> read;  // whose picture `again` is
    Pixels again;
    for (; video.done < video.shown.size(); ++video.done) {
      const std::size_t frame = video.shown[video.done], wanted = videos.drawing_of[frame];
      if (wanted > drawing) break;  // it is still to come
      if (wanted != drawing && read != wanted) {
        again = read_pixels(find_kept(videos, wanted));
        read = wanted;
      }
      append_shown(videos, video, frame, wanted == drawing ? picture : again);
    }
  }
}

void finish_sketch_videos(SketchVideos& videos) {
  for (SketchVideo& video : videos.videos) finish_video(video.stream);
}

}  // namespace mien

#include "clip/sketches.hpp"

#include <map>
#include <mutex>
#include <nlohmann/json.hpp>

#include "clip/pictures.hpp"
#include "clip/staging.hpp"
#include "core/pool.hpp"
#include "core/shared_cache.hpp"
#include "render/process.hpp"
#include "sketch/sketch.hpp"

namespace mien {

namespace {

// The materials of one figure, as a stage has them.
struct KeptLook {
  const Model* model = nullptr;
  SketchLook look;
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

void stage_moment(const Clip& clip, const std::string& include, const FrameStart& start, SketchBench& bench) {
  std::string text;
  append_povray_start(text, start);
  if (text == bench.start) return;
  set_stage(bench.desk,
            build_sketch_stage(include, text, clip.spec.render.width_px, clip.spec.render.height_px));
  bench.start = std::move(text);
  bench.looks.clear();
}

const SketchLook& find_look(const Model& model, SketchBench& bench) {
  for (const KeptLook& kept : bench.looks)
    if (kept.model == &model) return kept.look;
  bench.looks.push_back({&model, build_sketch_look(model, bench.desk.stage.names)});
  return bench.looks.back().look;
}

Pixels sketch_moment(const Clip& clip, const std::string& include, const FrameStart& start,
                     const Heads& heads, double time_s, const std::optional<Pose>& pose, SketchBench& bench) {
  const RenderSpec& render = clip.spec.render;
  stage_moment(clip, include, start, bench);
  const InkView view = compute_ink_view(start.view, render);
  bench.drawings.resize(heads.figures.size());
  for (std::size_t i = 0; i < heads.figures.size(); ++i) {
    draw_actor(heads, i, time_s, pose, view, bench.draw, bench.drawings[i]);
    find_look(heads.figures[i]->get_drawn_model(), bench);
  }
  std::vector<SketchFigure> figures;
  for (std::size_t i = 0; i < heads.figures.size(); ++i) {
    const Model& model = heads.figures[i]->get_drawn_model();
    figures.push_back({&model, &find_look(model, bench), &bench.drawings[i]});
  }
  return trace_sketch(bench.desk, figures, {render.width_px, render.height_px});
}

// One clip on its way to pictures.
struct SketchRun {
  Staged staged;
  std::string include;
  DrawingGroups groups;
  std::unique_ptr<SharedCache<Heads>> cache;
  std::vector<SketchBench> benches;  // one a thread
};

Pixels sketch_drawing(SketchRun& run, std::size_t drawing, int worker, const Resources& resources) {
  const Clip& clip = *run.staged.clip;
  const Cast& cast = *run.staged.cast;
  const auto find_time_s = [&](std::size_t i) {
    return compute_drawing_time_s(clip.spec.clip, clip.plan.drawings[i] - 1);
  };
  const std::size_t group = run.groups.group[drawing];
  auto heads = share_thing<Heads>(*run.cache, group, [&] {
    return build_heads(clip, cast, find_time_s(run.groups.first[group]), resources.heads);
  });
  SketchBench& bench = run.benches[static_cast<std::size_t>(worker)];
  if (bench.heads != heads) bench.looks.clear();
  bench.heads = heads;
  const double time_s = find_time_s(drawing);
  const FrameStart start = build_start(clip, cast, sample_performance(clip.performance, time_s).camera,
                                       sample_stage(clip.spec.clip, time_s));
  return sketch_moment(clip, run.include, start, *heads, time_s, {}, bench);
}

std::string build_include(const Clip& clip, const Resources& resources) {
  return build_povray_stage("", clip.spec.render, resources.stock.templates, list_sets(clip.spec.clip));
}

}  // namespace

SketchedStill sketch_still(const Clip& clip, const Cast& cast, const Still& still,
                           const Resources& resources) {
  const Heads heads = build_heads(clip, cast, still.time_s, resources.heads);
  SketchBench bench;
  SketchedStill sketched;
  sketched.picture =
      sketch_moment(clip, build_include(clip, resources), build_start(clip, cast, still.camera, still.stage),
                    heads, still.time_s, still.pose, bench);
  sketched.held = list_still_held(heads, still);
  return sketched;
}

void sketch_drawings(const std::vector<Staged>& parts, const Resources& resources, int jobs,
                     const SketchTaken& taken) {
  const Clip& first = *parts.front().clip;
  std::vector<SketchRun> runs(parts.size());
  PictureSize size{0, first.spec.render.height_px};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Clip& clip = *parts[i].clip;
    runs[i].staged = parts[i];
    runs[i].include = build_include(clip, resources);
    runs[i].groups = group_drawings(clip);
    runs[i].cache = std::make_unique<SharedCache<Heads>>(static_cast<std::size_t>(jobs) + 1);
    runs[i].benches.resize(static_cast<std::size_t>(jobs));
    size.width_px += clip.spec.render.width_px;
  }
  std::mutex order;
  std::map<std::size_t, Pixels> waiting;  // for those before them
  std::size_t next = 0;
  for_each_index(first.plan.drawings.size(), jobs, [&](std::size_t drawing, int worker) {
    throw_if_interrupted();
    Pixels picture;
    if (runs.size() == 1) {
      picture = sketch_drawing(runs.front(), drawing, worker, resources);
    } else {
      picture = {size, std::vector<std::uint8_t>(std::size_t{3} * static_cast<std::size_t>(size.width_px) *
                                                 static_cast<std::size_t>(size.height_px))};
      int left_px = 0;
      for (SketchRun& run : runs) {
        const Pixels part = sketch_drawing(run, drawing, worker, resources);
        paste_pixels(picture, part, left_px, 0);
        left_px += part.size.width_px;
      }
    }
    const std::lock_guard lock(order);
    waiting.emplace(drawing, std::move(picture));
    for (auto ready = waiting.begin(); ready != waiting.end() && ready->first == next; ++next) {
      taken(ready->first, ready->second);
      ready = waiting.erase(ready);
    }
  });
}

std::string build_sketch_manifest(const Clip& clip) {
  nlohmann::ordered_json manifest;
  manifest["mien"] = MIEN_VERSION;
  manifest["name"] = clip.files.name;
  manifest["title"] = clip.spec.title;
  manifest["quality"] = "sketch";
  manifest["clip"] = find_video_path(clip).filename().string();
  manifest["fps"] = clip.spec.clip.fps;
  manifest["frames"] = clip.plan.frames.size();
  manifest["drawings"] = clip.plan.drawings.size();
  manifest["width"] = clip.spec.render.width_px;
  manifest["height"] = clip.spec.render.height_px;
  return manifest.dump(1) + "\n";
}

SketchVideo start_sketch_video(const Clip& clip) {
  const RenderSpec& render = clip.spec.render;
  return {&clip, start_video({render.width_px, render.height_px}, clip.spec.clip.fps, find_video_path(clip))};
}

void append_drawing(SketchVideo& video, std::size_t drawing, const Pixels& picture) {
  const FramePlan& plan = video.clip->plan;
  for (std::size_t i = 0; i < plan.frames.size(); ++i)
    if (plan.drawn_as[i] == plan.drawings[drawing]) append_frame(video.stream, picture);
}

}  // namespace mien

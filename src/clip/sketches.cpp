#include "clip/sketches.hpp"

#include <cmath>
#include <map>
#include <mutex>

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
  std::string start;  // the text of `stage`
  SketchStage stage;
  std::vector<KeptLook> looks;
};

void set_stage(const Clip& clip, const std::string& include, const FrameStart& start, SketchBench& bench) {
  std::string text;
  append_povray_start(text, start);
  if (text == bench.start) return;
  bench.stage = build_sketch_stage(include, text, clip.spec.render.width_px, clip.spec.render.height_px);
  bench.start = std::move(text);
  bench.looks.clear();
}

const SketchLook& find_look(const Model& model, SketchBench& bench) {
  for (const KeptLook& kept : bench.looks)
    if (kept.model == &model) return kept.look;
  bench.looks.push_back({&model, build_sketch_look(model, bench.stage.names)});
  return bench.looks.back().look;
}

Pixels sketch_moment(const Clip& clip, const std::string& include, const FrameStart& start, const Heads& heads,
                     double time_s, const std::optional<Pose>& pose, SketchBench& bench) {
  const RenderSpec& render = clip.spec.render;
  set_stage(clip, include, start, bench);
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
  return trace_sketch(bench.stage, figures, {render.width_px, render.height_px}, bench.desk);
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
  sketched.picture = sketch_moment(clip, build_include(clip, resources),
                                   build_start(clip, cast, still.camera, still.stage), heads, still.time_s,
                                   still.pose, bench);
  sketched.held = list_still_held(heads, still);
  return sketched;
}

void sketch_drawings(const Clip& clip, const Cast& cast, const Resources& resources, int jobs,
                     const SketchTaken& taken) {
  const std::vector<int>& drawings = clip.plan.drawings;
  const DrawingGroups groups = group_drawings(clip);
  const std::string include = build_include(clip, resources);
  SharedCache<Heads> cache(static_cast<std::size_t>(jobs) + 1);
  std::vector<SketchBench> benches(static_cast<std::size_t>(jobs));
  std::vector<std::shared_ptr<const Heads>> at_work(static_cast<std::size_t>(jobs));
  std::mutex order;
  std::map<std::size_t, Pixels> waiting;  // for those before them
  std::size_t next = 0;
  for_each_index(drawings.size(), jobs, [&](std::size_t drawing, int worker) {
    throw_if_interrupted();
    const double time_s = compute_drawing_time_s(clip.spec.clip, drawings[drawing] - 1);
    const std::size_t group = groups.group[drawing];
    auto heads = share_thing<Heads>(cache, group, [&] {
      return build_heads(clip, cast, compute_drawing_time_s(clip.spec.clip, drawings[groups.first[group]] - 1),
                         resources.heads);
    });
    SketchBench& mine = benches[static_cast<std::size_t>(worker)];
    // A look is known by where its model lies: models of heads that have gone must not be taken for new ones.
    auto& held = at_work[static_cast<std::size_t>(worker)];
    if (held != heads) mine.looks.clear();
    held = heads;
    const FrameStart start = build_start(clip, cast, sample_performance(clip.performance, time_s).camera,
                                         sample_stage(clip.spec.clip, time_s));
    Pixels picture = sketch_moment(clip, include, start, *heads, time_s, {}, mine);
    const std::lock_guard lock(order);
    waiting.emplace(drawing, std::move(picture));
    for (auto first = waiting.begin(); first != waiting.end() && first->first == next; ++next) {
      taken(first->first, first->second);
      first = waiting.erase(first);
    }
  });
}

}  // namespace mien

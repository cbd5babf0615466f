#include "live/view_store.hpp"

#include <algorithm>

#include "timeline/stage_track.hpp"

namespace mien {

namespace {

constexpr std::size_t kMostScenes = 6;   // some ten megabytes each, with their figures
constexpr std::size_t kMostStages = 64;  // of a clip whose camera moves each drawing has its own

std::shared_ptr<const SketchStage> find_stage(ViewStore& store, const std::string& include,
                                              const FrameStart& start, const RenderSpec& render) {
  std::string text;
  append_povray_start(text, start);
  const std::string stage_text = include + text;
  {
    const std::lock_guard lock(store.mutex);
    const auto found = std::ranges::find(store.stages, stage_text, &ViewStage::text);
    if (found != store.stages.end()) {
      store.stages.splice(store.stages.begin(), store.stages, found);
      return store.stages.front().stage;
    }
  }
  auto stage = std::make_shared<const SketchStage>(
      build_sketch_stage(include, text, render.width_px, render.height_px));
  const std::lock_guard lock(store.mutex);
  store.stages.push_front({stage_text, stage});
  if (store.stages.size() > kMostStages) store.stages.pop_back();
  return stage;
}

bool shows(const ViewScene& scene, const ViewMoment& moment) {
  return scene.include == moment.include && scene.heads->figures == moment.heads->figures;
}

}  // namespace

ViewMoment find_moment(LiveShelf& shelf, ViewStore& store, LiveDocument& document, double time_s,
                       const std::optional<CameraKey>& camera) {
  const Clip& clip = *document.clip;
  ViewMoment moment;
  moment.time_s = time_s;
  moment.cast = find_cast(shelf, document);
  moment.heads = find_heads(shelf, document, time_s);
  const CameraKey key = camera ? *camera : sample_performance(clip.performance, time_s).camera;
  moment.start = build_start(clip, *moment.cast, key, sample_stage(clip.spec.clip, time_s));
  moment.include =
      build_povray_stage("", clip.spec.render, shelf.resources->stock.templates, list_sets(clip.spec.clip));
  moment.stage = find_stage(store, moment.include, moment.start, clip.spec.render);
  return moment;
}

ScenePointer find_scene(ViewStore& store, const ViewMoment& moment) {
  {
    const std::lock_guard lock(store.mutex);
    const auto found =
        std::ranges::find_if(store.scenes, [&](const ScenePointer& kept) { return shows(*kept, moment); });
    if (found != store.scenes.end()) {
      store.scenes.splice(store.scenes.begin(), store.scenes, found);
      return store.scenes.front();
    }
  }
  auto scene = std::make_shared<ViewScene>();
  scene->include = moment.include;
  scene->heads = moment.heads;
  for (const FigurePointer& figure : moment.heads->figures) {
    const Model& model = figure->get_drawn_model();
    scene->models.push_back(build_view_model(model, build_sketch_look(model, moment.stage->names)));
  }
  const std::lock_guard lock(store.mutex);
  for (const ScenePointer& kept : store.scenes)  // somebody else was quicker
    if (shows(*kept, moment)) return kept;
  scene->key = "m" + std::to_string(++store.count);
  store.scenes.push_front(scene);
  if (store.scenes.size() > kMostScenes) store.scenes.pop_back();
  return scene;
}

BorrowedBuffers::BorrowedBuffers(ViewStore& from) : store(from) {
  const std::lock_guard lock(store.mutex);
  if (store.buffers.empty()) {
    buffers = std::make_unique<DrawBuffers>();
  } else {
    buffers = std::move(store.buffers.back());
    store.buffers.pop_back();
  }
}

BorrowedBuffers::~BorrowedBuffers() {
  const std::lock_guard lock(store.mutex);
  store.buffers.push_back(std::move(buffers));
}

}  // namespace mien

#include "clip/trace.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "clip/known_drawings.hpp"
#include "clip/pictures.hpp"
#include "core/pool.hpp"
#include "core/text.hpp"
#include "render/picture.hpp"
#include "render/process.hpp"
#include "render/work_folder.hpp"
#include "timeline/drawings.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kCoarsest = 8;  // drawings from one to the next of the first pass

// Whose frames show one picture, ascending.
using DrawingsByKey = std::map<std::string, std::vector<std::size_t>>;

DrawingsByKey group_by_key(const TraceRun& run) {
  DrawingsByKey drawings;
  for (std::size_t i = 0; i < run.keys.size(); ++i) drawings[run.keys[i]].push_back(i);
  return drawings;
}

fs::path find_shown(const TraceRun& run, std::size_t drawing) {
  const Clip& clip = run.scenes.clip;
  return clip.files.picture(clip.plan.drawings[drawing]);
}

// The frame of a drawing shows its picture; one that does so already is left untouched.
void show_drawing(const TraceRun& run, std::size_t drawing) {
  const fs::path shown = find_shown(run, drawing);
  const std::string& key = run.keys[drawing];
  if (read_picture_key(shown) != key) show_picture(run.store.picture(key), shown);
}

// A frame may have what the store has lost.
void take_back(const TraceRun& run, std::size_t drawing) {
  const fs::path shown = find_shown(run, drawing);
  if (read_picture_key(shown) == run.keys[drawing]) show_picture(shown, run.store.picture(run.keys[drawing]));
}

void open_work(TraceRun& run) {
  if (!run.work) {
    run.work.emplace(run.work_parent.empty() ? run.scenes.clip.files.folder : run.work_parent);
    write_file(run.work->path / kHeadInclude, run.scenes.include);
  }
}

// Where POV-Ray finds the scene.
fs::path find_scene(const TraceRun& run, std::size_t drawing) {
  const Clip& clip = run.scenes.clip;
  return run.work->path / clip.files.scene(clip.plan.drawings[drawing]).filename();
}

bool has_changing_heads(const SceneRun& run) {
  return std::ranges::any_of(run.cast.figures, [](const FigurePointer& figure) { return !figure; });
}

// How many passes have all their drawings, but the last, after which there is no other.
std::size_t count_passes(const CoarseOrder& coarse, const std::vector<bool>& is_there) {
  std::size_t drawing = 0, passes = 0;
  for (; passes + 1 < coarse.ends.size(); ++passes)
    for (; drawing < coarse.ends[passes]; ++drawing)
      if (!is_there[coarse.order[drawing]]) return passes;
  return passes;
}

// What a frame that is missing asks of its clip: its scene before it is traced, and once more where it can be
// tried if it fails.
FrameHooks make_scene_hooks(TraceRun& run, const std::map<int, std::size_t>& drawing_of) {
  FrameHooks hooks;
  hooks.prepare = [&](const FrameJob& job) {
    if (!fs::exists(job.scene)) write_scene(build_scene(run.scenes, drawing_of.at(job.number), 0), job.scene);
  };
  hooks.failed = [&](const FrameJob& job) {
    write_file(run.scenes.clip.files.scenes() / kHeadInclude, run.scenes.include);
    write_scene(build_scene(run.scenes, drawing_of.at(job.number), 0), job.told_scene);
  };
  return hooks;
}

FrameJob make_frame_job(const TraceRun& run, std::size_t drawing) {
  const Clip& clip = run.scenes.clip;
  const int frame = clip.plan.drawings[drawing];
  return {frame, find_scene(run, drawing), run.store.picture(run.keys[drawing]), run.keys[drawing],
          clip.files.scene(frame)};
}

}  // namespace

PictureStore find_store(const Clip& clip, std::uintmax_t most_bytes) {
  return {clip.files.folder / kStoreFolder, most_bytes};
}

CoarseOrder order_coarsely(const FramePlan& plan, int poster_drawing) {
  CoarseOrder coarse;
  const std::size_t count = plan.drawings.size();
  std::vector<bool> is_taken(count, false);
  const auto take = [&](std::size_t drawing) {
    if (!is_taken[drawing]) coarse.order.push_back(drawing);
    is_taken[drawing] = true;
  };
  const auto poster = std::ranges::find(plan.drawings, poster_drawing);
  if (poster != plan.drawings.end()) take(static_cast<std::size_t>(poster - plan.drawings.begin()));
  for (std::size_t step = kCoarsest; step > 0; step /= 2) {
    for (std::size_t drawing = 0; drawing < count; drawing += step) take(drawing);
    coarse.ends.push_back(coarse.order.size());
  }
  return coarse;
}

void compute_keys(TraceRun& run, int jobs, const SceneWritten& computed) {
  const Clip& clip = run.scenes.clip;
  const std::size_t count = clip.plan.drawings.size();
  run.keys.resize(count);
  const std::vector<std::string> origins = list_origins(run.scenes);
  run.known = read_known_drawings(run.store);
  const bool is_kept = run.keeps_scenes && has_changing_heads(run.scenes);
  if (is_kept) open_work(run);
  for_each_index(count, jobs, [&](std::size_t turn, int worker) {
    throw_if_interrupted();
    const std::size_t drawing = run.scenes.groups.order[turn];
    if (const auto found = run.known.find(origins[drawing]); found != run.known.end()) {
      run.keys[drawing] = found->second;
      return computed(clip.plan.drawings[drawing]);
    }
    run.keys[drawing] = compute_scene_key(run.scenes, drawing, worker);
    if (is_kept && !has_picture(run.store, run.keys[drawing]))
      write_scene(build_scene(run.scenes, drawing, worker), find_scene(run, drawing));
    computed(clip.plan.drawings[drawing]);
  });
  for (std::size_t i = 0; i < count; ++i) run.known[origins[i]] = run.keys[i];
}

void find_pictures(TraceRun& run) {
  run.is_there.assign(run.keys.size(), false);
  for (const auto& [key, drawings] : group_by_key(run)) {
    bool is_there = has_picture(run.store, key);
    for (std::size_t i = 0; !is_there && i < drawings.size(); ++i) {
      take_back(run, drawings[i]);
      is_there = has_picture(run.store, key);
    }
    for (const std::size_t drawing : drawings) run.is_there[drawing] = is_there;
  }
}

std::size_t count_missing(const TraceRun& run) {
  std::size_t count = 0;
  for (const auto& [key, drawings] : group_by_key(run)) count += run.is_there[drawings.front()] ? 0 : 1;
  return count;
}

void trace_pictures(TraceRun& run, int jobs, const TraceHooks& hooks) {
  const Clip& clip = run.scenes.clip;
  const FramePlan& plan = clip.plan;
  const DrawingsByKey by_key = group_by_key(run);
  const CoarseOrder coarse = order_coarsely(plan, find_poster_drawing(clip));
  std::vector<FrameJob> frames;
  std::map<int, std::size_t> drawing_of;  // by frame
  std::set<std::string> begun;            // pictures that are to be traced
  for (const std::size_t drawing : coarse.order) {
    const int frame = plan.drawings[drawing];
    drawing_of[frame] = drawing;
    if (run.is_there[drawing]) {
      show_drawing(run, drawing);
      hooks.done(frame, true);
    } else if (begun.insert(run.keys[drawing]).second) {
      open_work(run);
      frames.push_back(make_frame_job(run, drawing));
    }
  }
  std::size_t passes = count_passes(coarse, run.is_there);
  FrameHooks traced = make_scene_hooks(run, drawing_of);
  traced.done = [&](int frame, bool was_kept) {
    std::error_code ignored;
    const std::size_t first = drawing_of.at(frame);
    fs::remove(find_scene(run, first), ignored);
    for (const std::size_t drawing : by_key.at(run.keys[first])) {
      show_drawing(run, drawing);
      run.is_there[drawing] = true;
      hooks.done(plan.drawings[drawing], was_kept || drawing != first);
    }
    const std::size_t ended = count_passes(coarse, run.is_there);
    if (ended > passes && hooks.pass_ended) hooks.pass_ended(run.is_there);
    passes = ended;
  };
  if (!frames.empty()) render_frames(frames, list_settings(clip.spec.render, {run.work->path}, jobs), traced);
  repeat_pictures(clip);
  trim_store(run.store, {run.keys.begin(), run.keys.end()});
  write_known_drawings(run.store, run.known, run.keys);
}

void trace_into_store(TraceRun& run, int jobs, const FrameDone& done) {
  const Clip& clip = run.scenes.clip;
  std::vector<FrameJob> frames;
  std::map<int, std::size_t> drawing_of;  // by frame
  std::set<std::string> begun;            // pictures that are to be traced
  for (std::size_t drawing = 0; drawing < run.keys.size(); ++drawing) {
    const int frame = clip.plan.drawings[drawing];
    drawing_of[frame] = drawing;
    if (begun.contains(run.keys[drawing]) || has_picture(run.store, run.keys[drawing])) {
      done(frame, true);
      continue;
    }
    open_work(run);
    begun.insert(run.keys[drawing]);
    frames.push_back(make_frame_job(run, drawing));
  }
  if (frames.empty()) return write_known_drawings(run.store, run.known, run.keys);
  FrameHooks traced = make_scene_hooks(run, drawing_of);
  traced.done = [&](int frame, bool was_kept) {
    std::error_code ignored;
    fs::remove(find_scene(run, drawing_of.at(frame)), ignored);
    done(frame, was_kept);
  };
  RenderSettings settings = list_settings(clip.spec.render, {run.work->path}, jobs);
  settings.work_parent = run.work->path;
  render_frames(frames, settings, traced);
  write_known_drawings(run.store, run.known, run.keys);
}

}  // namespace mien

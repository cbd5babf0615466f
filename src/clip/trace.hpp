// From a clip's drawings to their pictures: those that the store has are shown, the others traced.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "clip/known_drawings.hpp"
#include "clip/scenes.hpp"
#include "render/driver.hpp"
#include "render/picture_store.hpp"
#include "render/work_folder.hpp"

namespace mien {

// Of a clip's folder.
inline constexpr const char* kStoreFolder = "store";

// The store of a clip's pictures, of no more than `most_bytes` beyond those that the clip shows.
PictureStore find_store(const Clip& clip, std::uintmax_t most_bytes = PictureStore::kStoreBytes);

// The plan's drawings in the order in which a clip can be judged earliest: the poster's, every eighth, every
// fourth, every second, and those between. `ends` is how many of `order` each of these passes comes to.
struct CoarseOrder {
  std::vector<std::size_t> order;  // places in plan.drawings
  std::vector<std::size_t> ends;
};
CoarseOrder order_coarsely(const FramePlan& plan, int poster_drawing);

// One clip on its way to pictures. What it was made of must outlive it.
struct TraceRun {
  SceneRun scenes;
  PictureStore store;
  std::vector<std::string> keys;    // of the pictures of the plan's drawings: of compute_keys or write_scenes
  KnownDrawings known = {};         // of compute_keys: those that the store knew, and the plan's
  std::vector<bool> is_there = {};  // of each drawing: the store has its picture, whatever frame it was of
  std::optional<WorkFolder> work = {};     // for scenes on their way to POV-Ray, once there are any
  std::filesystem::path work_parent = {};  // where it is made; empty: in the clip's folder
  bool keeps_scenes = true;                // see compute_keys
};

// Computes every drawing that the store does not know yet to learn what its picture is known by. Of heads
// that change, which cost more than a drawing, the scenes that are missing are kept for trace_pictures unless
// `keeps_scenes` is false; else nothing is written. Told the frame of each, from any thread.
void compute_keys(TraceRun& run, int jobs, const SceneWritten& computed);

// Which of the pictures that `keys` names the store has; those that only a frame has go back into it.
void find_pictures(TraceRun& run);

// How many pictures are to be traced: drawings that are the same are one.
std::size_t count_missing(const TraceRun& run);

// Told of each drawing of the plan in any order.
struct TraceHooks {
  FrameDone done;
  std::function<void(const std::vector<bool>& is_there)> pass_ended = {};  // of CoarseOrder, but the last
};

// Has POV-Ray trace what is missing and gives every frame asked for its picture, as soon as it is there.
// Scenes are written just before they are traced and removed after it; of a frame that fails the scene stays
// in the clip's scenes/, where the message says how to try it. Throws as render_frames does.
void trace_pictures(TraceRun& run, int jobs, const TraceHooks& hooks);

// The same for one of several who fill the store at once: no frame is given a picture, nothing is taken out
// of the store, and all that is not a picture yet lies in the run's own work folder.
void trace_into_store(TraceRun& run, int jobs, const FrameDone& done);

}  // namespace mien

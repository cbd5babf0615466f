// A clip's pictures without POV-Ray: what its scenes would hold, traced by sketch/.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "clip/scenes.hpp"
#include "render/picture.hpp"
#include "render/video.hpp"
#include "render/work_folder.hpp"
#include "sketch/lettering.hpp"

namespace mien {

// What a still shows, and what limits held in it.
struct SketchedStill {
  Pixels picture;
  std::vector<Held> held;
};
SketchedStill sketch_still(const Clip& clip, const Cast& cast, const Still& still,
                           const Resources& resources);

// A clip with its cast: one, or several of one plan that are shown side by side.
struct Staged {
  const Clip* clip = nullptr;
  const Cast* cast = nullptr;
};

// Told of each drawing, in the order of time, by one thread at a time: its place in the plan's `drawings`.
using SketchTaken = std::function<void(std::size_t drawing, const Pixels& picture, bool was_kept)>;

// Pictures by what their pixels depend on, so that none is traced twice. Those of the newest call are kept,
// as many as there is room for.
struct SketchStore {
  std::map<std::string, std::shared_ptr<const Pixels>> pictures;
  std::size_t most_bytes = std::size_t{1} << 29;
};

// Every drawing of the plan, on up to `jobs` threads; the same pixels whatever their number. With a store
// only those that it has not are traced; it has all of them then and no others.
void sketch_drawings(const std::vector<Staged>& parts, const Resources& resources, int jobs,
                     SketchStore* store, const SketchTaken& taken);

// What was made, for other programs: the text of manifest_sketch.json.
std::string build_sketch_manifest(const Clip& clip);

// One video on its way: the plan's frames (from 0) that it shows, and how many of them it has.
struct SketchVideo {
  VideoStream stream;
  std::vector<std::size_t> shown;
  std::size_t done = 0;
};

// Joins drawings, as sketch_drawings gives them, to the videos of the frames asked for. A picture that is
// shown again after others waits on the disk till then. What it was made of must outlive it.
struct SketchVideos {
  const Clip* clip = nullptr;
  const Letters* letters = nullptr;
  std::vector<SketchVideo> videos;
  std::vector<std::size_t> drawing_of;  // of each of the plan's frames
  std::vector<bool> is_kept;            // of each drawing: it is shown again
  std::unique_ptr<WorkFolder> kept;
};
SketchVideos start_sketch_videos(const Clip& clip, const Letters& letters);
void append_drawing(SketchVideos& videos, std::size_t drawing, const Pixels& picture);
void finish_sketch_videos(SketchVideos& videos);

}  // namespace mien

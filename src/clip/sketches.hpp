// A clip's pictures without POV-Ray: what its scenes would hold, traced by sketch/.
#pragma once

#include <functional>
#include <vector>

#include "clip/scenes.hpp"
#include "render/picture.hpp"

namespace mien {

// What a still shows, and what limits held in it.
struct SketchedStill {
  Pixels picture;
  std::vector<Held> held;
};
SketchedStill sketch_still(const Clip& clip, const Cast& cast, const Still& still,
                           const Resources& resources);

// Told of each drawing, in the order of time, by one thread at a time: its place in the plan's `drawings`.
using SketchTaken = std::function<void(std::size_t drawing, const Pixels& picture)>;

// Every drawing of the plan, on up to `jobs` threads; the same pixels whatever their number.
void sketch_drawings(const Clip& clip, const Cast& cast, const Resources& resources, int jobs,
                     const SketchTaken& taken);

}  // namespace mien

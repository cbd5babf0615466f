// From a planned clip to its scenes: heads posed, placed and written.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "clip/staging.hpp"
#include "render/driver.hpp"

namespace mien {

// Told the frame of each scene as it is written; from any thread.
using SceneWritten = std::function<void(int frame)>;

// What was written of a drawing.
struct WrittenScene {
  std::string key;                // of its picture: a hash of all that its pixels depend on
  std::vector<TracedFile> files;  // that the key speaks of
};

// Writes head.inc with all parts that never change, a file of parts for each head of those who change, a
// scene for each frame asked for (a held drawing includes the one it repeats) and the .ini. Returns what was
// written of each drawing of the plan. However long the clip, few heads are in memory at once.
std::vector<WrittenScene> write_scenes(const Clip& clip, const Cast& cast, const Resources& resources,
                                       int jobs, const SceneWritten& written);

// A still's scene as one text, which includes a head.inc with the other text, and what limits hold back in
// it: not of `pose`.
struct StillScene {
  std::string text, include;
  std::vector<Held> held;
};
StillScene build_still_scene(const Clip& clip, const Cast& cast, const Still& still,
                             const Resources& resources);

}  // namespace mien

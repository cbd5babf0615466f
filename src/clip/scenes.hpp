// From a planned clip to its scenes: heads posed, placed and written.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "clip/staging.hpp"
#include "core/shared_cache.hpp"

namespace mien {

// The file of all that never changes in a clip, beside its scenes.
inline constexpr const char* kHeadInclude = "head.inc";

// The buffers of one thread; contents mean nothing between calls.
struct SceneBuffers {
  DrawBuffers draw;
  std::vector<Drawing> drawings;  // one an actor
  std::string text;
};

// The heads of one group of drawings, and those parts of them that are not in head.inc.
struct DrawnHeads {
  Heads heads;
  std::string parts;                        // POV-Ray's text; empty if there are none
  std::string include;                      // the file that holds it: "h0007.inc"; or empty
  std::string key;                          // a hash of it; or empty
  std::vector<std::vector<bool>> castable;  // of each figure's drawn model
};

// Puts the pictures that lie over a model's parts beside its scene, as PNG without transparency.
void write_part_pictures(const Model& model, const std::filesystem::path& folder);
void write_part_picture(const PartPicture& picture, const std::filesystem::path& folder);

// A clip's scenes on their way to text, in any order. However long the clip, few heads are in memory at once.
// Neither copied nor moved; what it was made of must outlive it.
struct SceneRun {
  SceneRun(const Clip& clip_, const Cast& cast_, const Resources& resources_, int jobs);

  const Clip& clip;
  const Cast& cast;
  const Resources& resources;
  std::string include;  // the text of head.inc
  std::string stage;    // the same without parts
  std::string key;      // of it and of how pictures are rendered
  DrawingGroups groups;
  SharedCache<DrawnHeads> heads;
  std::vector<SceneBuffers> buffers;  // one a thread
};

// The scene of one drawing of the plan.
struct SceneText {
  std::string text;
  std::string key;  // of its picture: a hash of all that its pixels depend on, whatever its frame is called
  std::shared_ptr<const DrawnHeads> heads;
};

// `worker` (below the run's jobs) is nobody else's during the call.
SceneText build_scene(SceneRun& run, std::size_t drawing, int worker);

// Its key alone, sooner: the casters of its shadows (sketch/casters) follow from the rest.
std::string compute_scene_key(SceneRun& run, std::size_t drawing, int worker);

// Its file, and beside it that of its heads' parts if they have one.
void write_scene(const SceneText& scene, const std::filesystem::path& path);

// Told the frame of each scene as it is written; from any thread.
using SceneWritten = std::function<void(int frame)>;

// Writes head.inc with all parts that never change, a file of parts for each head of those who change, a
// scene for each frame asked for (a held drawing includes the one it repeats) and the .ini. Returns the keys
// of the pictures of the plan's drawings. However long the clip, few heads are in memory at once.
std::vector<std::string> write_scenes(const Clip& clip, const Cast& cast, const Resources& resources,
                                      int jobs, const SceneWritten& written);

// A still's scene as one text, which includes a head.inc with the other text, and what limits hold back in
// it: not of `pose`.
struct StillScene {
  std::string text, include;
  std::vector<std::shared_ptr<const PartPicture>> pictures;  // that lie over parts of it
  std::vector<Held> held;
};
StillScene build_still_scene(const Clip& clip, const Cast& cast, const Still& still,
                             const Resources& resources);

}  // namespace mien

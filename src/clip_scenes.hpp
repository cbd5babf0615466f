// From a planned clip to its scenes: heads are built, posed, placed and written.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clip.hpp"
#include "clip_view.hpp"
#include "frames/figure.hpp"

namespace mien {

// What all scenes of a clip share.
struct Cast {
  // One an actor; empty for one whose head changes, which is built anew for each head it has.
  std::vector<std::shared_ptr<const Figure>> figures;
  Framing framing;
};

// Builds every head that does not change, and of the others those at their keys: their sizes make the
// framing. Their mistakes, and those of the heads between the keys, are told before anything is written.
// Throws InputError.
Cast build_cast(const Clip& clip, const std::filesystem::path& data_folder);

// What everybody does, with the eyes of the heads that they have (at the beginning, if they change).
std::vector<Performance> list_performances(const Clip& clip, const Cast& cast,
                                           const std::filesystem::path& data_folder);

// Writes head.inc with all parts that never change, a file of parts for each head of those who change, a
// scene for each frame asked for (a held drawing includes the one it repeats) and the .ini. Returns for each
// drawing of the plan the key of its picture: a hash of all that its pixels depend on. However long the clip,
// few heads are in memory at once.
std::vector<std::string> write_scenes(const Clip& clip, const Cast& cast, const Options& options,
                                      const std::filesystem::path& data_folder);

// One picture: the heads of a time, what they do, and the camera.
struct Still {
  double time_s = 0;
  std::optional<Pose> pose;  // instead of what they do then
  CameraKey camera;
  StageMoment stage;
};

// Its scene as one text, which includes a head.inc with the other text, and what limits hold back in it: not
// of `pose`.
struct StillScene {
  std::string text, include;
  std::vector<Held> held;
};
StillScene build_still_scene(const Clip& clip, const Cast& cast, const Still& still,
                             const std::filesystem::path& data_folder);

}  // namespace mien

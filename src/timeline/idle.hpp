// What a face does of itself between and on top of its keys: it leans, drifts, looks and blinks.
#pragma once

#include <vector>

#include "timeline/asymmetry.hpp"
#include "timeline/blinks.hpp"
#include "timeline/drift.hpp"
#include "timeline/gaze.hpp"

namespace mien {

struct Idle {
  Asymmetry asymmetry;
  Drift drift;
  Gaze gaze;
  EyeRig eyes;                // the plain adult's unless another head's was measured
  std::vector<Blink> blinks;  // by their times: asked for and, seeded, the clip's own
};

// Everything off that the clip does not ask for. Its tracks must be sorted.
Idle build_idle(const ClipSpec& clip);

// Gaze and blinks at `time_s`, in this order and after the drift: the eyes make up for where the head has
// drifted, and the lids come over all.
void add_looks_and_blinks(const Idle& idle, const EyeRig& eyes, double time_s, const CameraKey& camera,
                          const TurnKey& turn, Pose& pose);

}  // namespace mien

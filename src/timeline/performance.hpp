// When: the tracks of a clip, sampled at a time. Knows no geometry.
#pragma once

#include <vector>

#include "config/clip_spec.hpp"
#include "timeline/idle.hpp"

namespace mien {

// What the figure and the camera do at one moment.
struct Moment {
  Pose pose;
  TurnKey turn;
  CameraKey camera;
};

// A clip ready to be sampled: keys sorted, blinks placed.
struct Performance {
  ClipSpec clip;
  Idle idle;  // what the face does by itself
};

Performance build_performance(const ClipSpec& clip);

// Exactly a key's values at a key's time (what `idle` adds apart), the first key's before it and the last
// key's after it.
Moment sample_performance(const Performance& performance, double time_s);

// The time that frame `frame` (from 0) shows: its drawing's first frame, over fps.
double find_drawing_time_s(const ClipSpec& clip, int frame);

}  // namespace mien

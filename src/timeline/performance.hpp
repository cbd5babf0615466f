// When: the tracks of a clip, sampled at a time. Knows no geometry.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "config/clip_spec.hpp"
#include "timeline/idle.hpp"
#include "timeline/layers.hpp"

namespace mien {

// What the figure and the camera do at one moment.
struct Moment {
  Pose pose;
  TurnKey turn;
  CameraKey camera;
  bool is_there = true;                // has entered and not left
  std::optional<PlaceKey> place = {};  // where the actor stands now; empty: where it stood first
};

// A clip ready to be sampled.
struct Performance {
  ClipSpec clip;  // its keys sorted
  Idle idle;      // what the face does by itself
  std::shared_ptr<const Layers> layers;
};

Performance build_performance(const ClipSpec& clip);

// The clip at a time, which counts in whole ticks (core/ticks.hpp). Exactly a key's values at a key's time
// (cues and what `idle` adds apart), the first key's before it and the last key's after it; nothing is past
// its limits, times the reach of those who ask. A pure function: any number of threads may ask.
Moment sample_performance(const Performance& performance, double time_s);

// The same in steps, for who needs what lies between. Of a face that keys and cues ask for at a time
// (sample_layers): its pose within its limits; the moment of it but for looks and blinks, which
// add_looks_and_blinks adds.
Pose hold_face(const FaceState& asked);
Moment sample_unlooking(const Performance& performance, double time_s, const FaceState& asked);

// The time that frame `frame` (from 0) shows: its drawing's first frame, over fps.
double compute_drawing_time_s(const ClipSpec& clip, int frame);

// A move's value within its limits times `reach`; limits that are ends of the body (find_stop) are not
// lifted.
double hold_value(std::size_t move, double value, double reach);

}  // namespace mien

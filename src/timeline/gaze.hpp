// Where the eyes look: from a place in the room to the values of the eyeballs, and how they get there.
#pragma once

#include <vector>

#include "config/clip_spec.hpp"

namespace mien {

// How far an eyeball turns at value 1 and -1, degrees.
struct EyeReach {
  double left_deg = 30, right_deg = 30;  // to the character's sides
  double up_deg = 25, down_deg = 30;
};

// One head's eyes and the camera that looks at them, as far as a gaze must know. The default is the plain
// adult's; clip.hpp measures another head's.
struct EyeRig {
  glm::dvec3 left_mm{31.5, 0, 69.5};  // the left eyeball's centre; the right one's is its mirror
  glm::dvec3 pivot_mm{0, -62, -14};   // what the head turns about
  EyeReach left, right;
  glm::dvec3 camera_target_mm{0, -17, 0};  // what the camera looks at
  double camera_mm = 1270;                 // from there to the camera, at distance 1
};

// A move of the eyes from one thing to another takes 21 ms and 2.2 ms for each degree (the main sequence:
// face-facts 3.4): one to three frames at 24 a second.
double compute_saccade_s(double amplitude_deg);

// A small move of the eyes about what they look at.
struct Fixation {
  double at_s = 0;  // there from here on
  double side_deg = 0, up_deg = 0;
};

// `gaze` ready to be sampled.
struct Gaze {
  GazeSpec spec;                    // keys by time
  std::vector<Fixation> fixations;  // by time, one at least if it wanders
};

Gaze build_gaze(const GazeSpec& spec, double length_s);

// Adds the gaze at `time_s` to the eyes of `pose`, so that what an expression says of the eyes leans off it.
// Both eyes leave and arrive together, quick at once and never turning back; each aims at the place from its
// own centre; a turned head is made up for. Values are held within -1..1. Does nothing without a gaze.
void aim_eyes(const Gaze& gaze, const EyeRig& rig, double time_s, const TurnKey& turn,
              const CameraKey& camera, Pose& pose);

// What the keys of a gaze ask of the eyes past their reach, in fractions of it: the eyes rest at a key's
// place and would have to turn further. None on the way between two keys, and none of `wander`.
std::vector<Held> list_held_looks(const Gaze& gaze, const EyeRig& rig, double time_s, const TurnKey& turn,
                                  const CameraKey& camera, const Pose& pose);

// A move so large that the lids may hide it.
struct Shift {
  double at_s = 0;  // its middle
  double amplitude_deg = 0;
};

// The moves of the eyes, and those of the head that are quick, by time.
std::vector<Shift> list_shifts(const GazeSpec& gaze, const std::vector<TurnKey>& turn,
                               const std::vector<CameraKey>& camera);

}  // namespace mien

// The clip of a file as plain values: what moves when. spec.hpp holds the rest of the file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "config/areas.hpp"
#include "config/idle_spec.hpp"
#include "config/ledger.hpp"

namespace mien {

enum class Easing { linear, in, out, in_out, hold };

// One key of the performance. The pose is what `express`, `strength` and `areas` come to.
struct PoseKey {
  double at_s = 0;
  Easing ease = Easing::in_out;  // how the way from the key before to this one is gone
  Pose pose;
  std::string label;  // "smile 0.8": for messages and charts
  double reach = 1;   // as of an expression
  std::vector<Held> held = {};
  Place place = {};  // in the file; nothing for a key that mien adds
};

struct CameraKey {
  double at_s = 0;
  Easing ease = Easing::in_out;
  double angle_deg = 0;   // about the head, + shows more of the character's left side
  double height_deg = 0;  // + looks down from above
  double distance = 1;    // 1 frames the whole bust at any picture shape; 0.5 is half as far
};

// A neck's ways to each side.
inline constexpr double kMaxTurn_deg = 60, kMaxNod_deg = 40, kMaxTilt_deg = 30;

struct TurnKey {
  double at_s = 0;
  Easing ease = Easing::in_out;
  double turn_deg = 0;  // head to the character's left (+)
  double nod_deg = 0;   // chin down (+)
  double tilt_deg = 0;  // crown toward the character's left shoulder (+)
};

struct ClipSpec {
  int fps = 24;
  int draw = 1;                   // each drawing is held for this many frames: ones, twos, threes
  std::vector<PoseKey> keys;      // by time, at least one: a missing list is one neutral key at 0 s
  std::vector<CameraKey> camera;  // by time, at least one
  std::vector<TurnKey> turn;      // by time, at least one
  std::vector<double> blinks_s;   // blinks asked for at exact times (their shut moment)
  BlinkSpec blink;
  GazeSpec gaze;
  DriftSpec drift;
  AsymmetrySpec asymmetry;
  double length_s = 0;  // `length:`, else the time of the last key of any track
};

// The number of frames of the clip: one at 0 s and one each 1/fps after it, up to and including `length_s`
// rounded to the frame; at least 1. 3 s at 24 frames a second are 72 frames: the frame at 3 s would be the
// first of the next second and is left out, unless the clip is a single moment.
int count_frames(const ClipSpec& clip);

}  // namespace mien

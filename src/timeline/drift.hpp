// Nobody holds quite still: a slow seeded drift of the head and the brows, and breath.
#pragma once

#include <array>
#include <vector>

#include "config/clip_spec.hpp"

namespace mien {

// A sum of slow sines, no frequency a multiple of another's: it never jumps, never repeats within a clip, and
// never leaves -1..1.
struct Sway {
  struct Wave {
    double hz = 0, phase_rad = 0, share = 0;
  };
  std::array<Wave, 5> waves;
};

// The frequencies of a sway. Below, a clip would see a lean and no motion; above, it is a tremor.
inline constexpr double kSlowest_hz = 0.06, kFastest_hz = 0.6;

double sample_sway(const Sway& sway, double time_s);

// What drifts, each on its own. At amount 1 in degrees, or as a share of the limit.
struct Drift {
  double amount = 0;
  Sway turn, nod, tilt, brows_up, brows_turn, corners_up;
  double breath_s = 0;      // how long one takes; 0: none
  double breath_phase = 0;  // of the one at 0 s: 0..1
  Sway depth;               // no two are equally deep
};

// How full the chest is, 0..1, at a share of a breath, 0..1: it fills in two fifths of the time, empties in
// nearly half, and rests at 0.
double sample_breath(double phase);

// What a deep breath lifts the shoulders by. Quiet breath moves the breast bone by 2 to 4 mm; less is not
// seen in a small picture, more is a sigh.
inline constexpr double kBreath_mm = 2.2;

Drift build_drift(const DriftSpec& spec);

// Adds the drift and the breath at `time_s`. What has reached a limit is not driven past it.
void add_drift(const Drift& drift, double time_s, Pose& pose, TurnKey& turn);

}  // namespace mien

// What swings to and fro faster than its drawings can carry.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "config/clip_spec.hpp"

namespace mien {

// The least drawings that a swing to one side and back is made of: with four the eye sees both ends and the
// way between; with fewer each drawing is somewhere else, which is a jitter and no motion.
inline constexpr int kLeastDrawings = 4;

// The quickest swing to and fro of something.
struct Swing {
  double at_s = 0;        // where it begins
  double per_second = 0;  // so often
  double drawings = 0;    // so many drawings each time
  int draw = 1;           // each of so many frames
};

// The swing with the fewest drawings between two times, of a number that leaves and comes back by `least` or
// more each way; `per_second` is 0 if there is none. Looked at in steps of a fraction of a frame.
Swing compute_quickest_swing(const ClipSpec& clip, double from_s, double to_s, double least,
                             const std::function<double(double)>& value);

// Warnings at the formulas of keys and laws, and at the cues whose scripts nod, shake or tremble, that make
// fewer than kLeastDrawings drawings of a swing.
std::vector<Diagnostic> list_jitter(const ClipSpec& clip);

}  // namespace mien

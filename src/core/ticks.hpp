// Time that is exact: whole ticks. Sums of times and frames of any rate meet to the last bit, and an hour
// later they still do.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace mien {

// Divides the frames of 24, 25, 30, 48, 50, 60, 90, 100 and 120 a second and every millisecond: the "flick"
// of M. Horvath (Oculus, 2018). A frame of another rate is rounded to it, by less than 1 ns.
using Ticks = std::int64_t;
inline constexpr Ticks kTicksPerSecond = 705'600'000;

inline constexpr Ticks kEndless = Ticks{1} << 60;  // later than any clip; two of them can be added

// `time_s` may be infinite.
inline Ticks compute_ticks(double time_s) {
  const double ticks = time_s * static_cast<double>(kTicksPerSecond);
  constexpr auto kMost = static_cast<double>(kEndless);
  return ticks >= kMost ? kEndless : ticks <= -kMost ? -kEndless : std::llround(ticks);
}

// The nearest number to the exact time: 16 frames of 48 a second are 8.0 / 24 to the last bit.
inline double compute_seconds(Ticks ticks) {
  return static_cast<double>(ticks) / static_cast<double>(kTicksPerSecond);
}

// When frame `frame` (from 0) begins.
inline Ticks compute_frame_ticks(std::int64_t frame, int fps) {
  return (2 * frame * kTicksPerSecond + fps) / (2 * std::int64_t{fps});
}

}  // namespace mien

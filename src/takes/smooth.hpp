// Noise of a camera's eye taken out of rows, with onsets left where they are.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace mien {

// The One Euro filter (Casiez, Roussel and Vogel, "1 Euro filter", CHI 2012): a low pass whose cutoff rises
// with the speed, so that what rests is calm and what sets out is followed.
struct SmoothSpec {
  double cutoff_hz = 1.5;  // of what rests; lower is calmer and later, 0 leaves the rows as they are
  // Hz for each unit a second: 3 follows a blink (some 10 a second) within a frame. Lower cuts its depth,
  // higher lets noise through wherever something moves.
  double per_speed = 3;
  double speed_cutoff_hz = 4;  // of the speed itself
};

// Each of the `width` columns of `values`, row by row at these rising times, forward and backward, and of
// both the mean: what lags one way leads the other, so that an onset keeps its time.
void smooth_rows(const std::vector<double>& at_s, std::size_t width, const SmoothSpec& spec,
                 std::vector<float>& values);

// The same of angles, which count as a unit each `unit` degrees.
void smooth_angles(const std::vector<double>& at_s, const SmoothSpec& spec, double unit_deg,
                   std::vector<std::array<float, 3>>& angles_deg);

}  // namespace mien

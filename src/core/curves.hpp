// Curves through keys: the slopes with which a cubic passes each.
// Sources: the natural spline as in Yen, "Animation of Human Faces" (1990), section 2.3.1; the curve that
// never passes its keys: M. Steffen, "A simple method for monotonic interpolation in one dimension",
// Astronomy and Astrophysics 239 (1990).
#pragma once

#include <span>
#include <vector>

namespace mien {

// A value a key, `at_s` strictly rising, as many of both; the slopes are a second. Two keys are joined by a
// straight line, one has slope 0.
std::vector<double> compute_spline_slopes(std::span<const double> at_s, std::span<const double> values);
std::vector<double> compute_smooth_slopes(std::span<const double> at_s, std::span<const double> values);

// The cubic from one key to the next, `length_s` later, at a share `u` of the way's time; exact at both ends.
double sample_cubic(double from, double to, double slope_from, double slope_to, double length_s, double u);

}  // namespace mien

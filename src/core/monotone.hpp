// Smooth curves through a table that never overshoot it.
// Source: Fritsch and Carlson, "Monotone piecewise cubic interpolation", SIAM J. Numer. Anal. 17 (1980).
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace mien {

// A table of (x, y), x strictly ascending.
struct MonotoneCurve {
  std::vector<glm::dvec2> knots;
  std::vector<double> slopes;
};

// Throws RunError if there are fewer than two knots or x does not ascend.
MonotoneCurve build_monotone_curve(std::vector<glm::dvec2> knots);

// Between the knots the cubic; outside them the end value, or the straight continuation if `goes_on`.
double sample_curve(const MonotoneCurve& curve, double x, bool goes_on = false);

}  // namespace mien

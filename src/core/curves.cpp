#include "core/curves.hpp"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

struct Ways {
  std::vector<double> length_s, slopes;  // of the straight lines from key to key
};

Ways compute_ways(std::span<const double> at_s, std::span<const double> values) {
  Ways ways;
  for (std::size_t i = 0; i + 1 < at_s.size(); ++i) {
    ways.length_s.push_back(at_s[i + 1] - at_s[i]);
    ways.slopes.push_back((values[i + 1] - values[i]) / ways.length_s.back());
  }
  return ways;
}

// Steffen's slope at an end, beside the way of slope `near` and length `h`, `far` and `g` of the next one.
double compute_end_slope(double near, double h, double far, double g) {
  const double slope = near * (1 + h / (h + g)) - far * h / (h + g);
  if (slope * near <= 0) return 0;
  return std::abs(slope) > 2 * std::abs(near) ? 2 * near : slope;
}

}  // namespace

std::vector<double> compute_spline_slopes(std::span<const double> at_s, std::span<const double> values) {
  const std::size_t count = at_s.size();
  if (count < 2) return std::vector<double>(count, 0);
  const Ways ways = compute_ways(at_s, values);
  // Equal second derivatives at inner keys, none at the ends: three unknown slopes a row, solved from row to
  // row.
  std::vector<double> above(count), right(count);
  above[0] = 0.5;
  right[0] = 1.5 * ways.slopes[0];
  for (std::size_t i = 1; i < count; ++i) {
    const bool is_last = i + 1 == count;
    const double h = ways.length_s[i - 1], g = is_last ? 0 : ways.length_s[i];
    const double below = is_last ? 1 : g, middle = is_last ? 2 : 2 * (h + g);
    const double sum = is_last ? 3 * ways.slopes[i - 1] : 3 * (g * ways.slopes[i - 1] + h * ways.slopes[i]);
    const double pivot = middle - below * above[i - 1];
    above[i] = is_last ? 0 : h / pivot;
    right[i] = (sum - below * right[i - 1]) / pivot;
  }
  for (std::size_t i = count - 1; i-- > 0;) right[i] -= above[i] * right[i + 1];
  return right;
}

std::vector<double> compute_smooth_slopes(std::span<const double> at_s, std::span<const double> values) {
  const std::size_t count = at_s.size();
  if (count < 2) return std::vector<double>(count, 0);
  const auto [h, way] = compute_ways(at_s, values);
  if (count == 2) return {way[0], way[0]};
  std::vector<double> slopes(count, 0);
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const double parabola = (way[i - 1] * h[i] + way[i] * h[i - 1]) / (h[i - 1] + h[i]);
    const double least = std::min({std::abs(way[i - 1]), std::abs(way[i]), 0.5 * std::abs(parabola)});
    slopes[i] = way[i - 1] * way[i] <= 0 ? 0 : std::copysign(2 * least, way[i]);
  }
  const std::size_t last = count - 1;
  slopes[0] = compute_end_slope(way[0], h[0], way[1], h[1]);
  slopes[last] = compute_end_slope(way[last - 1], h[last - 1], way[last - 2], h[last - 2]);
  return slopes;
}

double sample_cubic(double from, double to, double slope_from, double slope_to, double length_s, double u) {
  const double r = 1 - u;
  return r * r * ((1 + 2 * u) * from + u * length_s * slope_from) +
         u * u * ((1 + 2 * r) * to - r * length_s * slope_to);
}

}  // namespace mien

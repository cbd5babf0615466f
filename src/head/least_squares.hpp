// Weighted linear least squares over the points of a cage: rows of (point, weight) and where they should
// come to lie. The normal equations are solved directly.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "head/head.hpp"

namespace mien {

using LinearRow = std::vector<std::pair<std::uint32_t, double>>;  // (point, factor): a linear form

struct LeastSquares {
  struct Equation {
    LinearRow row;
    double weight = 1;
    glm::dvec3 target{0};
  };
  std::vector<Equation> equations;
};

// The points that minimise the sum of weight * |row - target|^2. Throws RunError if some point is in no row.
std::vector<glm::dvec3> solve_least_squares(const LeastSquares& problem, std::size_t point_count);

// The skin's vertex `v` as a form over the cage's points.
LinearRow compute_limit_row(const Surface& surface, std::size_t v);

// The mean of some of the skin's vertices.
LinearRow compute_mean_row(const Surface& surface, const std::vector<std::uint32_t>& vertices,
                           const std::vector<double>& shares);

// The form's value at these points.
glm::dvec3 sample_row(const LinearRow& row, const std::vector<glm::dvec3>& points);

// How far a point's displacement is from the mean of its neighbours', each weighted by 1 / edge length.
std::vector<LinearRow> compute_umbrella_rows(const Cage& cage);

// Makes the right half of `points` the mirror image of the left one, bit for bit; the middle gets x = 0.
void mirror_half(const Cage& cage, std::vector<glm::dvec3>& points);

}  // namespace mien

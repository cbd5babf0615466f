// The place of a triangle that is nearest to a point: Ericson, "Real-Time Collision Detection", 2005, section
// 5.1.5.
#pragma once

#include <glm/glm.hpp>

namespace mien {

// Barycentric coordinates of the place of triangle a b c that is nearest to p; a corner's if the triangle has
// no area.
template <typename Vector>
Vector compute_nearest_barycentric(const Vector& p, const Vector& a, const Vector& b, const Vector& c) {
  using Number = typename Vector::value_type;
  const Vector ab = b - a, ac = c - a, ap = p - a;
  const Number d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const Vector bp = p - b;
  const Number d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const Number vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  const Vector cp = p - c;
  const Number d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const Number vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const Number va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const Number w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }
  const Number sum = va + vb + vc;
  if (!(sum > 0)) return {1, 0, 0};
  return {1 - vb / sum - vc / sum, vb / sum, vc / sum};
}

}  // namespace mien

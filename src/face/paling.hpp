// What is stretched pales: a lip that is drawn out holds less blood. Measured where it shows, along the
// border of the red round the mouth.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "head/head.hpp"

namespace mien {

struct RedBorder {
  std::vector<std::uint32_t> points;  // of the cage, once round the mouth
  double rest_mm = 0;                 // how long it is at rest
};

RedBorder build_red_border(const Cage& cage);

// From 0, at rest or drawn together, to 1, as far as lips go, of the posed cage's points.
double compute_paling(const RedBorder& border, const std::vector<glm::dvec3>& points);

}  // namespace mien

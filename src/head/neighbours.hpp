// Who stands beside whom in the cage.
#pragma once

#include <cstdint>
#include <vector>

#include "head/head.hpp"

namespace mien {

struct PointRing {
  std::vector<std::uint32_t> edges;      // points that share an edge, in no particular order
  std::vector<std::uint32_t> diagonals;  // points across a quad
  bool is_boundary = false;              // lies on an open edge
};

// One ring for each point of the cage. The ring of a mirror image is the mirror image of the ring, in order.
std::vector<PointRing> compute_rings(const Cage& cage);

// Where a point of the cage comes to lie on the smooth skin; a point of an open edge is taken as it is.
// Source: Halstead, Kass, DeRose, "Efficient, fair interpolation using Catmull-Clark surfaces", 1993.
glm::dvec3 compute_limit(const PointRing& ring, std::uint32_t point, const std::vector<glm::dvec3>& points);

}  // namespace mien

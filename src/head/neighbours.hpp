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
std::vector<PointRing> find_rings(const Cage& cage);

}  // namespace mien

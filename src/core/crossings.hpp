// Where a mesh passes through itself. Exact: vertices are put on a grid of a millionth of a millimetre, and
// the signs of the determinants there are those of whole numbers.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh.hpp"

namespace mien {

// Two triangles of the mesh, by index, the smaller first.
using Crossing = std::array<std::uint32_t, 2>;

// Pairs of triangles where an edge of one passes from one side of the other's plane to the other side within
// it, its border counted. Pairs that share two vertices or more are neighbours and left out; of those that
// share one, only what is opposite to it counts. Touching without passing is no crossing. Ascending.
// Coordinates must be within 1000 mm. With `is_asked`, one for each triangle, only pairs with one of those.
std::vector<Crossing> find_crossings(const std::vector<glm::vec3>& positions,
                                     const std::vector<Triangle>& triangles,
                                     const std::vector<bool>& is_asked = {});

// The middle of what the boxes of each pair have in common.
std::vector<glm::vec3> list_crossed_places(const std::vector<glm::vec3>& positions,
                                           const std::vector<Triangle>& triangles,
                                           const std::vector<Crossing>& crossings);

}  // namespace mien

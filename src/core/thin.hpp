// Fewer triangles for a shape that takes many poses: the same ones for all of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/mesh.hpp"

namespace mien {

// Takes vertices out, the least missed first, until no more than `most` triangles are left; those that stay
// keep their places. `poses` are the shape's vertices in several poses; a vertex is missed where the planes
// around it are, in the sum over all poses (the quadrics of Garland and Heckbert 1997, summed over poses as
// Mohr and Gleicher do in "Deformation sensitive decimation", 2003). `is_locked` vertices and open edges
// stay, and no triangle turns over in any pose. Closed stays closed. The same input gives the same result.
std::vector<Triangle> thin_posed(const std::vector<std::vector<glm::vec3>>& poses,
                                 std::vector<Triangle> triangles, const std::vector<bool>& is_locked,
                                 std::size_t most);

}  // namespace mien

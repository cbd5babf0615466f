// Where a plane cuts a surface.
#pragma once

#include "wire/solid.hpp"

namespace mien {

// The cut of the plane dot(normal, p) = offset through the triangles, joined to lines as long as they go;
// closed ones end where they begin. `normal` of length 1.
std::vector<WireLine> slice_solid(const WireSolid& solid, const glm::dvec3& normal, double offset, Pen pen);

}  // namespace mien

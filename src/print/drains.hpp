// Where a cavity drains.
#pragma once

#include <vector>

#include "print/grid.hpp"
#include "print/hollow.hpp"

namespace mien {

// The body's surface without its underside: what a drain must keep away from.
SurfaceTree build_sides(const Mesh& body);

// The drains of the largest cavity, `depth` above `wall_mm`. Empty if hollow.drains is 0; throws RunError if
// there is no place for any.
std::vector<Drain> plan_drains(const Mesh& body, const Grid& depth, const Hollow& hollow);

}  // namespace mien

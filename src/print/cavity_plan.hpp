// How far the hollow in a print may reach: the same in every pose, inside the thinnest of all.
#pragma once

#include "core/print.hpp"

namespace mien {

struct CavityRequest {
  std::vector<glm::dvec2> directions;  // of the columns, unit
  double low_mm = 0;                   // height of the lowest row
  double straight_mm = 0;              // up to here the middle is on the axis, for a drain straight down
  std::vector<double> walls_mm;        // rising
};

// The plan of a cavity that is further from every triangle of `surfaces` (all poses in one mesh, z up, mm)
// than each of the walls, but for a twentieth of it. It is one room, seen from a line in its mid-plane:
// ears and the like stay solid, and what hangs over steeply has more wall. Walls that leave no room of half a
// dozen rows are left out. The same for any number of threads.
CavityPlan plan_cavity(const Mesh& surfaces, const CavityRequest& request);

// One mesh for plan_cavity: the first of `poses`, and of the others all triangles that are further inward
// somewhere than they are in the first, or far from there.
Mesh join_poses(const std::vector<Triangle>& triangles, const std::vector<std::vector<glm::vec3>>& poses);

}  // namespace mien

// The hollow inside a print as rings, and the drain through which it empties.
#pragma once

#include "core/holes.hpp"
#include "core/print.hpp"
#include "print/base.hpp"

namespace mien {

struct Hollow {
  double wall_mm = 2;   // one of the plan's
  double drain_mm = 4;  // diameter; narrower than 3.5 and resin stays in; 0: the cavity is sealed
  double lift_mm = 0;   // of the figure's foot above the bed
  double pocket_depth_mm = 0, pocket_mm = 0;  // of a magnet in the underside: the drain begins in its ceiling
};

// Star-shaped rings from the floor up, each with a place in every direction of the plan; print coordinates.
struct Cavity {
  std::vector<std::vector<glm::vec3>> rings;
  glm::vec3 floor{0}, top{0};  // the first one's middle; what the last one ends in
  double drain_mm = 0;  // diameter: as asked, or less if the foot or the magnet's ledge has no room; 0: none
};

// The cavity for one wall of the plan. Throws RunError "a wall of 30 mm leaves nothing to hollow", "a wall
// of 4 mm leaves no room for a drain; ..." and "a wall of 0 mm is not above 0".
Cavity build_cavity(const CavityPlan& plan, const Hollow& hollow);

// The cavity as an inner wall behind `mesh`, joined by a tube to `drain`, the open loop that append_base
// left (as many vertices for each of the plan's directions as it has more); sealed if that is empty.
// The vent, if there is one, leads from the tube to its mouth `outside`, which append_base left open, too.
// Returns how many triangles of the mesh are not the cavity's wall: the tube and the vent are before it.
std::size_t append_cavity(Mesh& mesh, const Cavity& cavity, const Loop& drain, const VentMouth& outside = {});

// The least distance between the cavity's wall and the surface of `body`, the print as a solid, on a sample
// a millimetre.
double measure_wall_mm(const Mesh& body, const Cavity& cavity);

}  // namespace mien

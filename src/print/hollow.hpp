// The hollow inside a print: an inner wall of even thickness, and holes through which resin drains.
#pragma once

#include <vector>

#include "core/holes.hpp"
#include "core/mesh.hpp"

namespace mien {

struct Hollow {
  double wall_mm = 2;
  int drains = 2;                // fewer if there is no room; 0: the cavity is sealed
  double drain_diameter_mm = 4;  // narrower than 3.5 and resin stays in
  bool is_open = true;  // false: the drains are planned but not joined, for a program that drills them itself
};

// A hole straight up from the bed into the cavity.
struct Drain {
  glm::dvec2 at{0};
  double top_mm = 0;  // this high it is in the cavity for certain
};

struct Cavity {
  Mesh wall;  // seen from the cavity: added to the body, it is the body's inner wall
  std::vector<Drain> drains;
  std::vector<Loop> holes;  // the drains' loops in the plane z = 0, as find_boundary_loops gives them
};

// The inner wall of `body`, which is closed and stands on z = 0. The wall is wall_mm thick within a twentieth
// everywhere but within two cells of the drains; ears and the like, too narrow to have a cavity that drains,
// stay solid. Drains are at the cavity's lowest places, as far apart as can be. Throws RunError "a wall of 30
// mm leaves nothing to hollow" and "a wall of 2 mm leaves no room for a drain of 9 mm". The same bytes for
// any number of threads.
Cavity build_cavity(const Mesh& body, const Hollow& hollow);

// The least distance between the cavity's wall and the surface of `body`, on a sample a millimetre; around
// the drains, which go through, it is not taken.
double measure_wall_mm(const Mesh& body, const Cavity& cavity, const Hollow& hollow);

// The cavity's wall behind the triangles of `mesh`, which keep their numbers; returns its holes as loops of
// `mesh`, for append_base.
std::vector<Loop> append_cavity(Mesh& mesh, const Cavity& cavity);

}  // namespace mien

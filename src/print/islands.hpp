// What of a print begins in the air.
#pragma once

#include <vector>

#include "core/mesh.hpp"

namespace mien {

struct Island {
  glm::dvec3 lowest{0};  // where it begins
  double height_mm = 0;  // from there until it meets the rest; all of it if it never does
};

// The parts of a solid that a printer, layer upon layer from z = 0, would begin in the air and join to the
// rest more than `layer_mm` higher up; from the lowest to the highest. Seen on columns 0.4 mm apart, more for
// prints over 100 mm.
std::vector<Island> find_islands(const Mesh& solid, double layer_mm);

}  // namespace mien

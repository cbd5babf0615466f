// Brows for one colour: the skin under the hairs is raised and combed into locks, for hairs are too fine to
// print.
#pragma once

#include <vector>

#include "core/mesh.hpp"

namespace mien {

// How far the brows stand out, in mm of the drawing.
struct BrowRelief {
  float height_mm = 3;
  float lock_mm = 3;  // from lock to lock
};

// Raises `skin` (closed; its vertices keep their index, new ones follow) under the hairs of `hairs`, one mesh
// a brow as the drawing has it, each hair a connected piece with its root first. Finer triangles are made
// there first.
void raise_brows(Mesh& skin, const std::vector<Mesh>& hairs, const BrowRelief& relief);

}  // namespace mien

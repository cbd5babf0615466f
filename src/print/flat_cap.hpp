// A flat underside with holes in it.
#pragma once

#include <vector>

#include "core/holes.hpp"
#include "core/mesh.hpp"

namespace mien {

// Fills what lies between `outline` and `holes`, loops of open edges in one horizontal plane (as
// find_boundary_loops gives them), with triangles that look down. The outline may have any simple shape.
// No vertices are added. Throws RunError "the holes of the underside do not fit into its outline".
void append_flat_cap(Mesh& mesh, const Loop& outline, const std::vector<Loop>& holes);

}  // namespace mien

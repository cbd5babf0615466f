// Fewer triangles where a shape is nearly flat.
#pragma once

#include "core/mesh.hpp"

namespace mien {

// Collapses edges of `mesh`, the cheapest first, as long as the surface stays within about `tolerance_mm` of
// where it was: the quadric error of Garland and Heckbert, "Surface simplification using quadric error
// metrics" (1997). Closed stays closed, vertices on open edges stay where they are, nothing is folded over,
// normals are dropped. The same mesh gives the same result, always.
void simplify_mesh(Mesh& mesh, double tolerance_mm);

}  // namespace mien

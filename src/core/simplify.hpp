// Fewer triangles where a shape is nearly flat.
#pragma once

#include <vector>

#include "core/mesh.hpp"

namespace mien {

// Collapses edges of `mesh`, the cheapest first, as long as the surface stays within about `tolerance_mm` of
// where it was: the quadric error of Garland and Heckbert, "Surface simplification using quadric error
// metrics" (1997). Closed stays closed, vertices on open edges stay where they are, nothing is folded over,
// normals are dropped. The same mesh gives the same result, always. Vertices that `is_fixed` marks stay as
// well; it may be empty.
void simplify_mesh(Mesh& mesh, double tolerance_mm, const std::vector<bool>& is_fixed = {});

// Merges the ends of edges shorter than `least_mm`, the shortest first, where that turns no triangle over;
// for meshes full of needles, as they are cut from a grid. Else as simplify_mesh.
void merge_short_edges(Mesh& mesh, double least_mm, const std::vector<bool>& is_fixed = {});

}  // namespace mien

// A regular grid of values through a solid, and the surface where they change their sign.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "core/mesh.hpp"
#include "head/nearest.hpp"

namespace mien {

// Nodes (i, j, k) at origin + cell * (i, j, k), x fastest.
struct Grid {
  glm::dvec3 origin{0};  // mm
  double cell_mm = 1;
  glm::ivec3 count{0};
  std::vector<float> values;  // one a node

  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * count.y + j) * count.x + i;
  }
  glm::dvec3 place(int i, int j, int k) const { return origin + cell_mm * glm::dvec3(i, j, k); }
};

// A grid around `box`, which stands on z = 0, without values: nodes with k = 0 are at z = 0; a cell at least
// is free around all other sides, and the nodes are off the planes where meshes like to have their vertices.
Grid place_grid(const Box& box, double cell_mm);

// Where a column of nodes goes through the solid's surface.
struct ColumnCrossing {
  double z = 0;
  int turn = 0;  // +1: in, going up; -1: out
};

// For each column (x fastest) its crossings, ascending. Edges and vertices are met exactly once.
std::vector<std::vector<ColumnCrossing>> list_crossings(const Mesh& solid, const Grid& grid);

// How deep each node lies in the solid, in mm: exact up to `reach_mm`, which stands for all that is deeper;
// -cell_mm for all outside. The same for any number of threads.
Grid build_depth_grid(const Mesh& solid, const SurfaceTree& tree, double cell_mm, double reach_mm);

// The surface around all nodes of values above 0, seen from them: triangles run counter-clockwise as seen
// from inside. Closed, but open along loops in the plane z = 0 where values are above 0 there.
// `value_at` gives the value at any place; it must agree with the nodes' (or be larger at those above 0), and
// change by 1 a mm at most: each vertex is where it is found to be 0 on an edge, or just before.
Mesh build_level_surface(const Grid& grid, const std::function<double(const glm::dvec3&)>& value_at);

}  // namespace mien

// A regular grid through a solid: where its columns go in and out.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/mesh.hpp"

namespace mien {

// Nodes (i, j, k) at origin + cell * (i, j, k), x fastest.
struct Grid {
  glm::dvec3 origin{0};  // mm
  double cell_mm = 1;
  glm::ivec3 count{0};

  glm::dvec3 place(int i, int j, int k) const { return origin + cell_mm * glm::dvec3(i, j, k); }
};

// A grid around `box`, which stands on z = 0: nodes with k = 0 are at z = 0; a cell at least
// is free around all other sides, and the nodes are off the planes where meshes like to have their vertices.
Grid place_grid(const Box& box, double cell_mm);

// Where a column of nodes goes through the solid's surface.
struct ColumnCrossing {
  double z = 0;
  int turn = 0;  // +1: in, going up; -1: out
};

// For each column (x fastest) its crossings, ascending. Edges and vertices are met exactly once.
std::vector<std::vector<ColumnCrossing>> list_crossings(const Mesh& solid, const Grid& grid);

}  // namespace mien

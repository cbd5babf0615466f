// What fills an opening of a bust's skin: a grid of vertices from the upper rim to the lower one.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "core/mesh.hpp"
#include "core/print.hpp"
#include "frames/bust_slit.hpp"

namespace mien {

inline constexpr int kPatchRows = 14;  // steps from rim to rim: 0.8 mm of the head in an eye at rest

// The grid between two rims of n + 1 columns: columns 1 .. 2n - 1 and rows 1 .. kPatchRows - 1, column by
// column, are the vertices from `first` on. Its columns with even numbers stand between the rim's own.
struct Patch {
  std::vector<std::uint32_t> upper, lower;  // the rims, corners included
  std::uint32_t first = 0;

  int column_count() const { return kPatchFine * (static_cast<int>(upper.size()) - 1); }
  std::uint32_t vertex_count() const { return count_grid_vertices(upper.size(), kPatchRows); }
};

// A place of the grid: where the column's ends lie on the rims, and how far down from the upper one, 0..1.
struct PatchPlace {
  glm::vec3 upper{0}, lower{0};
  float down = 0;  // row / kPatchRows
  int row = 0;
};

// The patch of the slit, its vertices behind the mesh's (at 0, to be placed) and its triangles in the mesh.
Patch append_patch(Mesh& mesh, const Slit& slit);

// Puts every vertex of the grid where `place` says.
void place_patch(const Patch& patch, const std::function<glm::vec3(const PatchPlace&)>& place,
                 std::vector<glm::vec3>& positions);

}  // namespace mien

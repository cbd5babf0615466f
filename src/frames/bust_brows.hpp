// Brows for one colour: the skin under the hairs is raised and combed into locks, for hairs are too fine to
// print.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/mesh.hpp"

namespace mien {

// How far the brows stand out, in mm of the drawing.
struct BrowRelief {
  float height_mm = 3;
  float lock_mm = 3;  // from lock to lock
};

// How the skin of a head grows under its brows, in every pose alike.
struct RaisedBrows {
  std::size_t skin_count = 0;                      // vertices before any was added
  std::vector<std::array<std::uint32_t, 2>> ends;  // of the edge that each new vertex halves, in their order
  std::vector<bool> is_left_out;                   // of each new vertex: it need not be placed
  std::vector<std::pair<std::uint32_t, float>> heights;  // vertex and mm along its normal
};

// Makes finer triangles in `skin` (at rest, with normals; its vertices keep their index, new ones follow)
// under the hairs of `hairs`, one mesh a brow, each hair a connected piece with its root first.
RaisedBrows refine_brows(Mesh& skin, const std::vector<Mesh>& hairs, const BrowRelief& relief);

// New vertices that are neither kept nor between the ends of one that is, are not placed any more. `is_kept`
// has a value for each vertex.
void leave_out_brows(RaisedBrows& brows, const std::vector<bool>& is_kept);

// The skin's vertices in one pose with their normals, cut to `skin_count`, become those of the raised one.
void raise_brows(const RaisedBrows& brows, std::vector<glm::vec3>& positions,
                 std::vector<glm::vec3>& normals);

}  // namespace mien

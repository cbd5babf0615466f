// A triangle mesh and the few facts about it that everybody needs.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace mien {

using Triangle = std::array<std::uint32_t, 3>;
using Quad = std::array<std::uint32_t, 4>;

// Vertices are stored once and named by index, counter-clockwise seen from outside. Example, a unit square
// that looks along +z:  positions {(0,0,0),(1,0,0),(1,1,0),(0,1,0)}, triangles {{0,1,2},{0,2,3}}, normals all
// (0,0,1).
struct Mesh {
  std::vector<glm::vec3> positions;  // mm
  std::vector<glm::vec3> normals;    // unit length, one a vertex; may be empty while a mesh is being built
  std::vector<Triangle> triangles;
};

struct Box {
  glm::vec3 low{0}, high{0};  // mm
};

// The smallest box around all vertices; a box of zeros for an empty mesh.
Box compute_bounds(const std::vector<glm::vec3>& positions);

// Area-weighted vertex normals of `mesh.triangles`, written to `mesh.normals`. A vertex whose triangles have
// no area gets (0, 0, 1), so that a normal is always finite and of unit length.
void update_normals(Mesh& mesh);

// The number of edges that are not used exactly once in each direction: 0 says closed and consistently wound.
std::size_t count_open_edges(const std::vector<Triangle>& triangles);

// The volume inside a closed mesh in cubic millimetres, positive when wound outwards. Divergence theorem.
double compute_volume_mm3(const Mesh& mesh);

// `addition` behind the vertices and triangles of `mesh`.
void append_mesh(Mesh& mesh, const Mesh& addition);

}  // namespace mien

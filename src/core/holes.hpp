// Closing an open triangle mesh: where its edges are open, and caps for them that keep the winding.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh.hpp"

namespace mien {

// A closed walk along open edges, vertex after vertex, directed so that a cap's triangle (loop[i], loop[i +
// 1], apex) is wound like the mesh: the walk runs against the mesh's own edges.
using Loop = std::vector<std::uint32_t>;

// Every loop of open edges, each once, in the order of its smallest vertex, from which it starts. Example:
// the cube without its lid has one loop of four vertices. Throws RunError "mesh is not a surface at vertex N"
// where two loops meet in one vertex or the winding is not consistent.
std::vector<Loop> find_boundary_loops(const std::vector<Triangle>& triangles);

// The mean of the loop's edges, each counted by its length, so that crowded vertices do not pull it aside.
glm::vec3 compute_loop_centre(const std::vector<glm::vec3>& positions, const Loop& loop);

// A cap of one new vertex, `apex`, and a triangle for each edge of the loop. Right for loops that see the
// apex. Normals, if the mesh has any, are dropped by every cap: call update_normals again.
void append_fan_cap(Mesh& mesh, const Loop& loop, const glm::vec3& apex);

// A cap without new vertices, for a loop of any shape that is simple when seen along its own mean normal: ear
// clipping (Meisters 1975), the ear with the widest smallest angle first, which avoids slivers.
void append_ear_cap(Mesh& mesh, const Loop& loop);

// A band of triangles from `loop` to `next`, vertex i to vertex i; both as long. `next` is then the open
// edge.
void append_band(Mesh& mesh, const Loop& loop, const Loop& next);

// Caps every loop with ears: the mesh is closed afterwards. Returns the number of caps.
std::size_t close_holes(Mesh& mesh);

// The connected pieces of `mesh` (triangles that share vertices), in the order of their first vertex and with
// the order of their vertices kept; vertices without triangles are left out.
std::vector<Mesh> split_pieces(const Mesh& mesh);

}  // namespace mien

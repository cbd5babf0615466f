// Whether a mesh is consistent: each polygon closed and flat enough, each edge used once or twice and both
// ways round, each vertex on two edges at least (Yen 1990, 5.2.3), no point or polygon twice, all of it one
// piece.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "import/polygons.hpp"

namespace mien {

struct MeshFault {
  std::string message;               // what was found; what was expected; where, by coordinates
  int line = 0;                      // of the file, where it is text
  std::vector<std::uint32_t> faces;  // that have it
  bool is_warning = false;  // one can work with it: pieces apart, points at one place, polygons that are bent
};

struct MeshReport {
  std::vector<MeshFault> faults;  // by kind, then in the file's order
  std::size_t rims = 0;           // open ends: a head has those of neck, eyes and mouth
  std::size_t open_edges = 0;
  std::size_t pieces = 0;
};

// How far a corner may lie out of its polygon's plane, in shares of the polygon's longest edge.
inline constexpr double kFlatness = 0.1;

// Of a kind of fault as many are told as `most`, and then how many there are.
MeshReport find_mesh_faults(const Polygons& mesh, std::size_t most = 20);

// The mesh as PLY text: faces with a fault red, the others grey.
std::string draw_mesh_faults(const Polygons& mesh, const MeshReport& report);

}  // namespace mien

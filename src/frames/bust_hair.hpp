// The hair of a drawn bust: the skin under it is cut away, and a mass is sewn to the edge of what is left.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh.hpp"
#include "head/hair_relief.hpp"

namespace mien {

// A vertex of the hair's edge, between two of the skin's.
struct HairEdgeVertex {
  std::array<std::uint32_t, 2> ends{};
  float share = 0;  // 0 at the first .. 1 at the second
  glm::vec3 rest{0};
};

// A vertex of the mass. Near the edge it goes along with a vertex of it.
struct HairMassVertex {
  std::uint32_t vertex = 0;  // among all of the bust's
  glm::vec3 rest{0};         // mm of the head
  std::uint32_t edge = 0;    // index in BustHair::edge
  float share = 0;           // of that one's way
};

struct BustHair {
  std::uint32_t first = 0;  // of all that is hair's: the edge's vertices, then the mass's
  std::vector<HairEdgeVertex> edge;
  std::vector<HairMassVertex> mass;

  bool is_on() const { return !edge.empty(); }
  std::uint32_t first_of_mass() const { return first + static_cast<std::uint32_t>(edge.size()); }
};

// Cuts the hair's place out of `mesh`, whose vertices below `skin_count` are the skin at rest, and closes it
// with the mass, its vertices behind all others and its triangles last. `fine_mm`: of the head for one of the
// print. No hair, and `mesh` is of no more use, where the relief has none on this skin or its edge cannot be
// sewn.
BustHair append_hair(const NeutralHead& head, const HairRelief& relief, std::size_t skin_count,
                     double fine_mm, Mesh& mesh);

// Puts the hair's vertices where the others, placed already, have them.
void place_hair(const BustHair& hair, std::vector<glm::vec3>& positions);

// Marks the vertices that kept hair is placed by, and forgets those of the mass that are not kept.
void leave_out_hair(BustHair& hair, const std::vector<bool>& is_kept, std::vector<bool>& is_needed);

}  // namespace mien

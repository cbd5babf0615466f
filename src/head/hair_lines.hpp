// The few lines that ink draws on hair: from where its locks part along the way that they are combed, and
// from its part or toward its knot.
#pragma once

#include <vector>

#include "core/mesh.hpp"
#include "head/head.hpp"

namespace mien {

// A place of a mesh: in a triangle of its vertices, by their shares.
struct MeshPlace {
  Triangle vertices{0, 0, 0};
  glm::vec3 shares{1, 0, 0};
};

struct HairLine {
  std::vector<MeshPlace> places;           // of the mass; two at least
  double begins = 0, width = 1, ends = 0;  // of a line: at its first place, where it is widest, at its last
};

// The lines of a cut, drawn on the "hair_mass" that build_hair made of it on this head where it is drawn;
// none for a cut without a mass. Throws RunError for an unknown cut.
std::vector<HairLine> list_hair_lines(const NeutralHead& head, const std::string& cut, const Mesh& mass);

}  // namespace mien

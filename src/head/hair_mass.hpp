// The dark body under the locks: it fills what they leave open, and throws their shadow.
#pragma once

#include "head/hair_growth.hpp"

namespace mien {

// A closed shell from the whorl to the border, its inside in the skin; the knot and the tail that go with it,
// each closed. Exact mirror images on both halves. Bound vertex by vertex.
void append_mass(HeadPart& part, const HairScene& scene);

// One side of a closed shell: its pole is vertex `first`, then come the rows of each column.
struct ShellSide {
  std::uint32_t first = 0;
  int rows = 0;
};

// The triangles of both sides of such a shell, which goes round in `columns`, and of the rim between their
// last rows. Faces of no area are left out.
void sew_shell(std::vector<Triangle>& triangles, const ShellSide& outer, const ShellSide& inner, int columns);

// How thick it is at a place far from its edge, mm.
double compute_mass_height_mm(const HairScene& scene, const HairPlace& place);

}  // namespace mien

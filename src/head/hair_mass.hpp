// The dark body under the locks: it fills what they leave open, and throws their shadow.
#pragma once

#include "head/hair_growth.hpp"

namespace mien {

// A closed shell from the whorl to the border, its inside in the skin; the knot and the tail that go with it,
// each closed. Exact mirror images on both halves. Bound vertex by vertex.
void append_mass(HeadPart& part, const HairScene& scene);

// How thick it is at a place far from its edge, mm.
double compute_mass_height_mm(const HairScene& scene, const HairPlace& place);

}  // namespace mien

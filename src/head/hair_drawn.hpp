// Hair as ink has it: one closed mass with one outline, which ends in a few pointed locks.
#pragma once

#include "head/hair_growth.hpp"

namespace mien {

// The mass, closed, and knot and tail, each closed. Bound vertex by vertex.
void append_drawn_mass(HeadPart& part, const HairScene& scene);

}  // namespace mien

// Hair as ink has it: one closed mass with one outline, which ends in a few pointed locks.
#pragma once

#include <array>
#include <vector>

#include "head/hair_growth.hpp"

namespace mien {

// The mass, closed, and knot and tail, each closed. Bound vertex by vertex.
void append_drawn_mass(HeadPart& part, const HairScene& scene);

// Two vertices of the mass at its edge, of one column of trace_drawn_edge: the outer one, over the skin, and
// the one under it, in the skin. `columns`: how many there are.
std::array<std::uint32_t, 2> find_drawn_rim(std::size_t column, std::size_t columns);

// The vertices of the mass's outside along a column, from the edge up to where its locks are one.
std::vector<std::uint32_t> list_drawn_column(std::size_t column);

}  // namespace mien

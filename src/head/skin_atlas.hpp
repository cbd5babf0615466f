// The skin laid flat: a place in the unit square for each of its vertices, the same for every head, so that a
// picture painted over it fits all of them.
//
// The skin is cut behind along the mid-plane, from the neck over the crown to above the brow, and laid out so
// that each vertex is a weighted mean of its neighbours while the rim stays on the square (W. Tutte, "How to
// Draw a Graph", 1963; weights: M. Floater, "Mean value coordinates", 2003). Nothing can overlap: eye
// openings are closed for the time of the layout. Left and right are mirror images, side by side; the
// character's left is on the right.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/atlas.hpp"

namespace mien {

// The skin's vertices, and then second ones of those of the cut. `positions` are the adult's, mm; `mirror`
// the mirror image of each vertex. About a second. Throws RunError if the skin is not one that is open at
// neck and eyes alone.
Atlas build_skin_atlas(const std::vector<glm::vec3>& positions, const std::vector<Triangle>& triangles,
                       const std::vector<std::uint32_t>& mirror);

}  // namespace mien

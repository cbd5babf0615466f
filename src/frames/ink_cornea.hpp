// The front of an eye that is seen from the side.
#pragma once

#include "frames/ink_profile.hpp"

namespace mien {

// Appends the vertices of one stroke: between the lids the edge of the nearer ball, which is none of the
// face's outlines, as far as the head is seen from the side; nowhere else is there anything to see of it. For
// balls that have been drawn.
void append_cornea(const Ink& ink, const InkSight& sight, double line_mm, const Drawing& drawing,
                   std::vector<glm::vec3>& vertices);

}  // namespace mien

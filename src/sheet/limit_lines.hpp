// The limits of the areas as lines in space, for drawings that are seen from anywhere.
#pragma once

#include "frames/figure.hpp"
#include "wire/solid.hpp"

namespace mien {

// Rectangles that brows, eyes and mouth corners may not leave, and where lids, lips and chin end, before the
// face as it rests; `world` turns them with the head.
void append_limit_lines(const Figure& figure, const glm::dmat4& world, WireModel& model);

}  // namespace mien

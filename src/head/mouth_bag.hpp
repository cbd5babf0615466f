// The cavity of the mouth: palate, cheeks, floor and throat, as control points of the skin behind the lips.
#pragma once

#include <vector>

#include "config/part_numbers.hpp"
#include "head/head.hpp"

namespace mien {

// Places the rings MB1 (behind the lips) and MB2 (before the throat) of `points`, mm, so that a mouth of this
// size has room for its teeth. Whatever form the rings came with is lost. `cage` lends names only.
void shape_mouth_bag(const MouthNumbers& numbers, const Cage& cage, std::vector<glm::dvec3>& points);

}  // namespace mien

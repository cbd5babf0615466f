// Nostrils that keep their form while the nose around them changes.
#pragma once

#include <vector>

#include "head/head.hpp"

namespace mien {

// The rings inside a nostril hang on soft fields that know nothing of each other: sums of many can fold them.
// Brings them near to where the rim's own change carries them from `before`, exactly alike on both sides.
// What was asked for a small way from there is kept, more than that less and less. Both are points of `cage`.
void keep_nostrils(const Cage& cage, const std::vector<glm::dvec3>& before, std::vector<glm::dvec3>& points);

}  // namespace mien

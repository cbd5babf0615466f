// Where combed hair comes from: the grain of what is not made lock by lock.
#pragma once

#include "head/hair_growth.hpp"

namespace mien {

// Along the way that hair is combed: `across_mm` tells neighbouring strands apart (counted along a line
// around the part, or around the knot), `along_mm` how far they have come. Both
// sides of a part have the same.
struct HairFlow {
  double across_mm = 0, along_mm = 0;
};

HairFlow compute_hair_flow(const HairScene& scene, const HairPlace& place);

}  // namespace mien

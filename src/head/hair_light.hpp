// The ring of light on drawn hair.
#pragma once

#include <functional>
#include <vector>

#include "head/hair_edge.hpp"

namespace mien {

// Where the ring of light lies along a column of the mass: from which way to which.
struct LightBand {
  double high = 0, low = 0;
  bool is_there = false;
};

// A band that swells and thins, from which light runs down a few strands: one entry for each of `edges`.
// `compute_up`: how far up a place of the hair looks, -1..1. An entry that is not there, where the ring
// would close at the crown, lies within the hair all the same.
std::vector<LightBand> trace_light(const HairScene& scene, const std::vector<DrawnEdge>& edges,
                                   const std::function<double(const HairPlace&)>& compute_up);

}  // namespace mien

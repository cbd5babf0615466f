// The scan's nose looks for ours.
#pragma once

#include <vector>

#include "head/placed_scan.hpp"

namespace mien {

// A part of our left skin, vertex by vertex.
struct NosePatch {
  std::vector<glm::dvec3> points, normals;
};

// A place of the scan and which of the patch's vertices is nearest to it.
struct NosePull {
  std::uint32_t vertex = 0;
  glm::dvec3 at{0}, normal{0};
};

// A nose that is narrower than the scan's finds the scan's cheek before its wing: so each of the scan's
// points within `radius_mm` of `middle` asks which of ours is nearest and faces the same way, `reach_mm` at
// most. Nostrils' insides ask nothing; right ones are mirrored.
std::vector<NosePull> compute_nose_pulls(const PlacedScan& scan, const NosePatch& patch,
                                         const glm::dvec3& middle, double radius_mm, double reach_mm);

}  // namespace mien

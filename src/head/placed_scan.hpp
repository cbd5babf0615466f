// A scan that lies on our head, asked from either side.
#pragma once

#include "head/eye_fit.hpp"
#include "head/nearest.hpp"

namespace mien {

struct PlacedScan {
  SurfaceTree tree;
  glm::dmat3 turn{1};  // ours from the tree's: turn * place + shift
  glm::dvec3 shift{0};
};

inline glm::dvec3 mirror(const glm::dvec3& p) { return p * glm::dvec3(-1, 1, 1); }

// The scan's place nearest to `point` of our left half, within `reach_mm`; with `is_right` that of the
// point's mirror image, mirrored: both sides answer as left ones.
NearestPlace find_place(const PlacedScan& scan, const glm::dvec3& point, double reach_mm, bool is_right);

// Whether a place found by find_place looks into the open: `way_mm` before it there is no other surface. The
// inside of a nostril or of a mouth has the opposite wall there.
bool is_open(const PlacedScan& scan, const NearestPlace& place, double way_mm, bool is_right);

}  // namespace mien

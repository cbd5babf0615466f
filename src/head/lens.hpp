// A design's lens: space stretched about each eye. Skin and ball go through it together, so that lids which
// fit a round ball fit the tall oval that it becomes.
#pragma once

#include "head/head.hpp"

namespace mien {

struct Lens {
  glm::dvec3 centre{0};  // of the left eye, mm; the right one's is its mirror image
  double radius_mm = 1;
  double per_radius = 1;
  double taller = 0, full = 1, end = 2, flat = 0;  // dials of DesignNumbers; 0 changes nothing

  bool is_on() const { return taller > 1e-9 || flat > 1e-9; }
};

Lens build_lens(const NeutralHead& head);

// Where a point of the head's space comes to lie. Mirror images stay mirror images, bit for bit.
glm::dvec3 bend(const Lens& lens, const glm::dvec3& point);

}  // namespace mien

// Places round the axis of the lids, and where their edges lie on the skin.
#pragma once

#include <cmath>

#include "face/lid_rig.hpp"

namespace mien {

// A place about the axis of the lids.
struct LidPlace {
  double along_mm = 0, height_rad = 0, radius_mm = 0;
};

inline glm::dvec3 compute_up(const LidRig& rig) { return glm::cross(glm::dvec3(0, 0, 1), rig.axis); }

inline LidPlace find_place(const LidRig& rig, const glm::dvec3& point) {
  const glm::dvec3 arm = point - rig.eye.centre;
  const double up = glm::dot(arm, compute_up(rig));
  return {glm::dot(arm, rig.axis), std::atan2(up, arm.z), std::hypot(up, arm.z)};
}

inline glm::dvec3 compute_point_at(const LidRig& rig, const LidPlace& place) {
  return rig.eye.centre + place.along_mm * rig.axis +
         place.radius_mm * (std::sin(place.height_rad) * compute_up(rig) +
                            std::cos(place.height_rad) * glm::dvec3(0, 0, 1));
}

// Control points of the rings, in the left eye's mirror.
using RingPoints = std::vector<std::array<glm::dvec3, kLidColumns>>;

inline glm::dvec3 compute_on_skin(const LidEdge& edge, int column, const RingPoints& points) {
  glm::dvec3 sum(0);
  for (const auto& [ring, other, share] : edge.shares[column]) sum += share * points[ring][other];
  return sum;
}

}  // namespace mien

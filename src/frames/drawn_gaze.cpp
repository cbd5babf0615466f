#include "frames/drawn_gaze.hpp"

#include <algorithm>
#include <cmath>

#include "core/conventions.hpp"
#include "core/smooth.hpp"

namespace mien {

Pose turn_gaze_to_camera(const Figure& figure, const Pose& pose, const glm::dmat4& world_from_head,
                         const glm::dvec3& camera_mm) {
  constexpr double kFrom_deg = 50, kAll_deg = 85;  // between gaze and camera: less is no profile
  constexpr double kMost_deg = 30;                 // further and the profile looks at us
  const glm::dvec3 camera(glm::inverse(world_from_head) * glm::dvec4(camera_mm, 1));
  Pose turned = pose;
  for (const Side side : {Side::left, Side::right}) {
    glm::dvec3 centre = figure.head.eye.centre;
    if (side == Side::right) centre.x = -centre.x;
    const glm::dvec3 way = camera - centre;
    double& value = turned.values[*find_move(Area::eye, side, "side")];
    const double gaze_deg = value * figure.face.eye_side_rad / kRadiansPerDegree;
    const double off_deg = std::atan2(way.x, way.z) / kRadiansPerDegree - gaze_deg;
    const double by_deg = kMost_deg * smooth_step(kFrom_deg, kAll_deg, std::abs(off_deg));
    value += std::copysign(by_deg, off_deg) * kRadiansPerDegree / figure.face.eye_side_rad;
    value = std::clamp(value, std::min(-1.0, pose.values[*find_move(Area::eye, side, "side")]),
                       std::max(1.0, pose.values[*find_move(Area::eye, side, "side")]));
  }
  return turned;
}

}  // namespace mien

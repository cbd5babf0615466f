#include "wire/camera.hpp"

#include <algorithm>
#include <cmath>

#include "core/conventions.hpp"

namespace mien {

// A camera that looks straight down has no upright; as in scene/povray.cpp.
constexpr double kSteepest_deg = 89.5;

WireCamera build_wire_camera(const CameraView& view, const PictureSize& size) {
  const double angle = view.angle_deg * kRadiansPerDegree;
  const double height = std::clamp(view.height_deg, -kSteepest_deg, kSteepest_deg) * kRadiansPerDegree;
  WireCamera camera;
  camera.is_orthographic = view.is_orthographic;
  camera.size = size;
  camera.look_at = glm::dvec3(view.look_at);
  camera.toward = {std::sin(angle) * std::cos(height), std::sin(height), std::cos(angle) * std::cos(height)};
  camera.right = {std::cos(angle), 0, -std::sin(angle)};
  camera.up = glm::cross(camera.toward, camera.right);
  camera.distance_mm = compute_camera_distance_mm(view);
  camera.at = camera.look_at + camera.distance_mm * view.distance * camera.toward;
  const double tall_mm = std::max(view.frame_height_mm, view.frame_width_mm * size.height_px / size.width_px);
  camera.px_per_mm = size.height_px / tall_mm;
  return camera;
}

double compute_depth_mm(const WireCamera& camera, const glm::dvec3& place) {
  return glm::dot(camera.at - place, camera.toward);
}

glm::dvec2 find_paper_place(const WireCamera& camera, const glm::dvec3& place) {
  const glm::dvec3 way = place - camera.at;
  const double scale = camera.is_orthographic
                           ? camera.px_per_mm
                           : camera.px_per_mm * camera.distance_mm / compute_depth_mm(camera, place);
  return {camera.size.width_px / 2.0 + scale * glm::dot(way, camera.right),
          camera.size.height_px / 2.0 - scale * glm::dot(way, camera.up)};
}

glm::dvec3 find_way_to(const WireCamera& camera, const glm::dvec3& place) {
  return camera.is_orthographic ? camera.toward : glm::normalize(camera.at - place);
}

}  // namespace mien

// Embree 3.13: API documentation, "Geometry Objects"; vertices are read in sixteens of bytes, so that their
// buffer is one longer than they are.
#include "wire/seen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace mien {

WireStage::WireStage(const std::vector<WireSolid>& solids) : device(rtcNewDevice(nullptr)) {
  if (!device) throw RunError("Embree cannot be started");
  scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);  // no ray slips through between two triangles
  positions.reserve(solids.size());
  for (const WireSolid& solid : solids) {
    if (solid.triangles.empty()) continue;
    std::vector<glm::vec3>& own = positions.emplace_back(solid.positions);
    own.emplace_back(0);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, own.data(), 0,
                               sizeof(glm::vec3), own.size() - 1);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, solid.triangles.data(),
                               0, sizeof(Triangle), solid.triangles.size());
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(scene);
  if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
    throw RunError(fmt::format("Embree failed with error {}", static_cast<int>(error)));
}

WireStage::~WireStage() {
  if (scene) rtcReleaseScene(scene);
  rtcReleaseDevice(device);
}

bool is_seen(const WireStage& stage, const WireCamera& camera, const glm::dvec3& place) {
  const glm::dvec3 way = find_way_to(camera, place);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray{};
  ray.org_x = static_cast<float>(place.x);
  ray.org_y = static_cast<float>(place.y);
  ray.org_z = static_cast<float>(place.z);
  ray.dir_x = static_cast<float>(way.x);
  ray.dir_y = static_cast<float>(way.y);
  ray.dir_z = static_cast<float>(way.z);
  ray.tnear = static_cast<float>(kSeenLift_mm);
  ray.tfar = camera.is_orthographic ? 1e30f : static_cast<float>(glm::distance(camera.at, place));
  ray.mask = ~0U;
  rtcOccluded1(stage.scene, &context, &ray);
  return ray.tfar >= 0;
}

std::vector<std::array<double, 2>> find_seen(const WireStage& stage, const WireCamera& camera,
                                             const glm::dvec3& from, const glm::dvec3& to, double step_px) {
  constexpr int kHalvings = 6;
  const double length_px = glm::distance(find_paper_place(camera, from), find_paper_place(camera, to));
  const int count = std::max(2, static_cast<int>(std::ceil(length_px / step_px)));
  const auto ask = [&](double share) { return is_seen(stage, camera, glm::mix(from, to, share)); };
  std::vector<std::array<double, 2>> seen;
  bool was_seen = ask(0.5 / count);
  double begin = 0;
  for (int i = 1; i < count; ++i) {
    const bool is = ask((i + 0.5) / count);
    if (is == was_seen) continue;
    double low = (i - 0.5) / count, high = (i + 0.5) / count;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = (low + high) / 2;
      (ask(middle) == was_seen ? low : high) = middle;
    }
    const double change = (low + high) / 2;
    if (was_seen) seen.push_back({begin, change});
    begin = change;
    was_seen = is;
  }
  if (was_seen) seen.push_back({begin, 1});
  return seen;
}

}  // namespace mien

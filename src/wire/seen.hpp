// Which parts of a line are seen: hidden lines are found along each edge, not edge by edge.
//
// A. Appel, "The notion of quantitative invisibility and the machine rendering of solids", 1967, asks the
// same question with counts; here a ray from each place of the line to the camera answers it (I. Wald et al.,
// "Embree", 2014), and where the answer changes along the line the change is found by halving.
#pragma once

#include <embree3/rtcore.h>

#include <array>
#include <vector>

#include "wire/camera.hpp"
#include "wire/solid.hpp"

namespace mien {

// A ray begins so far off its line, mm: less, and it meets the surface that the line lies on; more, and what
// lies that near behind a fold is drawn.
inline constexpr double kSeenLift_mm = 0.05;

// What hides; shared read-only by all threads.
struct WireStage {
  explicit WireStage(const std::vector<WireSolid>& solids);
  WireStage(const WireStage&) = delete;
  WireStage& operator=(const WireStage&) = delete;
  ~WireStage();

  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<std::vector<glm::vec3>> positions;  // Embree's: one more than the solid has
};

// Whether nothing of the stage stands between a place and the camera.
bool is_seen(const WireStage& stage, const WireCamera& camera, const glm::dvec3& place);

// The seen parts of the way from one place to another, as shares of it, ascending: [0, 1] is all of it. A gap
// shorter than `step_px` may be missed, the ends of the others are found to a fiftieth of it.
std::vector<std::array<double, 2>> find_seen(const WireStage& stage, const WireCamera& camera,
                                             const glm::dvec3& from, const glm::dvec3& to, double step_px);

}  // namespace mien

#include "head/hair_flow.hpp"

#include <algorithm>
#include <cmath>

#include "core/conventions.hpp"
#include "head/hair_comb.hpp"

namespace mien {

namespace {

// Strands are told apart where they pass this near the part: the ends of a line have no width to count on.
constexpr double kNear_mm = 34;
constexpr double kThere_mm = 0.1;  // is as near
constexpr double kStep_mm = 9;     // upstream; an error of a step is a hair's breadth of `across`
constexpr int kSteps = 40;         // from the shoulders to the top

HairFlow compute_flow_to_knot(const HairScene& scene, const glm::dvec3& at) {
  glm::dvec3 knot, out;
  compute_knot(scene, knot, out);
  const glm::dvec3 arm = at - knot, up(0, -out.z, out.y);
  const double turn = std::atan2(arm.x, glm::dot(arm, up));
  constexpr double kRound_mm = 60;  // from the knot: half way to the hairline
  constexpr double kWhole_mm = 200;
  return {kRound_mm * scene.chart.size * turn,
          std::max(0.0, kWhole_mm * scene.chart.size - glm::length(arm))};
}

}  // namespace

HairFlow compute_hair_flow(const HairScene& scene, const HairPlace& place) {
  const HairChart& chart = scene.chart;
  glm::dvec3 at = compute_hair_point(chart, place, compute_ground_mm(scene, place));
  if (scene.cut.comb.is_gathered) return compute_flow_to_knot(scene, at);
  double gone_mm = 0;
  PartArm arm = compute_part_arm(scene, at);
  for (int step = 0; step < kSteps && arm.distance_mm > (kNear_mm + kThere_mm) * chart.size; ++step) {
    // The last step is as long as is left: neighbours that are told apart elsewhere would zigzag.
    const double step_mm = std::min(kStep_mm * chart.size, arm.distance_mm - kNear_mm * chart.size);
    const HairPlace here = compute_hair_place(chart, at);
    const glm::dvec3 way = compute_comb_way(scene, here, arm.distance_mm / chart.size);
    const HairPlace back = compute_hair_place(chart, at - step_mm * way);
    at = compute_hair_point(chart, back, compute_ground_mm(scene, back));
    gone_mm += step_mm;
    arm = compute_part_arm(scene, at);
  }
  // The same on both sides, or it would jump where they meet.
  const double turn = std::abs(std::atan2(arm.aside, arm.ahead));
  return {kNear_mm * chart.size * turn + arm.along_mm, gone_mm + arm.distance_mm};
}

}  // namespace mien

#include "head/hair_flow.hpp"

#include <algorithm>
#include <cmath>

#include "core/conventions.hpp"

namespace mien {

namespace {

// Strands are told apart where they pass this near the part: the ends of a line have no width to count on.
constexpr double kNear_mm = 34;
constexpr double kStep_mm = 9;  // upstream; an error of a step is a hair's breadth of `across`
constexpr int kSteps = 40;      // from the shoulders to the top

HairFlow find_flow_to_knot(const HairScene& scene, const glm::dvec3& at) {
  glm::dvec3 knot, out;
  find_knot(scene, knot, out);
  const glm::dvec3 arm = at - knot, up(0, -out.z, out.y);
  const double turn = std::atan2(arm.x, glm::dot(arm, up));
  constexpr double kRound_mm = 60;  // from the knot: half way to the hairline
  constexpr double kWhole_mm = 200;
  return {kRound_mm * scene.chart.size * turn,
          std::max(0.0, kWhole_mm * scene.chart.size - glm::length(arm))};
}

}  // namespace

HairFlow find_hair_flow(const HairScene& scene, const HairPlace& place) {
  const HairChart& chart = scene.chart;
  glm::dvec3 at = find_hair_point(chart, place, find_ground_mm(scene, place));
  if (scene.cut.comb.is_gathered) return find_flow_to_knot(scene, at);
  double gone_mm = 0;
  PartArm arm = find_part_arm(scene, at);
  for (int step = 0; step < kSteps && arm.distance_mm > kNear_mm * chart.size; ++step) {
    const HairPlace here = find_hair_place(chart, at);
    const glm::dvec3 way = find_comb_way(scene, here, arm.distance_mm / chart.size);
    const HairPlace back = find_hair_place(chart, at - kStep_mm * chart.size * way);
    at = find_hair_point(chart, back, find_ground_mm(scene, back));
    gone_mm += kStep_mm * chart.size;
    arm = find_part_arm(scene, at);
  }
  const double turn = std::atan2(arm.aside, arm.ahead);
  return {std::copysign(kNear_mm * chart.size * std::abs(turn) + arm.along_mm, turn),
          gone_mm + arm.distance_mm};
}

double find_part_distance_mm(const HairScene& scene, const HairPlace& place) {
  if (scene.cut.comb.is_gathered) return 1e9;
  return find_part_arm(scene, find_hair_point(scene.chart, place, find_ground_mm(scene, place))).distance_mm;
}

}  // namespace mien

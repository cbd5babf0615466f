#include "head/hair_comb.hpp"

#include <algorithm>
#include <cmath>

#include "core/conventions.hpp"
#include "core/smooth.hpp"

namespace mien {

namespace {

glm::dvec3 compute_arc_direction(double side_mm, double back_deg, double radius_mm) {
  const double turn = back_deg * kRadiansPerDegree;
  return glm::normalize(glm::dvec3(side_mm / radius_mm, std::cos(turn), -std::sin(turn)));
}

constexpr int kPartSteps = 24;  // of the part's arc: 4 degrees of a long one

// A place on the part's arc: its share of the way, and its direction from the head's centre.
struct PartPoint {
  double share = 0;
  glm::dvec3 direction{0, 1, 0};
};

// The place of the part's arc that is nearest to a direction of the head.
PartPoint find_part_point(const HairScene& scene, const glm::dvec3& direction) {
  const std::vector<glm::dvec3>& ways = scene.part_ways;
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < ways.size(); ++i)
    if (glm::dot(ways[i], direction) > glm::dot(ways[nearest], direction)) nearest = i;
  PartPoint best{static_cast<double>(nearest) / kPartSteps, ways[nearest]};
  // Between its steps too, or locks meet in these like the bones of a fish.
  for (std::size_t i = nearest > 0 ? nearest - 1 : 0; i < std::min(nearest + 1, ways.size() - 1); ++i) {
    const glm::dvec3 step = ways[i + 1] - ways[i];
    const double length2 = glm::dot(step, step);
    if (length2 < 1e-12) continue;
    const double t = std::clamp(glm::dot(direction - ways[i], step) / length2, 0.0, 1.0);
    const glm::dvec3 at = glm::normalize(ways[i] + t * step);
    if (glm::dot(at, direction) > glm::dot(best.direction, direction))
      best = {(static_cast<double>(i) + t) / kPartSteps, at};
  }
  return best;
}

glm::dvec3 compute_way_from_part(const HairScene& scene, const glm::dvec3& direction) {
  // A fringe falls side by side: straight out of the part's front end, and it would have a gap in its middle.
  constexpr double kAside = 0.35;
  const PartPoint part = find_part_point(scene, direction);
  glm::dvec3 way = direction - part.direction;
  const double fringe = scene.hangs.empty() ? 0 : scene.hangs.front();
  if (part.share <= 0 && !scene.cut.is_drawn) way.x *= std::lerp(1.0, kAside, fringe);
  return way;
}

// Along the ground, unit: out over the border of where hair ends, at a right angle to it.
glm::dvec3 compute_across_border(const HairScene& scene, double azimuth_deg, const glm::dvec3& normal) {
  constexpr double kStep_deg = 3;
  const auto place_at = [&](double degree) {
    const HairPlace place{degree, sample_border(scene.ends, degree)};
    return compute_hair_point(scene.chart, place, compute_ground_mm(scene, place));
  };
  return flatten(glm::cross(place_at(azimuth_deg + kStep_deg) - place_at(azimuth_deg - kStep_deg), normal),
                 normal);
}

}  // namespace

glm::dvec3 flatten(const glm::dvec3& way, const glm::dvec3& normal) {
  const glm::dvec3 flat = way - normal * glm::dot(way, normal);
  const double length = glm::length(flat);
  return length < 1e-9 ? glm::dvec3(0) : flat / length;
}

glm::dvec3 compute_part_direction(const HairComb& comb, double share) {
  return compute_arc_direction(comb.side_mm, std::lerp(comb.from_deg, comb.to_deg, share), kSkull_mm);
}

std::vector<glm::dvec3> list_part_ways(const HairComb& comb) {
  std::vector<glm::dvec3> ways;
  for (int i = 0; i <= kPartSteps; ++i)
    ways.push_back(compute_part_direction(comb, static_cast<double>(i) / kPartSteps));
  return ways;
}

double compute_part_distance_mm(const HairScene& scene, const HairPlace& place) {
  if (scene.cut.comb.is_gathered) return 1e9;
  return compute_part_arm(scene, compute_hair_point(scene.chart, place, compute_ground_mm(scene, place)))
      .distance_mm;
}

double compute_combed_mm(const HairScene& scene, const HairPlace& place) {
  const HairPlace above{place.azimuth_deg, std::min(1.0, place.way)};
  const glm::dvec3 direction = compute_hair_direction(scene.chart, above);
  const glm::dvec3 part = find_part_point(scene, direction).direction;
  const double turn = 2 * std::asin(std::min(1.0, 0.5 * glm::length(direction - part)));
  return kSkull_mm * turn + std::max(0.0, place.way - 1) * scene.chart.drop_mm / scene.chart.size;
}

std::vector<double> spread_ring_stations(const HairScene& scene, int count) {
  constexpr double kPart_mm = 20, kCrown_mm = 120;  // from the part: so far it rises, so far it bends
  constexpr double kAtPart = 1.6, kStraight = 0.6,
                   kWaves = 0.9;  // rings a millimetre, of those on the crown
  constexpr double kStep_mm = 1;
  const double below = scene.cut.locks.wave_mm > 0 ? kWaves : kStraight;
  double longest_mm = 0;
  for (int degree = 0; degree <= 180; ++degree)
    longest_mm =
        std::max(longest_mm,
                 compute_combed_mm(scene, {static_cast<double>(degree), sample_border(scene.ends, degree)}));
  const auto density = [&](double at_mm) {
    return at_mm < kPart_mm ? kAtPart : at_mm < kCrown_mm ? 1 : below;
  };
  double whole = 0;
  for (double at = 0; at < longest_mm; at += kStep_mm) whole += density(at);
  std::vector<double> stations;
  double gone = 0;
  for (double at = 0; at < longest_mm; at += kStep_mm) {
    if (gone >= whole * static_cast<double>(stations.size()) / count) stations.push_back(at);
    gone += density(at);
  }
  return stations;
}

double compute_part_depth(const HairScene& scene, const HairPlace& place) {
  constexpr double kWide_mm = 16, kShallowest = 0.8;  // to either side; of the thickness, in the part itself
  if (scene.cut.comb.scalp_mm <= 0) return 1;
  return std::lerp(kShallowest, 1.0,
                   smooth_step(0, kWide_mm * scene.chart.size, compute_part_distance_mm(scene, place)));
}

PartArm compute_part_arm(const HairScene& scene, const glm::dvec3& at) {
  const HairComb& comb = scene.cut.comb;
  const glm::dvec3 direction = glm::normalize(at - scene.chart.centre);
  const auto [share, nearest] = find_part_point(scene, direction);
  const double turn = comb.from_deg + share * (comb.to_deg - comb.from_deg);
  const glm::dvec3 front(0, std::sin(turn * kRadiansPerDegree), std::cos(turn * kRadiansPerDegree));
  const glm::dvec3 arm = direction - nearest;
  const double skull_mm = kSkull_mm * scene.chart.size;
  const double along_mm = skull_mm * share * (comb.to_deg - comb.from_deg) * kRadiansPerDegree;
  const double ahead = glm::dot(arm, front);
  if (share > 0 && share < 1) return {skull_mm * glm::length(arm), 0, arm.x, along_mm - skull_mm * ahead};
  return {skull_mm * glm::length(arm), ahead, arm.x, along_mm};
}

HairPlace compute_part_place(const HairScene& scene, double share) {
  return compute_hair_place(scene.chart, scene.chart.centre + compute_part_direction(scene.cut.comb, share));
}

glm::dvec3 compute_comb(const HairScene& scene, const glm::dvec3& at, const glm::dvec3& normal,
                        double droop) {
  const HairComb& comb = scene.cut.comb;
  const glm::dvec3 direction = glm::normalize(at - scene.chart.centre);
  glm::dvec3 way(0);
  if (comb.is_gathered) {
    way = flatten(scene.knot - at, normal);
  } else {
    way = comb.away * flatten(compute_way_from_part(scene, direction), normal);
    way += (comb.down + droop) * flatten({0, -1, 0}, normal) + comb.back * flatten({0, 0, -1}, normal);
  }
  return flatten(way, normal);
}

double compute_open(const HairScene& scene, const HairPlace& place) {
  constexpr double kFalls_deg = 46, kFallsWhole_deg = 56;  // to the sides: there hair hangs past the face
  if (scene.cut.locks.from_part <= 0 || scene.ends.empty()) return 0;
  return (1 - sample_border(scene.hangs, 0)) *
         (1 - smooth_step(kFalls_deg, kFallsWhole_deg, std::abs(place.azimuth_deg)));
}

glm::dvec3 turn_aside(const HairScene& scene, const HairPlace& place, const glm::dvec3& at,
                      const glm::dvec3& normal, const glm::dvec3& way) {
  constexpr double kNear_mm = 34, kInside_mm = 3;  // from the border: there it turns, and there it has
  constexpr double kAlong = 0.9;
  constexpr double kLeastDown =
      0.1;  // of a border that runs down: where it is steep, little is left before it
  const double open = compute_open(scene, place);
  if (open <= 0) return way;
  const double border = sample_border(scene.ends, place.azimuth_deg);
  const glm::dvec3 across = compute_across_border(scene, place.azimuth_deg, normal);
  const double down = std::max(kLeastDown, glm::dot(across, flatten({0, -1, 0}, normal)));
  const double left_mm = down * (border - place.way) * scene.chart.drop_mm / scene.chart.size;
  const double share = open * (1 - smooth_step(kInside_mm, kNear_mm, left_mm));
  const double falls = glm::dot(way, across);
  if (share <= 0 || falls <= 0) return way;
  const double hand = std::copysign(1.0, at.x - scene.cut.comb.side_mm * scene.chart.size);
  const double beyond = left_mm < kInside_mm ? std::min(0.5, 0.1 * (kInside_mm - left_mm)) : 0;
  return flatten(way - share * (falls + beyond) * across + share * kAlong * hand * glm::cross(normal, across),
                 normal);
}

glm::dvec3 compute_comb_way(const HairScene& scene, const HairPlace& place, double gone_mm) {
  const glm::dvec3 at = compute_hair_point(scene.chart, place, compute_ground_mm(scene, place));
  const glm::dvec3 normal = compute_ground_normal(scene, place);
  const double droop = scene.cut.comb.droop * std::min(1.0, gone_mm / kWeight_mm);
  const glm::dvec3 way = compute_comb(scene, at, normal, droop);
  return way == glm::dvec3(0) ? flatten({0, -1, 0.1}, normal) : way;
}

void compute_knot(const HairScene& scene, glm::dvec3& at, glm::dvec3& out) {
  out = compute_arc_direction(0, scene.cut.comb.knot_deg, 1);
  const glm::dvec3 far = scene.chart.centre + 100.0 * scene.chart.size * out;
  const HairPlace place = compute_hair_place(scene.chart, far);
  at = compute_hair_point(scene.chart, place, compute_ground_mm(scene, place));
  at.x = 0;  // the sine of 180 degrees is not quite 0
}

bool has_long_part(const HairScene& scene) {
  constexpr double kWide_deg = 20;
  const HairComb& comb = scene.cut.comb;
  return !comb.is_gathered && comb.to_deg - comb.from_deg >= kWide_deg;
}

bool has_part(const HairScene& scene) {
  constexpr double kOrderly_deg = 9.5;  // of disorder
  return has_long_part(scene) && scene.cut.comb.jitter_deg <= kOrderly_deg;
}

}  // namespace mien

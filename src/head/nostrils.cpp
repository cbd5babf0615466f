#include "head/nostrils.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "head/cage.hpp"

namespace mien {

namespace {

constexpr std::array kRim{"c1_it", "c2_it", "c3_it", "k_it", "M6_3", "M6_2", "M6_1", "c1_cb"};
constexpr std::size_t kSpokes = kRim.size();

// A ring inside the rim, spoke by spoke, and how much of what a spoke's point of the rim does on its own it
// follows. The deeper ones a little more than all of it: where a rim is drawn in to a corner, less would fold
// the wall behind it, and more would fold the rim.
struct NostrilRing {
  const char* name;
  double share;
};
constexpr std::array kRings{NostrilRing{"na", 1}, NostrilRing{"nr", 1.05}, NostrilRing{"ni", 1.2},
                            NostrilRing{"nd", 1.2}};

// Half of this is hardly held back; never further than this. An adult's, mm.
constexpr double kReach_mm = 0.8;

// The rim's points, then the one above its middle.
struct Rim {
  std::array<glm::dvec3, kSpokes + 1> points{};
  double size_mm = 1;
};

Rim measure_rim(const std::vector<glm::dvec3>& points, const Cage& cage) {
  Rim rim;
  glm::dvec3 middle(0), area(0);
  for (std::size_t i = 0; i < kSpokes; ++i) {
    rim.points[i] = points[find_point(cage, kRim[i])];
    middle += rim.points[i] / static_cast<double>(kSpokes);
  }
  for (std::size_t i = 0; i < kSpokes; ++i)
    area += 0.5 * glm::cross(rim.points[i] - middle, rim.points[(i + 1) % kSpokes] - middle);
  rim.size_mm = std::sqrt(glm::length(area));
  rim.points[kSpokes] = middle + area / rim.size_mm;
  return rim;
}

// The affine map that carries one rim best to the other. A rim is nearly flat: the point above its middle
// says where "up" goes.
struct AffineMap {
  glm::dvec3 from{0}, to{0};
  glm::dmat3 matrix{1};

  glm::dvec3 carry(const glm::dvec3& p) const { return to + matrix * (p - from); }
};

AffineMap fit_affine_map(const Rim& then, const Rim& now) {
  constexpr double kShare = 1.0 / (kSpokes + 1);
  AffineMap map;
  for (std::size_t i = 0; i <= kSpokes; ++i) {
    map.from += kShare * then.points[i];
    map.to += kShare * now.points[i];
  }
  glm::dmat3 spread(0), carried(0);  // the normal equations about both middles
  for (std::size_t i = 0; i <= kSpokes; ++i) {
    const glm::dvec3 arm = then.points[i] - map.from;
    spread += glm::outerProduct(arm, arm);
    carried += glm::outerProduct(now.points[i] - map.to, arm);
  }
  map.matrix = carried * glm::inverse(spread);
  return map;
}

}  // namespace

void keep_nostrils(const Cage& cage, const std::vector<glm::dvec3>& before, std::vector<glm::dvec3>& points) {
  if (before == points) return;
  const Rim then = measure_rim(before, cage), now = measure_rim(points, cage);
  const AffineMap map = fit_affine_map(then, now);
  const double reach_mm = kReach_mm * now.size_mm / then.size_mm;
  for (const NostrilRing& ring : kRings)
    for (std::size_t i = 0; i < kSpokes; ++i) {
      const std::uint32_t point = find_point(cage, fmt::format("{}_{}", ring.name, i));
      const glm::dvec3 own = now.points[i] - map.carry(then.points[i]);
      const glm::dvec3 carried = map.carry(before[point]) + ring.share * own;
      const glm::dvec3 way = points[point] - carried;
      const glm::dvec3 kept = carried + way / std::sqrt(1 + glm::dot(way, way) / (reach_mm * reach_mm));
      points[point] = kept;
      points[cage.mirror[point]] = kept * glm::dvec3(-1, 1, 1);
    }
}

}  // namespace mien

#include "head/nostrils.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <array>

#include "head/cage.hpp"

namespace mien {

namespace {

constexpr std::array kRim{"c1_it", "c2_it", "c3_it", "k_it", "M6_3", "M6_2", "M6_1", "c1_cb"};
constexpr auto kSpokes = static_cast<Eigen::Index>(kRim.size());

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

Eigen::RowVector4d extend(const glm::dvec3& p) { return {p.x, p.y, p.z, 1}; }
Eigen::RowVector3d pack(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

// The rim's points, then the one above its middle.
struct Rim {
  std::array<glm::dvec3, kSpokes + 1> points{};
  double size_mm = 1;
};

Rim measure_rim(const std::vector<glm::dvec3>& points, const Cage& cage) {
  Rim rim;
  glm::dvec3 middle(0), area(0);
  for (Eigen::Index i = 0; i < kSpokes; ++i) {
    rim.points[i] = points[find_point(cage, kRim[i])];
    middle += rim.points[i] / static_cast<double>(kSpokes);
  }
  for (Eigen::Index i = 0; i < kSpokes; ++i)
    area += 0.5 * glm::cross(rim.points[i] - middle, rim.points[(i + 1) % kSpokes] - middle);
  rim.size_mm = std::sqrt(glm::length(area));
  rim.points[kSpokes] = middle + area / rim.size_mm;
  return rim;
}

}  // namespace

void keep_nostrils(const Cage& cage, const std::vector<glm::dvec3>& before, std::vector<glm::dvec3>& points) {
  if (before == points) return;
  const Rim then = measure_rim(before, cage), now = measure_rim(points, cage);
  // The affine map that carries the rim best from then to now. A rim is nearly flat: a point above its
  // middle says where "up" goes.
  Eigen::Matrix<double, kSpokes + 1, 4> from;
  Eigen::Matrix<double, kSpokes + 1, 3> to;
  for (Eigen::Index i = 0; i <= kSpokes; ++i) {
    from.row(i) = extend(then.points[i]);
    to.row(i) = pack(now.points[i]);
  }
  const Eigen::Matrix<double, 4, 3> map = from.colPivHouseholderQr().solve(to);
  const Eigen::Matrix<double, kSpokes + 1, 3> own = to - from * map;
  const double reach_mm = kReach_mm * now.size_mm / then.size_mm;
  for (const NostrilRing& ring : kRings)
    for (Eigen::Index i = 0; i < kSpokes; ++i) {
      const std::uint32_t point = find_point(cage, fmt::format("{}_{}", ring.name, i));
      const Eigen::RowVector3d carried = extend(before[point]) * map + ring.share * own.row(i);
      const Eigen::RowVector3d way = pack(points[point]) - carried;
      const double length = way.norm();
      const Eigen::RowVector3d kept = carried + way / std::sqrt(1 + length * length / (reach_mm * reach_mm));
      points[point] = {kept(0), kept(1), kept(2)};
      points[cage.mirror[point]] = {-kept(0), kept(1), kept(2)};
    }
}

}  // namespace mien

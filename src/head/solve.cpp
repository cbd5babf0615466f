#include "head/solve.hpp"

#include <Eigen/Sparse>
#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "core/error.hpp"
#include "head/neighbours.hpp"

namespace mien {

namespace {

using Triplet = Eigen::Triplet<double>;
using Row = std::vector<std::pair<std::uint32_t, double>>;  // (point, weight): a linear form over the cage

// The strength of all fairness against the skin points' weights. Lower: typing noise shows; higher: features
// melt.
constexpr double kFairness = 0.06;
constexpr double kThirdDifference = 6.0;  // of kFairness, for each edge inside a broad form
constexpr double kBroadUmbrella = 0.10;   // what is left there of the umbrella operator, which shrinks
constexpr double kHardWeight = 1000;      // a hidden control point stays where it was typed

// Regions by the first prefix that fits, and their share of kFairness. Neighbouring rows must not differ
// much, or the weaker one stands out as a ridge.
struct RegionFairness {
  std::string_view prefix;
  double factor;
};
constexpr std::array kRegions{
    RegionFairness{"cap", 0.8}, RegionFairness{"s", 2.0},   RegionFairness{"q", 3.0},
    RegionFairness{"f", 0.8},   RegionFairness{"c2", 0.35}, RegionFairness{"c3", 0.35},
    RegionFairness{"k", 0.35},  RegionFairness{"n", 0.35},
};

double compute_fairness(const SkinPoint& point) {
  const std::string_view name = point.name;
  if (!point.skin) return 3;
  if (name.find("_N") != name.npos || name.ends_with("_D2")) return 4;
  if (name.ends_with("_D1")) return 3;
  if (name.find("_F") != name.npos) return 0.8;
  for (const RegionFairness& region : kRegions)
    if (name.starts_with(region.prefix)) return region.factor;
  return 1;
}

bool is_broad_form(std::string_view name) {
  name = strip_side(name);
  if (name.starts_with("er")) return name.starts_with("er1_");
  return name.starts_with("s") || name.starts_with("f") || name.starts_with("cap") || name.starts_with("q") ||
         name.find("_F") != name.npos || name.find("_N") != name.npos || name.find("_D") != name.npos;
}

Row limit_row(const PointRing& ring, std::uint32_t point) {
  const auto n = static_cast<double>(ring.edges.size());
  const double total = n * (n + 5);
  Row row{{point, n * n / total}};
  for (const std::uint32_t k : ring.edges) row.emplace_back(k, 4 / total);
  for (const std::uint32_t k : ring.diagonals) row.emplace_back(k, 1 / total);
  return row;
}

// sum_k w_k c_k / sum_k w_k - c_v, with w = 1 / edge length so that uneven ring spacing is not faired away.
Row umbrella_row(const Cage& cage, const PointRing& ring, std::uint32_t point, bool by_length) {
  double sum = 0;
  Row row;
  for (const std::uint32_t k : ring.edges) {
    const double length = glm::length(cage.points[k] - cage.points[point]);
    const double weight = by_length ? 1 / std::max(length, 1e-3) : 1;
    row.emplace_back(k, weight);
    sum += weight;
  }
  for (auto& entry : row) entry.second /= sum;
  row.emplace_back(point, -1.0);
  return row;
}

struct Normals {  // the normal equations, collected row by row
  std::vector<Triplet> entries;
  Eigen::MatrixX3d right;

  void add(const Row& row, double weight, const glm::dvec3& target) {
    for (const auto& [i, wi] : row) {
      for (const auto& [j, wj] : row) entries.emplace_back(i, j, weight * wi * wj);
      for (int axis = 0; axis < 3; ++axis) right(i, axis) += weight * wi * target[axis];
    }
  }
};

Row subtract(const Row& a, const Row& b) {
  std::map<std::uint32_t, double> sum;
  for (const auto& [i, w] : a) sum[i] += w;
  for (const auto& [i, w] : b) sum[i] -= w;
  return {sum.begin(), sum.end()};
}

void solve_pass(const HalfHead& half, const std::vector<PointRing>& rings, bool is_first, Cage& cage) {
  const auto count = static_cast<std::uint32_t>(cage.points.size());
  Normals normals{{}, Eigen::MatrixX3d::Zero(count, 3)};
  std::vector<Row> umbrellas(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const bool is_left = i < half.points.size();
    const SkinPoint& point = half.points[is_left ? i : cage.mirror[i]];
    const glm::dvec3 side(is_left ? 1 : -1, 1, 1);
    umbrellas[i] = umbrella_row(cage, rings[i], i, !is_first);
    if (point.is_hard) {
      normals.add({{i, 1.0}}, kHardWeight, *point.skin * side);
      continue;
    }
    if (point.skin) {
      const bool has_limit = !is_first && !rings[i].is_boundary;
      normals.add(has_limit ? limit_row(rings[i], i) : Row{{i, 1.0}}, point.weight, *point.skin * side);
    }
    const double share = is_broad_form(cage.names[i]) ? kBroadUmbrella : 1;
    normals.add(umbrellas[i], kFairness * compute_fairness(point) * share, glm::dvec3(0));
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!is_broad_form(cage.names[i]) || rings[i].is_boundary) continue;
    for (const std::uint32_t k : rings[i].edges)
      if (k > i && is_broad_form(cage.names[k]) && !rings[k].is_boundary)
        normals.add(subtract(umbrellas[i], umbrellas[k]), kFairness * kThirdDifference, glm::dvec3(0));
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(normals.entries.begin(), normals.entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
  if (factors.info() != Eigen::Success) throw RunError("the cage's equations cannot be solved");
  const Eigen::MatrixX3d solution = factors.solve(normals.right);
  for (std::uint32_t i = 0; i < count; ++i) cage.points[i] = {solution(i, 0), solution(i, 1), solution(i, 2)};
  for (std::uint32_t i = 0; i < half.points.size(); ++i) {
    if (cage.mirror[i] == i) cage.points[i].x = 0;
    cage.points[cage.mirror[i]] = cage.points[i] * glm::dvec3(cage.mirror[i] == i ? 1 : -1, 1, 1);
  }
}

}  // namespace

void solve_cage(const HalfHead& half, Cage& cage) {
  const std::vector<PointRing> rings = compute_rings(cage);
  constexpr int kPasses = 3;  // the edge lengths of pass 2 hardly differ from those of pass 1
  for (int pass = 0; pass < kPasses; ++pass) solve_pass(half, rings, pass == 0, cage);
}

}  // namespace mien

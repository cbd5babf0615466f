#include "head/least_squares.hpp"

#include <Eigen/Sparse>
#include <algorithm>

#include "core/error.hpp"
#include "head/neighbours.hpp"
#include "head/surface.hpp"

namespace mien {

std::vector<glm::dvec3> solve_least_squares(const LeastSquares& problem, std::size_t point_count) {
  const auto count = static_cast<Eigen::Index>(point_count);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(count, 3);
  for (const auto& [row, weight, target] : problem.equations)
    for (const auto& [i, wi] : row) {
      for (const auto& [j, wj] : row) entries.emplace_back(i, j, weight * wi * wj);
      for (int axis = 0; axis < 3; ++axis) right(i, axis) += weight * wi * target[axis];
    }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
  if (factors.info() != Eigen::Success) throw RunError("internal: the cage's equations cannot be solved");
  const Eigen::MatrixX3d solution = factors.solve(right);
  std::vector<glm::dvec3> points(point_count);
  for (std::size_t i = 0; i < point_count; ++i) points[i] = {solution(i, 0), solution(i, 1), solution(i, 2)};
  return points;
}

LinearRow compute_limit_row(const Surface& surface, std::size_t v) {
  LinearRow row;
  for (std::uint32_t k = surface.first[v]; k < surface.first[v + 1]; ++k)
    row.emplace_back(surface.point[k], surface.weight[k]);
  return row;
}

LinearRow compute_mean_row(const Surface& surface, const std::vector<std::uint32_t>& vertices,
                           const std::vector<double>& shares) {
  LinearRow mean;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (const auto& [point, weight] : compute_limit_row(surface, vertices[i]))
      mean.emplace_back(point, weight * shares[i]);
  return mean;
}

glm::dvec3 sample_row(const LinearRow& row, const std::vector<glm::dvec3>& points) {
  glm::dvec3 sum{0};
  for (const auto& [point, weight] : row) sum += weight * points[point];
  return sum;
}

std::vector<LinearRow> compute_umbrella_rows(const Cage& cage) {
  const std::vector<PointRing> rings = compute_rings(cage);
  std::vector<LinearRow> rows(cage.points.size());
  for (std::uint32_t i = 0; i < rows.size(); ++i) {
    double sum = 0;
    for (const std::uint32_t k : rings[i].edges) {
      const double weight = 1 / std::max(glm::length(cage.points[k] - cage.points[i]), 1e-3);
      rows[i].emplace_back(k, weight);
      sum += weight;
    }
    for (auto& entry : rows[i]) entry.second /= sum;
    rows[i].emplace_back(i, -1.0);
  }
  return rows;
}

void mirror_half(const Cage& cage, std::vector<glm::dvec3>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t image = cage.mirror[i];
    if (image == i) points[i].x = 0;
    if (image > i) points[image] = points[i] * glm::dvec3(-1, 1, 1);
  }
}

}  // namespace mien

#include "head/fields.hpp"

#include <fmt/format.h>
#include <Eigen/Sparse>
#include <algorithm>

#include "core/error.hpp"
#include "head/cage.hpp"
#include "head/neighbours.hpp"

namespace mien {

namespace {

using Matrix = Eigen::SparseMatrix<double>;

constexpr double kConstraint = 50;  // of handles and anchors against the energy: within 2 % of the asked move
constexpr double kStrip_mm = 12;    // half width of the middle strip that one side's move may drag

const glm::dvec3 kEven(-1, 1, 1), kOdd(1, -1, -1);  // what the other half does, of what the left half does

// Symmetric fields must be exactly symmetric: average with the mirror image, which differs by rounding only.
void symmetrise(const Cage& cage, const glm::dvec3& image, Field& field) {
  for (std::size_t i = 0; i < field.size(); ++i) {
    const std::size_t m = cage.mirror[i];
    if (m == i) field[i] = 0.5 * (field[i] + field[i] * image);
    if (m <= i) continue;
    const glm::dvec3 mean = 0.5 * (field[i] + field[m] * image);
    field[i] = mean;
    field[m] = mean * image;
  }
}

}  // namespace

struct FieldSolver::State {
  Matrix energy;  // (L^T L), L the 1/length-weighted Laplacian
  Eigen::SimplicialLDLT<Matrix> factors;
  std::vector<bool> factored;  // the points that were constrained in `factors`; empty: none yet
};

FieldSolver build_field_solver(const Cage& cage) {
  const std::vector<PointRing> rings = compute_rings(cage);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::uint32_t i = 0; i < cage.points.size(); ++i) {
    double sum = 0;
    std::vector<double> weights;
    for (const std::uint32_t k : rings[i].edges) {
      weights.push_back(1 / std::max(glm::length(cage.points[k] - cage.points[i]), 1e-3));
      sum += weights.back();
    }
    entries.emplace_back(i, i, -1.0);
    for (std::size_t e = 0; e < weights.size(); ++e)
      entries.emplace_back(i, rings[i].edges[e], weights[e] / sum);
  }
  const auto count = static_cast<Eigen::Index>(cage.points.size());
  Matrix laplacian(count, count);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  FieldSolver solver{std::make_shared<FieldSolver::State>(), &cage};
  Matrix identity(count, count);
  identity.setIdentity();
  // The diagonal must be in the pattern, since constraints are added there.
  solver.state->energy = Matrix(laplacian.transpose() * laplacian) + 1e-12 * identity;
  solver.state->factors.analyzePattern(solver.state->energy);
  return solver;
}

namespace {

// Solves (energy + diag(constraint)) u = constraint * target, for the columns of `target`.
Eigen::MatrixXd solve_constrained(const FieldSolver& solver, const std::vector<bool>& is_constrained,
                                  const Eigen::MatrixXd& target) {
  FieldSolver::State& state = *solver.state;
  if (state.factored != is_constrained) {
    state.factored.clear();
    Matrix matrix = state.energy;
    for (Eigen::Index i = 0; i < target.rows(); ++i)
      if (is_constrained[i]) matrix.coeffRef(i, i) += kConstraint;
    state.factors.factorize(matrix);
    if (state.factors.info() != Eigen::Success) throw RunError("a field's equations cannot be solved");
    state.factored = is_constrained;
  }
  return state.factors.solve(Eigen::MatrixXd(target * kConstraint));
}

}  // namespace

Field solve_field(const FieldSolver& solver, const Handles& handles, const std::vector<bool>& anchors,
                  Reach reach) {
  const Cage& cage = *solver.cage;
  std::vector<bool> is_constrained = anchors;
  Eigen::MatrixXd target = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(cage.points.size()), 3);
  const auto constrain = [&](std::uint32_t i, const glm::dvec3& move) {
    is_constrained[i] = true;
    for (int axis = 0; axis < 3; ++axis) target(i, axis) = move[axis];
  };
  for (const auto& [name, move] : handles) {
    const std::uint32_t i = find_point(cage, name), m = cage.mirror[i];
    if (m != i && reach != Reach::left) constrain(m, move * (reach == Reach::odd ? kOdd : kEven));
    if (m != i && reach == Reach::left) {
      if (cage.points[i].x > kStrip_mm)
        constrain(m, glm::dvec3(0));
      else
        is_constrained[m] = false;
    }
  }
  for (const auto& [name, move] : handles) constrain(find_point(cage, name), move);

  const Eigen::MatrixXd solution = solve_constrained(solver, is_constrained, target);
  Field field(cage.points.size());
  for (std::size_t i = 0; i < field.size(); ++i) field[i] = {solution(i, 0), solution(i, 1), solution(i, 2)};
  if (reach != Reach::left) symmetrise(cage, reach == Reach::odd ? kOdd : kEven, field);
  return field;
}

std::vector<double> solve_weights(const FieldSolver& solver, const std::map<std::string, double>& values,
                                  const std::vector<bool>& zeros) {
  const Cage& cage = *solver.cage;
  std::vector<bool> is_constrained = zeros;
  Eigen::MatrixXd target = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(cage.points.size()), 1);
  for (const auto& [name, value] : values)
    for (const std::uint32_t i : {find_point(cage, name), cage.mirror[find_point(cage, name)]}) {
      is_constrained[i] = true;
      target(i, 0) = value;
    }
  const Eigen::MatrixXd solution = solve_constrained(solver, is_constrained, target);
  std::vector<double> weights(cage.points.size());
  for (std::size_t i = 0; i < weights.size(); ++i)
    weights[i] = 0.5 * (solution(i, 0) + solution(cage.mirror[i], 0));  // exactly alike on both sides
  return weights;
}

Field mirror_field(const Cage& cage, const Field& field) {
  Field mirrored(field.size());
  for (std::size_t i = 0; i < field.size(); ++i) mirrored[i] = field[cage.mirror[i]] * glm::dvec3(-1, 1, 1);
  return mirrored;
}

}  // namespace mien

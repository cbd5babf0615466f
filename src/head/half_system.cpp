#include "head/half_system.hpp"

#include <Eigen/Sparse>
#include <algorithm>

#include "core/error.hpp"

namespace mien {

using Matrix = Eigen::SparseMatrix<double>;

struct HalfSystem::State {
  Matrix matrix;                                   // lower triangle
  std::vector<std::array<Eigen::Index, 3>> slots;  // of each block: where its three columns begin
  Eigen::SimplicialLDLT<Matrix> factors;
};

HalfRow build_half_row(const Cage& cage, const LinearRow& row) {
  std::vector<HalfTerm> terms;
  for (const auto& [point, weight] : row) {
    const std::uint32_t image = cage.mirror[point];
    terms.push_back({std::min(point, image), image == point ? 0 : image < point ? -weight : weight, weight});
  }
  std::stable_sort(terms.begin(), terms.end(),
                   [](const HalfTerm& a, const HalfTerm& b) { return a.point < b.point; });
  HalfRow half;
  for (const HalfTerm& term : terms) {
    if (!half.terms.empty() && half.terms.back().point == term.point) {
      half.terms.back().x += term.x;
      half.terms.back().yz += term.yz;
    } else {
      half.terms.push_back(term);
    }
  }
  return half;
}

HalfSystem build_half_system(const Cage& cage, std::size_t half_count,
                             const std::vector<std::vector<HalfRow>*>& rows) {
  HalfSystem system;
  system.point_count = half_count;
  for (std::uint32_t i = 0; i < half_count; ++i) system.is_middle.push_back(cage.mirror[i] == i);
  // Which points meet: of each column j its rows i >= j.
  std::vector<std::vector<std::uint32_t>> columns(half_count);
  for (std::uint32_t i = 0; i < half_count; ++i) columns[i].push_back(i);
  for (const std::vector<HalfRow>* list : rows)
    for (const HalfRow& row : *list)
      for (std::size_t i = 0; i < row.terms.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j) columns[row.terms[j].point].push_back(row.terms[i].point);
  std::vector<std::uint32_t> begin{0};
  for (auto& column : columns) {
    std::sort(column.begin(), column.end());
    column.erase(std::unique(column.begin(), column.end()), column.end());
    begin.push_back(begin.back() + static_cast<std::uint32_t>(column.size()));
  }
  for (std::vector<HalfRow>* list : rows)
    for (HalfRow& row : *list)
      for (std::size_t i = 0; i < row.terms.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j) {
          const auto& column = columns[row.terms[j].point];
          const auto at = std::lower_bound(column.begin(), column.end(), row.terms[i].point) - column.begin();
          row.blocks.push_back(begin[row.terms[j].point] + static_cast<std::uint32_t>(at));
        }

  system.state = std::make_shared<HalfSystem::State>();
  const auto size = static_cast<Eigen::Index>(3 * half_count);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::uint32_t j = 0; j < half_count; ++j)
    for (const std::uint32_t i : columns[j])
      for (int b = 0; b < 3; ++b)
        for (int a = 0; a < 3; ++a) entries.emplace_back(3 * i + a, 3 * j + b, 1.0);
  Matrix& matrix = system.state->matrix;
  matrix.resize(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  for (std::uint32_t j = 0; j < half_count; ++j)
    for (std::size_t k = 0; k < columns[j].size(); ++k) {
      std::array<Eigen::Index, 3> slots{};
      for (int b = 0; b < 3; ++b)
        slots[b] = matrix.outerIndexPtr()[3 * j + b] + 3 * static_cast<Eigen::Index>(k);
      system.state->slots.push_back(slots);
    }
  system.state->factors.analyzePattern(matrix);
  clear_equations(system);
  return system;
}

void clear_equations(HalfSystem& system) {
  system.blocks.assign(system.state->slots.size(), {});
  system.right.assign(system.point_count, glm::dvec3(0));
}

void add_equation(HalfSystem& system, const HalfRow& row, const glm::dvec3& target, const glm::dvec3& normal,
                  double plane, double free) {
  std::array<double, 9> metric{};
  for (int b = 0; b < 3; ++b)
    for (int a = 0; a < 3; ++a) metric[3 * b + a] = plane * normal[a] * normal[b] + (a == b ? free : 0);
  const glm::dvec3 pull = plane * normal * glm::dot(normal, target) + free * target;
  std::size_t pair = 0;
  for (std::size_t i = 0; i < row.terms.size(); ++i) {
    const HalfTerm& ti = row.terms[i];
    const std::array<double, 3> fi{ti.x, ti.yz, ti.yz};
    for (int a = 0; a < 3; ++a) system.right[ti.point][a] += fi[a] * pull[a];
    for (std::size_t j = 0; j <= i; ++j, ++pair) {
      const HalfTerm& tj = row.terms[j];
      const std::array<double, 3> fj{tj.x, tj.yz, tj.yz};
      std::array<double, 9>& block = system.blocks[row.blocks[pair]];
      for (int b = 0; b < 3; ++b)
        for (int a = 0; a < 3; ++a) block[3 * b + a] += metric[3 * b + a] * fi[a] * fj[b];
    }
  }
}

std::vector<glm::dvec3> solve_equations(HalfSystem& system) {
  HalfSystem::State& state = *system.state;
  double* values = state.matrix.valuePtr();
  for (std::size_t k = 0; k < system.blocks.size(); ++k)
    for (int b = 0; b < 3; ++b)
      for (int a = 0; a < 3; ++a) values[state.slots[k][b] + a] = system.blocks[k][3 * b + a];
  Eigen::VectorXd right(static_cast<Eigen::Index>(3 * system.point_count));
  for (std::size_t i = 0; i < system.point_count; ++i) {
    for (int axis = 0; axis < 3; ++axis)
      right(static_cast<Eigen::Index>(3 * i) + axis) = system.right[i][axis];
    // Points of the middle have no x: an equation of its own keeps the matrix regular.
    const auto x = static_cast<Eigen::Index>(3 * i);
    if (system.is_middle[i]) state.matrix.coeffRef(x, x) += 1;
  }
  state.factors.factorize(state.matrix);
  if (state.factors.info() != Eigen::Success)
    throw RunError("internal: the half's equations cannot be solved");
  const Eigen::VectorXd solution = state.factors.solve(right);
  std::vector<glm::dvec3> moves(system.point_count);
  for (std::size_t i = 0; i < system.point_count; ++i) {
    const auto x = static_cast<Eigen::Index>(3 * i);
    moves[i] = {system.is_middle[i] ? 0 : solution(x), solution(x + 1), solution(x + 2)};
  }
  return moves;
}

}  // namespace mien

// Displacements of one half's control points as the unknowns of a least-squares problem; the other half is
// the mirror image, so that what is known of either side counts for both.
#pragma once

#include <array>
#include <memory>

#include "head/least_squares.hpp"

namespace mien {

// A linear form over the half: x and the other two axes have different factors, as mirrored points count
// with -x and points of the middle with no x at all.
struct HalfTerm {
  std::uint32_t point = 0;  // of the half
  double x = 0, yz = 0;
};

struct HalfRow {
  std::vector<HalfTerm> terms;
  std::vector<std::uint32_t> blocks;  // of each pair of terms (j <= i), filled by build_half_system
};

HalfRow build_half_row(const Cage& cage, const LinearRow& row);

struct HalfSystem {
  struct State;  // the sparse matrix and its symbolic factors
  std::shared_ptr<State> state;
  std::size_t point_count = 0;
  std::vector<bool> is_middle;
  std::vector<std::array<double, 9>> blocks;  // 3 x 3, by column, for each pair of points that meet in a row
  std::vector<glm::dvec3> right;
};

// A system whose equations will be these rows and no others.
HalfSystem build_half_system(const Cage& cage, std::size_t half_count,
                             const std::vector<std::vector<HalfRow>*>& rows);

void clear_equations(HalfSystem& system);

// Adds (row - target)^T (plane normal normal^T + free) (row - target): `plane` holds the row to the plane
// through the target, `free` to the target itself.
void add_equation(HalfSystem& system, const HalfRow& row, const glm::dvec3& target, const glm::dvec3& normal,
                  double plane, double free);

// The displacements of the half's points.
std::vector<glm::dvec3> solve_equations(HalfSystem& system);

}  // namespace mien

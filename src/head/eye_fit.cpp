#include "head/eye_fit.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "head/least_squares.hpp"
#include "head/surface.hpp"

namespace mien {

namespace {

constexpr double kUnmoved_mm = 1e-6;  // rounding; less would make the ball follow it
// The least height of a lid above the ball, as a share of the adult's at that point: the ball must not show
// through, and a rim that a person made thinner may stay so.
constexpr double kLeastGap = 0.7;

// The points of the left lids' rings, by their numbers in the cage.
std::vector<std::uint32_t> compute_lid_points(const Cage& cage) {
  std::vector<std::uint32_t> points;
  for (const char* ring : {"E0_", "E1_", "E2_"})
    for (int i = 0; i < 16; ++i) points.push_back(find_point(cage, ring + std::to_string(i)));
  return points;
}

// Lids that sink into the ball are lifted straight outward, a few times since neighbours share their places.
void seat_lids(const HeadStock& stock, HeadForm& form) {
  const Eye adult_eye;
  const double scale = form.eye.radius_mm / adult_eye.radius_mm;
  constexpr int kRounds = 12;  // the rest is below a hundredth of a millimetre
  for (int round = 0; round < kRounds; ++round)
    for (const std::uint32_t i : compute_lid_points(stock.adult)) {
      const LinearRow row = compute_limit_row(*stock.surface, i);
      const double adult_gap =
          glm::length(sample_row(row, stock.adult.points) - adult_eye.centre) - adult_eye.radius_mm;
      const glm::dvec3 out = sample_row(row, form.points) - form.eye.centre;
      const double shortfall = kLeastGap * scale * adult_gap - (glm::length(out) - form.eye.radius_mm);
      if (shortfall <= 0) continue;
      form.points[i] += glm::normalize(out) * shortfall;
    }
  mirror_half(stock.adult, form.points);
}

}  // namespace

glm::dvec3 apply_similarity(const Similarity& similarity, const glm::dvec3& point) {
  return similarity.scale * (similarity.rotation * point) + similarity.shift;
}

Similarity fit_similarity(const std::vector<glm::dvec3>& from, const std::vector<glm::dvec3>& to) {
  const auto count = static_cast<Eigen::Index>(from.size());
  Eigen::Matrix3Xd source(3, count), target(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    source.col(i) << from[i].x, from[i].y, from[i].z;
    target.col(i) << to[i].x, to[i].y, to[i].z;
  }
  const Eigen::Matrix4d found = Eigen::umeyama(source, target, true);
  Similarity similarity;
  similarity.scale = found.block<3, 1>(0, 0).norm();
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      similarity.rotation[column][row] = found(row, column) / similarity.scale;
  similarity.shift = {found(0, 3), found(1, 3), found(2, 3)};
  return similarity;
}

void fit_eye(const HeadStock& stock, const std::vector<glm::dvec3>& before, HeadForm& form) {
  std::vector<glm::dvec3> from, to;
  double moved = 0;
  for (const std::uint32_t i : compute_lid_points(stock.adult)) {
    const LinearRow row = compute_limit_row(*stock.surface, i);
    from.push_back(sample_row(row, before));
    to.push_back(sample_row(row, form.points));
    moved = std::max(moved, glm::length(to.back() - from.back()));
  }
  if (moved < kUnmoved_mm) return;
  const Similarity similarity = fit_similarity(from, to);
  form.eye.centre = apply_similarity(similarity, form.eye.centre);
  form.eye.radius_mm *= similarity.scale;
  seat_lids(stock, form);
}

}  // namespace mien

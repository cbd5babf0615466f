#include "head/contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include "core/conventions.hpp"
#include "head/cage.hpp"
#include "head/lid_rest.hpp"
#include "head/lip_sheet.hpp"

namespace mien {

namespace {

constexpr int kLidColumns = 16;

// Where a vertex of the skin lies while the cage is moved.
glm::dvec3 compute_limit(const Surface& surface, const Cage& cage, std::uint32_t vertex) {
  glm::dvec3 sum{0};
  for (std::uint32_t k = surface.first[vertex]; k < surface.first[vertex + 1]; ++k)
    sum += static_cast<double>(surface.weight[k]) * cage.points[surface.point[k]];
  return sum;
}

void move_both(Cage& cage, std::uint32_t point, const glm::dvec3& move) {
  cage.points[point] += move;
  if (cage.mirror[point] == point)
    cage.points[point].x = 0;
  else
    cage.points[cage.mirror[point]] = cage.points[point] * glm::dvec3(-1, 1, 1);
}

// The vertices of the skin in the cage's left quads whose corners all fulfil `is_wanted`, each once, and the
// quads they make.
struct Sheet {
  std::vector<std::uint32_t> vertices;
  std::vector<Quad> quads;
};

template <typename Wanted>
Sheet compute_sheet(const Surface& surface, const Cage& cage, const Wanted& is_wanted) {
  Sheet sheet;
  for (std::size_t q = 0; q < cage.quads.size() / 2; ++q) {
    const Quad& quad = cage.quads[q];
    if (!std::all_of(quad.begin(), quad.end(), is_wanted)) continue;
    for (std::size_t i = 0; i < 32; i += 2) sheet.quads.push_back(surface.quads[32 * q + i]);
  }
  for (const Quad& quad : sheet.quads) sheet.vertices.insert(sheet.vertices.end(), quad.begin(), quad.end());
  std::sort(sheet.vertices.begin(), sheet.vertices.end());
  sheet.vertices.erase(std::unique(sheet.vertices.begin(), sheet.vertices.end()), sheet.vertices.end());
  return sheet;
}

}  // namespace

bool touches_eye(double at) {
  constexpr double kInner = 1.4, kOuter = 0.6;  // columns beside the corners
  return at > kInner && at < kLidColumns - kInner && std::abs(at - 8) > kOuter;
}

std::vector<MarginVertex> compute_lid_ring(const Surface& surface, const Cage& cage, const LidRings& rings) {
  std::vector<int> column(cage.points.size());
  for (std::size_t i = 0; i < column.size(); ++i) column[i] = compute_ring_column(cage.names[i], rings.ring);
  const auto is_in = [&](std::uint32_t p) { return column[p] >= 0 || cage.names[p].starts_with(rings.next); };
  const auto is_out = [&](std::uint32_t p) {
    return column[p] >= 0 || cage.names[p].starts_with(rings.before);
  };
  const Sheet in = compute_sheet(surface, cage, is_in), out = compute_sheet(surface, cage, is_out);
  std::vector<std::uint32_t> shared;
  std::set_intersection(in.vertices.begin(), in.vertices.end(), out.vertices.begin(), out.vertices.end(),
                        std::back_inserter(shared));
  std::vector<MarginVertex> margin;
  for (const std::uint32_t v : shared) {
    // The ring's own weights are those of a spline along it: their middle is the place along it.
    double sum = 0, x = 0, y = 0;
    for (std::uint32_t k = surface.first[v]; k < surface.first[v + 1]; ++k)
      if (const int c = column[surface.point[k]]; c >= 0) {
        const double turn = 2 * std::numbers::pi * c / kLidColumns;
        sum += surface.weight[k];
        x += surface.weight[k] * std::cos(turn);
        y += surface.weight[k] * std::sin(turn);
      }
    if (sum <= 0) continue;
    const double at = std::atan2(y, x) / (2 * std::numbers::pi) * kLidColumns;
    margin.push_back({v, at < 0 ? at + kLidColumns : at});
  }
  return margin;
}

double compute_standoff_mm(const EyeNumbers& numbers, const Eye& eye, const glm::dvec3& point) {
  const double scale = eye.radius_mm / numbers.ball_mm, out = numbers.outward_deg * kRadiansPerDegree;
  const glm::dvec3 arm = (point - eye.centre) / scale;
  const glm::dvec3 axis(std::sin(out), 0, std::cos(out));
  const double length = glm::length(arm), along = glm::dot(arm, axis);
  const double share = std::sqrt(std::max(0.0, length * length - along * along)) / numbers.cornea_edge_mm;
  if (along <= 0 || share >= 1) return scale * (length - numbers.ball_mm);
  const double rise = numbers.cornea_rise_mm * std::pow(1 - share * share, kCorneaSwell) + kCorneaLift_mm;
  return scale * (length - numbers.ball_mm - rise * along / length);
}

void touch_ball(const Surface& surface, const EyeNumbers& numbers, const Eye& eye, Cage& cage) {
  constexpr double kOff_mm = 0.16;  // 0 shows the ball's facets through the lid, 0.4 a gap from the side
  constexpr int kRounds = 8;        // a round leaves about a third of what is amiss
  const std::vector<MarginVertex> margin = compute_lid_ring(surface, cage);
  std::array<std::uint32_t, kLidColumns> points{};
  for (int c = 0; c < kLidColumns; ++c) points[c] = find_point(cage, fmt::format("E0_{}", c));
  for (int round = 0; round < kRounds; ++round) {
    std::array<double, kLidColumns> sum{}, weight{};
    for (const auto& [vertex, at] : margin) {
      if (!touches_eye(at)) continue;
      const double shortfall =
          kOff_mm - compute_standoff_mm(numbers, eye, compute_limit(surface, cage, vertex));
      for (int c = 0; c < kLidColumns; ++c)
        if (const double near = 1 - std::abs(at - c); near > 0) {
          sum[c] += near * shortfall;
          weight[c] += near;
        }
    }
    for (int c = 0; c < kLidColumns; ++c)
      if (weight[c] > 0)
        move_both(cage, points[c],
                  glm::normalize(cage.points[points[c]] - eye.centre) * (1.3 * sum[c] / weight[c]));
  }
}

void seat_lids(const Surface& surface, const EyeNumbers& numbers, const Eye& eye, Cage& cage) {
  constexpr int kTurns = 2;  // seating a lid that was turned far shifts its edge by a tenth of a millimetre
  for (int turn = 0; turn < kTurns; ++turn) {
    rest_lids(surface, numbers, eye, cage);
    touch_ball(surface, numbers, eye, cage);
  }
}

namespace {

// Where the lips' lines lie one before the other they do not touch, but the upper one stays the upper one.
void keep_order(const Surface& surface, const Cage& cage, LipShortfalls& shortfalls) {
  constexpr double kLeast_mm = 0.01;
  for (int column = 0; column < kLipColumns; ++column)
    for (const char* ring : kLipRings) {
      const auto height = [&](int i) {
        return compute_limit(surface, cage, find_point(cage, ring + std::to_string(i))).y;
      };
      shortfalls[column] =
          std::max(shortfalls[column], kLeast_mm - (height(column) - height(2 * kLipColumns - column)));
    }
}

}  // namespace

void part_lips(const Surface& surface, Cage& cage) {
  constexpr std::array kShares{1.0, 1.0, 0.35};  // of rings M0, M1, M2: the red's border hardly knows
  constexpr int kRounds = 12;                    // each takes away half or more; lips that are apart need one
  constexpr double kApart_mm = 0.03;             // less lets facets of the two touch; more shows a slit
  const LipSheet upper = build_lip_sheet(surface, cage, true), lower = build_lip_sheet(surface, cage, false);
  std::vector<glm::dvec3> upper_at, lower_at;
  for (int round = 0; round < kRounds; ++round) {
    place_lip(upper, cage.points, Side::left, upper_at);
    place_lip(lower, cage.points, Side::left, lower_at);
    LipShortfalls shortfalls{};
    compute_lip_shortfalls(upper, upper_at, lower, lower_at, kApart_mm, shortfalls);
    keep_order(surface, cage, shortfalls);
    if (*std::max_element(shortfalls.begin(), shortfalls.end()) <= 0) return;
    for (int column = 0; column < kLipColumns; ++column)
      for (std::size_t ring = 0; ring < kLipRings.size(); ++ring) {
        const glm::dvec3 move(0, 0.55 * shortfalls[column] * kShares[ring], 0);
        move_both(cage, find_point(cage, kLipRings[ring] + std::to_string(column)), move);
        move_both(cage, find_point(cage, kLipRings[ring] + std::to_string(2 * kLipColumns - column)), -move);
      }
  }
}

}  // namespace mien

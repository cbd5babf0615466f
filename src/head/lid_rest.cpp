// Where lids rest: after Dutton on lid retraction, the upper lid covers 1 to 2 mm of the iris, the lower one
// lies at its edge or up to 1 mm off.
#include "head/lid_rest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "core/conventions.hpp"
#include "head/cage.hpp"
#include "head/contact.hpp"
#include "head/least_squares.hpp"

namespace mien {

namespace {

constexpr int kLidColumns = 16;
constexpr int kHalfLid = kLidColumns / 2;

// How far a ring of the lids turns with its margin. The hidden back less, or it would come out of the ball;
// crease and skin beyond less and less, or brow and cheek would move.
struct RingShare {
  const char* ring;
  double upper, lower;
};
constexpr std::array kRingShares{RingShare{"EB", 0.5, 0.5},  RingShare{"E0", 1, 1},
                                 RingShare{"E1", 1, 1},      RingShare{"E2", 0.8, 0.7},
                                 RingShare{"E3", 0.35, 0.3}, RingShare{"E4", 0.1, 0.08}};

// The middle of the limbus, seen from the front, and its radius, mm.
struct IrisEdge {
  glm::dvec2 middle{0};
  double radius_mm = 0, scale = 1;
};

IrisEdge compute_iris_edge(const EyeNumbers& numbers, const Eye& eye) {
  IrisEdge iris;
  iris.scale = eye.radius_mm / numbers.ball_mm;
  iris.radius_mm = iris.scale * numbers.limbus_mm;
  const double depth = std::sqrt(eye.radius_mm * eye.radius_mm - iris.radius_mm * iris.radius_mm);
  const double aside = depth * std::sin(numbers.outward_deg * kRadiansPerDegree);
  iris.middle = {eye.centre.x + aside, eye.centre.y};
  return iris;
}

// The vertices of the margin's two edges, E0 and E1, of one lid.
struct LidEdges {
  bool is_upper;
  std::array<std::vector<LinearRow>, 2> vertices;
};

LidEdges compute_lid_edges(const Surface& surface, const Cage& cage, bool is_upper) {
  LidEdges edges{is_upper, {}};
  constexpr std::array kEdges{LidRings{}, LidRings{"E0_", "E1_", "E2_"}};
  for (std::size_t e = 0; e < kEdges.size(); ++e)
    for (const MarginVertex& margin : compute_lid_ring(surface, cage, kEdges[e]))
      if ((margin.at < 0.5 * kLidColumns) == is_upper)
        edges.vertices[e].push_back(compute_limit_row(surface, margin.vertex));
  return edges;
}

// Where the margin crosses `x`: the lowest (upper lid) or highest (lower) of its edges.
double compute_lid_height(const LidEdges& edges, const Cage& cage, double x) {
  const double sign = edges.is_upper ? 1 : -1;
  double height = std::numeric_limits<double>::max();
  for (const std::vector<LinearRow>& edge : edges.vertices) {
    std::vector<glm::dvec2> line;
    for (const LinearRow& vertex : edge) line.emplace_back(sample_row(vertex, cage.points));
    std::sort(line.begin(), line.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
    for (std::size_t i = 1; i < line.size(); ++i) {
      const glm::dvec2 &a = line[i - 1], &b = line[i];
      if (x < a.x || x > b.x || a.x == b.x) continue;
      height = std::min(height, sign * glm::mix(a.y, b.y, (x - a.x) / (b.x - a.x)));
    }
  }
  return sign * height;
}

double compute_cover_mm(const LidEdges& edges, const Cage& cage, const IrisEdge& iris) {
  const double sign = edges.is_upper ? 1 : -1;
  return (iris.radius_mm - sign * (compute_lid_height(edges, cage, iris.middle.x) - iris.middle.y)) /
         iris.scale;
}

// How far a lid must go down (upper) or up (lower) to hide what it should.
double compute_shortfall(const RestRange& range, double cover_mm) {
  if (cover_mm < range.least_mm) return range.least_mm - cover_mm;
  return std::min(0.0, range.most_mm - cover_mm);
}

// Turns the points of one lid about the line between the corners, through the ball's centre.
void turn_lid(const Eye& eye, bool is_upper, double angle_rad, Cage& cage) {
  const glm::dvec3 axis =
      glm::normalize(cage.points[find_point(cage, "E1_8")] - cage.points[find_point(cage, "E1_0")]);
  for (const RingShare& share : kRingShares)
    for (int i = 1; i < kHalfLid; ++i) {
      const int column = is_upper ? i : kLidColumns - i;
      const std::uint32_t point = find_point(cage, fmt::format("{}_{}", share.ring, column));
      const double taper = std::sin(std::numbers::pi * i / kHalfLid);
      const double angle = angle_rad * taper * (is_upper ? share.upper : share.lower);
      const glm::dmat3 turn(glm::rotate(glm::dmat4(1), angle, axis));
      cage.points[point] = eye.centre + turn * (cage.points[point] - eye.centre);
      cage.points[cage.mirror[point]] = cage.points[point] * glm::dvec3(-1, 1, 1);
    }
}

}  // namespace

IrisCover measure_iris_cover(const Surface& surface, const Cage& cage, const EyeNumbers& numbers,
                             const Eye& eye) {
  const IrisEdge iris = compute_iris_edge(numbers, eye);
  return {compute_cover_mm(compute_lid_edges(surface, cage, true), cage, iris),
          compute_cover_mm(compute_lid_edges(surface, cage, false), cage, iris)};
}

void rest_lids(const Surface& surface, const EyeNumbers& numbers, const Eye& eye, Cage& cage) {
  constexpr int kRounds = 6;          // each leaves a fifth of what is amiss or less
  constexpr double kGood_mm = 0.005;  // far below what is seen; less costs rounds
  const IrisEdge iris = compute_iris_edge(numbers, eye);
  const LidEdges upper = compute_lid_edges(surface, cage, true),
                 lower = compute_lid_edges(surface, cage, false);
  for (int round = 0; round < kRounds; ++round) {
    const double down = compute_shortfall(kUpperLidRest, compute_cover_mm(upper, cage, iris)),
                 up = compute_shortfall(kLowerLidRest, compute_cover_mm(lower, cage, iris));
    if (std::abs(down) < kGood_mm && std::abs(up) < kGood_mm) return;
    // The margin lies about a ball's radius before the axis.
    turn_lid(eye, true, down / numbers.ball_mm, cage);
    turn_lid(eye, false, -up / numbers.ball_mm, cage);
  }
}

}  // namespace mien

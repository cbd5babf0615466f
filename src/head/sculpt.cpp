// A stroke is a soft selection over the cage: falloff (1 - (d / r)^2)^2 by distance along its edges and
// diagonals (Dijkstra 1959), which is the kernel of Wyvill's soft objects (1986) without its last term.
#include "head/sculpt.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <queue>

#include "core/conventions.hpp"
#include "core/error.hpp"
#include "head/eye_fit.hpp"
#include "head/landmarks.hpp"
#include "head/least_squares.hpp"
#include "head/neighbours.hpp"
#include "head/surface.hpp"

namespace mien {

namespace {

// Along a zigzag of edges and diagonals a way is longer than it is, by 4 % in the mean.
constexpr double kZigzag = 0.96;

// How far each point of the cage lies from the place, along the skin; only those within `reach` are exact.
std::vector<double> compute_distances(const NeutralHead& head, const std::vector<PointRing>& rings,
                                      const LinearRow& place, const glm::dvec3& at, double reach_mm) {
  std::vector<double> distances(rings.size(), 1e9);
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto reach = [&](std::uint32_t point, double distance) {
    if (distance >= distances[point] || distance > reach_mm) return;
    distances[point] = distance;
    open.emplace(distance, point);
  };
  for (const auto& [point, weight] : place)
    reach(point, glm::distance(glm::dvec3(head.skin.positions[point]), at));
  while (!open.empty()) {
    const auto [distance, point] = open.top();
    open.pop();
    if (distance > distances[point]) continue;
    for (const auto* others : {&rings[point].edges, &rings[point].diagonals})
      for (const std::uint32_t other : *others)
        reach(other,
              distance + kZigzag * glm::distance(head.skin.positions[point], head.skin.positions[other]));
  }
  return distances;
}

// How far a point goes that is scaled and turned about `at` by a share of what the stroke says: a point half
// way out turns half as far.
glm::dvec3 reshape_about(const SculptStroke& stroke, const glm::dvec3& at, const glm::dvec3& point,
                         double share) {
  const glm::dvec3 axis = stroke.about == "x"   ? glm::dvec3(1, 0, 0)
                          : stroke.about == "y" ? glm::dvec3(0, 1, 0)
                                                : glm::dvec3(0, 0, 1);
  const glm::dvec3 arm = (1 + share * (stroke.scale - 1)) * (point - at);
  const glm::dmat4 turned = glm::rotate(glm::dmat4(1), share * stroke.turn_deg * kRadiansPerDegree, axis);
  return at + glm::dmat3(turned) * arm - point;
}

// The same of a stroke and its mirror image, whose shares are `here` and `there`: where they meet they are
// one.
glm::dvec3 reshape_point(const SculptStroke& stroke, const glm::dvec3& at, const glm::dvec3& point,
                         double here, double there) {
  if (here + there == 0) return glm::dvec3(0);
  const glm::dvec3 mirror(-1, 1, 1);
  const glm::dvec3 own = reshape_about(stroke, at, point, here),
                   other = mirror * reshape_about(stroke, at, mirror * point, there);
  return (here * own + there * other) / (here + there);
}

void apply_stroke(const HeadStock& stock, const std::vector<PointRing>& rings, const SculptStroke& stroke,
                  HeadForm& form) {
  NeutralHead head = build_bare_head(stock, form.points);
  head.hairline = form.hairline;
  const SkinSpot spot = find_place(head, stroke.at);
  const LinearRow place = compute_mean_row(*stock.surface, spot.vertices, spot.shares);
  const glm::dvec3 at = sample_row(place, form.points);
  const std::vector<double> distances = compute_distances(head, rings, place, at, stroke.radius_mm);

  // Where the two sides' strokes meet they are one, not twice as strong; aside moves fade toward the middle.
  std::vector<glm::dvec3> shares(form.points.size(), glm::dvec3(0));
  const auto falloff = [&](std::size_t i) {
    const double way = std::min(distances[i] / stroke.radius_mm, 1.0);
    return (1 - way * way) * (1 - way * way);
  };
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double here = falloff(i), there = falloff(stock.adult.mirror[i]);
    const double share = here + there - here * there;
    const double aside = at.x > 0 ? std::clamp(form.points[i].x / at.x, -1.0, 1.0) : 0;
    shares[i] = {share * aside, share, share};
  }
  const glm::dvec3 reached = sample_row(place, shares);
  if (stroke.scale != 1 || stroke.turn_deg != 0)
    for (std::size_t i = 0; i < shares.size(); ++i)
      form.points[i] += reshape_point(stroke, at, form.points[i], falloff(i), falloff(stock.adult.mirror[i]));
  for (std::size_t i = 0; i < shares.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      if (stroke.move_mm[axis] != 0 && reached[axis] > 0)
        form.points[i][axis] += stroke.move_mm[axis] * shares[i][axis] / reached[axis];
  mirror_half(stock.adult, form.points);
}

}  // namespace

void sculpt_form(const HeadStock& stock, const std::vector<SculptStroke>& strokes, HeadForm& form) {
  if (strokes.empty()) return;
  const std::vector<PointRing> rings = compute_rings(stock.adult);
  const std::vector<glm::dvec3> before = form.points;
  for (const SculptStroke& stroke : strokes) apply_stroke(stock, rings, stroke, form);
  fit_eye(stock, before, form);
}

}  // namespace mien

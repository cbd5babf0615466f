// What stands out from the head's side is the ear; ours is laid on it by its middle and its size first, then
// by closest points both ways (Besl and McKay, "A method for registration of 3-D shapes", 1992) with a
// similarity.
#include "head/scan_ear.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/pool.hpp"
#include "head/cage.hpp"
#include "head/least_squares.hpp"
#include "head/surface.hpp"

namespace mien {

namespace {

constexpr int kInnermostSeen = 9;         // ring; further in is the canal, which scanners do not see
constexpr double kAround_mm = 50;         // of our ear's middle, an adult's: people's lie up to 25 mm off
constexpr double kStandsOut_mm = 4;       // from the head's side; the side itself is met to 2 mm
constexpr std::size_t kMostAsked = 400;   // of the points of either ear
constexpr std::size_t kLeastPoints = 25;  // of the scan's ear: fewer have no form
constexpr std::array kTilts_deg{0.0, -15.0, 15.0, 30.0};
constexpr std::array kSizes{1.0, 0.85};
constexpr int kRounds = 40;  // the rest moves less than a tenth of a millimetre
constexpr double kFirstReach_mm = 14, kLastReach_mm = 6;
constexpr double kFacing = 0.4;  // least cosine between our normal and the scan's
constexpr double kLeastSize = 0.5, kMostSize = 1.6;
// An ear lies on another where it is this near and faces the same way: three quarters of any two people's do,
// less than a third of an ear laid on a lump that is none.
constexpr double kNear_mm = 3, kLeastShare = 0.5;

struct Cloud {
  std::vector<glm::dvec3> points, normals;
};

glm::dvec3 compute_middle(const Cloud& cloud) {
  glm::dvec3 middle(0);
  for (const glm::dvec3& p : cloud.points) middle += p / static_cast<double>(cloud.points.size());
  return middle;
}

double compute_radius(const Cloud& cloud, const glm::dvec3& middle) {
  double sum = 0;
  for (const glm::dvec3& p : cloud.points) sum += glm::dot(p - middle, p - middle);
  return std::sqrt(sum / static_cast<double>(cloud.points.size()));
}

// Every so many, evenly over the list.
Cloud thin_out(const Cloud& cloud) {
  Cloud thin;
  const std::size_t stride = cloud.points.size() / kMostAsked + 1;
  for (std::size_t i = 0; i < cloud.points.size(); i += stride) {
    thin.points.push_back(cloud.points[i]);
    thin.normals.push_back(cloud.normals[i]);
  }
  return thin;
}

struct Sides {
  Cloud ear, head;  // of our left half: what is the ear's own, and what is near it and not
};

Sides split_ear(const HeadStock& stock, const std::vector<glm::dvec3>& points) {
  const Surface& surface = *stock.surface;
  std::vector<Float4> packed;
  std::vector<glm::vec3> positions, normals;
  pack_points(points, packed);
  deform_surface(surface, packed, positions);
  update_surface_normals(surface, positions, normals);
  Sides sides;
  for (std::uint32_t v = 0; v < surface.vertex_count(); ++v) {
    if (surface.mirror[v] < v) continue;
    double share = 0, hollow = 0;
    for (const auto& [point, weight] : compute_limit_row(surface, v)) {
      const int ring = find_ear_ring(stock.adult.names[point]);
      if (ring >= 2) share += weight;
      if (ring > kInnermostSeen) hollow += weight;
    }
    constexpr double kWhole = 0.9, kSome = 0.1;  // between them the root is both
    Cloud* into = share > kWhole && hollow < kSome ? &sides.ear : share < kSome ? &sides.head : nullptr;
    if (into == nullptr) continue;
    into->points.emplace_back(positions[v]);
    into->normals.emplace_back(normals[v]);
  }
  return sides;
}

// The side as it would be without an ear: the hole within its root is spanned by spokes.
void span_root(const Cage& cage, const std::vector<glm::dvec3>& points, Cloud& head) {
  std::vector<glm::dvec3> ring;
  glm::dvec3 middle(0);
  for (std::size_t i = 0; i < cage.points.size(); ++i)
    if (find_ear_ring(cage.names[i]) == 1 && cage.mirror[i] > i) ring.push_back(points[i]);
  for (const glm::dvec3& p : ring) middle += p / static_cast<double>(ring.size());
  constexpr int kSteps = 8;  // closer than kStandsOut_mm
  for (const glm::dvec3& p : ring)
    for (int i = 0; i < kSteps; ++i) {
      head.points.push_back(glm::mix(middle, p, static_cast<double>(i) / kSteps));
      head.normals.emplace_back(1, 0, 0);
    }
}

double compute_distance(const Cloud& cloud, const glm::dvec3& point) {
  double least = 1e300;
  for (const glm::dvec3& p : cloud.points) least = std::min(least, glm::dot(p - point, p - point));
  return std::sqrt(least);
}

// The scan's points that stand out around the middle; right ones mirrored.
Cloud compute_standing_out(const PlacedScan& scan, const Cloud& head, const glm::dvec3& middle) {
  Cloud near_head;
  for (const glm::dvec3& p : head.points)
    if (glm::distance(p, middle) < kAround_mm + 2 * kStandsOut_mm) near_head.points.push_back(p);
  Cloud out;
  for (std::size_t v = 0; v < scan.tree.positions.size(); ++v) {
    if (scan.tree.is_rim[v]) continue;
    glm::dvec3 at = scan.turn * scan.tree.positions[v] + scan.shift,
               normal = scan.turn * scan.tree.normals[v];
    if (at.x < 0) at = mirror(at), normal = mirror(normal);
    if (glm::distance(at, middle) > kAround_mm || compute_distance(near_head, at) < kStandsOut_mm) continue;
    out.points.push_back(at);
    out.normals.push_back(normal);
  }
  return out;
}

struct Trial {
  Similarity carried;
  double miss = 2;   // mean square of the distances in both directions, in squares of the reach: 2 at most
  double share = 0;  // as EarFit's
};

struct Direction {
  double miss = 0;
  std::size_t near = 0;
};

// Closest points of `ask` in `answer`, both as they lie now; `take` gets the two indices of each match.
template <typename Take>
Direction match(const Cloud& ask, const Cloud& answer, double reach_mm, Take take) {
  Direction direction;
  for (std::size_t i = 0; i < ask.points.size(); ++i) {
    double least = reach_mm * reach_mm;
    std::size_t best = answer.points.size();
    for (std::size_t j = 0; j < answer.points.size(); ++j) {
      const glm::dvec3 way = answer.points[j] - ask.points[i];
      const double square = glm::dot(way, way);
      if (square >= least || glm::dot(ask.normals[i], answer.normals[j]) < kFacing) continue;
      least = square;
      best = j;
    }
    direction.miss += least / (reach_mm * reach_mm);
    if (best == answer.points.size()) continue;
    direction.near += least < kNear_mm * kNear_mm;
    take(i, best);
  }
  direction.miss /= static_cast<double>(ask.points.size());
  return direction;
}

void improve(const Cloud& ear, const Cloud& theirs, double reach_mm, Trial& trial) {
  Cloud ours;
  for (std::size_t i = 0; i < ear.points.size(); ++i) {
    ours.points.push_back(apply_similarity(trial.carried, ear.points[i]));
    ours.normals.push_back(trial.carried.rotation * ear.normals[i]);
  }
  std::vector<glm::dvec3> from, to;
  const auto add = [&](std::size_t own, std::size_t other) {
    from.push_back(ear.points[own]);
    to.push_back(theirs.points[other]);
  };
  const Direction there = match(ours, theirs, reach_mm, add);
  const Direction back = match(theirs, ours, reach_mm, [&](std::size_t i, std::size_t j) { add(j, i); });
  trial.miss = there.miss + back.miss;
  trial.share = static_cast<double>(there.near + back.near) /
                static_cast<double>(ours.points.size() + theirs.points.size());
  if (from.size() < kLeastPoints) return;
  const Similarity better = fit_similarity(from, to);
  if (better.scale > kLeastSize && better.scale < kMostSize) trial.carried = better;
}

}  // namespace

int find_ear_ring(std::string_view name) {
  const std::string_view bare = strip_side(name);
  if (!bare.starts_with("er")) return 0;
  int ring = 0;
  const auto [end, error] = std::from_chars(bare.data() + 2, bare.data() + bare.size(), ring);
  return error == std::errc() && *end == '_' ? ring : 0;
}

Similarity carry_ear_by_root(const Cage& cage, const std::vector<glm::dvec3>& points) {
  std::vector<glm::dvec3> from, to;
  for (std::size_t i = 0; i < cage.points.size(); ++i)
    if (find_ear_ring(cage.names[i]) == 1 && cage.mirror[i] > i) {
      from.push_back(cage.points[i]);
      to.push_back(points[i]);
    }
  return fit_similarity(from, to);
}

EarFit find_ear(const HeadStock& stock, const PlacedScan& scan, const std::vector<glm::dvec3>& points) {
  const Similarity start = carry_ear_by_root(stock.adult, points);
  Cloud head = split_ear(stock, points).head;
  span_root(stock.adult, points, head);
  const Cloud ear = thin_out(split_ear(stock, stock.adult.points).ear);
  const glm::dvec3 own_middle = compute_middle(ear);
  const Cloud all = compute_standing_out(scan, head, apply_similarity(start, own_middle));
  if (all.points.size() < kLeastPoints) return {start, 0, false};
  const Cloud theirs = thin_out(all);
  const glm::dvec3 middle = compute_middle(theirs);
  const double size = compute_radius(theirs, middle) / compute_radius(ear, own_middle);
  std::vector<Trial> trials;
  for (const double tilt : kTilts_deg)
    for (const double factor : kSizes) {
      Trial trial;
      trial.carried.scale = std::clamp(factor * size, kLeastSize, kMostSize);
      trial.carried.rotation = glm::dmat3(glm::rotate(glm::dmat4(1), glm::radians(tilt), {1, 0, 0}));
      trial.carried.shift = middle - trial.carried.scale * (trial.carried.rotation * own_middle);
      trials.push_back(trial);
    }
  for_each_index(trials.size(), count_workers(), [&](std::size_t i, int) {
    for (int round = 0; round <= kRounds; ++round)
      improve(ear, theirs, glm::mix(kFirstReach_mm, kLastReach_mm, static_cast<double>(round) / kRounds),
              trials[i]);
  });
  const Trial& best = *std::ranges::min_element(trials, {}, &Trial::miss);
  return {best.carried, best.share, best.share >= kLeastShare};
}

}  // namespace mien

#include "face/fold_tracks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/smooth.hpp"
#include "head/cage.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr double kStep_mm = 1;  // between the points of a line: longer ones turn visibly
constexpr double kReach = 2.6;  // a swelling ends at so many times its highest place

glm::vec3 find_place(const NeutralHead& head, const std::vector<glm::vec3>& skin, const FoldPoint& point) {
  const glm::vec3 from = skin[find_point(head.cage, point.from)], to = skin[find_point(head.cage, point.to)];
  return glm::mix(from, to, static_cast<float>(point.share));
}

glm::vec3 compute_normal(const NeutralHead& head, const std::vector<glm::vec3>& normals,
                         const FoldPoint& point) {
  return glm::normalize(find_place(head, normals, point));
}

Track build_track(const NeutralHead& head, const Mesh& adult, const FoldSet& set, const FoldLine& line) {
  Track track;
  track.set = &set;
  track.reach_mm = static_cast<float>(set.width_mm * set.spread * kReach);
  std::vector<glm::vec3> through, normals;
  float length_mm = 0;
  for (const FoldPoint& point : line.through) {
    through.push_back(find_place(head, adult.positions, point));
    normals.push_back(compute_normal(head, adult.normals, point));
    if (through.size() > 1) length_mm += glm::distance(through.back(), through[through.size() - 2]);
  }
  std::vector<double> knots;
  for (std::size_t i = 0; i < line.depths.size(); ++i)
    knots.push_back(static_cast<double>(i) /
                    static_cast<double>(std::max<std::size_t>(2, line.depths.size()) - 1));
  const int steps = std::max(4, static_cast<int>(length_mm / kStep_mm));
  track.step_mm = length_mm / static_cast<float>(steps);
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps, t = share * static_cast<double>(through.size() - 1);
    track.points.push_back(sample_curve(through, t));
    track.normals.push_back(sample_curve(normals, t));
    track.depths.push_back(static_cast<float>(sample_stations(knots, line.depths, share)));
  }
  track.box = compute_bounds(track.points);
  track.box.low -= track.reach_mm;
  track.box.high += track.reach_mm;
  return track;
}

bool is_inside(const Box& box, const glm::vec3& p) {
  return glm::all(glm::greaterThanEqual(p, box.low)) && glm::all(glm::lessThanEqual(p, box.high));
}

// Where a point lies beside a track: the distance in mm, positive to the left of the way seen from outside,
// and how far along it that is.
struct Beside {
  float away_mm = 1e9f;
  float along_mm = 0;
};

float compute_square(const glm::vec3& v) { return glm::dot(v, v); }

Beside compute_beside(const Track& track, const glm::vec3& p) {
  std::size_t nearest = 0;
  float least = 1e18f;
  for (std::size_t i = 0; i < track.points.size(); ++i)
    if (const float square = compute_square(p - track.points[i]); square < least) {
      least = square;
      nearest = i;
    }
  // On the two segments that meet there.
  std::size_t segment = 0;
  float share = 0;
  least = 1e18f;
  for (std::size_t i = nearest == 0 ? 0 : nearest - 1; i < std::min(nearest + 1, track.points.size() - 1);
       ++i) {
    const glm::vec3 way = track.points[i + 1] - track.points[i], to = p - track.points[i];
    const float t = std::clamp(glm::dot(to, way) / glm::dot(way, way), 0.0f, 1.0f);
    const float square = compute_square(to - t * way);
    if (square >= least) continue;
    least = square;
    segment = i;
    share = t;
  }
  const glm::vec3 way = track.points[segment + 1] - track.points[segment];
  const glm::vec3 left = glm::cross(track.normals[segment], way);
  const float side = glm::dot(p - track.points[segment], left);
  return {std::copysign(std::sqrt(least), side), track.step_mm * (static_cast<float>(segment) + share)};
}

// The cut through a fold, in its depth: a groove of -1 with a swelling on either side.
double sample_profile(const FoldSet& set, double away_mm) {
  const double t = std::abs(away_mm) / set.width_mm, u = t / set.spread;
  if (u >= kReach) return 0;
  const double edge = 1 - (u / kReach) * (u / kReach);  // to 0 with slope 0
  // The two swellings go over into each other in the groove, where both are 0.
  const double swelling = u * u * std::exp(1 - u * u);
  return edge * edge * (set.rolls[away_mm > 0 ? 0 : 1] * swelling - std::exp(-t * t));
}

double sample_depth(const Track& track, double along_mm) {
  const double at =
      std::clamp(along_mm / track.step_mm, 0.0, static_cast<double>(track.depths.size()) - 1.001);
  const auto i = static_cast<std::size_t>(at);
  return std::lerp(track.depths[i], track.depths[i + 1], at - static_cast<double>(i));
}

enum Channel : std::uint32_t {
  kAside = 0,
  kBroken = 2,
  kShift = 4
};  // of scatter(); the right side has the next

// Chance along a line, from -1 to 1, smooth, with lumps 1 long.
double sample_chance(std::uint32_t series, std::uint32_t channel, double along) {
  const double cell = std::floor(along);
  const auto i = static_cast<std::uint32_t>(static_cast<int>(cell) + 1024);
  return 2 * glm::mix(scatter(series, i, channel), scatter(series, i + 1, channel),
                      smooth_step(0, 1, along - cell)) -
         1;
}

// A fold's height where a side has its own share `apart` of chance; on the mid-line both have the left's.
double compute_height_mm(const Track& track, const Beside& beside, std::uint32_t side, double apart) {
  const FoldSet& set = *track.set;
  const FoldUnevenness& uneven = *track.uneven;
  const auto chance = [&](std::uint32_t channel, double lumps) {
    const double along = beside.along_mm / (lumps * uneven.along_mm);
    const double left = sample_chance(track.series, channel, along);
    return side == 0 ? left : glm::mix(left, sample_chance(track.series, channel + side, along), apart);
  };
  // Lines stray in long waves, break in short ones, and end sooner on one side than on the other.
  constexpr double kStray = 1.6, kEnd = 6, kEarlier = 0.6, kWeak = 0.05, kWeakest = 0.6;
  const double away_mm = beside.away_mm + set.uneven * uneven.aside_mm * chance(kAside, kStray);
  const double shift_mm = set.uneven * uneven.broken * kEarlier * uneven.along_mm * chance(kShift, kEnd);
  const double depth =
      std::min(sample_depth(track, beside.along_mm), sample_depth(track, beside.along_mm + shift_mm));
  const double broken = set.uneven * uneven.broken * smooth_step(kWeak, kWeakest, chance(kBroken, 1));
  return set.depth_mm * depth * (1 - std::min(broken, 1.0)) * sample_profile(set, away_mm);
}

}  // namespace

std::vector<Track> build_tracks(const NeutralHead& head, const Mesh& adult, const FoldData& data) {
  std::vector<Track> tracks;
  for (const FoldSet& set : data.sets)
    for (const FoldLine& line : set.lines) {
      try {
        tracks.push_back(build_track(head, adult, set, line));
        tracks.back().uneven = &data.uneven;
        tracks.back().series = 1000 * data.uneven.seed + static_cast<std::uint32_t>(tracks.size());
      } catch (const RunError& e) {
        throw RunError(fmt::format("{}:{}: {}", data.file, line.file_line, e.what()));
      }
    }
  return tracks;
}

std::array<double, 2> compute_heights_mm(const std::vector<Track>& tracks, const FoldSet& set,
                                         const glm::vec3& place) {
  std::array<double, 2> heights_mm{};
  for (const Track& track : tracks) {
    if (track.set != &set || !is_inside(track.box, place)) continue;
    const Beside beside = compute_beside(track, place);
    const double apart = smooth_step(0, track.uneven->shared_mm, static_cast<double>(place.x));
    for (const std::uint32_t side : {0U, 1U})
      heights_mm[side] += compute_height_mm(track, beside, side, apart);
  }
  return heights_mm;
}

EdgeLimit limit_edges(const std::vector<Track>& tracks, double edge) {
  return [&tracks, edge](const glm::vec3& p) {
    constexpr double kGroove = 1.6, kSwelling = 1.5;  // how far they reach, in widths and in spreads
    constexpr double kSofter = 1.7;                   // edges of a swelling against those of its groove
    double limit_mm = 1e9;
    for (const Track& track : tracks) {
      if (!is_inside(track.box, p)) continue;
      const double short_mm = edge * track.set->edge * track.set->width_mm;
      const double away = std::abs(compute_beside(track, p).away_mm) / track.set->width_mm;
      if (away < kGroove) limit_mm = std::min(limit_mm, short_mm);
      if (away < kSwelling * track.set->spread) limit_mm = std::min(limit_mm, kSofter * short_mm);
    }
    return limit_mm;
  };
}

}  // namespace mien

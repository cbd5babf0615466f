#include "face/fold_tracks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
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

glm::vec3 find_normal(const NeutralHead& head, const std::vector<glm::vec3>& normals,
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
    normals.push_back(find_normal(head, adult.normals, point));
    if (through.size() > 1) length_mm += glm::distance(through.back(), through[through.size() - 2]);
  }
  std::vector<double> knots;
  for (std::size_t i = 0; i < line.depths.size(); ++i)
    knots.push_back(static_cast<double>(i) /
                    static_cast<double>(std::max<std::size_t>(2, line.depths.size()) - 1));
  const int steps = std::max(4, static_cast<int>(length_mm / kStep_mm));
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps, t = share * static_cast<double>(through.size() - 1);
    track.points.push_back(sample_curve(through, t));
    track.normals.push_back(sample_curve(normals, t));
    track.depths.push_back(static_cast<float>(sample_stations(knots, line.depths, share)));
  }
  track.box = find_bounds(track.points);
  track.box.low -= track.reach_mm;
  track.box.high += track.reach_mm;
  return track;
}

bool is_inside(const Box& box, const glm::vec3& p) {
  return glm::all(glm::greaterThanEqual(p, box.low)) && glm::all(glm::lessThanEqual(p, box.high));
}

// Where a point lies beside a track: the distance in mm, positive to the left of the way seen from outside,
// and the depth there.
struct Beside {
  float away_mm = 1e9f;
  float depth = 0;
};

float find_square(const glm::vec3& v) { return glm::dot(v, v); }

Beside find_beside(const Track& track, const glm::vec3& p) {
  std::size_t nearest = 0;
  float least = 1e18f;
  for (std::size_t i = 0; i < track.points.size(); ++i)
    if (const float square = find_square(p - track.points[i]); square < least) {
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
    const float square = find_square(to - t * way);
    if (square >= least) continue;
    least = square;
    segment = i;
    share = t;
  }
  const glm::vec3 way = track.points[segment + 1] - track.points[segment];
  const glm::vec3 left = glm::cross(track.normals[segment], way);
  const float side = glm::dot(p - track.points[segment], left);
  return {std::copysign(std::sqrt(least), side),
          glm::mix(track.depths[segment], track.depths[segment + 1], share)};
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

}  // namespace

std::vector<Track> build_tracks(const NeutralHead& head, const Mesh& adult, const FoldData& data,
                                const std::filesystem::path& file) {
  std::vector<Track> tracks;
  for (const FoldSet& set : data.sets)
    for (const FoldLine& line : set.lines) {
      try {
        tracks.push_back(build_track(head, adult, set, line));
      } catch (const RunError& e) {
        throw RunError(fmt::format("{}:{}: {}", file.string(), line.file_line, e.what()));
      }
    }
  return tracks;
}

double find_height_mm(const std::vector<Track>& tracks, const FoldSet& set, const glm::vec3& place) {
  double height_mm = 0;
  for (const Track& track : tracks) {
    if (track.set != &set || !is_inside(track.box, place)) continue;
    const Beside beside = find_beside(track, place);
    height_mm += set.depth_mm * beside.depth * sample_profile(set, beside.away_mm);
  }
  return height_mm;
}

EdgeLimit limit_edges(const std::vector<Track>& tracks, double edge) {
  return [&tracks, edge](const glm::vec3& p) {
    constexpr double kGroove = 1.6, kSwelling = 1.5;  // how far they reach, in widths and in spreads
    constexpr double kSofter = 1.7;                   // edges of a swelling against those of its groove
    double limit_mm = 1e9;
    for (const Track& track : tracks) {
      if (!is_inside(track.box, p)) continue;
      const double short_mm = edge * track.set->width_mm;
      const double away = std::abs(find_beside(track, p).away_mm) / track.set->width_mm;
      if (away < kGroove) limit_mm = std::min(limit_mm, short_mm);
      if (away < kSwelling * track.set->spread) limit_mm = std::min(limit_mm, kSofter * short_mm);
    }
    return limit_mm;
  };
}

}  // namespace mien

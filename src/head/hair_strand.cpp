#include "head/hair_strand.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/conventions.hpp"
#include "core/smooth.hpp"
#include "head/hair_comb.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr std::uint32_t kSeries = 43;  // of scatter()
enum Channel : std::uint32_t { kLength, kLayer, kTurn, kPhase, kLift, kTip, kStart };

glm::dvec3 turn_about(const glm::dvec3& way, const glm::dvec3& axis, double degrees) {
  const double angle = degrees * kRadiansPerDegree;
  return way * std::cos(angle) + glm::cross(axis, way) * std::sin(angle);
}

// Hair is stiff: where ways part, or a root lies on the far side of them, it bends in an arc and has no
// elbow.
glm::dvec3 bend(const glm::dvec3& before, const glm::dvec3& way, const glm::dvec3& normal, double most_deg) {
  const glm::dvec3 on = flatten(before, normal);
  if (on == glm::dvec3(0) || way == glm::dvec3(0)) return way;
  const double turn =
      std::atan2(glm::dot(glm::cross(on, way), normal), glm::dot(on, way)) / kRadiansPerDegree;
  return std::abs(turn) <= most_deg ? way : turn_about(on, normal, std::copysign(most_deg, turn));
}

// The lock's way over the ground in small equal steps.
struct Path {
  std::vector<HairPlace> places;
  double step_mm = 0;
};

Path trace_path(const HairScene& scene, const HairPlace& root, std::uint32_t index, std::uint32_t family,
                double wanted_mm) {
  const HairCut& cut = scene.cut;
  const double size = scene.chart.size;
  Path path{{root}, 3.0 * size};
  constexpr double kFamily = 0.65;  // of how tips differ: those that fall together end together
  const double own = scatter(kSeries, index, kTip),
               among = index == family ? own : std::lerp(own, scatter(kSeries, family, kTip), kFamily);
  const double tip = (among - 0.5) * 2 * cut.locks.tips_mm * size;
  const double turn = cut.comb.jitter_deg * 2 * (scatter(kSeries, index, kTurn) - 0.5);
  constexpr double kBend_deg = 9;  // in a step: an arc of 19 mm; ink's broad strokes turn as they must
  const double most_deg = cut.is_drawn || cut.comb.is_gathered ? 180 : kBend_deg;
  glm::dvec3 before(0);
  HairPlace place = root;
  double gone_mm = 0;
  while (gone_mm < wanted_mm) {
    const double ground = compute_ground_mm(scene, place);
    const glm::dvec3 at = compute_hair_point(scene.chart, place, ground);
    const glm::dvec3 normal = compute_ground_normal(scene, place);
    if (cut.comb.is_gathered && glm::distance(at, scene.knot) < 1.5 * path.step_mm) break;
    const double share = std::min(1.0, gone_mm / (kWeight_mm * size));
    const double swirl = cut.comb.swirl_deg * (1 - share);
    glm::dvec3 way = compute_comb(scene, at, normal, cut.comb.droop * share);
    way = turn_about(way, normal, turn + swirl);
    way = turn_aside(scene, place, at, normal, way);
    way = bend(before, way, normal, most_deg);
    before = way;
    const HairPlace next = compute_hair_place(scene.chart, at + path.step_mm * way);
    if (next.way > HairChart::kLongest - 0.02) break;
    if (!scene.ends.empty() && compute_open(scene, next) < 0.05 &&
        next.way + tip / scene.chart.drop_mm > sample_border(scene.ends, next.azimuth_deg)) {
      // One that begins beyond the border has no place at all.
      if (path.places.size() < 2) path.places.clear();
      break;
    }
    place = next;
    gone_mm += path.step_mm;
    path.places.push_back(place);
  }
  return path;
}

// A short lock bends less than a long one; waves, curls and ink's outlines want all that the cut has.
int count_rings(const HairScene& scene, double length_mm) {
  constexpr double kRing_mm = 5.5;
  constexpr int kLeast = 3;
  const HairLocks& locks = scene.cut.locks;
  if (scene.cut.is_drawn || locks.wave_mm > 0 || locks.curl_mm > 0) return locks.rings;
  const int needed = 1 + static_cast<int>(std::ceil(length_mm / (kRing_mm * scene.chart.size)));
  return std::clamp(needed, std::min(kLeast, locks.rings), locks.rings);
}

// A step of a way: its ends, and how far hair has come from the part there, the first end's less than the
// last's.
struct Step {
  HairPlace first, last;
  double from_mm = 0, to_mm = 0;
};

// The share of a step at which hair has come so far from the part: as if evenly, and then once better.
double find_on_step(const HairScene& scene, const Step& step, double wanted_mm) {
  const double even = (wanted_mm - step.from_mm) / (step.to_mm - step.from_mm);
  const double turn = std::remainder(step.last.azimuth_deg - step.first.azimuth_deg, 360);
  const HairPlace place{step.first.azimuth_deg + even * turn, std::lerp(step.first.way, step.last.way, even)};
  const double come_mm = std::clamp(compute_combed_mm(scene, place), step.from_mm, step.to_mm);
  if (come_mm > wanted_mm) return even * (wanted_mm - step.from_mm) / (come_mm - step.from_mm);
  return come_mm < wanted_mm ? even + (1 - even) * (wanted_mm - come_mm) / (step.to_mm - come_mm) : even;
}

// Where rings lie on a way, 0..1: at its root and its tip, where the scene has its stations between them, and
// once more before the tip, where a lock narrows.
std::vector<double> place_rings(const HairScene& scene, const Path& path) {
  constexpr double kLast = 0.94;
  constexpr double kApart_mm = 2.5;  // nearer together is a ring for nothing
  const auto steps = static_cast<double>(path.places.size()) - 1;
  std::vector<double> shares{0};
  double before = compute_combed_mm(scene, path.places.front()), last = before;
  std::size_t station = 0;
  for (std::size_t i = 1; i < path.places.size(); ++i) {
    const double now = compute_combed_mm(scene, path.places[i]);
    while (station < scene.ring_stations.size() &&
           scene.ring_stations[station] < std::max(before, last + kApart_mm))
      ++station;
    for (; station < scene.ring_stations.size() && scene.ring_stations[station] < now; ++station) {
      last = scene.ring_stations[station];
      const Step step{path.places[i - 1], path.places[i], before, now};
      shares.push_back((static_cast<double>(i - 1) + find_on_step(scene, step, last)) / steps);
    }
    before = now;
  }
  while (shares.size() > 1 && shares.back() > kLast - kApart_mm / (steps * path.step_mm)) shares.pop_back();
  shares.push_back(kLast);
  shares.push_back(1);
  return shares;
}

}  // namespace

std::vector<double> compute_ways(const HairStrand& strand) {
  std::vector<double> ways{0};
  for (std::size_t i = 1; i < strand.points.size(); ++i)
    ways.push_back(ways.back() + glm::distance(strand.points[i], strand.points[i - 1]));
  const double whole = std::max(1e-9, ways.back());
  for (double& way : ways) way /= whole;
  return ways;
}

HairStrand grow_strand(const HairScene& scene, const HairPlace& root, std::uint32_t index,
                       std::uint32_t family) {
  const HairCut& cut = scene.cut;
  const HairLocks& locks = cut.locks;
  const double size = scene.chart.size, child = 1 - (1 - cut.infant) * scene.youth;
  const double border = sample_border(scene.hairline, root.azimuth_deg);
  const double share = std::min(1.0, root.way / border);
  const double ragged = 1 + locks.ragged * 2 * (scatter(kSeries, index, kLength) - 0.5);
  const double wanted_mm =
      size * (0.6 + 0.4 * child) * ragged * sample_spread(locks.length_mm, root.azimuth_deg, share);
  HairStrand strand;
  strand.root = root;
  strand.layer = scatter(kSeries, index, kLayer);
  if (wanted_mm < 1) return strand;
  const double standing = locks.stand;
  const Path path = trace_path(scene, root, index, family, wanted_mm * (1 - standing));
  const auto steps = static_cast<double>(path.places.size()) - 1;
  if (steps < 1 && standing == 0) return strand;
  if (path.places.empty()) return strand;
  strand.length_mm = std::max(steps * path.step_mm, standing * wanted_mm);
  if (!cut.comb.is_gathered && standing == 0 && steps > 0)
    strand.length_mm = std::min(strand.length_mm, wanted_mm);

  const double phase = scatter(kSeries, family, kPhase);
  // Till there it comes out of the skin.
  const double risen = std::max(locks.risen, std::min(1.0, locks.rise_mm * size / strand.length_mm));
  // Over the mass, which hides what is deeper.
  const double spread = cut.is_drawn ? 1 : 0.5;  // more, and those on top stand off by themselves, as wires
  const double deepest = locks.deepest * cut.mass, lift = deepest + spread * (1 - deepest) * strand.layer;
  std::vector<double> shares;
  if (!scene.ring_stations.empty() && steps > 0) shares = place_rings(scene, path);
  const int rings = shares.empty() ? count_rings(scene, strand.length_mm) : static_cast<int>(shares.size());
  for (int ring = 0; ring < rings; ++ring) {
    const double even = static_cast<double>(ring) / (rings - 1);
    const double s = shares.empty() ? even : shares[static_cast<std::size_t>(ring)], at = s * steps;
    const auto i = std::min(static_cast<std::size_t>(at), path.places.size() - 1);
    const auto j = std::min(i + 1, path.places.size() - 1);
    const HairPlace &a = path.places[i], &b = path.places[j];
    const double t = at - std::floor(at);
    const auto height_at = [&](const HairPlace& place) {
      return size * child * compute_part_depth(scene, place) * compute_thickness_mm(scene, place);
    };
    // Out of the skin at the root, then in its layer; the tips of short hair stay up, those of gathered hair
    // and of long hair lie down.
    constexpr double kClear_mm = 0.8;  // a flat lock on a round skin would cut into it
    const double rise = std::min(1.0, smooth_step(-0.02, risen, s) + 0.3 * smooth_step(0, 0.2 * risen, s));
    const auto point_at = [&](const HairPlace& place) {
      return compute_hair_point(scene.chart, place,
                                compute_ground_mm(scene, place) +
                                    rise * (kClear_mm * size + lift * height_at(place)) +
                                    standing * wanted_mm * s);
    };
    glm::dvec3 point = glm::mix(point_at(a), point_at(b), t);
    const glm::dvec3 out =
        glm::normalize(glm::mix(compute_ground_normal(scene, a), compute_ground_normal(scene, b), t));
    const glm::dvec3 ahead = compute_comb(scene, point, out, 0);
    const glm::dvec3 side = glm::cross(ahead, out);
    const double gone_mm = s * strand.length_mm;
    if (locks.wave_mm > 0) {
      constexpr double kOwn = 0.16;  // of a wave: more and neighbours part
      // Outward as the mass below waves, one and all: locks that rise where their neighbours sink cut through
      // them.
      const HairPlace here = compute_hair_place(scene.chart, point);
      const double wave = compute_wave(scene, here), turn = 2 * std::numbers::pi * (wave + kOwn * phase),
                   common = 2 * std::numbers::pi * wave;
      const double amount_mm = smooth_step(0, 0.3, s) * locks.wave_mm * size * compute_wave_room(scene, here);
      // Across its own way: where the comb's ways part far from the part, a lock would have an elbow.
      const glm::dvec3 gone = point_at(path.places[std::min(i + 2, path.places.size() - 1)]) -
                              point_at(path.places[i > 0 ? i - 1 : 0]);
      const glm::dvec3 across = glm::cross(flatten(gone, out), out);
      point += across * (0.8 * amount_mm * std::sin(turn)) + out * (0.5 * amount_mm * (1 + std::cos(common)));
    }
    if (locks.curl_mm > 0) {
      const double turn = 2 * std::numbers::pi * (gone_mm / (locks.curl_length_mm * size) + phase);
      const double radius =
          locks.curl_mm * size * child * smooth_step(0, 0.25, s) * (0.6 + 0.8 * strand.layer);
      const glm::dvec3 first = standing > 0.5 ? ahead : out;
      point += radius * (std::cos(turn) * side + std::sin(turn) * first);
    }
    strand.points.push_back(point);
    strand.outs.push_back(out);
  }
  return strand;
}

HairPlace trace_to_part(const HairScene& scene, const HairPlace& place, std::uint32_t index) {
  constexpr double kStep_mm = 4;
  constexpr int kSteps = 120;                         // from the shoulders to the top
  constexpr double kNearest_mm = 1.5, kWide_mm = 16;  // all at one line would be a seam
  const HairChart& chart = scene.chart;
  const double wanted_mm =
      chart.size * (kNearest_mm + kWide_mm * std::pow(scatter(kSeries, index, kStart), 2));
  HairPlace here = place;
  for (int step = 0; step < kSteps; ++step) {
    const glm::dvec3 at = compute_hair_point(chart, here, compute_ground_mm(scene, here));
    const double left_mm = compute_part_arm(scene, at).distance_mm - wanted_mm;
    if (left_mm <= 0) break;
    const glm::dvec3 way = compute_comb_way(scene, here, (left_mm + wanted_mm) / chart.size);
    const HairPlace back = compute_hair_place(chart, at - std::min(left_mm, kStep_mm * chart.size) * way);
    if (back.way > sample_border(scene.hairline, back.azimuth_deg) && back.way > here.way) break;
    here = back;
  }
  return here.way > sample_border(scene.hairline, here.azimuth_deg) ? place : here;
}

std::vector<HairStrand> grow_families(const HairScene& scene) {
  constexpr std::uint32_t kFirst = 30000;  // their numbers among all
  const HairLocks& locks = scene.cut.locks;
  std::vector<HairStrand> families;
  if (locks.gathers <= 0) return families;
  const auto roots = spread_roots(scene, locks.gathers, locks.root_band, scene.cut.is_mirrored);
  for (std::uint32_t i = 0; i < roots.size(); ++i) {
    const std::uint32_t index = kFirst + i;
    const HairPlace root = locks.from_part > 0 ? trace_to_part(scene, roots[i], index) : roots[i];
    families.push_back(grow_strand(scene, root, index, index));
    families.back().index = index;
  }
  std::erase_if(families, [](const HairStrand& strand) { return strand.points.empty(); });
  return families;
}

const HairStrand* find_family(const HairScene& scene, const std::vector<HairStrand>& families,
                              const HairPlace& place) {
  const glm::dvec3 at = compute_hair_point(scene.chart, place, compute_ground_mm(scene, place));
  const HairStrand* nearest = nullptr;
  double best = 1e18;
  for (const HairStrand& family : families)
    for (const glm::dvec3& point : family.points)
      if (const glm::dvec3 away = point - at; glm::dot(away, away) < best) {
        best = glm::dot(away, away);
        nearest = &family;
      }
  return nearest;
}

void fall_in(const HairScene& scene, const HairStrand& middle, HairStrand& strand) {
  constexpr double kBegins = 0.12, kWhole = 0.95;  // of its way
  constexpr double kNear_mm = 12, kFar_mm = 28;    // from the middle: what is farther falls by itself
  const double pull = scene.cut.locks.gathered;
  const std::vector<double> ways = compute_ways(strand);
  for (std::size_t i = 0; i < strand.points.size(); ++i) {
    const double s = ways[i];
    glm::dvec3& at = strand.points[i];
    glm::dvec3 arm(0);
    double best = 1e18;
    for (std::size_t k = 0; k + 1 < middle.points.size(); ++k) {
      const glm::dvec3 &a = middle.points[k], way = middle.points[k + 1] - a;
      const double share = std::clamp(glm::dot(at - a, way) / std::max(1e-9, glm::dot(way, way)), 0.0, 1.0);
      const glm::dvec3 away = a + share * way - at;
      if (glm::dot(away, away) < best) {
        best = glm::dot(away, away);
        arm = away;
      }
    }
    arm -= glm::dot(arm, strand.outs[i]) * strand.outs[i];
    const double near = 1 - smooth_step(kNear_mm, kFar_mm, glm::length(arm) / scene.chart.size);
    // Each stays as high over the ground as it was, or those beside each other pass through one another.
    const HairPlace before = compute_hair_place(scene.chart, at);
    const double high_mm =
        glm::distance(at, compute_hair_point(scene.chart, before, 0)) - compute_ground_mm(scene, before);
    at += pull * near * smooth_step(kBegins, kWhole, s) * arm;
    const HairPlace after = compute_hair_place(scene.chart, at);
    at = compute_hair_point(scene.chart, after, compute_ground_mm(scene, after) + high_mm);
  }
}

}  // namespace mien

#include "head/hair_growth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/conventions.hpp"
#include "core/smooth.hpp"
#include "head/lids.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr std::uint32_t kSeries = 43;  // of scatter()
enum Channel : std::uint32_t { kLength, kLayer, kTurn, kPhase, kLift, kTip, kStart };
constexpr int kDegrees = 181;    // of a border: 0..180
constexpr double kWay_mm = 130;  // of the adult, from the whorl to the height of the centre

// A smooth curve through the knots of the left half, degree by degree.
HairBorder compute_border(const NeutralHead& head, const std::vector<HairKnot>& knots,
                          const HairChart& chart) {
  std::vector<double> azimuths, ways;
  for (const HairKnot& knot : knots) {
    glm::dvec3 p(find_named_point(head, knot.point));
    if (!knot.level_of.empty()) p.y = find_named_point(head, knot.level_of).y;
    p.y += knot.up_mm * chart.size;
    const HairPlace place = compute_hair_place(chart, p);
    azimuths.push_back(std::abs(place.azimuth_deg));
    ways.push_back(place.way);
  }
  for (std::size_t i = 1; i < azimuths.size(); ++i)
    azimuths[i] = std::max(azimuths[i], azimuths[i - 1] + 0.5);
  HairBorder border;
  for (int degree = 0; degree < kDegrees; ++degree) border.push_back(sample_stations(azimuths, ways, degree));
  return border;
}

glm::dvec3 compute_arc_direction(double side_mm, double back_deg, double radius_mm) {
  const double turn = back_deg * kRadiansPerDegree;
  return glm::normalize(glm::dvec3(side_mm / radius_mm, std::cos(turn), -std::sin(turn)));
}

constexpr double kSkull_mm = 100;  // of the adult: what a part's side is measured on

glm::dvec3 compute_part_direction(const HairComb& comb, double share) {
  return compute_arc_direction(comb.side_mm, std::lerp(comb.from_deg, comb.to_deg, share), kSkull_mm);
}

constexpr int kPartSteps = 24;  // of the part's arc: 4 degrees of a long one

std::vector<glm::dvec3> list_part_ways(const HairComb& comb) {
  std::vector<glm::dvec3> ways;
  for (int i = 0; i <= kPartSteps; ++i)
    ways.push_back(compute_part_direction(comb, static_cast<double>(i) / kPartSteps));
  return ways;
}

// A place on the part's arc: its share of the way, and its direction from the head's centre.
struct PartPoint {
  double share = 0;
  glm::dvec3 direction{0, 1, 0};
};

// The place of the part's arc that is nearest to a direction of the head.
PartPoint find_part_point(const HairScene& scene, const glm::dvec3& direction) {
  const std::vector<glm::dvec3>& ways = scene.part_ways;
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < ways.size(); ++i)
    if (glm::dot(ways[i], direction) > glm::dot(ways[nearest], direction)) nearest = i;
  PartPoint best{static_cast<double>(nearest) / kPartSteps, ways[nearest]};
  // Between its steps too, or locks meet in these like the bones of a fish.
  for (std::size_t i = nearest > 0 ? nearest - 1 : 0; i < std::min(nearest + 1, ways.size() - 1); ++i) {
    const glm::dvec3 step = ways[i + 1] - ways[i];
    const double length2 = glm::dot(step, step);
    if (length2 < 1e-12) continue;
    const double t = std::clamp(glm::dot(direction - ways[i], step) / length2, 0.0, 1.0);
    const glm::dvec3 at = glm::normalize(ways[i] + t * step);
    if (glm::dot(at, direction) > glm::dot(best.direction, direction))
      best = {(static_cast<double>(i) + t) / kPartSteps, at};
  }
  return best;
}

glm::dvec3 compute_way_from_part(const HairScene& scene, const glm::dvec3& direction) {
  // A fringe falls side by side: straight out of the part's front end, and it would have a gap in its middle.
  constexpr double kAside = 0.35;
  const PartPoint part = find_part_point(scene, direction);
  glm::dvec3 way = direction - part.direction;
  const double fringe = scene.hangs.empty() ? 0 : scene.hangs.front();
  if (part.share <= 0 && !scene.cut.is_drawn) way.x *= std::lerp(1.0, kAside, fringe);
  return way;
}

glm::dvec3 flatten(const glm::dvec3& way, const glm::dvec3& normal) {
  const glm::dvec3 flat = way - normal * glm::dot(way, normal);
  const double length = glm::length(flat);
  return length < 1e-9 ? glm::dvec3(0) : flat / length;
}

glm::dvec3 turn_about(const glm::dvec3& way, const glm::dvec3& axis, double degrees) {
  const double angle = degrees * kRadiansPerDegree;
  return way * std::cos(angle) + glm::cross(axis, way) * std::sin(angle);
}

// The way hair is combed at a place, along the ground; `down` more of it falls.
glm::dvec3 compute_comb(const HairScene& scene, const glm::dvec3& at, const glm::dvec3& normal,
                        double droop) {
  const HairComb& comb = scene.cut.comb;
  const glm::dvec3 direction = glm::normalize(at - scene.chart.centre);
  glm::dvec3 way(0);
  if (comb.is_gathered) {
    way = flatten(scene.knot - at, normal);
  } else {
    way = comb.away * flatten(compute_way_from_part(scene, direction), normal);
    way += (comb.down + droop) * flatten({0, -1, 0}, normal) + comb.back * flatten({0, 0, -1}, normal);
  }
  return flatten(way, normal);
}

// Whether hair is combed out of the face at a place, 1, or ends where its cut says, 0: beside an open
// forehead long hair falls.
double compute_open(const HairScene& scene, const HairPlace& place) {
  constexpr double kFalls_deg = 14, kFallsWhole_deg = 40;  // to the sides: there hair hangs past the face
  if (scene.cut.locks.from_part <= 0 || scene.ends.empty()) return 0;
  return (1 - sample_border(scene.hangs, 0)) *
         (1 - smooth_step(kFalls_deg, kFallsWhole_deg, std::abs(place.azimuth_deg)));
}

// Hair that is combed from a part does not end at an open forehead: the nearer it comes to its border, the
// more it goes along it, away from the part, until there is room to fall.
glm::dvec3 turn_aside(const HairScene& scene, const HairPlace& place, const glm::dvec3& at,
                      const glm::dvec3& normal, const glm::dvec3& way) {
  constexpr double kNear_mm = 34, kInside_mm = 3;  // from the border: there it turns, and there it has
  constexpr double kAlong = 0.9;
  const double open = compute_open(scene, place);
  if (open <= 0) return way;
  const double border = sample_border(scene.hairline, place.azimuth_deg);
  const double left_mm = (border - place.way) * scene.chart.drop_mm / scene.chart.size;
  const double share = open * (1 - smooth_step(kInside_mm, kNear_mm, left_mm));
  const glm::dvec3 down = flatten({0, -1, 0}, normal);
  const double falls = glm::dot(way, down);
  if (share <= 0 || falls <= 0) return way;
  const double hand = std::copysign(1.0, at.x - scene.cut.comb.side_mm * scene.chart.size);
  const double beyond = left_mm < kInside_mm ? std::min(0.5, 0.1 * (kInside_mm - left_mm)) : 0;
  return flatten(way - share * (falls + beyond) * down + share * kAlong * hand * glm::cross(normal, down),
                 normal);
}

// How much of what falls at an azimuth is a fringe, which lies on the forehead.
double compute_fringe(const HairScene& scene, double azimuth_deg) {
  constexpr double kFront_deg = 36, kSide_deg = 56;  // it ends between them
  if (!scene.cut.covers_ears) return 0;              // short hair and curls stand up there
  return sample_border(scene.hangs, 0) * (1 - smooth_step(kFront_deg, kSide_deg, std::abs(azimuth_deg)));
}

// How much longer the way down a meridian to the hairline is than the nearest way: 1 where it is level.
double compute_steepness(const HairScene& scene, double azimuth_deg) {
  constexpr double kTurn_deg = 2;    // either side: what the hairline's slope is read over
  constexpr double kRound_mm = 1.5;  // a degree of azimuth, where the hairline is steep
  const double azimuth = std::abs(azimuth_deg);
  const double fall_mm = kWay_mm * (sample_border(scene.hairline, azimuth + kTurn_deg) -
                                    sample_border(scene.hairline, std::abs(azimuth - kTurn_deg)));
  const double slope = fall_mm / (2 * kTurn_deg * kRound_mm);
  return std::sqrt(1 + slope * slope);
}

constexpr double kWeight_mm = 80;  // a lock has its own weight after so much

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

}  // namespace

double sample_border(const HairBorder& border, double azimuth_deg) {
  const double at = std::clamp(std::abs(azimuth_deg), 0.0, 180.0);
  const auto i = std::min<std::size_t>(static_cast<std::size_t>(at), border.size() - 2);
  return std::lerp(border[i], border[i + 1], at - static_cast<double>(i));
}

double sample_spread(const HairSpread& spread, double azimuth_deg, double share) {
  const double turn = std::abs(azimuth_deg) / 90;
  std::vector<double> stations;
  for (std::size_t i = 0; i < spread.front.size(); ++i)
    stations.push_back(static_cast<double>(i) / static_cast<double>(spread.front.size() - 1));
  const auto at = [&](const std::vector<double>& table) { return sample_stations(stations, table, share); };
  const double front = smooth_step(0, 1, 1 - turn), back = smooth_step(0, 1, turn - 1);
  return front * at(spread.front) + back * at(spread.back) + (1 - front - back) * at(spread.side);
}

double compute_ground_mm(const HairScene& scene, const HairPlace& place) {
  const HairCut& cut = scene.cut;
  const double skin = sample_hair_chart(scene.chart, scene.chart.skin_mm, place);
  if (!cut.covers_ears) return skin;
  const double cover = sample_hair_chart(scene.chart, scene.chart.cover_mm, place);
  const double down = std::max(0.0, place.way - 1);
  const double hangs =
      sample_border(scene.hangs, place.azimuth_deg) - compute_fringe(scene, place.azimuth_deg);
  return std::lerp(skin, cover, std::max(0.0, hangs)) * (1 - cut.tuck * down * down);
}

glm::dvec3 compute_ground_normal(const HairScene& scene, const HairPlace& place) {
  constexpr double kTurn_deg = 3, kWay = 0.04;  // either side: 5 mm, what two ears' edges are smoothed over
  const auto at = [&](double turn, double way) {
    HairPlace near{place.azimuth_deg + turn, std::max(0.0, place.way + way)};
    near.azimuth_deg -= 360 * std::floor((near.azimuth_deg + 180) / 360);
    return compute_hair_point(scene.chart, near, compute_ground_mm(scene, near));
  };
  if (place.way < 2 * kWay) return compute_hair_direction(scene.chart, place);
  const glm::dvec3 normal = glm::cross(at(0, kWay) - at(0, -kWay), at(kTurn_deg, 0) - at(-kTurn_deg, 0));
  const double length = glm::length(normal);
  return length < 1e-9 ? compute_hair_direction(scene.chart, place) : normal / length;
}

HairScene build_hair_scene(const NeutralHead& head, const HairCut& cut) {
  HairScene scene{cut, build_hair_chart(head, cut.whorl_deg, cut.centre_mm), {}, {}, {}, 0};
  scene.part_ways = list_part_ways(cut.comb);
  scene.hairline = compute_border(head, cut.hairline, scene.chart);
  if (!cut.ends.empty()) scene.ends = compute_border(head, cut.ends, scene.chart);
  constexpr double kHangs = 0.2;  // of a way: tips 24 mm below the hairline
  for (std::size_t i = 0; i < scene.hairline.size(); ++i)
    scene.hangs.push_back(scene.ends.empty() ? 0 : smooth_step(0, kHangs, scene.ends[i] - scene.hairline[i]));
  constexpr double kInfant_mm = 66, kGrown_mm = 84;  // eye to chin
  scene.youth = 1 - smooth_step(kInfant_mm, kGrown_mm, compute_eye_to_chin_mm(head));
  if (cut.comb.is_gathered) compute_knot(scene, scene.knot, scene.knot_out);
  return scene;
}

double compute_inside_mm(const HairScene& scene, const HairPlace& place) {
  return (sample_border(scene.hairline, place.azimuth_deg) - place.way) * kWay_mm /
         compute_steepness(scene, place.azimuth_deg);
}

double compute_thickness_mm(const HairScene& scene, const HairPlace& place) {
  constexpr double kLies =
      0.65;  // of the thickness at a fringe's tips; less, and raised brows push skin through
  const bool is_drawn = scene.cut.is_drawn;  // brows that rise would come out of what does not move
  const double border = sample_border(scene.hairline, place.azimuth_deg);
  const double thick_mm =
      sample_spread(scene.cut.thick_mm, place.azimuth_deg, std::min(1.0, place.way / border));
  if (scene.ends.empty() || is_drawn) return thick_mm;
  const double fringe = compute_fringe(scene, place.azimuth_deg);
  const double low = smooth_step(0.7 * border, sample_border(scene.ends, 0), place.way);
  return thick_mm * (1 - (1 - kLies) * fringe * low);
}

double compute_room(const HairChart& chart, const HairPlace& place) {
  constexpr double kTurn_deg = 1, kWay = 0.01;
  const auto at = [&](double turn, double way) {
    return compute_hair_point(chart, {place.azimuth_deg + turn, place.way + way}, 1);
  };
  // On a globe of radius 1; below its middle a way is as long as the drop, of a skull of 95 mm.
  constexpr double kGlobe_mm = 95, kMost = 2.45;  // a way of 140 degrees
  if (place.way >= 1) return std::min(1.0, chart.drop_mm / (kGlobe_mm * chart.size) / kMost);
  const glm::dvec3 aside = (at(kTurn_deg, 0) - at(-kTurn_deg, 0)) / (2 * kTurn_deg * kRadiansPerDegree);
  const glm::dvec3 down = (at(0, 0) - at(0, -kWay)) / kWay;
  return std::min(1.0, glm::length(glm::cross(aside, down)) / kMost);
}

std::vector<HairPlace> spread_roots(const HairScene& scene, int count, double band, bool is_left) {
  // Two irrational steps (Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018).
  constexpr double kFirst = 0.7548776662466927, kSecond = 0.5698402909980532;
  std::vector<HairPlace> roots;
  double longest = 0;
  for (const double way : scene.hairline) longest = std::max(longest, way);
  const int wanted = is_left ? count / 2 : count;
  const int tries = 90 * count + 1000;  // far more than the narrowest band needs
  for (int i = 1; i < tries && static_cast<int>(roots.size()) < wanted; ++i) {
    const double turn = std::fmod(i * kFirst, 1.0), along = std::fmod(i * kSecond, 1.0);
    HairPlace place{is_left ? 180 * turn : 360 * turn - 180, longest * along};
    const double border = sample_border(scene.hairline, place.azimuth_deg);
    if (place.way > border || place.way < band * border) continue;
    if (scatter(kSeries + 1, static_cast<std::uint32_t>(i), 0) > compute_room(scene.chart, place)) continue;
    roots.push_back(place);
  }
  return roots;
}

namespace {

// A stretch of the hairline, degrees from the front, and how far inside it roots lie.
struct BorderBand {
  double first_deg, last_deg, least_mm, most_mm;
};

// Roots on both sides alike, evenly along the stretch.
std::vector<HairPlace> spread_along(const HairScene& scene, int count, const BorderBand& band,
                                    std::uint32_t series) {
  constexpr double kStep = 0.6180339887498949;  // of the golden section: even at any count
  constexpr double kSteepest = 4;               // more, and roots lie far above the temple
  std::vector<HairPlace> roots;
  for (int i = 0; i < count; ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    const int pair = i / 2;  // one root a side
    const double turn = std::fmod((pair + 1) * kStep, 1.0);
    const double azimuth = (i % 2 == 0 ? 1 : -1) * std::lerp(band.first_deg, band.last_deg, turn);
    const double inside_mm = std::lerp(band.least_mm, band.most_mm, scatter(series, index, 0));
    const double up_mm = inside_mm * std::min(kSteepest, compute_steepness(scene, azimuth));
    roots.push_back({azimuth, sample_border(scene.hairline, azimuth) - up_mm / kWay_mm});
  }
  return roots;
}

constexpr double kBeforeEar_deg = 84;

// Where hair begins to fall from the hairline, degrees from the front.
double find_first_fall(const HairScene& scene) {
  constexpr double kHangs = 0.5;  // less of it, and hair is combed out of the face
  double first_deg = 0;
  while (first_deg < kBeforeEar_deg && sample_border(scene.hangs, first_deg) < kHangs) ++first_deg;
  return first_deg;
}

}  // namespace

std::vector<HairPlace> spread_border_roots(const HairScene& scene, int count) {
  return spread_along(scene, count, {find_first_fall(scene), kBeforeEar_deg, 1, 9}, kSeries + 2);
}

std::vector<HairPlace> spread_front_roots(const HairScene& scene, int count) {
  return spread_along(scene, count, {0, find_first_fall(scene), 0.5, 32}, kSeries + 3);
}

std::vector<HairPlace> spread_part_roots(const HairScene& scene, int count) {
  constexpr double kLeast_mm = 0.8, kMost_mm = 4.5;  // from the part
  std::vector<HairPlace> roots;
  const int pairs = count / 2;
  for (int i = 0; i < 2 * pairs; ++i) {
    const int pair = i / 2;  // one root a side
    const double share = (pair + 0.5) / pairs;
    const double away_mm =
        std::lerp(kLeast_mm, kMost_mm, scatter(kSeries + 4, static_cast<std::uint32_t>(i), 0));
    const glm::dvec3 part = compute_part_direction(scene.cut.comb, share);
    const glm::dvec3 level = flatten({i % 2 == 0 ? 1 : -1, 0, 0}, part);
    const HairPlace root =
        compute_hair_place(scene.chart, scene.chart.centre + part + level * (away_mm / kSkull_mm));
    if (root.way < sample_border(scene.hairline, root.azimuth_deg)) roots.push_back(root);
  }
  return roots;
}

void compute_knot(const HairScene& scene, glm::dvec3& at, glm::dvec3& out) {
  out = compute_arc_direction(0, scene.cut.comb.knot_deg, 1);
  const glm::dvec3 far = scene.chart.centre + 100.0 * scene.chart.size * out;
  const HairPlace place = compute_hair_place(scene.chart, far);
  at = compute_hair_point(scene.chart, place, compute_ground_mm(scene, place));
  at.x = 0;  // the sine of 180 degrees is not quite 0
}

glm::dvec3 compute_comb_way(const HairScene& scene, const HairPlace& place, double gone_mm) {
  const glm::dvec3 at = compute_hair_point(scene.chart, place, compute_ground_mm(scene, place));
  const glm::dvec3 normal = compute_ground_normal(scene, place);
  const double droop = scene.cut.comb.droop * std::min(1.0, gone_mm / kWeight_mm);
  const glm::dvec3 way = compute_comb(scene, at, normal, droop);
  return way == glm::dvec3(0) ? flatten({0, -1, 0.1}, normal) : way;
}

PartArm compute_part_arm(const HairScene& scene, const glm::dvec3& at) {
  const HairComb& comb = scene.cut.comb;
  const glm::dvec3 direction = glm::normalize(at - scene.chart.centre);
  const auto [share, nearest] = find_part_point(scene, direction);
  const double turn = comb.from_deg + share * (comb.to_deg - comb.from_deg);
  const glm::dvec3 front(0, std::sin(turn * kRadiansPerDegree), std::cos(turn * kRadiansPerDegree));
  const glm::dvec3 arm = direction - nearest;
  const double skull_mm = kSkull_mm * scene.chart.size;
  const double along_mm = skull_mm * share * (comb.to_deg - comb.from_deg) * kRadiansPerDegree;
  const double ahead = glm::dot(arm, front);
  if (share > 0 && share < 1) return {skull_mm * glm::length(arm), 0, arm.x, along_mm - skull_mm * ahead};
  return {skull_mm * glm::length(arm), ahead, arm.x, along_mm};
}

HairPlace compute_part_place(const HairScene& scene, double share) {
  return compute_hair_place(scene.chart, scene.chart.centre + compute_part_direction(scene.cut.comb, share));
}

double compute_wave(const HairScene& scene, const HairPlace& place) {
  constexpr double kSlant_deg = 65;  // around the head to be a wave behind: level rings look ironed
  return place.way * scene.chart.drop_mm / (scene.cut.locks.wave_length_mm * scene.chart.size) +
         std::abs(place.azimuth_deg) / kSlant_deg;
}

namespace {

// A short lock bends less than a long one; waves, curls and ink's outlines want all that the cut has.
int count_rings(const HairScene& scene, double length_mm) {
  constexpr double kRing_mm = 5.5;
  constexpr int kLeast = 3;
  const HairLocks& locks = scene.cut.locks;
  if (scene.cut.is_drawn || locks.wave_mm > 0 || locks.curl_mm > 0) return locks.rings;
  const int needed = 1 + static_cast<int>(std::ceil(length_mm / (kRing_mm * scene.chart.size)));
  return std::clamp(needed, std::min(kLeast, locks.rings), locks.rings);
}

}  // namespace

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
  const double deepest = locks.deepest * cut.mass,
               lift = deepest + (1 - deepest) * strand.layer * strand.layer;
  const int rings = count_rings(scene, strand.length_mm);
  // What hangs bends over the crown, and then falls straight: rings lie closer there.
  constexpr double kCloser = 1.5;
  const double closer = cut.covers_ears && !cut.is_drawn && locks.wave_mm == 0 ? kCloser : 1;
  for (int ring = 0; ring < rings; ++ring) {
    const double s = std::pow(static_cast<double>(ring) / (rings - 1), closer), at = s * steps;
    const auto i = std::min(static_cast<std::size_t>(at), path.places.size() - 1);
    const auto j = std::min(i + 1, path.places.size() - 1);
    const HairPlace &a = path.places[i], &b = path.places[j];
    const double t = at - std::floor(at);
    const auto height_at = [&](const HairPlace& place) {
      return size * child * compute_thickness_mm(scene, place);
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
      const double turn =
          2 * std::numbers::pi * (compute_wave(scene, compute_hair_place(scene.chart, point)) + kOwn * phase);
      const double amount_mm = smooth_step(0, 0.3, s) * locks.wave_mm * size;
      point += side * (0.8 * amount_mm * std::sin(turn)) + out * (0.5 * amount_mm * (1 + std::cos(turn)));
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
  constexpr double kLevel = 0.3;                   // of what it lies higher or lower: a lock is flat
  constexpr double kNear_mm = 12, kFar_mm = 28;    // from the middle: what is farther falls by itself
  const double pull = scene.cut.locks.gathered;
  for (std::size_t i = 0; i < strand.points.size(); ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(strand.points.size() - 1);
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
    arm -= (1 - kLevel) * glm::dot(arm, strand.outs[i]) * strand.outs[i];
    const double near = 1 - smooth_step(kNear_mm, kFar_mm, glm::length(arm) / scene.chart.size);
    at += pull * near * smooth_step(kBegins, kWhole, s) * arm;
  }
}

}  // namespace mien

#include "head/hair_growth.hpp"

#include <algorithm>
#include <cmath>

#include "core/conventions.hpp"
#include "core/smooth.hpp"
#include "head/hair_comb.hpp"
#include "head/lids.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr std::uint32_t kRootSeries = 43;  // of scatter()
constexpr int kDegrees = 181;              // of a border: 0..180
constexpr double kWay_mm = 130;            // of the adult, from the whorl to the height of the centre

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
  constexpr int kOwnRings = 3;  // of each lock: at its root, at its tip and before it
  if (cut.covers_ears && !cut.is_drawn && !scene.ends.empty() && !cut.comb.is_gathered)
    scene.ring_stations = spread_ring_stations(scene, cut.locks.rings - kOwnRings);
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
    if (scatter(kRootSeries + 1, static_cast<std::uint32_t>(i), 0) > compute_room(scene.chart, place))
      continue;
    roots.push_back(place);
  }
  return roots;
}

namespace {

// A stretch of the hairline, degrees from the front, and how far inside it roots lie.
struct BorderBand {
  double first_deg, last_deg, least_mm, most_mm;
  double crowding = 1;  // more: closer at its first end
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
    const double turn = std::pow(std::fmod((pair + 1) * kStep, 1.0), band.crowding);
    const double azimuth = (i % 2 == 0 ? 1 : -1) * std::lerp(band.first_deg, band.last_deg, turn);
    const double inside_mm = std::lerp(band.least_mm, band.most_mm, scatter(series, index, 0));
    const double up_mm = inside_mm * std::min(kSteepest, compute_steepness(scene, azimuth));
    roots.push_back({azimuth, sample_border(scene.hairline, azimuth) - up_mm / kWay_mm});
  }
  return roots;
}

constexpr double kBeforeEar_deg = 84;

// Where hair begins to fall past the face, degrees from the front.
double find_first_fall(const HairScene& scene) {
  constexpr double kOpen = 0.5;  // less of it, and hair falls
  double first_deg = 0;
  while (first_deg < kBeforeEar_deg && compute_open(scene, {first_deg, 1}) > kOpen) ++first_deg;
  return first_deg;
}

}  // namespace

std::vector<HairPlace> spread_border_roots(const HairScene& scene, int count) {
  constexpr double kMost_mm = 9, kMostOfFringe_mm = 30;  // nearer together, and a fringe has two tiers
  constexpr double kFringe = 1.7;
  const double fringe = sample_border(scene.hangs, 0);
  return spread_along(scene, count,
                      {find_first_fall(scene), kBeforeEar_deg, 1,
                       std::lerp(kMost_mm, kMostOfFringe_mm, fringe), std::lerp(1.0, kFringe, fringe)},
                      kRootSeries + 2);
}

std::vector<HairPlace> spread_front_roots(const HairScene& scene, int count) {
  return spread_along(scene, count, {0, find_first_fall(scene), 0.5, 32}, kRootSeries + 3);
}

std::vector<HairPlace> spread_part_roots(const HairScene& scene, int count) {
  constexpr double kLeast_mm = 0.8, kMost_mm = 4.5;  // from the part
  std::vector<HairPlace> roots;
  const int pairs = count / 2;
  for (int i = 0; i < 2 * pairs; ++i) {
    const int pair = i / 2;  // one root a side
    const double share = (pair + 0.5) / pairs;
    const double away_mm =
        std::lerp(kLeast_mm, kMost_mm, scatter(kRootSeries + 4, static_cast<std::uint32_t>(i), 0));
    const glm::dvec3 part = compute_part_direction(scene.cut.comb, share);
    const glm::dvec3 level = flatten({i % 2 == 0 ? 1 : -1, 0, 0}, part);
    const HairPlace root =
        compute_hair_place(scene.chart, scene.chart.centre + part + level * (away_mm / kSkull_mm));
    if (root.way < sample_border(scene.hairline, root.azimuth_deg)) roots.push_back(root);
  }
  return roots;
}

double compute_wave_room(const HairScene& scene, const HairPlace& place) {
  constexpr double kNone_mm = 2, kWhole_mm = 24;  // inside the hairline
  const double open = 1 - sample_border(scene.hangs, place.azimuth_deg);
  return 1 - open * (1 - smooth_step(kNone_mm, kWhole_mm, compute_inside_mm(scene, place)));
}

double compute_wave(const HairScene& scene, const HairPlace& place) {
  constexpr double kSlant_mm = 120;  // to the back to be a wave behind: level rings look ironed
  const double back_mm = -compute_hair_point(scene.chart, place, compute_ground_mm(scene, place)).z;
  return compute_combed_mm(scene, place) / scene.cut.locks.wave_length_mm +
         back_mm / (kSlant_mm * scene.chart.size);
}

}  // namespace mien

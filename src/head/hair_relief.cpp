// A field of heights over the head: the larger of several bodies, its edges rounded by a bell, and no slope
// below what hangs that a printer could not build on.
#include "head/hair_relief.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/conventions.hpp"
#include "core/pool.hpp"
#include "core/smooth.hpp"
#include "head/hair.hpp"
#include "head/hair_comb.hpp"
#include "head/hair_mass.hpp"
#include "head/hair_strand.hpp"

namespace mien {

namespace {

constexpr int kAzimuths = HairRelief::kAzimuths, kWays = HairRelief::kWays;
constexpr double kWayStep = HairChart::kLongest / (kWays - 1);
constexpr double kStep = 1.4;  // of the print: how high hair ends; lower is lost beside brows and lips

std::size_t slot(int azimuth, int way) {
  return static_cast<std::size_t>(((azimuth % kAzimuths) + kAzimuths) % kAzimuths * kWays + way);
}

HairPlace place_of(int azimuth, int way) { return {azimuth - 180.0, way * kWayStep}; }

// What a point of the face throws on the head, seen from the axis, stays free of hair, and so much around it.
void keep_free(const HairChart& chart, const glm::dvec3& point, double around_mm, std::vector<double>& ends) {
  constexpr double kOut_mm = 80;  // of it from the axis
  const HairPlace place = compute_hair_place(chart, point);
  const double above = place.way - around_mm / chart.drop_mm,
               beside_deg = around_mm / (kOut_mm * chart.size * kRadiansPerDegree);
  const int first = static_cast<int>(std::floor(place.azimuth_deg + 180 - beside_deg)),
            last = static_cast<int>(std::ceil(place.azimuth_deg + 180 + beside_deg));
  for (int azimuth = first; azimuth <= last; ++azimuth) {
    double& end = ends[static_cast<std::size_t>((azimuth + kAzimuths) % kAzimuths)];
    end = std::min(end, above);
  }
}

// How far from the axis hair lies at a place, `left_mm` of the way before it ends.
double compute_body_mm(const HairScene& scene, const HairPlace& place, double left_mm, double fine_mm) {
  constexpr double kThinner = 0.65, kThins_mm = 34;  // at its edge, over so much
  constexpr double kRim_mm = 14;                     // over so much hair is as thick as its step at least
  constexpr double kTurn_mm = 22;                    // the round of what hangs, at its lower edge
  constexpr double kTuck = 0.2;  // how much nearer it comes to the neck, of the square of the way down
  const double size = scene.chart.size;
  const double least = kStep * fine_mm * (1 - 0.5 * smooth_step(0.3, 1, left_mm / (kRim_mm * size)));
  const double thins = std::lerp(kThinner, 1.0, smooth_step(0, kThins_mm * size, left_mm));
  const double thick = std::max(thins * compute_mass_height_mm(scene, place), least);
  const double out = compute_ground_mm(scene, place) + thick;
  if (!scene.cut.covers_ears) return out;
  const double turn = std::clamp(1 - left_mm / (kTurn_mm * size), 0.0, 0.7);
  const double hangs = sample_border(scene.hangs, place.azimuth_deg), down = std::max(0.0, place.way - 1);
  const double least_out = sample_hair_chart(scene.chart, scene.chart.skin_mm, place) + least;
  const double tucked =
      out * (1 - hangs * kTuck * down * down) - hangs * kTurn_mm * size * (1 - std::sqrt(1 - turn * turn));
  return std::max(std::min(out, least_out), tucked);
}

// Where the hair's outer edge is at each degree of azimuth: as the cut says, around ears that it leaves free
// and above brows and lids, but so much higher as the slope under it takes.
std::vector<double> compute_ends(const NeutralHead& head, const HairScene& scene,
                                 const std::vector<glm::vec3>& face, double fine_mm) {
  constexpr double kBesideEar = 0.8, kAboveFace = 0.7;  // of the print
  constexpr double kSlope = 0.9, kLongest_mm = 11;      // of what slopes; more would bare the neck
  std::vector<double> ends;
  const HairBorder& border = scene.ends.empty() ? scene.hairline : scene.ends;
  for (int azimuth = 0; azimuth < kAzimuths; ++azimuth)
    ends.push_back(sample_border(border, place_of(azimuth, 0).azimuth_deg));
  for (const glm::vec3& p : face) keep_free(scene.chart, glm::dvec3(p), kAboveFace * fine_mm, ends);
  const std::vector<double> before = ends;
  for (int azimuth = 0; azimuth < kAzimuths; ++azimuth) {
    const HairPlace place{azimuth - 180.0, before[static_cast<std::size_t>(azimuth)]};
    const double high = compute_body_mm(scene, place, 0, fine_mm) -
                        sample_hair_chart(scene.chart, scene.chart.skin_mm, place);
    ends[static_cast<std::size_t>(azimuth)] -=
        std::min(kSlope * high, kLongest_mm * scene.chart.size) / scene.chart.drop_mm;
  }
  if (scene.cut.covers_ears) return ends;
  const std::vector<HairGround> grounds = list_hair_grounds(head);
  for (std::size_t v = 0; v < head.skin.positions.size(); ++v)
    if (grounds[v] == HairGround::ear)
      keep_free(scene.chart, glm::dvec3(head.skin.positions[v]), kBesideEar * fine_mm, ends);
  return ends;
}

// Below all layers of the skin at each place: where there is no hair, nothing of the neck under a chin or a
// jaw is taken for covered.
std::vector<double> compute_floor(const NeutralHead& head, const HairChart& chart, double sunk_mm) {
  constexpr int kBeside = 2;  // places: vertices lie apart
  std::vector<double> floor;
  for (int azimuth = 0; azimuth < kAzimuths; ++azimuth)
    for (int way = 0; way < kWays; ++way)
      floor.push_back(sample_hair_chart(chart, chart.skin_mm, place_of(azimuth, way)));
  const std::vector<HairGround> grounds = list_hair_grounds(head);
  for (std::size_t v = 0; v < grounds.size(); ++v) {
    if (grounds[v] == HairGround::ear) continue;
    const glm::dvec3 at(head.skin.positions[v]);
    const HairPlace place = compute_hair_place(chart, at);
    const double out = glm::distance(compute_hair_point(chart, place, 0), at);
    const int azimuth = static_cast<int>(std::lround(place.azimuth_deg + 180)),
              way = static_cast<int>(std::lround(place.way / kWayStep));
    for (int i = azimuth - kBeside; i <= azimuth + kBeside; ++i)
      for (int j = std::max(0, way - kBeside); j <= std::min(kWays - 1, way + kBeside); ++j)
        floor[slot(i, j)] = std::min(floor[slot(i, j)], out);
  }
  for (double& value : floor) value -= sunk_mm;
  return floor;
}

// A lock as a ridge over the body: points along it on the ground, and how broad it is at each.
struct Ridge {
  std::vector<glm::dvec3> points;
  std::vector<double> half_mm;
  double layer = 0, height = 1;  // 0 .. 1
};

std::vector<Ridge> list_ridges(const HairScene& scene) {
  constexpr double kCurl_mm = 9;           // half of a knob of curls
  constexpr double kStep_mm = 2.5;         // from point to point
  constexpr double kLeastWidth_mm = 12;    // finer ones do not print
  constexpr double kDot = 1, kLong = 2.2;  // of its breadth: one as short is a dot, as long is a lock
  const HairCut& cut = scene.cut;
  const double size = scene.chart.size, width = std::max(cut.locks.width_mm, kLeastWidth_mm);
  const auto roots = spread_roots(scene, cut.locks.count, cut.locks.root_band, false);
  std::vector<Ridge> ridges(roots.size());
  for_each_index(roots.size(), count_workers(), [&](std::size_t i, int) {
    const HairStrand strand =
        grow_strand(scene, roots[i], static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i));
    if (strand.points.empty()) return;
    Ridge& ridge = ridges[i];
    ridge.layer = strand.layer;
    ridge.height = smooth_step(kDot, kLong, strand.length_mm / (width * size));
    const auto add = [&](const glm::dvec3& at, double half_mm) {
      const HairPlace place = compute_hair_place(scene.chart, at);
      ridge.points.push_back(compute_hair_point(scene.chart, place, compute_ground_mm(scene, place)));
      ridge.half_mm.push_back(half_mm);
    };
    if (cut.locks.curl_mm > 0) {
      ridge.height = 1;
      add(compute_hair_point(scene.chart, roots[i], compute_ground_mm(scene, roots[i])), kCurl_mm * size);
      return;
    }
    const std::size_t last = strand.points.size() - 1;
    const int steps = std::max(2, static_cast<int>(strand.length_mm / (kStep_mm * size)));
    for (int step = 0; step <= steps; ++step) {
      const double s = static_cast<double>(step) / steps, at = s * static_cast<double>(last);
      const std::size_t k = std::min(static_cast<std::size_t>(at), last - 1);
      // As a leaf: broad soon, and long in coming to its tip.
      const double half =
          0.5 * width * size * std::sqrt(smooth_step(0, 0.25, s) * (1 - smooth_step(0.5, 1.05, s)));
      add(glm::mix(strand.points[k], strand.points[k + 1], at - static_cast<double>(k)), half);
    }
  });
  return ridges;
}

// How much higher than the body locks stand at each place.
std::vector<double> compute_locks(const HairScene& scene, double fine_mm) {
  constexpr double kRound = 0.45, kLayer = 0.35, kKnob = 0.9;  // of the print: their backs, one over another
  const HairChart& chart = scene.chart;
  std::vector<glm::dvec3> grounds;
  for (int azimuth = 0; azimuth < kAzimuths; ++azimuth)
    for (int way = 0; way < kWays; ++way)
      grounds.push_back(compute_hair_point(chart, place_of(azimuth, way),
                                           compute_ground_mm(scene, place_of(azimuth, way))));
  std::vector<double> locks(grounds.size(), 0);
  const double round = scene.cut.locks.curl_mm > 0 ? kKnob : kRound;
  for (const Ridge& ridge : list_ridges(scene))
    for (std::size_t i = 0; i < ridge.points.size(); ++i) {
      const double half = ridge.half_mm[i];
      if (half <= 0) continue;
      const HairPlace middle = compute_hair_place(chart, ridge.points[i]);
      const double narrow = std::sin(std::min(1.0, middle.way) * 90 * kRadiansPerDegree) * 70 * chart.size;
      const int up = static_cast<int>(std::ceil(half / (kWayStep * chart.drop_mm))) + 1,
                aside = std::min(kAzimuths / 2 - 1,
                                 static_cast<int>(half / (narrow * kRadiansPerDegree + 1e-3)) + 2),
                at_azimuth = static_cast<int>(std::lround(middle.azimuth_deg + 180)),
                at_way = static_cast<int>(std::lround(middle.way / kWayStep));
      for (int azimuth = at_azimuth - aside; azimuth <= at_azimuth + aside; ++azimuth)
        for (int way = std::max(0, at_way - up); way <= std::min(kWays - 1, at_way + up); ++way) {
          const double away = glm::distance(grounds[slot(azimuth, way)], ridge.points[i]) / half;
          if (away >= 1) continue;
          double& lock = locks[slot(azimuth, way)];
          lock = std::max(lock, ridge.height *
                                    (kLayer * ridge.layer * std::sqrt(1 - away) + round * (1 - away * away)) *
                                    fine_mm);
        }
    }
  return locks;
}

// Takes away what hangs over the chest's edge, as far as a print's slope goes up from there.
void clear_chest(const HairChart& chart, const std::vector<glm::vec3>& chest, double fine_mm,
                 std::vector<double>& values) {
  constexpr double kSteeper = 0.85, kInside = 1.5;  // than prop_up's; of the print
  constexpr int kWide = 6;                          // degrees to either side: the edge's vertices lie apart
  std::vector<HairPlace> ends(kAzimuths, {0, HairChart::kLongest});
  std::vector<double> outs(kAzimuths, 1e9);
  for (const glm::vec3& p : chest) {
    const glm::dvec3 at(p);
    const HairPlace place = compute_hair_place(chart, at);
    const double out = glm::distance(compute_hair_point(chart, place, 0), at) - kInside * fine_mm;
    const int middle = static_cast<int>(std::lround(place.azimuth_deg + 180));
    for (int i = middle - kWide; i <= middle + kWide; ++i) {
      const auto azimuth = static_cast<std::size_t>((i + kAzimuths) % kAzimuths);
      ends[azimuth].way = std::min(ends[azimuth].way, place.way);
      outs[azimuth] = std::min(outs[azimuth], out);
    }
  }
  for (int azimuth = 0; azimuth < kAzimuths; ++azimuth)
    for (int way = 0; way < kWays; ++way) {
      const auto i = static_cast<std::size_t>(azimuth);
      const double up_mm = (ends[i].way - place_of(azimuth, way).way) * chart.drop_mm;
      double& value = values[slot(azimuth, way)];
      value = std::min(value, std::max(0.0, outs[i] + (up_mm > 0 ? kSteeper : 2) * up_mm));
    }
}

// A bell over the places about each, `wide_mm` from its middle to where it bends.
void soften(const HairChart& chart, double wide_mm, std::vector<double>& values) {
  constexpr int kMost = 12;
  const std::vector<double> before = values;
  const auto weigh = [](double x) { return std::exp(-0.5 * x * x); };
  std::vector<double> across(values.size());
  const int reach = std::min(kMost, static_cast<int>(std::ceil(2.5 * wide_mm / (kWayStep * chart.drop_mm))));
  for (int azimuth = 0; azimuth < kAzimuths; ++azimuth)
    for (int way = 0; way < kWays; ++way) {
      double sum = 0, weights = 0;
      for (int i = std::max(0, way - reach); i <= std::min(kWays - 1, way + reach); ++i) {
        const double weight = weigh((i - way) * kWayStep * chart.drop_mm / wide_mm);
        sum += weight * before[slot(azimuth, i)];
        weights += weight;
      }
      across[slot(azimuth, way)] = sum / weights;
    }
  for (int way = 0; way < kWays; ++way) {
    const double round = std::sin(std::min(1.0, way * kWayStep) * 90 * kRadiansPerDegree);
    for (int azimuth = 0; azimuth < kAzimuths; ++azimuth) {
      const double step_mm = kRadiansPerDegree * std::max(40.0, across[slot(azimuth, way)]) * round + 1e-3;
      const int wide = std::min(kMost, static_cast<int>(std::ceil(2.5 * wide_mm / step_mm)));
      double sum = 0, weights = 0;
      for (int i = -wide; i <= wide; ++i) {
        const double weight = weigh(i * step_mm / wide_mm);
        sum += weight * across[slot(azimuth + i, way)];
        weights += weight;
      }
      values[slot(azimuth, way)] = sum / weights;
    }
  }
}

// Whether the way from one place to the next leads down the head, and not around it, as ways do beside the
// whorl.
bool runs_down(const HairChart& chart, const HairPlace& from, const HairPlace& to) {
  constexpr double kSteep = 0.5;  // of the steepest way there is
  const glm::dvec3 out = compute_hair_direction(chart, from), step = compute_hair_direction(chart, to) - out;
  return -step.y > kSteep * glm::length(step) * std::sqrt(std::max(0.0, 1 - out.y * out.y));
}

// Fills what recedes too fast below hair.
void prop_up(const HairChart& chart, std::vector<double>& values) {
  const auto skin_mm = [&](const HairPlace& place) { return sample_hair_chart(chart, chart.skin_mm, place); };
  constexpr double kOver = 0.9;  // breadth to height: less than 45 degrees, as triangles cut corners
  for (int azimuth = 0; azimuth < kAzimuths; ++azimuth)
    for (int way = 1; way < kWays; ++way) {
      const HairPlace above = place_of(azimuth, way - 1), here = place_of(azimuth, way);
      const double before = values[slot(azimuth, way - 1)];
      double& value = values[slot(azimuth, way)];
      const auto weigh = [&](const HairPlace& place) {
        const glm::dvec3 out = compute_hair_direction(chart, place);
        return std::sqrt(out.x * out.x + out.z * out.z) - kOver * out.y;
      };
      const double sunk_mm = (std::max(0.0, here.way - 1) - std::max(0.0, above.way - 1)) * chart.drop_mm;
      const double high = weigh(above), low = weigh(here);
      const bool is_below = here.way > 1 || runs_down(chart, above, here);
      if (is_below && before > skin_mm(above) && high > 0 && low > high - 1e-9)
        value = std::max(value, (before * high - kOver * sunk_mm) / low);
    }
}

// No wall beside hair is steeper than triangles can follow.
void lean_walls(const HairChart& chart, std::vector<double>& values) {
  constexpr double kSteepest = 2.2;
  constexpr int kFirst = kWays / 8;  // nearer to the whorl there is no edge
  for (int way = kFirst; way < kWays; ++way) {
    const double round = std::sin(std::min(1.0, way * kWayStep) * 90 * kRadiansPerDegree) * kRadiansPerDegree;
    const auto lean = [&](int from, int to) {
      const double most = values[slot(from, way)];
      const HairPlace place{from % kAzimuths - 180.0, way * kWayStep};
      if (most <= sample_hair_chart(chart, chart.skin_mm, place)) return;
      double& value = values[slot(to, way)];
      value = std::max(value, most - kSteepest * round * std::max(40.0, most));
    };
    for (int azimuth = 0; azimuth < 2 * kAzimuths; ++azimuth) lean(azimuth, azimuth + 1);
    for (int azimuth = 2 * kAzimuths; azimuth > 0; --azimuth) lean(azimuth, azimuth - 1);
  }
}

// Even at the whorl, where all meridians begin.
void level_whorl(std::vector<double>& values) {
  double sum = 0;
  for (int azimuth = 0; azimuth < kAzimuths; ++azimuth) sum += values[slot(azimuth, 0)] / kAzimuths;
  for (int azimuth = 0; azimuth < kAzimuths; ++azimuth) values[slot(azimuth, 0)] = sum;
}

// A ball's far side, seen from the axis.
void add_ball(const HairChart& chart, const glm::dvec3& centre, double radius_mm,
              std::vector<double>& values) {
  for (int azimuth = 0; azimuth < kAzimuths; ++azimuth)
    for (int way = 0; way < kWays; ++way) {
      const HairPlace place = place_of(azimuth, way);
      const glm::dvec3 origin = compute_hair_point(chart, place, 0),
                       out = compute_hair_direction(chart, place);
      const glm::dvec3 arm = centre - origin;
      const double along = glm::dot(arm, out), aside = glm::dot(arm, arm) - along * along;
      if (along <= 0 || aside > radius_mm * radius_mm) continue;
      double& value = values[slot(azimuth, way)];
      value = std::max(value, along + std::sqrt(radius_mm * radius_mm - aside));
    }
}

void add_knot(const HairScene& scene, std::vector<double>& values) {
  const HairChart& chart = scene.chart;
  glm::dvec3 at, out;
  compute_knot(scene, at, out);
  if (scene.cut.bun_radius_mm > 0) {
    constexpr double kOut = 0.4, kSmaller = 0.92;  // of its radius: what prints without a neck
    const double radius = scene.cut.bun_radius_mm * chart.size;
    add_ball(chart, at + out * kOut * radius, kSmaller * radius, values);
  }
  if (scene.cut.tail.radius_mm <= 0) return;
  // It lies on the back of the head and on the neck: what hangs free would begin in the air.
  constexpr int kBalls = 60;
  constexpr double kOut = 0.35, kClings = 0.6;  // of its radius; of the way back to the neck
  constexpr double kLong = 0.8, kLess = 0.4;    // of what hangs free; an infant has no neck for it
  const double radius = scene.cut.tail.radius_mm * chart.size,
               length = (kLong - kLess * scene.youth) * scene.cut.tail.length_mm * chart.size;
  HairPlace place{180, compute_hair_place(chart, at).way};
  if (at.z > compute_hair_point(chart, {180, 0}, 100).z) place.azimuth_deg = 0;
  for (int i = 0; i <= kBalls; ++i) {
    const double s = static_cast<double>(i) / kBalls;
    const double ground = compute_ground_mm(scene, place),
                 widest = compute_ground_mm(scene, {place.azimuth_deg, std::min(1.0, place.way)});
    const double full = std::sqrt(smooth_step(-0.25, 0.3, s) * (1 - 0.75 * smooth_step(0.45, 1, s)));
    add_ball(chart,
             compute_hair_point(chart, place, std::lerp(widest, ground, kClings) + kOut * radius * full),
             radius * full, values);
    const double step = length / kBalls;
    place.azimuth_deg = 180;
    place.way +=
        step / (place.way < 1
                    ? ground * std::acos(glm::dot(chart.whorl, compute_hair_direction(chart, {180, 1})))
                    : chart.drop_mm);
  }
}

}  // namespace

bool has_hair_mass(const NeutralHead& head, const std::string& cut) {
  return cut != "none" && find_drawn_cut(head, cut).mass > 0;
}

HairRelief build_hair_relief(const NeutralHead& head, const std::string& cut, const HairSurroundings& around,
                             double fine_mm) {
  const HairScene scene = build_hair_scene(head, find_drawn_cut(head, cut));
  const HairChart& chart = scene.chart;
  const std::vector<double> ends = compute_ends(head, scene, around.face, fine_mm);
  HairRelief relief{chart, std::vector<double>(std::size_t{kAzimuths} * kWays), scene.cut.covers_ears, 0};
  const std::vector<double> locks = compute_locks(scene, fine_mm),
                            floor = compute_floor(head, chart, kStep * fine_mm);
  for_each_index(kAzimuths, count_workers(), [&](std::size_t index, int) {
    const int azimuth = static_cast<int>(index);
    for (int way = 0; way < kWays; ++way) {
      const HairPlace place = place_of(azimuth, way);
      const double left_mm = (ends[index] - place.way) * chart.drop_mm;
      relief.outer_mm[slot(azimuth, way)] =
          left_mm > 0 ? compute_body_mm(scene, place, left_mm, fine_mm) + locks[slot(azimuth, way)]
                      : floor[slot(azimuth, way)];
    }
  });
  clear_chest(chart, around.chest, fine_mm, relief.outer_mm);
  constexpr double kSoft = 0.4;  // of the print: how round edges are
  lean_walls(chart, relief.outer_mm);
  if (scene.cut.comb.is_gathered) add_knot(scene, relief.outer_mm);
  soften(chart, kSoft * fine_mm, relief.outer_mm);
  prop_up(chart, relief.outer_mm);
  level_whorl(relief.outer_mm);
  for (int azimuth = 0; azimuth < kAzimuths; ++azimuth)
    for (int way = 0; way < kWays; ++way)
      relief.top_mm =
          std::max(relief.top_mm,
                   compute_hair_point(chart, place_of(azimuth, way), relief.outer_mm[slot(azimuth, way)]).y);
  return relief;
}

double sample_hair_relief(const HairRelief& relief, const HairPlace& place) {
  const double a = place.azimuth_deg + 180, w = std::clamp(place.way / kWayStep, 0.0, kWays - 1.0);
  const int i = static_cast<int>(std::floor(a)), j = std::min(static_cast<int>(w), kWays - 2);
  const auto at = [&](int azimuth, int way) { return relief.outer_mm[slot(azimuth, way)]; };
  return std::lerp(std::lerp(at(i, j), at(i + 1, j), a - i), std::lerp(at(i, j + 1), at(i + 1, j + 1), a - i),
                   w - j);
}

}  // namespace mien

#include "head/hair_drawn.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/conventions.hpp"
#include "core/smooth.hpp"
#include "head/hair_comb.hpp"
#include "head/hair_edge.hpp"
#include "head/hair_light.hpp"
#include "head/hair_locks.hpp"
#include "head/hair_mass.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

struct DrawnShell {
  const HairScene& scene;
  std::vector<DrawnEdge> edge;  // one a column
  Fall fall;
  double level = 0;                    // the way above which no column ends
  std::vector<LightBand> light = {};   // one a column
  std::vector<glm::dvec3> puffs = {};  // curls: points of the ground
};

constexpr int kLightRow = 11;  // the ring of light lies between this row and the next
constexpr int kLevelRows = 26, kEndRows = 13, kDrawnRows = kLevelRows + kEndRows;
constexpr int kDrawnInnerRows = 8;  // of the inside, which nobody sees

// A lock is bent from where it is free, and most at its tip.
HairPlace bend_place(const DrawnShell& shell, const DrawnEdge& edge, double way) {
  constexpr double kFree_mm = 40;  // of the adult
  const double free = kFree_mm * shell.scene.chart.size / shell.scene.chart.drop_mm;
  const double share = std::clamp(1 - (edge.way - way) / free, 0.0, 1.0);
  return {wrap_azimuth(edge.turn_deg + edge.bent_deg * share * share), way};
}

HairPlace find_drawn_place(const DrawnShell& shell, std::size_t column, int row) {
  const DrawnEdge& edge = shell.edge[column];
  const LightBand& light = shell.light[column];
  const auto between = [&](double from, double to, int first, int last) {
    return bend_place(shell, edge, std::lerp(from, to, static_cast<double>(row - first) / (last - first)));
  };
  if (row <= kLightRow) return between(0, light.high, 0, kLightRow);
  constexpr double kBelow =
      0.3;  // of what is left under the light, where it comes down further than all ends
  const double level = std::max(shell.level, std::lerp(light.low, edge.way, kBelow));
  if (row <= kLevelRows) return between(light.low, level, kLightRow + 1, kLevelRows);
  return between(level, edge.way, kLevelRows, kDrawnRows);
}

double compute_drawn_size(const HairScene& scene) {
  return scene.chart.size * (1 - (1 - scene.cut.infant) * scene.youth);
}

// Curls are balls of them, spread evenly.
constexpr double kPuff_mm = 21;  // radius, of the adult

std::vector<glm::dvec3> list_puffs(const HairScene& scene) {
  constexpr int kPuffs = 90;
  std::vector<glm::dvec3> puffs;
  if (scene.cut.locks.curl_mm <= 0) return puffs;
  for (const HairPlace& place : spread_roots(scene, kPuffs, 0, false))
    puffs.push_back(compute_hair_point(scene.chart, place, compute_ground_mm(scene, place)));
  return puffs;
}

// How much of a ball stands over a point of the ground, 0..1.
double compute_puff(const DrawnShell& shell, const glm::dvec3& ground) {
  double most = 0;
  const double radius = kPuff_mm * shell.scene.chart.size;
  for (const glm::dvec3& puff : shell.puffs) {
    const glm::dvec3 arm = (ground - puff) / radius;
    most = std::max(most, 1 - glm::dot(arm, arm));
  }
  return std::sqrt(most);
}

// What hair hangs on at a place, distance from the axis: beside the face it comes in to the cheek, before the
// ears.
double compute_drawn_ground_mm(const DrawnShell& shell, const HairPlace& place) {
  constexpr double kIn_mm = 22, kOver_mm = 4;                    // toward the cheek; over it
  constexpr double kBehind_deg = 26, kHigh = 0.85, kLow = 1.15;  // over so much it goes out to cover the ear
  const HairScene& scene = shell.scene;
  const double ground = compute_ground_mm(scene, place);
  if (!shell.fall.is_there) return ground;
  const double in =
      (1 - smooth_step(shell.fall.to_deg, shell.fall.to_deg + kBehind_deg, std::abs(place.azimuth_deg))) *
      smooth_step(kHigh, kLow, place.way);
  const double skin = sample_hair_chart(scene.chart, scene.chart.skin_mm, place);
  const double least = std::min(ground, skin + kOver_mm * scene.chart.size);
  return std::max(least, ground - in * kIn_mm * scene.chart.size);
}

// How far a lock stands out over where it parts from those beside it, and how far its tip turns out.
double compute_swell_mm(const DrawnShell& shell, const DrawnEdge& edge, const HairPlace& place) {
  constexpr double kRound_mm = 3.2, kRises = 0.25;
  if (edge.deep_mm <= 0 || !shell.puffs.empty()) return 0;
  const double share = smooth_step(kRises, 1, place.way / edge.way);
  return compute_drawn_size(shell.scene) * kRound_mm * share * (1 - edge.across * edge.across);
}

// Distance from the axis of the outside.
double compute_outer_mm(const DrawnShell& shell, const DrawnEdge& edge, const HairPlace& place) {
  // Its edge: on the skin, or over what it hangs on. Sunk in the skin, it would be as ragged as skin is.
  constexpr double kOn_mm = 0.9, kLifted_mm = 1.6;
  const HairScene& scene = shell.scene;
  const double size = compute_drawn_size(scene), round_mm = scene.cut.round_mm * scene.chart.size;
  const double left_mm = std::max(0.0, edge.way - place.way) * scene.chart.drop_mm;
  const double share = std::min(1.0, left_mm / round_mm);
  const double full = std::sqrt(1 - (1 - share) * (1 - share));
  const double rim_mm = size * std::lerp(kOn_mm, kLifted_mm, edge.lifts);
  constexpr double kFlat = 0.2;  // between curls, of how thick they are
  const double ground = compute_drawn_ground_mm(shell, place);
  double thick_mm = compute_mass_height_mm(scene, place) + compute_swell_mm(shell, edge, place);
  if (!shell.puffs.empty())
    thick_mm *= std::lerp(kFlat, 1.0, compute_puff(shell, compute_hair_point(scene.chart, place, ground)));
  return ground + rim_mm + full * (thick_mm - rim_mm);
}

double compute_inner_mm(const HairScene& scene, const HairPlace& place, double outer_mm, bool is_edge) {
  constexpr double kDeep_mm = 3.5;  // in the skin: no light comes through a gap
  constexpr double kSolid_mm = 60, kThin = 0.1;
  const double free = scene.cut.covers_ears ? smooth_step(0.9, 1.15, place.way) : 0;
  const double sheet = compute_drawn_size(scene) * scene.cut.sheet_mm * (is_edge ? kThin : 1);
  const double skin = sample_hair_chart(scene.chart, scene.chart.skin_mm, place) - kDeep_mm;
  return std::min(outer_mm - 0.5, std::max(skin, outer_mm - std::lerp(kSolid_mm, sheet, free)));
}

void append_drawn_vertex(HeadPart& part, const HairScene& scene, const HairPlace& place, double out_mm) {
  const auto index = static_cast<std::uint32_t>(part.part.rest.positions.size());
  const HairSeat& seat = find_seat(scene, place);
  part.part.rest.positions.emplace_back(compute_hair_point(scene.chart, place, out_mm));
  part.bindings.push_back({seat.triangle, seat.barycentric, index, 1});
}

// How far up a place of the hair looks, -1..1: more over the forehead, less at the sides, so that what is as
// high all round bows over the one and falls to the others.
double compute_up(const DrawnShell& shell, const HairPlace& place) {
  constexpr double kBows = 0.07;
  const HairScene& scene = shell.scene;
  const glm::dvec3 broadest = scene.chart.centre + glm::dvec3(0, scene.cut.centre_mm * scene.chart.size, 0);
  const glm::dvec3 way = glm::normalize(
      compute_hair_point(scene.chart, place, compute_drawn_ground_mm(shell, place)) - broadest);
  return way.y + kBows * (way.x * way.x - way.z * way.z) / std::max(1e-9, 1 - way.y * way.y);
}

void append_drawn_shell(HeadPart& part, const HairScene& scene) {
  DrawnShell shell{scene, trace_drawn_edge(scene), find_fall(scene), 0, {}, list_puffs(scene)};
  constexpr double kLevel = 0.9;  // of the highest place where locks part
  shell.level = 1e9;
  for (const DrawnEdge& edge : shell.edge) shell.level = std::min(shell.level, kLevel * edge.way);
  shell.light =
      trace_light(scene, shell.edge, [&](const HairPlace& place) { return compute_up(shell, place); });
  const int columns = static_cast<int>(shell.edge.size());
  const auto first_outer = static_cast<std::uint32_t>(part.part.rest.positions.size());
  const double top_mm = compute_outer_mm(shell, shell.edge.front(), {0, 0});
  append_drawn_vertex(part, scene, {0, 0}, top_mm);
  for (std::size_t column = 0; column < shell.edge.size(); ++column)
    for (int row = 1; row <= kDrawnRows; ++row) {
      const HairPlace place = find_drawn_place(shell, column, row);
      append_drawn_vertex(part, scene, place, compute_outer_mm(shell, shell.edge[column], place));
    }
  const auto first_inner = static_cast<std::uint32_t>(part.part.rest.positions.size());
  append_drawn_vertex(part, scene, {0, 0}, compute_inner_mm(scene, {0, 0}, top_mm, false));
  for (const DrawnEdge& edge : shell.edge)
    for (int row = 1; row <= kDrawnInnerRows; ++row) {
      const HairPlace place = bend_place(shell, edge, edge.way * row / kDrawnInnerRows);
      append_drawn_vertex(
          part, scene, place,
          compute_inner_mm(scene, place, compute_outer_mm(shell, edge, place), row == kDrawnInnerRows));
    }
  sew_shell(part.part.rest.triangles, {first_outer, kDrawnRows}, {first_inner, kDrawnInnerRows}, columns);
  const auto is_light = [&](std::uint32_t v) {
    if (v <= first_outer || v >= first_inner) return false;
    const std::uint32_t at = v - first_outer - 1, row = at % kDrawnRows + 1;
    return shell.light[at / kDrawnRows].is_there && (row == kLightRow || row == kLightRow + 1);
  };
  for (const Triangle& t : part.part.rest.triangles)
    part.part.triangle_shade.push_back(is_light(t[0]) && is_light(t[1]) && is_light(t[2]) ? 1 : 0);
}

// A ring about a way: `up` and `aside` are unit and across it.
Ring make_drawn_ring(const glm::dvec3& centre, const glm::dvec3& aside, const glm::dvec3& up,
                     double radius_mm) {
  constexpr int kSides = 20;
  Ring ring;
  for (int k = 0; k < kSides; ++k) {
    const double turn = 2 * std::numbers::pi * k / kSides;
    ring.emplace_back(centre + radius_mm * (std::sin(turn) * aside + std::cos(turn) * up));
  }
  return ring;
}

void append_drawn_body(HeadPart& part, const HairScene& scene, const std::vector<Ring>& rings,
                       const glm::dvec3& start, const glm::dvec3& end, const glm::dvec3& knot) {
  const std::size_t first = part.part.rest.positions.size();
  append_loft(part.part.rest, glm::vec3(start), rings, glm::vec3(end));
  const HairSeat& seat = find_seat(scene, compute_hair_place(scene.chart, knot));
  part.bindings.push_back({seat.triangle, seat.barycentric, static_cast<std::uint32_t>(first),
                           static_cast<std::uint32_t>(part.part.rest.positions.size() - first)});
}

// A ball on the knot.
void append_drawn_bun(HeadPart& part, const HairScene& scene) {
  constexpr int kRings = 14;
  constexpr double kOut = 0.6, kFlat = 0.8;  // of its radius
  const double radius = scene.cut.bun_radius_mm * scene.chart.size;
  glm::dvec3 at, out;
  compute_knot(scene, at, out);
  const glm::dvec3 centre = at + kOut * radius * out, up(0, -out.z, out.y), aside(1, 0, 0);
  std::vector<Ring> rings;
  for (int i = 1; i < kRings; ++i) {
    const double angle = std::numbers::pi * (1 - static_cast<double>(i) / kRings);
    rings.push_back(make_drawn_ring(centre + kFlat * radius * std::cos(angle) * out, aside, up,
                                    radius * std::sin(angle)));
  }
  append_drawn_body(part, scene, rings, centre - kFlat * radius * out, centre + kFlat * radius * out, at);
}

// A tail that hangs from the knot: locks beside each other, each of which runs out in a point.
void append_drawn_tail(HeadPart& part, const HairScene& scene) {
  struct TailLock {
    double aside, back, broad, length;  // of its radius; of its length
  };
  constexpr std::array<TailLock, 3> kLocks{
      {{0, 0, 0.86, 1}, {0.62, 0.15, 0.6, 0.8}, {-0.7, -0.1, 0.52, 0.66}}};
  constexpr int kRings = 22;
  constexpr double kBegins = 0.45, kFull = 0.4, kRunsOut = 2.0;  // of its radius; of its length; a power
  const HairTail& tail = scene.cut.tail;
  const double size = scene.chart.size;
  glm::dvec3 at, out;
  compute_knot(scene, at, out);
  const glm::dvec3 aside(1, 0, 0);
  for (const TailLock& lock : kLocks) {
    const TailLine line{at, out, tail.out_mm * size, lock.length * tail.length_mm * size};
    const auto find = [&](double s) {
      const double spread = tail.radius_mm * size * smooth_step(0, 0.8, s);
      return line.at(s) + spread * glm::dvec3(lock.aside, 0, -lock.back);
    };
    std::vector<Ring> rings;
    for (int i = 0; i < kRings; ++i) {
      const double s = static_cast<double>(i) / kRings;
      const glm::dvec3 along = glm::normalize(find(s + 0.01) - find(s - 0.01));
      const double radius = lock.broad * (kBegins + (1 - kBegins) * smooth_step(0, kFull, s)) *
                            (1 - std::pow(s, kRunsOut)) * tail.radius_mm * size;
      const glm::dvec3 across = glm::normalize(aside - glm::dot(aside, along) * along);
      rings.push_back(make_drawn_ring(find(s), across, glm::normalize(glm::cross(across, along)), radius));
    }
    append_drawn_body(part, scene, rings, find(-0.01), find(1), at);
  }
}

// A lock by itself, flat, along a curve.
void append_stray(HeadPart& part, const HairScene& scene, const std::vector<glm::vec3>& way,
                  const glm::dvec3& out, double broad_mm, double flat) {
  constexpr int kRings = 10;
  constexpr double kBegins = 0.7, kFull = 0.3;
  const auto last = static_cast<double>(way.size() - 1);
  std::vector<Ring> rings;
  for (int i = 0; i < kRings; ++i) {
    const double s = static_cast<double>(i) / kRings;
    const glm::dvec3 along = glm::normalize(glm::dvec3(sample_curve(way, (s + 0.01) * last)) -
                                            glm::dvec3(sample_curve(way, (s - 0.01) * last)));
    const glm::dvec3 across = glm::normalize(glm::cross(out, along)), up = glm::cross(across, along);
    const double broad = 0.5 * broad_mm * (kBegins + (1 - kBegins) * smooth_step(0, kFull, s)) * (1 - s * s);
    Ring ring = make_drawn_ring(glm::dvec3(0), across, up * flat, broad);
    for (glm::vec3& p : ring) p += sample_curve(way, s * last);
    rings.push_back(std::move(ring));
  }
  append_drawn_body(part, scene, rings, glm::dvec3(sample_curve(way, -0.02 * last)), glm::dvec3(way.back()),
                    glm::dvec3(way.front()));
}

// A stray: where it begins, on the adult how long and broad it is, and how far it bends: along a direction of
// `turn_deg` from the front, or toward the middle of the face.
struct DrawnStray {
  double azimuth_deg = 0, way = 0, length_mm = 0, broad_mm = 0, bent = 0, turn_deg = 0;
};
constexpr int kStrayPlaces = 7;

// Before an ear, down the cheek.
void append_temple_stray(HeadPart& part, const HairScene& scene, const DrawnStray& stray) {
  constexpr double kOff_mm = 3.5, kBegins = 0.3, kBent_deg = 9, kFlat = 0.45;
  const double size = compute_drawn_size(scene);
  const double from = stray.way * sample_border(scene.hairline, stray.azimuth_deg);
  std::vector<glm::vec3> way;
  glm::dvec3 out(0);
  for (int i = 0; i < kStrayPlaces; ++i) {
    const double s = static_cast<double>(i) / (kStrayPlaces - 1);
    const double bent_deg = std::copysign(kBent_deg * stray.bent * s * s, stray.azimuth_deg);
    const HairPlace here{stray.azimuth_deg - bent_deg,
                         from + s * stray.length_mm * size / scene.chart.drop_mm};
    way.emplace_back(compute_hair_point(scene.chart, here,
                                        compute_ground_mm(scene, here) + size * kOff_mm * (kBegins + s)));
    out += compute_hair_direction(scene.chart, here);
  }
  append_stray(part, scene, way, glm::normalize(out), stray.broad_mm * size, kFlat);
}

// Off the crown, in an arc.
void append_crown_stray(HeadPart& part, const HairScene& scene, const DrawnStray& stray) {
  constexpr double kSunk_mm = 5, kRises = 0.85, kFalls = 0.4, kUp = 0.1, kFlat = 0.4;
  const double size = compute_drawn_size(scene), turn = stray.turn_deg * kRadiansPerDegree;
  const HairPlace place{stray.azimuth_deg, stray.way};
  const glm::dvec3 out = compute_hair_direction(scene.chart, place);
  const glm::dvec3 base = compute_hair_point(
      scene.chart, place,
      compute_ground_mm(scene, place) + compute_mass_height_mm(scene, place) - kSunk_mm * size);
  const glm::dvec3 aside = glm::normalize(glm::dvec3(std::sin(turn), kUp, std::cos(turn)));
  std::vector<glm::vec3> way;
  for (int i = 0; i < kStrayPlaces; ++i) {
    const double s = static_cast<double>(i) / (kStrayPlaces - 1);
    way.emplace_back(base + stray.length_mm * size *
                                ((kRises * s - kFalls * s * s) * out + stray.bent * s * s * aside));
  }
  append_stray(part, scene, way, glm::normalize(glm::cross(aside, glm::cross(out, aside))),
               stray.broad_mm * size, kFlat);
}

// Two that stand off at the crown; of gathered hair, one before each ear. Curls are life enough.
void append_drawn_strays(HeadPart& part, const HairScene& scene) {
  constexpr std::array<DrawnStray, 2> kCrown{{{-170, 0.1, 30, 15, 1.25, 60}, {160, 0.16, 22, 11, 1.2, 150}}};
  constexpr std::array<DrawnStray, 2> kTemples{{{57, 0.93, 58, 9, 0.5}, {-61, 0.95, 44, 7, 0.6}}};
  if (scene.cut.locks.curl_mm > 0) return;
  if (has_part(scene) && !scene.cut.covers_ears) return;  // hair that is combed
  if (scene.cut.comb.is_gathered)
    for (const DrawnStray& stray : kTemples) append_temple_stray(part, scene, stray);
  else
    for (const DrawnStray& stray : kCrown) append_crown_stray(part, scene, stray);
}

}  // namespace

std::array<std::uint32_t, 2> find_drawn_rim(std::size_t column, std::size_t columns) {
  const std::size_t outer = (column + 1) * kDrawnRows,  // behind the top's
      first_inner = columns * kDrawnRows + 1;
  return {static_cast<std::uint32_t>(outer),
          static_cast<std::uint32_t>(first_inner + (column + 1) * kDrawnInnerRows)};
}

std::vector<std::uint32_t> list_drawn_column(std::size_t column) {
  std::vector<std::uint32_t> vertices;
  for (int row = kDrawnRows; row > kLevelRows; --row)
    vertices.push_back(static_cast<std::uint32_t>(column) * kDrawnRows + static_cast<std::uint32_t>(row));
  return vertices;
}

void append_drawn_mass(HeadPart& part, const HairScene& scene) {
  append_drawn_shell(part, scene);
  if (scene.cut.bun_radius_mm > 0) append_drawn_bun(part, scene);
  if (scene.cut.tail.radius_mm > 0) append_drawn_tail(part, scene);
  append_drawn_strays(part, scene);
  part.part.triangle_shade.resize(part.part.rest.triangles.size(), 0);
}

}  // namespace mien

#include "head/hair_drawn.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/conventions.hpp"
#include "core/smooth.hpp"
#include "head/hair_edge.hpp"
#include "head/hair_locks.hpp"
#include "head/hair_mass.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

struct DrawnShell {
  const HairScene& scene;
  std::vector<DrawnEdge> edge;  // one a column
  Fall fall;
  double level = 0;                    // the way above which all columns' rows lie at the same ways
  std::vector<glm::dvec3> puffs = {};  // curls: points of the ground
};

constexpr int kLevelRows = 17, kEndRows = 13, kDrawnRows = kLevelRows + kEndRows;
constexpr int kDrawnInnerRows = 8;  // of the inside, which nobody sees

// A lock is bent from where it is free, and most at its tip.
HairPlace bend_place(const DrawnShell& shell, const DrawnEdge& edge, double way) {
  constexpr double kFree_mm = 40;  // of the adult
  const double free = kFree_mm * shell.scene.chart.size / shell.scene.chart.drop_mm;
  const double share = std::clamp(1 - (edge.way - way) / free, 0.0, 1.0);
  return {wrap_azimuth(edge.turn_deg + edge.bent_deg * share * share), way};
}

HairPlace find_drawn_place(const DrawnShell& shell, const DrawnEdge& edge, int row) {
  const double share = static_cast<double>(row - kLevelRows) / kEndRows;
  return bend_place(
      shell, edge,
      row <= kLevelRows ? shell.level * row / kLevelRows : std::lerp(shell.level, edge.way, share));
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
  double thick_mm = compute_mass_height_mm(scene, place);
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

void append_drawn_shell(HeadPart& part, const HairScene& scene) {
  DrawnShell shell{scene, trace_drawn_edge(scene), find_fall(scene), 0, list_puffs(scene)};
  constexpr double kLevel = 0.9;  // of the highest place where locks part
  shell.level = 1e9;
  for (const DrawnEdge& edge : shell.edge) shell.level = std::min(shell.level, kLevel * edge.way);
  const int columns = static_cast<int>(shell.edge.size());
  const auto first_outer = static_cast<std::uint32_t>(part.part.rest.positions.size());
  const double top_mm = compute_outer_mm(shell, shell.edge.front(), {0, 0});
  append_drawn_vertex(part, scene, {0, 0}, top_mm);
  for (const DrawnEdge& edge : shell.edge)
    for (int row = 1; row <= kDrawnRows; ++row) {
      const HairPlace place = find_drawn_place(shell, edge, row);
      append_drawn_vertex(part, scene, place, compute_outer_mm(shell, edge, place));
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

// A tail that hangs from the knot and runs out in one point.
void append_drawn_tail(HeadPart& part, const HairScene& scene) {
  constexpr int kRings = 26;
  constexpr double kBegins = 0.45, kFull = 0.35, kRunsOut = 2.4;  // of its radius; of its length; a power
  const HairTail& tail = scene.cut.tail;
  const double size = scene.chart.size;
  glm::dvec3 at, out;
  compute_knot(scene, at, out);
  const TailLine line{at, out, tail.out_mm * size, tail.length_mm * size};
  std::vector<Ring> rings;
  const glm::dvec3 aside(1, 0, 0);
  for (int i = 0; i < kRings; ++i) {
    const double s = static_cast<double>(i) / kRings;
    const glm::dvec3 along = glm::normalize(line.at(s + 0.01) - line.at(s - 0.01));
    const double radius = (kBegins + (1 - kBegins) * smooth_step(0, kFull, s)) * (1 - std::pow(s, kRunsOut)) *
                          tail.radius_mm * size;
    rings.push_back(make_drawn_ring(line.at(s), aside, glm::normalize(glm::cross(aside, along)), radius));
  }
  append_drawn_body(part, scene, rings, line.at(-0.01), line.at(1), at);
}

}  // namespace

void append_drawn_mass(HeadPart& part, const HairScene& scene) {
  append_drawn_shell(part, scene);
  if (scene.cut.bun_radius_mm > 0) append_drawn_bun(part, scene);
  if (scene.cut.tail.radius_mm > 0) append_drawn_tail(part, scene);
}

}  // namespace mien

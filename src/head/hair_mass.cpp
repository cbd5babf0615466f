#include "head/hair_mass.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/smooth.hpp"
#include "head/hair_comb.hpp"
#include "head/hair_flow.hpp"
#include "head/hair_locks.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr int kColumns = 120, kRows = 30;  // of the outside: 4 mm and 6 mm apart where it is broadest
constexpr int kInnerRows = 8;              // of the inside, which nobody sees
constexpr double kPi = std::numbers::pi;

// Columns come in pairs: c and its mirror image kColumns - 1 - c.
double compute_azimuth(int column) { return 360 * (column + 0.5) / kColumns - 180; }

struct Shell {
  const HairScene& scene;
  std::vector<double> border;    // by column
  std::vector<double> even;      // the same without tips
  std::vector<double> hangs;     // 0: it ends in the skin at the hairline .. 1: it hangs free
  std::vector<glm::dvec3> edge;  // where that is
};

HairPlace find_place(const Shell& shell, int column, double along) {
  return {compute_azimuth(column), along * shell.border[static_cast<std::size_t>(column)]};
}

// How full the mass is at a distance from its edge: a quarter of a round where it hangs, a slope where it
// grows.
double compute_fullness(const Shell& shell, int column, const glm::dvec3& at) {
  constexpr int kReach = 20;  // columns to either side; the edge is nowhere nearer
  double nearest = 1e9;
  for (int i = -kReach; i <= kReach; ++i) {
    const glm::dvec3 away = shell.edge[static_cast<std::size_t>((column + i + kColumns) % kColumns)] - at;
    nearest = std::min(nearest, glm::dot(away, away));
  }
  const double round_mm = shell.scene.cut.round_mm * shell.scene.chart.size;
  const double share = std::min(1.0, std::sqrt(nearest) / round_mm);
  const double hangs = shell.hangs[static_cast<std::size_t>(column)];
  return std::lerp(smooth_step(0, 1, share), std::sqrt(1 - (1 - share) * (1 - share)), hangs);
}

// Of thicknesses against the adult's.
double compute_hair_size(const HairScene& scene) {
  return scene.chart.size * (1 - (1 - scene.cut.infant) * scene.youth);
}

// The grain of the mass at a place: strands as they are combed there.
glm::dvec2 compute_mass_grain(const HairScene& scene, const HairPlace& place) {
  constexpr double kWhole_mm = 260;  // of the adult: a strand's length when it comes to its tip's colour
  const HairFlow flow = compute_hair_flow(scene, place);
  return {flow.across_mm, 100 * std::min(1.0, flow.along_mm / (kWhole_mm * scene.chart.size))};
}

// The grain where the mass hangs free, `share` 1, and ends after so many mm: over the last of them it ends
// strand by strand (materials.inc), and nowhere else. Rows are farther apart than that, so the one before the
// last lies as far below that grain as it is away.
glm::dvec2 end_in_strands(glm::dvec2 grain, double left_mm, double share) {
  constexpr double kHem_mm = 13, kWhole = 84, kLeast = 30;
  grain.y = std::min(grain.y, kWhole);
  const double near = 100 - (100 - kWhole) * left_mm / kHem_mm;
  if (near > kLeast) grain.y = std::lerp(grain.y, near, share);
  return grain;
}

void append_vertex(HeadPart& part, const HairScene& scene, const HairPlace& place, const glm::dvec3& at,
                   const glm::dvec2& grain) {
  const auto index = static_cast<std::uint32_t>(part.part.rest.positions.size());
  const HairSeat& seat = find_seat(scene, place);
  part.part.rest.positions.emplace_back(at);
  part.part.grain.emplace_back(grain);
  part.bindings.push_back({seat.triangle, seat.barycentric, index, 1});
}

glm::dvec3 mirror(const glm::dvec3& p) { return {-p.x, p.y, p.z}; }

// Where it hangs it ends in tips of its own, each as broad as a column or two and none as long as its
// neighbour, or its edge is a level one that shows from inside and between the locks.
void fray(Shell& shell, const HairBorder& border) {
  constexpr std::uint32_t kSeries = 47;
  constexpr double kDeep = 2.2;                // of how much tips differ
  constexpr double kHigh = 0.05, kLow = 0.35;  // ways below the hairline: there it begins, here it is whole
  const HairScene& scene = shell.scene;
  for (int column = 0; column < kColumns; ++column) {
    const double azimuth = std::abs(compute_azimuth(column));
    const double below = sample_border(border, azimuth) - sample_border(scene.hairline, azimuth);
    const int left = std::max(column, kColumns - 1 - column);
    const double deep_mm = kDeep * scene.cut.locks.tips_mm * smooth_step(kHigh, kLow, below) *
                           (1 - compute_open(scene, {azimuth, 1})) *
                           sample_noise(kSeries, 1.3 * left, 2 * kColumns);
    shell.border[static_cast<std::size_t>(column)] -= deep_mm * scene.chart.size / scene.chart.drop_mm;
  }
}

// How far the shell's edge runs down at a column, mm from the one before it to the one after it.
double measure_fall_mm(const Shell& shell, int column) {
  const auto find_border = [&](int other) {
    return shell.even[static_cast<std::size_t>((other + kColumns) % kColumns)];
  };
  return std::abs(find_border(column + 1) - find_border(column - 1)) * shell.scene.chart.drop_mm;
}

// The grain across along the edge: that of the steepest place for all of a stretch that runs down, as strands
// do there.
std::vector<double> find_rim_grain(const Shell& shell) {
  constexpr int kReach = 6;  // columns to either side
  std::vector<double> rims;
  for (int column = 0; column < kColumns; ++column) {
    int steepest = column;
    for (int other = column - kReach; other <= column + kReach; ++other)
      if (measure_fall_mm(shell, other) > measure_fall_mm(shell, steepest)) steepest = other;
    rims.push_back(compute_mass_grain(shell.scene, find_place(shell, (steepest + kColumns) % kColumns, 1)).x);
  }
  return rims;
}

// Where the mass ends, column by column, and where it hangs there; `is_free`: it may hang at all. Its edge
// lies so far inside the border of hair, above and beside, that locks hide it.
void find_borders(Shell& shell, bool is_free) {
  const HairScene& scene = shell.scene;
  const HairCut& cut = scene.cut;
  const double way_mm = scene.chart.size / scene.chart.drop_mm;  // in ways
  constexpr double kInset_mm = 7, kBeside_deg = 9;
  for (int column = 0; column < kColumns; ++column) {
    // Where it hangs, tips of locks make the edge; where it grows, it runs out in the skin.
    constexpr double kTips = 1.4;  // of how much tips differ
    constexpr double kHigh = 0.05,
                     kLow = 0.35;  // of a way below the hairline: there tips begin, here all are
    const HairBorder& border = is_free ? scene.ends : scene.hairline;
    const double azimuth = std::abs(compute_azimuth(column));
    const double below = sample_border(border, azimuth) - sample_border(scene.hairline, azimuth);
    // Behind the ears nothing falls over the bare strip that an inset leaves.
    constexpr double kEar_deg = 78, kBehind_deg = 105;
    const double own_mm =
        is_free ? cut.inset_mm : cut.inset_mm * (1 - smooth_step(kEar_deg, kBehind_deg, azimuth));
    const double inset_mm =
        std::lerp(own_mm, kInset_mm + kTips * cut.locks.tips_mm, smooth_step(kHigh, kLow, below));
    const double open = compute_open(scene, {azimuth, 1});
    shell.hangs.push_back(is_free ? (1 - open) * sample_border(scene.hangs, azimuth) : 0);
    double least = 1e9;
    // Hair that is combed from a part is combed out of the face.
    constexpr double kCombed_deg = 20,
                     kCombedFringe_deg = 11;  // less, and it stands beside the face as a board
    const double combed_deg = std::lerp(kCombed_deg, kCombedFringe_deg, sample_border(scene.hangs, 0));
    const double beside_deg =
        (cut.locks.from_part > 0 ? combed_deg : kBeside_deg) * (1 + 0.5 * smooth_step(kLow, 2 * kLow, below));
    for (const double beside : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      double near = std::abs(compute_azimuth(column) + beside * beside_deg);
      if (near > 180) near = 360 - near;
      least = std::min(least, sample_border(border, near));
    }
    // Over an open forehead it ends where hair grows, and steps back where hair begins to fall: only locks
    // reach farther.
    constexpr double kInside_mm = 1, kBack_mm = 18, kForehead_deg = 37, kTemple_deg = 50;
    const double inside_mm =
        std::lerp(kInside_mm, kBack_mm, smooth_step(kForehead_deg, kTemple_deg, azimuth));
    shell.border.push_back(std::lerp(least - inset_mm * way_mm,
                                     sample_border(scene.hairline, azimuth) - inside_mm * way_mm, open));
  }
  // Where it turns from the forehead down beside the face, it has no corner.
  constexpr int kRounds = 6;
  for (int round = 0; cut.locks.from_part > 0 && round < kRounds; ++round) {
    const std::vector<double> before = shell.border;
    for (std::size_t i = 0; i < before.size(); ++i)
      shell.border[i] =
          std::min(before[i], 0.5 * before[i] + 0.25 * (before[(i + 1) % before.size()] +
                                                        before[(i + before.size() - 1) % before.size()]));
  }
}

void append_shell(HeadPart& part, const HairScene& scene) {
  const HairCut& cut = scene.cut;
  const HairChart& chart = scene.chart;
  Shell shell{scene, {}, {}, {}, {}};
  const bool is_free = !scene.ends.empty() && cut.covers_ears;
  find_borders(shell, is_free);
  shell.even = shell.border;
  fray(shell, is_free ? scene.ends : scene.hairline);
  for (int column = 0; column < kColumns; ++column) {
    const HairPlace place = find_place(shell, column, 1);
    shell.edge.push_back(compute_hair_point(chart, place, compute_ground_mm(scene, place)));
  }
  const double size = compute_hair_size(scene);
  std::vector<std::vector<double>> outer(kColumns);  // distance, column by column
  const auto first_outer = static_cast<std::uint32_t>(part.part.rest.positions.size());
  const double top_mm = compute_ground_mm(scene, {0, 0}) + compute_mass_height_mm(scene, {0, 0});
  append_vertex(part, scene, {0, 0}, compute_hair_point(chart, {0, 0}, top_mm),
                compute_mass_grain(scene, {0, 0}));
  std::vector<std::vector<glm::dvec3>> points(kColumns);
  // Both halves have one form, but for a part at a side.
  const bool is_even = cut.comb.side_mm == 0 || cut.comb.scalp_mm <= 0;
  for (int column = is_even ? kColumns / 2 : 0; column < kColumns; ++column)
    for (int row = 1; row <= kRows; ++row) {
      const HairPlace place = find_place(shell, column, static_cast<double>(row) / kRows);
      const double ground = compute_ground_mm(scene, place);
      const double full = compute_fullness(shell, column, compute_hair_point(chart, place, ground));
      constexpr double kSunk = -0.5;  // mm: an edge in the skin
      const double edge = std::lerp(kSunk, cut.edge_mm, shell.hangs[static_cast<std::size_t>(column)]);
      const double distance =
          ground + size * edge + full * (compute_mass_height_mm(scene, place) - size * edge);
      const auto at = static_cast<std::size_t>(column),
                 other = static_cast<std::size_t>(kColumns - 1 - column);
      outer[at].push_back(distance);
      points[at].push_back(compute_hair_point(chart, place, distance));
      if (!is_even) continue;
      outer[other].push_back(distance);
      points[other].push_back(mirror(points[at].back()));
    }
  constexpr double kLevel_mm = 6, kSteep_mm = 14;
  constexpr double kStrands = 3;  // they lie that much closer there than over the mass
  const std::vector<double> rims = find_rim_grain(shell);
  const auto compute_grain = [&](int column, int row, int rows, glm::dvec2 grain) {
    const auto at = static_cast<std::size_t>(column);
    const double rim = rims[at] + (rows == kInnerRows ? kStrands * cut.sheet_mm : 0);
    if (row == rows)
      grain.x = std::lerp(grain.x, rim, smooth_step(kLevel_mm, kSteep_mm, measure_fall_mm(shell, column)));
    const double left_mm = shell.border[at] * (1 - static_cast<double>(row) / rows) * chart.drop_mm;
    return end_in_strands(grain, left_mm, smooth_step(0.05, 0.4, shell.hangs[at]));
  };
  for (int column = 0; column < kColumns; ++column)
    for (int row = 1; row <= kRows; ++row) {
      const HairPlace place = find_place(shell, column, static_cast<double>(row) / kRows);
      append_vertex(part, scene, place,
                    points[static_cast<std::size_t>(column)][static_cast<std::size_t>(row - 1)],
                    compute_grain(column, row, kRows, compute_mass_grain(scene, place)));
    }
  const auto first_inner = static_cast<std::uint32_t>(part.part.rest.positions.size());
  constexpr double kSunk_mm = 3.5;  // the inside lies so deep in the skin: no light comes through a gap
  const double inner_top_mm = compute_ground_mm(scene, {0, 0}) - kSunk_mm;
  append_vertex(part, scene, {0, 0}, compute_hair_point(chart, {0, 0}, inner_top_mm), {0, 0});
  for (int column = 0; column < kColumns; ++column)
    for (int row = 1; row <= kInnerRows; ++row) {
      const int left = std::max(column, kColumns - 1 - column);
      const HairPlace place = find_place(shell, left, static_cast<double>(row) / kInnerRows);
      const auto at = static_cast<std::size_t>(row * kRows / kInnerRows - 1);
      const double free = cut.covers_ears ? smooth_step(0.9, 1.15, place.way) : 0;
      const double sheet = glm::mix(60.0, size * cut.sheet_mm * (row == kInnerRows ? 0.45 : 1), free);
      const double skin = sample_hair_chart(chart, chart.skin_mm, place) - kSunk_mm;
      const double out = std::min(outer[static_cast<std::size_t>(left)][at],
                                  outer[static_cast<std::size_t>(kColumns - 1 - left)][at]);
      const glm::dvec3 p = compute_hair_point(chart, place, std::min(out - 0.5, std::max(skin, out - sheet)));
      append_vertex(part, scene, find_place(shell, column, static_cast<double>(row) / kInnerRows),
                    left == column ? p : mirror(p),
                    compute_grain(column, row, kInnerRows, {4.0 * column, 100.0 * row / kInnerRows}));
    }
  sew_shell(part.part.rest.triangles, {first_outer, kRows}, {first_inner, kInnerRows}, kColumns);
}

// A round body about the knot's axis: `rings` of it from the skin outward.
void append_round(HeadPart& part, const HairScene& scene, const std::vector<Ring>& rings,
                  const glm::vec3& start, const glm::vec3& end, const HairPlace& place) {
  const std::size_t first = part.part.rest.positions.size();
  append_loft(part.part.rest, start, rings, end);
  const std::size_t last = part.part.rest.positions.size();
  const HairSeat& seat = find_seat(scene, place);
  for (std::size_t i = first; i < last; ++i)
    part.part.grain.emplace_back(static_cast<float>(i % 7) * 3.0f, 30.0f);
  part.bindings.push_back({seat.triangle, seat.barycentric, static_cast<std::uint32_t>(first),
                           static_cast<std::uint32_t>(last - first)});
}

constexpr int kSides = 24;  // of a round body

// Left and right to the bit: the left half's points, and their images.
Ring make_ring(const glm::dvec3& centre, const glm::dvec3& up, double across_mm, double up_mm) {
  Ring ring(kSides);
  for (int k = 0; k <= kSides / 2; ++k) {
    const double turn = 2 * kPi * k / kSides;
    const double x = k == 0 || k == kSides / 2 ? 0 : across_mm * std::sin(turn);
    const glm::dvec3 p = centre + up * (up_mm * std::cos(turn));
    ring[static_cast<std::size_t>(k)] = glm::vec3(x, p.y, p.z);
    if (k > 0 && k < kSides / 2) ring[static_cast<std::size_t>(kSides - k)] = glm::vec3(-x, p.y, p.z);
  }
  return ring;
}

void append_knot(HeadPart& part, const HairScene& scene) {
  constexpr int kRings = 12;
  const double radius = 0.97 * scene.cut.bun_radius_mm * scene.chart.size;
  glm::dvec3 at, out;
  compute_knot(scene, at, out);
  const glm::dvec3 centre = at + out * 0.6 * radius, up(0, -out.z, out.y);
  std::vector<Ring> rings;
  for (int i = 1; i < kRings; ++i) {
    const double angle = kPi * (1 - static_cast<double>(i) / kRings);
    const double wide = radius * std::sin(angle);
    rings.push_back(make_ring(centre + out * (0.8 * radius * std::cos(angle)), up, wide, wide));
  }
  append_round(part, scene, rings, centre - 0.8 * radius * out, centre + 0.8 * radius * out,
               compute_hair_place(scene.chart, at));
}

}  // namespace

double compute_mass_height_mm(const HairScene& scene, const HairPlace& place) {
  const HairCut& cut = scene.cut;
  // Locks come up beside the part, not in it: it would be a notch in the outline.
  constexpr double kAtPart = 0.85, kWide_mm = 15;
  const double from_part =
      smooth_step(0, kWide_mm * scene.chart.size, compute_part_distance_mm(scene, place));
  const double share = cut.covers_ears && !cut.is_drawn
                           ? std::lerp(std::max(cut.mass, kAtPart), cut.mass, from_part)
                           : cut.mass;
  double height = share * compute_part_depth(scene, place) * compute_thickness_mm(scene, place);
  constexpr double kDrawn = 1.6;  // of a wave: an outline has nothing else to tell it by
  if (cut.locks.wave_mm > 0)
    height += 0.5 * (cut.is_drawn ? kDrawn : 1) * cut.locks.wave_mm * smooth_step(0.1, 0.5, place.way) *
              compute_wave_room(scene, place) * (1 + std::cos(2 * kPi * compute_wave(scene, place)));
  return compute_hair_size(scene) * height;
}

void sew_shell(std::vector<Triangle>& triangles, const ShellSide& outer, const ShellSide& inner,
               int columns) {
  const auto vertex = [&](const ShellSide& side, int column, int row) {
    return row == 0 ? side.first
                    : side.first + 1 + static_cast<std::uint32_t>((column % columns) * side.rows + row - 1);
  };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) triangles.push_back({a, b, c});
  };
  for (int column = 0; column < columns; ++column) {
    for (int row = 0; row < outer.rows; ++row) {
      const auto at = [&](int c, int r) { return vertex(outer, column + c, row + r); };
      add(at(0, 0), at(0, 1), at(1, 1));
      add(at(0, 0), at(1, 1), at(1, 0));
    }
    for (int row = 0; row < inner.rows; ++row) {
      const auto at = [&](int c, int r) { return vertex(inner, column + c, row + r); };
      add(at(0, 0), at(1, 1), at(0, 1));
      add(at(0, 0), at(1, 0), at(1, 1));
    }
    const std::uint32_t a = vertex(outer, column, outer.rows), b = vertex(outer, column + 1, outer.rows),
                        c = vertex(inner, column + 1, inner.rows), d = vertex(inner, column, inner.rows);
    add(a, d, c);
    add(a, c, b);
  }
}

void append_mass(HeadPart& part, const HairScene& scene) {
  append_shell(part, scene);
  if (scene.cut.bun_radius_mm > 0) append_knot(part, scene);
}

}  // namespace mien

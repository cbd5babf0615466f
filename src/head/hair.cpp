// Hair in masses first, then locks, then hints of strands (Bammes, "Complete Guide to Life Drawing", 1991;
// Loomis, "Drawing the Head and Hands", 1956).
#include "head/hair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/data.hpp"
#include "core/error.hpp"
#include "head/cage.hpp"
#include "head/hair_locks.hpp"
#include "head/lids.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr int kColumns = 360, kRows = 64;  // of the outside: 1.5 mm and 2.5 mm apart where it is broadest
constexpr int kInnerRows = 10;             // of the inside, which nobody sees
constexpr int kShades = 12;
constexpr double kPi = std::numbers::pi;

struct Strands {
  const HairCut& cut;
  HairChart chart;
  std::vector<double> border;    // way of the hairline, by column
  std::vector<glm::dvec3> edge;  // where that is, by column
  double youth = 0;              // 1: an infant's
};

// The hairline's way at each column: a smooth curve through the knots of the left half and its mirror image.
std::vector<double> find_border(const NeutralHead& head, const HairCut& cut, const HairChart& chart) {
  std::vector<double> azimuths, ways;
  for (const HairKnot& knot : cut.hairline) {
    glm::dvec3 p(find_named_point(head, knot.point));
    if (!knot.level_of.empty()) p.y = find_named_point(head, knot.level_of).y;
    p.y += knot.up_mm * chart.size;
    const HairPlace place = find_hair_place(chart, p);
    azimuths.push_back(std::abs(place.azimuth_deg));
    ways.push_back(place.way);
  }
  for (std::size_t i = 1; i < azimuths.size(); ++i)
    azimuths[i] = std::max(azimuths[i], azimuths[i - 1] + 0.5);
  std::vector<double> border;
  for (int column = 0; column < kColumns; ++column) {
    const double turn = (column + 0.5) / kColumns;
    const LockPlace lock = find_lock(cut, turn);
    const double tip = (round_ridge(lock.across) - 0.6) * (0.5 + find_tip_share(lock)) +
                       0.35 * (round_ridge(lock.split) - 0.6);
    border.push_back(sample_stations(azimuths, ways, std::abs(360 * turn - 180)) +
                     tip * cut.tips_mm * chart.size / chart.drop_mm);
  }
  return border;
}

HairPlace find_place(const Strands& strands, int column, double along) {
  const HairCut& cut = strands.cut;
  const double turn = (column + 0.5) / kColumns, rest = 1 - along;
  const double wave = std::sin(kPi * along) * std::sin(2 * kPi * (3 * turn + 0.8 * along));
  double azimuth = 360 * turn - 180 + cut.swirl_deg * rest * rest + cut.wave_deg * wave;
  azimuth -= 360 * std::floor((azimuth + 180) / 360);
  return {azimuth, along * strands.border[static_cast<std::size_t>(column)]};
}

// How full the mass is at a distance from its edge: a quarter of a round.
double find_fullness(const Strands& strands, int column, const glm::dvec3& at) {
  constexpr int kReach = 60;  // columns to either side; the edge is nowhere nearer
  double nearest = 1e9;
  for (int i = -kReach; i <= kReach; ++i) {
    const glm::dvec3 away = strands.edge[static_cast<std::size_t>((column + i + kColumns) % kColumns)] - at;
    nearest = std::min(nearest, glm::dot(away, away));
  }
  const double share = std::min(1.0, std::sqrt(nearest) / (strands.cut.round_mm * strands.chart.size));
  return std::sqrt(1 - (1 - share) * (1 - share));
}

// What the mass lies on, by rows of one column: the skin, or what hangs over the ears.
std::vector<double> find_ground(const Strands& strands, int column) {
  std::vector<double> ground;
  for (int row = 0; row <= kRows; ++row) {
    const HairPlace place = find_place(strands, column, static_cast<double>(row) / kRows);
    double value = sample_hair_chart(
        strands.chart, strands.cut.covers_ears ? strands.chart.cover_mm : strands.chart.skin_mm, place);
    const double down = std::max(0.0, place.way - 1);
    if (strands.cut.covers_ears) value *= 1 - strands.cut.tuck * down * down;
    ground.push_back(value);
  }
  return ground;
}

std::vector<Shade> make_palette(const glm::vec3& colour) {
  std::vector<Shade> palette;
  for (int i = 0; i < kShades; ++i) {
    const float light = static_cast<float>(i) / (kShades - 1);
    const glm::vec3 shade = colour * (0.50f + 0.95f * light) + glm::vec3(0.035f, 0.022f, 0.012f) * light;
    palette.push_back({glm::clamp(shade, 0.0f, 1.0f), 0.15f + 0.35f * light});
  }
  return palette;
}

void append_vertex(HeadPart& part, const Strands& strands, const HairPlace& place, const glm::dvec3& at,
                   double light) {
  const auto index = static_cast<std::uint32_t>(part.part.rest.positions.size());
  // What hangs free rides with the broadest place above it, not with cheek and neck.
  const HairPlace seat_at{place.azimuth_deg, strands.cut.covers_ears ? std::min(place.way, 0.9) : place.way};
  const HairSeat& seat = find_hair_seat(strands.chart, seat_at);
  part.part.rest.positions.emplace_back(at);
  part.part.shade.push_back(
      static_cast<std::uint16_t>(std::lround(std::clamp(light, 0.0, 1.0) * (kShades - 1))));
  part.bindings.push_back({seat.triangle, seat.barycentric, index, 1});
}

// Outside and inside as two domes of columns and rows from the whorl to the hairline, joined at their edges.
void append_mass(HeadPart& part, Strands& strands) {
  const HairCut& cut = strands.cut;
  const HairChart& chart = strands.chart;
  std::vector<std::vector<double>> grounds;
  for (int column = 0; column < kColumns; ++column) {
    grounds.push_back(find_ground(strands, column));
    strands.edge.push_back(find_hair_point(chart, find_place(strands, column, 1), grounds.back().back()));
  }
  const double size = chart.size * (1 - (1 - cut.infant) * strands.youth);
  std::vector<double> outer;  // distance, column by column
  const auto first_outer = static_cast<std::uint32_t>(part.part.rest.positions.size());
  const double top_mm = grounds[0][0] + size * cut.side_mm[0];
  append_vertex(part, strands, {0, 0}, find_hair_point(chart, {0, 0}, top_mm), 0.5);
  for (int column = 0; column < kColumns; ++column)
    for (int row = 1; row <= kRows; ++row) {
      const double along = static_cast<double>(row) / kRows;
      const HairPlace place = find_place(strands, column, along);
      const double ground = grounds[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)];
      const double full = find_fullness(strands, column, find_hair_point(chart, place, ground));
      const double thick = find_thickness_mm(cut, place, along);
      const Carving carving = carve(cut, (column + 0.5) / kColumns, place);
      const double height =
          cut.edge_mm + full * (thick - cut.edge_mm) + (0.25 + 0.75 * full) * carving.height_mm;
      outer.push_back(ground + size * std::max(height, 0.5 * cut.edge_mm));
      append_vertex(part, strands, place, find_hair_point(chart, place, outer.back()), carving.light);
    }
  const auto first_inner = static_cast<std::uint32_t>(part.part.rest.positions.size());
  constexpr double kSunk_mm = 2.5;  // the inside lies so deep in the skin: no light comes through a gap
  append_vertex(part, strands, {0, 0}, find_hair_point(chart, {0, 0}, grounds[0][0] - kSunk_mm), 0);
  for (int column = 0; column < kColumns; ++column)
    for (int row = 1; row <= kInnerRows; ++row) {
      const HairPlace place = find_place(strands, column, static_cast<double>(row) / kInnerRows);
      const auto at = static_cast<std::size_t>(column * kRows + row * kRows / kInnerRows - 1);
      const double free = cut.covers_ears ? smooth_step(0.9, 1.15, place.way) : 0;
      const double sheet = glm::mix(60.0, size * cut.sheet_mm * (row == kInnerRows ? 0.45 : 1), free);
      const double skin = sample_hair_chart(chart, chart.skin_mm, place) - kSunk_mm;
      append_vertex(part, strands, place, find_hair_point(chart, place, std::max(skin, outer[at] - sheet)),
                    0);
    }
  const auto vertex = [&](std::uint32_t first, int rows, int column, int row) {
    return row == 0 ? first : first + 1 + static_cast<std::uint32_t>((column % kColumns) * rows + row - 1);
  };
  auto& triangles = part.part.rest.triangles;
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) triangles.push_back({a, b, c});
  };
  for (int column = 0; column < kColumns; ++column) {
    for (int row = 0; row < kRows; ++row) {
      const auto at = [&](int c, int r) { return vertex(first_outer, kRows, column + c, row + r); };
      add(at(0, 0), at(0, 1), at(1, 1));
      add(at(0, 0), at(1, 1), at(1, 0));
    }
    for (int row = 0; row < kInnerRows; ++row) {
      const auto at = [&](int c, int r) { return vertex(first_inner, kInnerRows, column + c, row + r); };
      add(at(0, 0), at(1, 1), at(0, 1));
      add(at(0, 0), at(1, 0), at(1, 1));
    }
    const std::uint32_t a = vertex(first_outer, kRows, column, kRows);
    const std::uint32_t b = vertex(first_outer, kRows, column + 1, kRows);
    const std::uint32_t c = vertex(first_inner, kInnerRows, column + 1, kInnerRows);
    const std::uint32_t d = vertex(first_inner, kInnerRows, column, kInnerRows);
    add(a, d, c);
    add(a, c, b);
  }
}

// A knot of twisted locks on the whorl.
void append_bun(HeadPart& part, const Strands& strands) {
  constexpr int kSpokes = 96, kRings = 36, kTwists = 9;
  const HairChart& chart = strands.chart;
  const double radius = strands.cut.bun_radius_mm * chart.size;
  const double skin = sample_hair_chart(chart, chart.skin_mm, {180, 0});
  const glm::dvec3 out = chart.whorl, aside(1, 0, 0), up = glm::cross(out, aside);
  const glm::dvec3 centre = chart.centre + out * (skin + 0.62 * radius);
  const auto first = static_cast<std::uint32_t>(part.part.rest.positions.size());
  const auto add = [&](double angle, double turn) {
    const double coil = turn * kTwists + 2.2 * angle / kPi;  // locks wind round as they go out
    const double across = 2 * (coil - std::floor(coil)) - 1, ridge = round_ridge(across);
    const double fade = std::sin(angle);
    const double r = radius * (1 + fade * 0.085 * (ridge - 0.6));
    const glm::dvec3 p = out * (0.82 * std::cos(angle)) +
                         std::sin(angle) * (std::cos(2 * kPi * turn) * aside + std::sin(2 * kPi * turn) * up);
    append_vertex(part, strands, {180, 0}, centre + r * p, 0.25 + 0.5 * ridge);
  };
  add(0, 0);
  for (int ring = 1; ring < kRings; ++ring)
    for (int spoke = 0; spoke < kSpokes; ++spoke)
      add(kPi * ring / kRings, static_cast<double>(spoke) / kSpokes);
  add(kPi, 0);
  const auto vertex = [&](int ring, int spoke) {
    return first + 1 + static_cast<std::uint32_t>((ring - 1) * kSpokes + spoke % kSpokes);
  };
  const std::uint32_t last = vertex(kRings - 1, kSpokes - 1) + 1;
  auto& triangles = part.part.rest.triangles;
  for (int spoke = 0; spoke < kSpokes; ++spoke) {
    triangles.push_back({first, vertex(1, spoke), vertex(1, spoke + 1)});
    for (int ring = 1; ring + 1 < kRings; ++ring) {
      triangles.push_back({vertex(ring, spoke), vertex(ring + 1, spoke), vertex(ring + 1, spoke + 1)});
      triangles.push_back({vertex(ring, spoke), vertex(ring + 1, spoke + 1), vertex(ring, spoke + 1)});
    }
    triangles.push_back({vertex(kRings - 1, spoke), last, vertex(kRings - 1, spoke + 1)});
  }
}

}  // namespace

std::vector<HeadPart> build_hair(const NeutralHead& head, const std::string& cut, const Look& look) {
  if (cut == "none") return {};
  const auto cuts = load_hair_cuts(find_data_folder() / "templates/head/hair.yaml");
  const auto found = cuts.find(cut);
  if (found == cuts.end()) throw RunError(fmt::format("templates/head/hair.yaml has no cut '{}'", cut));
  Strands strands{
      found->second, build_hair_chart(head, found->second.whorl_deg, found->second.centre_mm), {}, {}, 0};
  strands.border = find_border(head, strands.cut, strands.chart);
  constexpr double kInfant_mm = 66, kGrown_mm = 84;  // eye to chin
  strands.youth = 1 - smooth_step(kInfant_mm, kGrown_mm, find_eye_to_chin_mm(head));

  HeadPart part;
  part.part.name = "hair";
  part.part.material = "tress";
  part.part.is_printed = false;  // busts stay bald: their union does not bear locks that touch each other
  part.part.palette = make_palette(look.hair);
  part.mount = Mount::strands;
  append_mass(part, strands);
  if (strands.cut.bun_radius_mm > 0) append_bun(part, strands);
  update_normals(part.part.rest);
  std::vector<HeadPart> parts;
  parts.push_back(std::move(part));
  return parts;
}

}  // namespace mien

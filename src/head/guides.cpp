#include "head/guides.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "config/words.hpp"
#include "core/error.hpp"
#include "head/cage.hpp"
#include "head/neighbours.hpp"
#include "head/organs.hpp"
#include "head/shapes.hpp"

namespace mien {

namespace {

// Two lines, or a line and an end, keep this much of the head's height between them: below it features would
// be squeezed flat.
constexpr double kNearest = 0.01;
constexpr double kLeastEar = 0.1;  // of the head's height: half of the smallest ear there is

// The forehead's mid-line from the brows to the crown.
constexpr std::array kForehead{"p_g", "p_F1", "p_F2", "p_F3", "p_F4", "cap_0_1", "cap_0_2", "cap_0_3"};

// Places of a shape on the skin.
struct SkinRuler {
  const Cage& cage;
  const HeadForm& shape;
  std::vector<PointRing> rings;

  glm::dvec3 place_of(std::uint32_t point) const { return compute_limit(rings[point], point, shape.points); }
  double height_of(std::uint32_t point) const { return place_of(point).y; }
  double height_of(std::string_view name) const { return height_of(find_point(cage, name)); }

  // The lowest (x) and highest (y) of the points with a prefix; all of them if it is empty.
  glm::dvec2 range_of(std::string_view prefix) const {
    glm::dvec2 range(std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest());
    for (std::uint32_t i = 0; i < cage.points.size(); ++i) {
      if (!cage.names[i].starts_with(prefix) || rings[i].is_boundary) continue;
      const double y = height_of(i);
      range = {std::min(range.x, y), std::max(range.y, y)};
    }
    return range;
  }
};

// The crown lies between points of the mid-line: the top of the parabola through the highest and the two
// beside it.
double compute_crown(const SkinRuler& ruler) {
  constexpr std::array kCrown{"cap_0_1", "cap_0_2", "cap_0_3", "cap_0_4", "cap_0_5", "s9_F4"};
  std::array<glm::dvec3, kCrown.size()> line;
  for (std::size_t i = 0; i < line.size(); ++i) line[i] = ruler.place_of(find_point(ruler.cage, kCrown[i]));
  std::size_t top = 1;
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    if (line[i].y > line[top].y) top = i;
  const double ahead = line[top - 1].z - line[top].z, behind = line[top + 1].z - line[top].z;
  const double rise_ahead = (line[top - 1].y - line[top].y) / ahead;
  const double rise_behind = (line[top + 1].y - line[top].y) / behind;
  const double bend = (rise_ahead - rise_behind) / (ahead - behind);
  const double slope = rise_ahead - bend * ahead;
  return line[top].y + (bend < 0 ? slope * slope / (-4 * bend) : 0);
}

glm::dvec2 find_height(const SkinRuler& ruler) { return {ruler.height_of("m12_D1"), compute_crown(ruler)}; }

double compute_hairline_height(const SkinRuler& ruler) {
  const HairlineMark mark = compute_hairline(ruler.cage, ruler.shape.hairline);
  return glm::mix(ruler.height_of(mark.below), ruler.height_of(mark.above), mark.share);
}

// The place of the mark that lies at a height, mm; the nearest end of the mid-line if none does.
double place_hairline(const SkinRuler& ruler, double height_mm) {
  for (std::size_t i = 0; i + 1 < kForehead.size(); ++i) {
    const double below = ruler.height_of(kForehead[i]), above = ruler.height_of(kForehead[i + 1]);
    if (height_mm < above)
      return static_cast<double>(i) + std::max(0.0, (height_mm - below) / (above - below));
  }
  return kForehead.size() - 1;
}

GuideLines measure_lines(const SkinRuler& ruler) {
  const glm::dvec2 ends = find_height(ruler), ear = ruler.range_of("er");
  GuideLines lines{{"hairline", compute_hairline_height(ruler)},
                   {"brow_line", ruler.height_of("p_g")},
                   {"eye_line", ruler.shape.eye.centre.y},
                   {"nose_base", ruler.height_of("M6_0")},
                   {"mouth_line", (ruler.height_of("M1_0") + ruler.height_of("M1_12")) / 2},
                   {"ear_top", ear.y},
                   {"ear_base", ear.x}};
  for (auto& [name, height] : lines) height = (height - ends.x) / (ends.y - ends.x);
  return lines;
}

// Makes the ears, as they came out of the warp, end at these heights (mm): sized and shifted as wholes.
void fit_ears(const Cage& cage, const glm::dvec2& wanted, HeadForm& shape) {
  const glm::dvec2 now = SkinRuler{cage, shape, compute_rings(cage)}.range_of("er");
  const double size = (wanted.y - wanted.x) / (now.y - now.x);
  // About the ear's root, so that it grows outward from the head and not into it.
  const glm::dvec3 root =
      (shape.points[find_point(cage, "s4_L9")] + shape.points[find_point(cage, "s4_C1")]) / 2.0;
  const auto move = [&](const glm::dvec3& p) {
    const glm::dvec3 grown = root + size * (p - root);
    return glm::dvec3(grown.x, wanted.x + size * (p.y - now.x), grown.z);
  };
  move_shares(
      cage, [](std::string_view name) { return compute_ear_share(name, kGrownEar); }, move, shape);
}

// Throws InputError unless the lines keep their order and their distance.
void check_lines(const GuideLines& lines) {
  double below = 0;
  for (const std::string& line : kGuides) {
    if (lines.at(line) <= below + kNearest)
      throw InputError(
          fmt::format("guide line '{}' meets the one below it; expected the order mouth_line, nose_base, "
                      "eye_line, brow_line, hairline from chin to crown on this head",
                      line));
    below = lines.at(line);
  }
  if (below >= 1 - kNearest) throw InputError("guide line 'hairline' meets the crown; expected it below");
  if (lines.at("ear_top") <= lines.at("ear_base") + kLeastEar)
    throw InputError(
        "guide line 'ear_top' comes too near to 'ear_base'; expected an ear a tenth of the head high");
}

// Moves all lines to where they are wanted, chin and crown staying.
void warp_lines(const Cage& cage, const GuideLines& wanted, HeadForm& shape) {
  const SkinRuler ruler{cage, shape, compute_rings(cage)};
  const glm::dvec2 ends = find_height(ruler);
  const double height = ends.y - ends.x;
  const GuideLines now = measure_lines(ruler);
  std::vector<glm::dvec2> knots{{ends.x - height, ends.x - height}, {ends.x, ends.x}};
  for (const std::string& line : kGuides)
    knots.emplace_back(ends.x + height * now.at(line), ends.x + height * wanted.at(line));
  knots.emplace_back(ends.y, ends.y);
  Warp warp;
  warp.height = build_monotone_curve(std::move(knots));
  Cage now_cage = cage;
  now_cage.points = shape.points;
  const HeadForm moved = apply_warp(now_cage, shape.eye, warp);
  shape.points = moved.points;
  shape.eye = moved.eye;
  fit_ears(cage, {ends.x + height * wanted.at("ear_base"), ends.x + height * wanted.at("ear_top")}, shape);
}

}  // namespace

HairlineMark compute_hairline(const Cage& cage, double hairline) {
  const double last = kForehead.size() - 2;
  const double below = std::clamp(std::floor(hairline), 0.0, last);
  const auto i = static_cast<std::size_t>(below);
  return {find_point(cage, kForehead[i]), find_point(cage, kForehead[i + 1]), hairline - below};
}

glm::dvec2 find_height(const Cage& cage, const HeadForm& shape) {
  return find_height(SkinRuler{cage, shape, compute_rings(cage)});
}

GuideLines measure_guides(const Cage& cage, const HeadForm& shape) {
  return measure_lines(SkinRuler{cage, shape, compute_rings(cage)});
}

GuideChart measure_chart(const Cage& cage, const HeadForm& shape) {
  const SkinRuler ruler{cage, shape, compute_rings(cage)};
  const glm::dvec2 ends = find_height(ruler);
  return {ends.y - ends.x, measure_lines(ruler)};
}

void move_guides(const Cage& cage, const GuideLines& wanted, HeadForm& shape, const GuideLines& shares) {
  if (wanted.empty()) return;
  GuideLines lines = measure_guides(cage, shape);
  for (const auto& [line, height] : wanted) {
    const auto share = shares.find(line);
    lines[line] = share == shares.end() ? height : std::lerp(lines[line], height, share->second);
  }
  check_lines(lines);
  // Control points moved by a curve do not carry the skin along it quite: the second and third round take up
  // what the one before left, a hundredth of the move.
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) warp_lines(cage, lines, shape);
}

void fit_chart(const Cage& cage, const GuideChart& chart, HeadForm& shape) {
  const double eye_y_mm = shape.eye.centre.y;
  const glm::dvec2 ends = find_height(cage, shape);
  const double size = chart.height_mm / (ends.y - ends.x);
  for (glm::dvec3& point : shape.points) point *= size;
  shape.eye.centre *= size;
  shape.eye.radius_mm *= size;
  GuideLines lines = chart.lines;
  lines.erase("hairline");
  move_guides(cage, lines, shape);
  const SkinRuler ruler{cage, shape, compute_rings(cage)};
  const glm::dvec2 now = find_height(ruler);
  shape.hairline = place_hairline(ruler, glm::mix(now.x, now.y, chart.lines.at("hairline")));
  const double rise_mm = eye_y_mm - shape.eye.centre.y;
  for (glm::dvec3& point : shape.points) point.y += rise_mm;
  shape.eye.centre.y += rise_mm;
}

}  // namespace mien

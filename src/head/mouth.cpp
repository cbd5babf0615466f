// Teeth, gums and tongue. The rows are suggested, not drawn tooth by tooth (Loomis, "Drawing the Head and
// Hands", 1956): one smooth band with hints of the gaps, a scalloped gum, and the lips' own curve, which is
// flatter than a dental arch, so that the far teeth still show in a smile. Widths of teeth: Wheeler, "Dental
// Anatomy".
#include <algorithm>
#include <cmath>
#include <numbers>

#include "head/binding.hpp"
#include "head/head.hpp"
#include "head/lids.hpp"
#include "head/part_numbers.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr double kLowerWidth = 0.80;  // of lower teeth against the upper ones beside them
constexpr double kBareHalf_mm = 16,
                 kBareHeight_mm = 4.5;  // of what the lips bare, from the middle of their line

double square(double value) { return value * value; }

// Where the rows stand: fitted to the lips of one head.
struct Arch {
  const MouthNumbers& numbers;
  double scale = 1;       // of this mouth against the adult's
  double lips_y_mm = 0;   // the line between the lips
  double front_z_mm = 0;  // of the upper row's front
  double curve = 0.021;   // 1/mm: of the lips, z = front - curve x^2
  double growth = 1;      // of the teeth out of the gums: 0 none yet
};

double find_arch_depth(const Arch& arch, double x) {
  const double beyond = std::max(0.0, x - arch.scale * arch.numbers.bend_from_mm);
  return arch.curve * x * x + arch.numbers.bend / (arch.scale * arch.scale) * beyond * beyond * beyond;
}

// One cut through the row, x >= 0: where it is on the arch, which way is out, and where in its tooth.
struct Column {
  glm::vec2 at{0};      // x, z behind the front (negative)
  glm::vec2 out{0, 1};  // unit, in the same plane
  double share = 0;     // 0 middle of the face, 1 the row's end
  double gap = 0;       // 1 between two teeth, 0 from a fifth of a tooth on
  double rise_mm = 0;   // of this tooth's biting edge
  double belly = 0;     // 1 in the middle of a tooth, 0 between teeth
};

struct ArchPoint {
  double x = 0, length_mm = 0;
};

std::vector<ArchPoint> measure_arch(const Arch& arch, double half_mm) {
  constexpr int kSteps = 160;
  std::vector<ArchPoint> points{{0, 0}};
  for (int i = 1; i <= kSteps; ++i) {
    const double x = arch.scale * half_mm * i / kSteps;
    const double run = x - points.back().x,
                 fall = find_arch_depth(arch, x) - find_arch_depth(arch, points.back().x);
    points.push_back({x, points.back().length_mm + std::hypot(run, fall)});
  }
  return points;
}

double find_arch_x(const std::vector<ArchPoint>& points, double length_mm) {
  std::size_t next = 1;
  while (next + 1 < points.size() && points[next].length_mm < length_mm) ++next;
  const ArchPoint &a = points[next - 1], &b = points[next];
  return a.x + (b.x - a.x) * (length_mm - a.length_mm) / (b.length_mm - a.length_mm);
}

// Cuts from the middle outward, closer together beside the gaps. `width` scales the teeth: lower ones are
// narrower.
std::vector<Column> build_columns(const Arch& arch, double half_mm, double width) {
  static constexpr std::array kCuts{0.0, 0.05, 0.14, 0.3, 0.5, 0.7, 0.86, 0.95};
  const std::vector<ArchPoint> points = measure_arch(arch, half_mm);
  const double end_mm = points.back().length_mm;
  const auto& widths = arch.numbers.widths_mm;
  const auto& rises = arch.numbers.rise_mm;
  std::vector<Column> columns;
  double from_mm = 0;
  for (std::size_t tooth = 0; from_mm < end_mm; ++tooth) {
    const std::size_t kind = std::min(tooth, widths.size() - 1);
    const double width_mm = widths[kind] * width * arch.scale;
    for (const double cut : kCuts) {
      const double length_mm = from_mm + cut * width_mm;
      if (length_mm > end_mm) break;
      const double x = find_arch_x(points, length_mm), step = 0.05;
      const double slope = (find_arch_depth(arch, x + step) - find_arch_depth(arch, x - step)) / (2 * step);
      Column column;
      column.at = glm::vec2(x, -find_arch_depth(arch, x));
      column.out = glm::normalize(glm::vec2(x > 0 ? slope : 0.0, 1));
      column.share = length_mm / end_mm;
      const double side = std::min(cut, 1 - cut);
      const double plain = 1 - smooth_step(0.4, 0.75, column.share);  // far teeth are one band
      column.gap = plain * (1 - smooth_step(0, 0.2, side));
      column.belly = plain * smooth_step(0, 0.5, side);
      const std::size_t other = cut < 0.5 ? (kind > 0 ? kind - 1 : 0) : std::min(kind + 1, widths.size() - 1);
      const double near = 0.5 * (1 - smooth_step(0, 0.3, side));
      column.rise_mm = arch.scale * ((1 - near) * rises[kind] + near * rises[other]);
      columns.push_back(column);
    }
    from_mm += width_mm;
  }
  return columns;
}

// A row or a gum: its numbers, and +1 for the upper one, which grows downward, -1 for the lower one.
struct Row {
  const TeethRowNumbers& numbers;
  int sign = 1;
};

// The point of a cut `height_mm` above the lips' line (below it in the lower row), `out_mm` in front of the
// arch.
glm::vec3 place_in_row(const Arch& arch, const Row& row, const Column& column, double height_mm,
                       double out_mm) {
  const glm::vec2 flat =
      column.at + column.out * static_cast<float>(out_mm - arch.scale * row.numbers.inset_mm);
  return {flat.x, arch.lips_y_mm + row.sign * height_mm, arch.front_z_mm + flat.y};
}

// How far the row's front lies behind the arch at a height: it leans back toward the gum.
double find_lean_mm(const Arch& arch, const Row& row, double height_mm) {
  const TeethRowNumbers& teeth = row.numbers;
  const double share =
      std::max(0.0, (height_mm / arch.scale + teeth.edge_mm) / (teeth.gum_mm + teeth.edge_mm));
  return arch.scale * teeth.lean_mm * share * share;
}

constexpr int kTeethSides = 11, kHeightShades = 4, kDepthShades = 7, kGapShades = 3;

std::uint16_t find_tooth_shade(const Column& column, double crown) {
  const auto height = std::lround(std::clamp(crown, 0.0, 1.0) * (kHeightShades - 1));
  const auto depth = std::lround(smooth_step(0.3, 0.9, column.share) * (kDepthShades - 1));
  const auto gap = std::lround(column.gap * (kGapShades - 1));
  return static_cast<std::uint16_t>((height * kDepthShades + depth) * kGapShades + gap);
}

// Warm off-white: clearer at the edge, yellower at the gum, in the cheeks' shade further back.
std::vector<Shade> make_teeth_palette() {
  const glm::vec3 edge(0.955f, 0.915f, 0.84f), gum(0.94f, 0.85f, 0.71f), cheek(0.16f, 0.08f, 0.07f);
  std::vector<Shade> palette;
  for (int height = 0; height < kHeightShades; ++height)
    for (int depth = 0; depth < kDepthShades; ++depth)
      for (int gap = 0; gap < kGapShades; ++gap) {
        const float far = 0.8f * static_cast<float>(depth) / (kDepthShades - 1);
        const float dim = 1 - 0.07f * static_cast<float>(gap) / (kGapShades - 1);
        const glm::vec3 enamel = glm::mix(edge, gum, static_cast<float>(height) / (kHeightShades - 1)) * dim;
        palette.push_back({glm::mix(enamel, cheek, far), 0.5f});
      }
  return palette;
}

// One cut of the teeth: down the front, round the edge, up the back. Counter-clockwise about +x in the upper
// row.
Ring build_tooth_ring(const Arch& arch, const Row& row, const Column& column,
                      std::vector<std::uint16_t>& shades) {
  const MouthNumbers& mouth = arch.numbers;
  const double gum = arch.scale * row.numbers.gum_mm;
  const double rise = column.rise_mm * (row.sign > 0 ? 1 : 0.35);  // lower edges are nearly level
  const double full_edge = -arch.scale * (row.numbers.edge_mm - mouth.notch_mm * column.gap) + rise;
  const double hidden_edge = gum + 1.5 * arch.scale;  // mm: inside the gum
  const double edge = hidden_edge + (full_edge - hidden_edge) * arch.growth;
  const double back = smooth_step(0.25, 0.75, column.share);  // 0 a cutting edge, 1 a grinding one
  const double thick_gum = arch.scale * (row.numbers.thick_mm + 3.5 * back),
               thick_edge = arch.scale * (1.1 + 4.5 * back);
  const double groove = arch.scale * (mouth.groove_mm * column.gap - 0.12 * column.belly);

  static constexpr std::array kFront{1.35, 1.0, 0.8, 0.55, 0.3, 0.12, 0.02};
  static constexpr std::array kBack{0.03, 0.3, 0.7, 1.35};
  Ring ring;
  const double top = gum + 3.2 * arch.scale;
  const auto add = [&](double crown, double behind_mm) {
    const double height = edge + (top - edge) * crown / kFront.front();
    const double rolled =
        0.6 * arch.scale * std::pow(std::max(0.0, 1 - crown), 4);  // back at the biting edge
    ring.push_back(
        place_in_row(arch, row, column, height, -find_lean_mm(arch, row, height) - rolled - behind_mm));
    shades.push_back(find_tooth_shade(column, crown));
  };
  const double root = 0.9 * arch.scale;  // further back than the crown: it must not come through the gum
  for (const double crown : kFront) add(crown, groove + (crown > 1 ? root : 0));
  for (const double crown : kBack) add(crown, thick_edge + (thick_gum - thick_edge) * std::min(1.0, crown));
  return ring;
}

constexpr int kGumSides = 8, kGumShades = 5;

// One cut of the gum: a roll that ends thin on the teeth, lower between them.
Ring build_gum_ring(const Arch& arch, const Row& row, const Column& column,
                    std::vector<std::uint16_t>& shades) {
  const MouthNumbers& mouth = arch.numbers;
  const double scale = arch.scale, gum = scale * row.numbers.gum_mm, thick = scale * mouth.gum_thick_mm;
  const double ridge = 2.5 * (1 - arch.growth);  // mm: toothless gums meet lower
  const double margin = gum - scale * (mouth.scallop_mm * column.gap * arch.growth + ridge),
               top = gum + 4.5 * scale;
  const double back = smooth_step(0.25, 0.75, column.share);
  const double deep = scale * (row.numbers.thick_mm + 3.5 * back);
  const auto front_at = [&](double height) { return -find_lean_mm(arch, row, height); };

  Ring ring;
  const auto add = [&](double height, double out_mm, double dark) {
    ring.push_back(place_in_row(arch, row, column, height, out_mm));
    const double shade = std::clamp(dark + 0.6 * smooth_step(0.2, 1, column.share), 0.0, 1.0);
    shades.push_back(static_cast<std::uint16_t>(std::lround(shade * (kGumShades - 1))));
  };
  add(top, front_at(top) - 0.5 * scale, 0.5);
  add(gum + 2.0 * scale, front_at(gum + 2.0 * scale) + 1.1 * thick, 0.2);
  add(margin + 0.7 * scale, front_at(margin + 0.7 * scale) + thick * (0.8 + 0.3 * column.gap), 0);
  add(margin, front_at(margin) + 0.12 * scale, 0);
  add(margin + 0.1 * scale, front_at(margin) - 0.8 * scale, 0);
  add(margin + 0.1 * scale, front_at(margin) - deep + 0.6 * scale, 0.6);
  add(margin + 1.5 * scale, front_at(margin) - deep - 1.2 * scale, 0.7);
  add(top, front_at(top) - deep - 1.0 * scale, 0.8);
  return ring;
}

std::vector<Shade> make_gum_palette() {
  const glm::vec3 pink(0.77f, 0.47f, 0.45f), dark(0.42f, 0.19f, 0.19f);
  std::vector<Shade> palette;
  for (int i = 0; i < kGumShades; ++i)
    palette.push_back({glm::mix(pink, dark, static_cast<float>(i) / (kGumShades - 1)), 0.6f});
  return palette;
}

Ring mirror_ring(Ring ring) {
  for (glm::vec3& p : ring) p.x = -p.x;
  return ring;
}

glm::vec3 find_middle(const Ring& ring) {
  glm::vec3 sum(0);
  for (const glm::vec3& p : ring) sum += p;
  return sum / static_cast<float>(ring.size());
}

// The row's far end is round: cuts draw together over its last tenth.
void round_off(Ring& ring, double share) {
  const double beyond = std::clamp((share - 0.9) / 0.1, 0.0, 0.99);
  const glm::vec3 middle = find_middle(ring);
  for (glm::vec3& p : ring) p = middle + (p - middle) * static_cast<float>(std::sqrt(1 - square(beyond)));
}

// The whole row from cuts of its left half: the right half is its mirror image, bit for bit.
template <typename BuildRing>
HeadPart build_band(const Arch& arch, const Row& row, const std::vector<Column>& columns,
                    BuildRing build_ring) {
  HeadPart part;
  std::vector<Ring> left, rings;
  std::vector<std::vector<std::uint16_t>> left_shades;
  for (const Column& column : columns) {
    left_shades.emplace_back();
    left.push_back(build_ring(arch, row, column, left_shades.back()));
    round_off(left.back(), column.share);
    if (row.sign < 0) {  // upside down, so the other way round
      std::reverse(left.back().begin(), left.back().end());
      std::reverse(left_shades.back().begin(), left_shades.back().end());
    }
  }
  const auto take = [&](std::size_t column, bool is_mirrored) {
    rings.push_back(is_mirrored ? mirror_ring(left[column]) : left[column]);
    part.part.shade.insert(part.part.shade.end(), left_shades[column].begin(), left_shades[column].end());
  };
  part.part.shade.push_back(left_shades.back().front());
  for (std::size_t i = left.size() - 1; i > 0; --i) take(i, true);
  for (std::size_t i = 0; i < left.size(); ++i) take(i, false);
  part.part.shade.push_back(left_shades.back().front());

  const glm::vec3 end = find_middle(left.back());
  append_loft(part.part.rest, {-end.x, end.y, end.z}, rings, end);
  update_normals(part.part.rest);
  part.mount = row.sign > 0 ? Mount::skull : Mount::jaw;
  part.part.is_rigid = true;
  return part;
}

HeadPart build_teeth(const Arch& arch, const Row& row, const std::vector<Column>& columns) {
  HeadPart part = build_band(arch, row, columns, build_tooth_ring);
  part.part.name = row.sign > 0 ? "teeth_upper" : "teeth_lower";
  part.part.material = "teeth";
  part.part.palette = make_teeth_palette();
  return part;
}

HeadPart build_gum(const Arch& arch, const Row& row, const std::vector<Column>& columns) {
  HeadPart part = build_band(arch, row, columns, build_gum_ring);
  part.part.name = row.sign > 0 ? "gum_upper" : "gum_lower";
  part.part.material = "gum";
  part.part.palette = make_gum_palette();
  return part;
}

// A low dome from the throat to behind the lower teeth, with a shallow groove along its middle.
HeadPart build_tongue(const Arch& arch) {
  const TongueNumbers& tongue = arch.numbers.tongue;
  const double scale = arch.scale;
  const double tip_z = arch.front_z_mm - scale * (arch.numbers.lower.inset_mm + tongue.tip_mm);
  const double top_y = arch.lips_y_mm - scale * tongue.top_mm, low_y = top_y - 7.0 * scale;
  constexpr int kTongueShades = 8, kRings = 16,
                kHalf = 10;  // points of half a ring, from the top to the bottom
  HeadPart part;
  std::vector<Ring> rings;
  const std::size_t sides = 2 * kHalf - 2;
  part.part.shade.push_back(kTongueShades - 1);
  for (int r = 0; r < kRings; ++r) {
    const double way = static_cast<double>(r) / (kRings - 1),
                 from_tip_mm = (1 - way) * (1 - way) * tongue.back_mm + 0.3;
    const double round = std::sqrt(1 - std::exp(-from_tip_mm / 4.5));
    const double z = tip_z - scale * from_tip_mm, half = scale * tongue.half_mm * round;
    const double dome = top_y + scale * (1.8 * smooth_step(0, 18, from_tip_mm) - 2.6 * (1 - round));
    Ring ring;
    for (int k = 0; k < kHalf; ++k) {
      const double turn = std::numbers::pi * k / (kHalf - 1), side = std::sin(turn), up = std::cos(turn);
      const double groove = 0.8 * scale * std::exp(-square(3.2 * side)) * std::max(0.0, up) * round;
      const double middle = 0.5 * (dome + low_y), reach = 0.5 * (dome - low_y) * round;
      ring.emplace_back(k == kHalf - 1 ? 0 : half * side, middle + reach * up - groove, z);
    }
    for (int k = kHalf - 2; k > 0; --k) ring.emplace_back(-ring[k].x, ring[k].y, ring[k].z);
    std::reverse(ring.begin() + 1, ring.end());  // counter-clockwise seen from the tip
    rings.push_back(ring);
    part.part.shade.insert(part.part.shade.end(), sides,
                           static_cast<std::uint16_t>(std::lround((kTongueShades - 1) * (1 - way))));
  }
  part.part.shade.push_back(0);
  Mesh& mesh = part.part.rest;
  append_loft(mesh, find_middle(rings.front()), rings,
              find_middle(rings.back()) + glm::vec3(0, 0, 0.25f * scale));
  for (glm::vec3* end : {&mesh.positions.front(), &mesh.positions.back()}) end->x = 0;
  update_normals(mesh);
  part.part.name = "tongue";
  part.part.material = "tongue";
  for (int i = 0; i < kTongueShades; ++i) {
    const float back = static_cast<float>(i) / (kTongueShades - 1);
    part.part.palette.push_back(
        {glm::mix(glm::vec3(0.76f, 0.43f, 0.42f), glm::vec3(0.34f, 0.15f, 0.15f), back), 0.6f});
  }
  part.part.is_rigid = true;
  part.mount = Mount::jaw;
  return part;
}

Arch fit_arch(const NeutralHead& head, const MouthNumbers& numbers) {
  Arch arch{numbers};
  const glm::vec3 middle = find_named_point(head, "M0_0"), side = find_named_point(head, "M0_4");
  arch.scale = find_named_point(head, "M1_6").x / numbers.corner_mm;
  arch.lips_y_mm = 0.5 * (find_named_point(head, "M1_0").y + find_named_point(head, "M1_12").y);
  arch.curve = (middle.z - side.z) / (side.x * side.x);
  arch.front_z_mm = middle.z - arch.scale * numbers.setback_mm;
  arch.growth = smooth_step(numbers.grown_mm[0], numbers.grown_mm[1], find_eye_to_chin_mm(head));
  return arch;
}

// How far a row comes too near to the back of the lips, mm. Only its bare part counts: toward the fold above
// and below, and in the cheeks, gum and flesh are one.
double find_intrusion_mm(const Mesh& row, const Arch& arch, const SkinPatch& lips) {
  double intrusion = 0;
  for (const glm::vec3& p : row.positions) {
    if (p.x < 0 || p.x > arch.scale * kBareHalf_mm ||
        std::abs(p.y - arch.lips_y_mm) > arch.scale * kBareHeight_mm)
      continue;
    const SkinPlace place = find_nearest_place(lips, p);
    const double free_mm = glm::dot(p - place.point, place.normal);
    intrusion = std::max(intrusion, arch.scale * arch.numbers.clearance_mm - free_mm);
  }
  return intrusion;
}

// Moves both rows back until the lips have room.
void make_room_for_lips(const NeutralHead& head, Arch& arch, const Row& upper, const Row& lower) {
  const auto reach = static_cast<float>(arch.scale * arch.numbers.upper.half_mm);
  const glm::vec3 middle = find_named_point(head, "M0_0");
  const SkinPatch lips = build_skin_patch(head.skin, {middle - glm::vec3(2, reach, reach), middle + reach});
  for (int pass = 0; pass < 4; ++pass) {
    const Mesh teeth_above =
        build_teeth(arch, upper, build_columns(arch, upper.numbers.half_mm, 1)).part.rest;
    const Mesh teeth_below =
        build_teeth(arch, lower, build_columns(arch, lower.numbers.half_mm, kLowerWidth)).part.rest;
    const double intrusion =
        std::max(find_intrusion_mm(teeth_above, arch, lips), find_intrusion_mm(teeth_below, arch, lips));
    if (intrusion < 0.01) return;
    arch.front_z_mm -= intrusion;
  }
}

}  // namespace

std::vector<HeadPart> build_mouth(const NeutralHead& head, const Look&) {
  const MouthNumbers numbers = load_part_numbers().mouth;
  Arch arch = fit_arch(head, numbers);
  const Row upper{numbers.upper, 1}, lower{numbers.lower, -1};
  make_room_for_lips(head, arch, upper, lower);

  std::vector<HeadPart> parts;
  parts.push_back(build_teeth(arch, upper, build_columns(arch, upper.numbers.half_mm, 1)));
  parts.push_back(build_gum(arch, upper, build_columns(arch, upper.numbers.half_mm, 1)));
  parts.push_back(build_teeth(arch, lower, build_columns(arch, lower.numbers.half_mm, kLowerWidth)));
  parts.push_back(build_gum(arch, lower, build_columns(arch, lower.numbers.half_mm, kLowerWidth)));
  parts.push_back(build_tongue(arch));
  return parts;
}

}  // namespace mien

// Teeth one by one, as rings from the biting edge to the root: Nelson, "Wheeler's Dental Anatomy, Physiology
// and Occlusion", simplified to what is seen through an open mouth. Near by they can be counted; from afar
// the shallow gaps between them leave one light band (Loomis, "Drawing the Head and Hands", 1956).
#include <algorithm>
#include <array>
#include <cmath>

#include "core/conventions.hpp"
#include "core/smooth.hpp"
#include "head/dental_arch.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

// A ring of a tooth lies at this share of the way from the biting edge to the gum's margin; all else of it in
// shares of the tooth's own measures.
struct Station {
  double height;
  double wide;     // of its width: the widest place, where neighbours touch, is a third of the way up
  double back_mm;  // of its front: rolled back at the edge, and under the gum
  double thick;    // from the thickness of its edge (0) to that of its neck (1)
};

constexpr std::array<Station, 6> kStations{{{0.0, 0.935, 0.42, 0.0},
                                            {0.10, 0.985, 0.08, 0.22},
                                            {0.36, 1.0, 0.0, 0.62},
                                            {0.70, 0.955, 0.08, 0.92},
                                            {1.0, 0.87, 0.50, 1.0},
                                            {1.35, 0.70, 1.30, 0.9}}};

// A ring's points: across (-1 toward the middle of the face, 1 away from it), from the front (0) to the back
// (1). Counter-clockwise seen from the root of an upper tooth of the left.
struct RingPoint {
  double across, behind;
};

constexpr std::array<RingPoint, 14> kRing{{{1.0, 0.42},
                                           {0.82, 0.86},
                                           {0.42, 0.98},
                                           {0.0, 1.0},
                                           {-0.42, 0.98},
                                           {-0.82, 0.86},
                                           {-1.0, 0.42},
                                           {-0.98, 0.11},
                                           {-0.80, 0.0},
                                           {-0.45, 0.0},
                                           {0.0, 0.0},
                                           {0.45, 0.0},
                                           {0.80, 0.0},
                                           {0.98, 0.11}}};

constexpr double kBow = 0.075;  // how far the front's sides lie behind its middle, of the width
constexpr double kCorner_mm =
    0.5;  // how much higher the edge ends at its sides; more cuts notches that show from afar
constexpr double kFossa_mm = 0.35;  // depth of the table of a grinding tooth
constexpr double kTouch =
    1.02;  // neighbours overlap by this: 1 lets the dark behind shine through between them
constexpr double kLeastGrown = 0.12;  // of a tooth deep in the gum: a body, if a small one

// Height of the biting edge above its own lowest place, mm of the adult.
double compute_edge_rise_mm(const TeethRowNumbers& row, std::size_t kind, double across) {
  const double side = std::abs(across), far = across > 0 ? 1.25 : 0.8;  // the far corner is the rounder one
  const double corner = far * kCorner_mm * side * side * side * side;
  const double slope = row.cusps[kind] == 2 ? std::abs(2 * side - 1) : side;
  return corner + (row.cusps[kind] > 0 ? row.point_mm[kind] * slope : 0);
}

struct ToothShape {
  const DentalArch& arch;
  const TeethRow& row;
  const Tooth& tooth;
  glm::vec2 along{1, 0}, out{0, 1};

  // Height and distance behind the row's outside, mm.
  glm::vec3 place(double across_mm, double behind_mm, double height_mm) const {
    const glm::vec2 flat =
        tooth.place.at + along * static_cast<float>(across_mm) - out * static_cast<float>(behind_mm);
    return {flat.x, arch.lips_y_mm + row.sign * height_mm, arch.front_z_mm + flat.y};
  }
};

ToothShape shape_tooth(const DentalArch& arch, const TeethRow& row, const Tooth& tooth) {
  const double turn = row.numbers.turn_deg[tooth.kind] * kRadiansPerDegree;
  const auto c = static_cast<float>(std::cos(turn)), s = static_cast<float>(std::sin(turn));
  const glm::vec2 &along = tooth.place.along, &out = tooth.place.out;
  return {arch, row, tooth, c * along + s * out, c * out - s * along};
}

glm::vec3 place_on_tooth(const ToothShape& shape, const Station& station, const RingPoint& point) {
  const Tooth& tooth = shape.tooth;
  const TeethRowNumbers& numbers = shape.row.numbers;
  const double scale = shape.arch.scale, wide = 0.5 * (kTouch * tooth.width_mm - tooth.free_mm);
  const double grown = std::max(tooth.grown, kLeastGrown);
  const double edge = tooth.edge_mm + scale * (compute_edge_rise_mm(numbers, tooth.kind, point.across) +
                                               0.5 * point.behind * (numbers.cusps[tooth.kind] > 0));
  const double root = tooth.edge_mm + kStations.back().height * (tooth.neck_mm - tooth.edge_mm);
  double height = edge + station.height * (tooth.neck_mm - edge);
  height = root + (height - root) * grown;

  const double narrow = tooth.milk > 0 ? 1 - 0.06 * tooth.milk * station.height : 1;
  const double small = 0.5 + 0.5 * grown;
  const double table = numbers.table_mm[tooth.kind], neck = numbers.thick_mm[tooth.kind];
  const double thick = scale * small * (table + (neck - table) * station.thick);
  const double bow = kBow * 2 * wide * point.across * point.across;
  // The inner half of a front tooth is narrower: the arch is round there.
  const double taper = 0.2 * (1 - smooth_step(0.35, 0.65, tooth.share));
  const double across = wide * small * narrow * station.wide * point.across * (1 - taper * point.behind);
  const double behind = compute_lean_mm(shape.arch, shape.row, height, tooth.share) +
                        scale * station.back_mm + bow * (1 - point.behind) + thick * point.behind;
  return shape.place(across, behind, height);
}

constexpr int kHeightShades = 5, kDepthShades = 7, kGapShades = 3, kMilkShades = 2;
constexpr double kBehind = 0.95;  // of the throat's shade; less of it shows the far row as a grey band

std::uint16_t compute_tooth_shade(const ToothShape& shape, double height, double across, double behind) {
  const Tooth& tooth = shape.tooth;
  const auto up = std::lround(std::clamp(height, 0.0, 1.0) * (kHeightShades - 1));
  // The lower row lies in the shade of the cheek and the upper one: bright, its sides look like broken ones.
  const double dark = shape.row.sign < 0 ? 0.62 : 0.95;
  // Its tables are seen from above, and are lit from there.
  const double turned = shape.row.sign < 0 ? std::lerp(0.65, 1.0, smooth_step(0, 0.35, height)) : 1;
  const double far = std::max(smooth_step(0.12, dark, tooth.share), kBehind * turned * behind);
  const auto depth = std::lround(far * (kDepthShades - 1));
  const auto gap = std::lround(smooth_step(0.8, 1.0, std::abs(across)) * (kGapShades - 1));
  const auto milk = std::lround(tooth.milk);
  return static_cast<std::uint16_t>(((milk * kHeightShades + up) * kDepthShades + depth) * kGapShades + gap);
}

// Warm off-white: a little grey where the edge lets light through, yellower at the gum, in the cheeks' shade
// further back. Milk teeth have the blue-ish white they are called after; enamel wears thin with the years,
// and the yellow below it shows.
std::vector<Shade> make_teeth_palette(double years) {
  struct Enamel {
    glm::vec3 edge, body, neck;
  };
  constexpr std::array<Enamel, kMilkShades> kEnamel{
      {{{0.90f, 0.89f, 0.85f}, {0.945f, 0.905f, 0.83f}, {0.91f, 0.81f, 0.67f}},
       {{0.94f, 0.94f, 0.93f}, {0.965f, 0.95f, 0.91f}, {0.94f, 0.89f, 0.81f}}}};
  constexpr Enamel kWorn{{0.86f, 0.82f, 0.73f}, {0.89f, 0.82f, 0.69f}, {0.83f, 0.71f, 0.54f}};
  const auto worn = static_cast<float>(smooth_step(30, 75, years));
  // Of cheeks and throat; on the way to it teeth are reddish, for grey ones look like stones.
  const glm::vec3 shade(0.17f, 0.08f, 0.065f);
  const glm::vec3 half(0.50f, 0.34f, 0.28f);
  std::vector<Shade> palette;
  for (const Enamel& enamel : kEnamel)
    for (int height = 0; height < kHeightShades; ++height)
      for (int depth = 0; depth < kDepthShades; ++depth)
        for (int gap = 0; gap < kGapShades; ++gap) {
          const float up = static_cast<float>(height) / (kHeightShades - 1);
          const float far = 0.88f * static_cast<float>(depth) / (kDepthShades - 1);
          const float between = 0.09f * static_cast<float>(gap) / (kGapShades - 1);
          const glm::vec3 edge = glm::mix(enamel.edge, kWorn.edge, worn),
                          neck = glm::mix(enamel.neck, kWorn.neck, worn);
          const glm::vec3 low =
              glm::mix(edge, glm::mix(enamel.body, kWorn.body, worn), std::min(1.0f, 4 * up));
          const glm::vec3 own = glm::mix(low, neck, smooth_step(0.35f, 1.0f, up));
          const glm::vec3 lit = glm::mix(own, neck * 0.8f, between);
          // In the shade no lamp is mirrored either.
          palette.push_back({glm::mix(glm::mix(lit, half, far), glm::mix(half, shade, far), far),
                             0.5f * (1 - smooth_step(0.1f, 0.7f, far))});
        }
  return palette;
}

// Adds a tooth of the left half.
void append_tooth(const ToothShape& shape, Mesh& mesh, std::vector<std::uint16_t>& shades) {
  const Tooth& tooth = shape.tooth;
  std::vector<Ring> rings;
  shades.push_back(compute_tooth_shade(shape, 0, 0, 0.5));
  for (const Station& station : kStations) {
    rings.emplace_back();
    for (const RingPoint& point : kRing) {
      rings.back().push_back(place_on_tooth(shape, station, point));
      shades.push_back(compute_tooth_shade(shape, station.height, point.across, point.behind));
    }
  }
  shades.push_back(compute_tooth_shade(shape, 1, 0, 0.5));
  glm::vec3 table = compute_middle(rings.front());
  if (shape.row.numbers.cusps[tooth.kind] > 0 && tooth.kind > 2)
    table.y += static_cast<float>(shape.row.sign * shape.arch.scale * kFossa_mm * tooth.grown);
  append_loft(mesh, table, rings, compute_middle(rings.back()));
}

constexpr int kGumShades = 6;

// A cut of the gum: where it is along the row, and the teeth's measures there.
struct GumCut {
  ArchPlace place;
  double across = 0;     // of its tooth, -1..1
  double margin_mm = 0;  // height of the gum's edge before the teeth
  double inner_mm = 0;   // and behind them, where it is nearly level
  double neck_mm = 0;    // height of the row's gums there
  double thick_mm = 0, bow_mm = 0, share = 0, grown = 1;
};

std::vector<GumCut> cut_gum(const DentalArch& arch, const TeethRow& row) {
  const ArchLine line = trace_arch(arch, row);
  const std::vector<Tooth> teeth = lay_teeth(arch, row, line);
  const MouthNumbers& mouth = arch.numbers;
  const double scale = arch.scale;
  static constexpr std::array kAcross{-1.0, -0.72, -0.28, 0.28, 0.72};
  std::vector<GumCut> cuts;
  const auto add = [&](std::size_t kind, double across, double beyond_mm) {
    const Tooth& tooth = teeth[kind];
    const Tooth& other = teeth[across < 0 ? (kind > 0 ? kind - 1 : 0) : std::min(kind + 1, kTeeth - 1)];
    const double side = std::abs(across),
                 near = 0.5 * side * side * side * side;  // half at the neighbour's border
    const auto blend = [&](double own, double its) { return own + (its - own) * near; };
    GumCut cut;
    cut.across = across;
    cut.place = compute_arch_place(line, tooth.from_mm + 0.5 * tooth.width_mm * (1 + across) + beyond_mm);
    cut.grown = blend(tooth.grown, other.grown);
    cut.neck_mm = blend(tooth.neck_mm, other.neck_mm);
    cut.share = std::min(1.0, tooth.share + 0.5 * across * tooth.width_mm / line.length_mm.back());
    cut.thick_mm = scale * blend(row.numbers.thick_mm[tooth.kind], row.numbers.thick_mm[other.kind]);
    cut.bow_mm = kBow * blend(tooth.width_mm, other.width_mm) * across * across;
    cut.margin_mm = cut.neck_mm - scale * mouth.scallop_mm * side * side * side * cut.grown -
                    scale * mouth.ridge_mm * (1 - cut.grown);
    cut.inner_mm =
        cut.margin_mm + (0.5 * (cut.neck_mm - cut.margin_mm) - 1.2 * scale * cut.share) * cut.grown;
    cuts.push_back(cut);
  };
  for (std::size_t kind = 0; kind < kTeeth; ++kind)
    for (const double across : kAcross) add(kind, across, 0);
  add(kTeeth - 1, 1, 0);
  add(kTeeth - 1, 1, 2.2 * scale);
  return cuts;
}

// One cut of the gum: a roll that ends thin on the teeth and fills the gaps between them.
Ring build_gum_ring(const DentalArch& arch, const TeethRow& row, const GumCut& cut,
                    std::vector<std::uint16_t>& shades) {
  const double scale = arch.scale, thick = scale * arch.numbers.gum_thick_mm;
  const double side = std::abs(cut.across);
  const auto front_at = [&](double height) {
    return compute_lean_mm(arch, row, height, cut.share) + 0.6 * cut.bow_mm;
  };
  Ring ring;
  const auto add = [&](double height, double behind_mm, double dark) {
    const glm::vec2 flat = cut.place.at - cut.place.out * static_cast<float>(behind_mm);
    ring.emplace_back(flat.x, arch.lips_y_mm + row.sign * height, arch.front_z_mm + flat.y);
    const double shade = std::clamp(dark + 0.75 * smooth_step(0.15, 1, cut.share), 0.0, 1.0);
    shades.push_back(static_cast<std::uint16_t>(std::lround(shade * (kGumShades - 1))));
  };
  const double margin = cut.margin_mm, top = cut.neck_mm + 5 * scale, deep = cut.thick_mm + 0.5 * scale;
  const double valley = 0.35 * scale * side * side;  // the roots stand out a little
  add(top, front_at(top) + 0.6 * scale, 0.45);
  add(cut.neck_mm + 2.4 * scale, front_at(cut.neck_mm + 2.4 * scale) - 1.1 * thick + valley, 0.2);
  add(margin + 0.9 * scale, front_at(margin + 0.9 * scale) - thick + 0.5 * valley, 0);
  add(margin + 0.15 * scale, front_at(margin) - 0.45 * thick, 0);
  add(margin - 0.05 * scale, front_at(margin) + 0.8 * scale, 0);
  const double inner = cut.inner_mm;
  add(inner, front_at(inner) + deep - 0.9 * scale, 0.5);
  add(inner + 1.2 * scale, front_at(inner) + deep + 0.7 * scale, 0.6);
  add(top, front_at(inner) + deep + 2.4 * scale, 0.8);
  return ring;
}

std::vector<Shade> make_gum_palette() {
  const glm::vec3 pink(0.79f, 0.47f, 0.45f), dark(0.24f, 0.09f, 0.085f);
  std::vector<Shade> palette;
  for (int i = 0; i < kGumShades; ++i)
    palette.push_back({glm::mix(pink, dark, static_cast<float>(i) / (kGumShades - 1)), 0.6f});
  return palette;
}

// Cuts beyond the last tooth draw together: a round end.
constexpr std::array<float, 2> kEndSizes{0.92f, 0.3f};

void draw_together(Ring& ring, float size) {
  const glm::vec3 middle = compute_middle(ring);
  for (glm::vec3& p : ring) p = middle + (p - middle) * size;
}

Ring mirror_ring(Ring ring) {
  for (glm::vec3& p : ring) p.x = -p.x;
  return ring;
}

void turn_triangles_over(Mesh& mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
}

// Adds the mirror image of all that is there.
void append_mirror(Mesh& mesh, std::vector<std::uint16_t>& shades) {
  const auto count = static_cast<std::uint32_t>(mesh.positions.size());
  const std::size_t triangles = mesh.triangles.size();
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::vec3 p = mesh.positions[i];
    mesh.positions.emplace_back(-p.x, p.y, p.z);
  }
  for (std::size_t i = 0; i < triangles; ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    mesh.triangles.push_back({a + count, c + count, b + count});
  }
  shades.insert(shades.end(), shades.begin(), shades.begin() + count);
}

void finish_row(const TeethRow& row, HeadPart& part) {
  update_normals(part.part.rest);
  part.mount = row.sign > 0 ? Mount::skull : Mount::jaw;
  part.part.is_rigid = true;
}

}  // namespace

HeadPart build_teeth(const DentalArch& arch, const TeethRow& row) {
  HeadPart part;
  Mesh& mesh = part.part.rest;
  for (const Tooth& tooth : lay_teeth(arch, row, trace_arch(arch, row)))
    append_tooth(shape_tooth(arch, row, tooth), mesh, part.part.shade);
  if (row.sign < 0) turn_triangles_over(mesh);
  append_mirror(mesh, part.part.shade);
  part.part.name = row.sign > 0 ? "teeth_upper" : "teeth_lower";
  part.part.material = "teeth";
  part.part.palette = make_teeth_palette(arch.years);
  finish_row(row, part);
  return part;
}

HeadPart build_teeth_band(const DentalArch& arch, const TeethRow& row) {
  constexpr int kCuts = 24;          // of the left half: 2 mm apart
  constexpr double kRise_mm = 4;     // of its edge toward the row's end: less, and it is a bar
  constexpr double kThick_mm = 1.5;  // more, and its underside shows as a step
  constexpr double kTop = 1.3;       // of the way from a tooth's edge to the gum
  constexpr std::array kHeights{1.0, 0.6, 0.3, 0.0};  // of the way from its edge to its top
  const ArchLine line = trace_arch(arch, row);
  const std::vector<Tooth> teeth = lay_teeth(arch, row, line);
  // An infant's first two would be a white bar, and these two are never shed at one time.
  const double grown = std::max(teeth[2].grown, teeth[3].grown);
  const double neck = teeth[0].neck_mm, top = std::lerp(teeth[0].edge_mm, neck, kTop);
  std::vector<Ring> left, rings;
  for (int i = 0; i <= kCuts; ++i) {
    const double share = static_cast<double>(i) / kCuts;
    const ArchPlace place = compute_arch_place(line, share * line.length_mm.back());
    const double edge = std::lerp(neck, teeth[0].edge_mm + arch.scale * kRise_mm * share * share, grown);
    left.emplace_back();
    const auto add = [&](double height, double behind_mm) {
      const glm::vec2 flat =
          place.at - place.out * static_cast<float>(compute_lean_mm(arch, row, height, share) + behind_mm);
      left.back().emplace_back(i == 0 ? 0 : flat.x, arch.lips_y_mm + row.sign * height,
                               arch.front_z_mm + flat.y);
    };
    for (const double way : kHeights) add(std::lerp(edge, top, way), 0);
    add(edge, arch.scale * kThick_mm);
    add(top, arch.scale * kThick_mm);
  }
  for (std::size_t i = kCuts; i > 0; --i) rings.push_back(mirror_ring(left[i]));
  rings.insert(rings.end(), left.begin(), left.end());
  HeadPart part;
  append_loft(part.part.rest, compute_middle(rings.front()), rings, compute_middle(rings.back()));
  part.part.name = "teeth_upper";
  part.part.material = "teeth";
  finish_row(row, part);
  return part;
}

HeadPart build_gum(const DentalArch& arch, const TeethRow& row) {
  HeadPart part;
  std::vector<Ring> left, rings;
  std::vector<std::vector<std::uint16_t>> left_shades;
  const std::vector<GumCut> cuts = cut_gum(arch, row);
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    left_shades.emplace_back();
    left.push_back(build_gum_ring(arch, row, cuts[i], left_shades.back()));
    if (const std::size_t beyond = i + kEndSizes.size(); beyond >= cuts.size())
      draw_together(left.back(), kEndSizes[beyond - cuts.size()]);
    if (i == 0)
      for (glm::vec3& p : left.back()) p.x = 0;
    if (row.sign < 0) {  // upside down, so the other way round
      std::reverse(left.back().begin(), left.back().end());
      std::reverse(left_shades.back().begin(), left_shades.back().end());
    }
  }
  std::vector<std::uint16_t>& shade = part.part.shade;
  const auto take = [&](std::size_t cut, bool is_mirrored) {
    rings.push_back(is_mirrored ? mirror_ring(left[cut]) : left[cut]);
    shade.insert(shade.end(), left_shades[cut].begin(), left_shades[cut].end());
  };
  shade.push_back(left_shades.back().front());
  for (std::size_t i = left.size() - 1; i > 0; --i) take(i, true);
  for (std::size_t i = 0; i < left.size(); ++i) take(i, false);
  shade.push_back(left_shades.back().front());
  const glm::vec3 end = compute_middle(left.back());
  append_loft(part.part.rest, {-end.x, end.y, end.z}, rings, end);
  part.part.name = row.sign > 0 ? "gum_upper" : "gum_lower";
  part.part.material = "gum";
  part.part.palette = make_gum_palette();
  finish_row(row, part);
  return part;
}

}  // namespace mien

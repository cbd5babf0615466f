// Teeth and gums. The rows are suggested, not drawn tooth by tooth (Loomis, "Drawing the Head and Hands",
// 1956): one smooth band with hints of the gaps, and a scalloped gum.
#include <algorithm>
#include <array>
#include <cmath>

#include "head/dental_arch.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr int kHeightShades = 4, kDepthShades = 7, kGapShades = 3;

std::uint16_t find_tooth_shade(const ToothCut& cut, double crown) {
  const auto height = std::lround(std::clamp(crown, 0.0, 1.0) * (kHeightShades - 1));
  const auto depth = std::lround(smooth_step(0.3, 0.9, cut.share) * (kDepthShades - 1));
  const auto gap = std::lround(cut.gap * (kGapShades - 1));
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
Ring build_tooth_ring(const DentalArch& arch, const TeethRow& row, const ToothCut& cut,
                      std::vector<std::uint16_t>& shades) {
  const MouthNumbers& mouth = arch.numbers;
  const double gum = arch.scale * row.numbers.gum_mm;
  const double rise = cut.rise_mm * (row.sign > 0 ? 1 : 0.35);  // lower edges are nearly level
  const double full_edge = -arch.scale * (row.numbers.edge_mm - mouth.notch_mm * cut.gap) + rise;
  const double hidden_edge = gum + 1.5 * arch.scale;  // mm: inside the gum
  const double edge = hidden_edge + (full_edge - hidden_edge) * arch.growth;
  const double back = smooth_step(0.25, 0.75, cut.share);  // 0 a cutting edge, 1 a grinding one
  const double thick_gum = arch.scale * (row.numbers.thick_mm + 3.5 * back),
               thick_edge = arch.scale * (1.1 + 4.5 * back);
  const double groove = arch.scale * (mouth.groove_mm * cut.gap - 0.12 * cut.belly);

  static constexpr std::array kFront{1.35, 1.0, 0.8, 0.55, 0.3, 0.12, 0.02};
  static constexpr std::array kBack{0.03, 0.3, 0.7, 1.35};
  Ring ring;
  const double top = gum + 3.2 * arch.scale;
  const auto add = [&](double crown, double behind_mm) {
    const double height = edge + (top - edge) * crown / kFront.front();
    const double rolled =
        0.6 * arch.scale * std::pow(std::max(0.0, 1 - crown), 4);  // back at the biting edge
    ring.push_back(
        place_in_row(arch, row, cut, height, -find_lean_mm(arch, row, height) - rolled - behind_mm));
    shades.push_back(find_tooth_shade(cut, crown));
  };
  const double root = 0.9 * arch.scale;  // further back than the crown: it must not come through the gum
  for (const double crown : kFront) add(crown, groove + (crown > 1 ? root : 0));
  for (const double crown : kBack) add(crown, thick_edge + (thick_gum - thick_edge) * std::min(1.0, crown));
  return ring;
}

constexpr int kGumShades = 5;

// One cut of the gum: a roll that ends thin on the teeth, lower between them.
Ring build_gum_ring(const DentalArch& arch, const TeethRow& row, const ToothCut& cut,
                    std::vector<std::uint16_t>& shades) {
  const MouthNumbers& mouth = arch.numbers;
  const double scale = arch.scale, gum = scale * row.numbers.gum_mm, thick = scale * mouth.gum_thick_mm;
  const double ridge = 2.5 * (1 - arch.growth);  // mm: toothless gums meet lower
  const double margin = gum - scale * (mouth.scallop_mm * cut.gap * arch.growth + ridge),
               top = gum + 4.5 * scale;
  const double back = smooth_step(0.25, 0.75, cut.share);
  const double deep = scale * (row.numbers.thick_mm + 3.5 * back);
  const auto front_at = [&](double height) { return -find_lean_mm(arch, row, height); };

  Ring ring;
  const auto add = [&](double height, double out_mm, double dark) {
    ring.push_back(place_in_row(arch, row, cut, height, out_mm));
    const double shade = std::clamp(dark + 0.6 * smooth_step(0.2, 1, cut.share), 0.0, 1.0);
    shades.push_back(static_cast<std::uint16_t>(std::lround(shade * (kGumShades - 1))));
  };
  add(top, front_at(top) - 0.5 * scale, 0.5);
  add(gum + 2.0 * scale, front_at(gum + 2.0 * scale) + 1.1 * thick, 0.2);
  add(margin + 0.7 * scale, front_at(margin + 0.7 * scale) + thick * (0.8 + 0.3 * cut.gap), 0);
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

// The row's far end is round: cuts draw together over its last tenth.
void round_off(Ring& ring, double share) {
  const double beyond = std::clamp((share - 0.9) / 0.1, 0.0, 0.99);
  const glm::vec3 middle = find_middle(ring);
  for (glm::vec3& p : ring) p = middle + (p - middle) * static_cast<float>(std::sqrt(1 - beyond * beyond));
}

// The whole row from cuts of its left half: the right half is its mirror image, bit for bit.
template <typename BuildRing>
HeadPart build_band(const DentalArch& arch, const TeethRow& row, BuildRing build_ring) {
  HeadPart part;
  std::vector<Ring> left, rings;
  std::vector<std::vector<std::uint16_t>> left_shades;
  for (const ToothCut& cut : cut_row(arch, row)) {
    left_shades.emplace_back();
    left.push_back(build_ring(arch, row, cut, left_shades.back()));
    round_off(left.back(), cut.share);
    if (row.sign < 0) {  // upside down, so the other way round
      std::reverse(left.back().begin(), left.back().end());
      std::reverse(left_shades.back().begin(), left_shades.back().end());
    }
  }
  const auto take = [&](std::size_t cut, bool is_mirrored) {
    rings.push_back(is_mirrored ? mirror_ring(left[cut]) : left[cut]);
    part.part.shade.insert(part.part.shade.end(), left_shades[cut].begin(), left_shades[cut].end());
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

}  // namespace

HeadPart build_teeth(const DentalArch& arch, const TeethRow& row) {
  HeadPart part = build_band(arch, row, build_tooth_ring);
  part.part.name = row.sign > 0 ? "teeth_upper" : "teeth_lower";
  part.part.material = "teeth";
  part.part.palette = make_teeth_palette();
  return part;
}

HeadPart build_gum(const DentalArch& arch, const TeethRow& row) {
  HeadPart part = build_band(arch, row, build_gum_ring);
  part.part.name = row.sign > 0 ? "gum_upper" : "gum_lower";
  part.part.material = "gum";
  part.part.palette = make_gum_palette();
  return part;
}

}  // namespace mien

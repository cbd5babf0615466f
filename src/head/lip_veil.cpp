// Lips that are shut leave a slit a hair wide, through which lit teeth would show as white dashes. What
// closes it in a mouth is the wet inner side of the upper lip, which hangs behind the lower one: a thin flap
// of its colour here. Between shut lips it lies in the dark; over bared teeth a dark one would be a gap.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/smooth.hpp"
#include "head/binding.hpp"
#include "head/cage.hpp"
#include "head/dental_arch.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr int kColumns = 6;  // of the lips from the middle to a corner
constexpr int kSteps = 2;    // rings of the flap for each of them
constexpr double kHang_mm =
    1.0;  // below the slit; more shows under a raised lip, less lets a low lamp's light out
constexpr double kThinner = 0.6;    // of its hang is gone at its ends: a corner that opens would show it
constexpr double kThick_mm = 0.12;  // half; two sides of one plane would flicker
constexpr double kLast = 5.4;       // column where it ends, before the corner's fold

// One cross-section: it grows from the inner edge of the lip and hangs down.
struct VeilCut {
  glm::vec3 root{0}, tip{0};
};

}  // namespace

HeadPart build_lip_veil(const NeutralHead& head, double scale, const glm::vec3& srgb) {
  const auto at = [&](const char* ring, int column) {
    return head.skin.positions[find_point(head.cage, fmt::format("{}_{}", ring, column))];
  };
  std::vector<glm::vec3> inner, slit;
  for (int column = 0; column <= kColumns; ++column) {
    inner.push_back(at("M0", column));
    slit.push_back(0.5f * (at("M1", column) + at("M1", 2 * kColumns - column)));
  }
  std::vector<VeilCut> cuts;  // of the left half
  const int count = static_cast<int>(std::lround(kLast * kSteps));
  for (int i = 0; i <= count; ++i) {
    const double column = static_cast<double>(i) / kSteps;
    VeilCut cut;
    cut.root = sample_curve(inner, column);
    if (i == 0) cut.root.x = 0;
    const float low = sample_curve(slit, column).y -
                      static_cast<float>(scale * kHang_mm * (1 - kThinner * smooth_step(3, kLast, column)));
    cut.tip = {cut.root.x, std::min(low, cut.root.y - static_cast<float>(0.1 * scale)), cut.root.z};
    cuts.push_back(cut);
  }

  HeadPart part;
  std::vector<Ring> rings;
  const auto thick = static_cast<float>(scale * kThick_mm);
  const auto take = [&](const VeilCut& cut, float side) {  // counter-clockwise seen from the left
    Ring ring;
    for (const auto& [p, out] :
         {std::pair{cut.root, thick}, {cut.root, -thick}, {cut.tip, -thick}, {cut.tip, thick}})
      ring.emplace_back(side * p.x, p.y, p.z + out);
    std::reverse(ring.begin(), ring.end());
    rings.push_back(ring);
  };
  for (std::size_t i = cuts.size() - 1; i > 0; --i) take(cuts[i], -1);
  for (const VeilCut& cut : cuts) take(cut, 1);
  Mesh& mesh = part.part.rest;
  append_loft(mesh, compute_middle(rings.front()), rings, compute_middle(rings.back()));
  update_normals(mesh);

  // Each ring rides on the skin at its root; the fans' points go with the outermost ones.
  const glm::vec3 reach(0, 6 * scale, 6 * scale);
  const SkinPatch patch =
      build_skin_patch(head.skin, {glm::vec3(-inner.back().x, inner.back().y, inner.back().z) - reach,
                                   inner.front() + glm::vec3(inner.back().x, 0, 0) + reach});
  std::uint32_t first = 0;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const bool is_end = r == 0 || r + 1 == rings.size();
    const auto size = static_cast<std::uint32_t>(rings[r].size()) + (is_end ? 1 : 0);
    const SkinPlace place = find_nearest_place(patch, 0.5f * (rings[r][2] + rings[r][3]));
    part.bindings.push_back({place.triangle, place.barycentric, first, size});
    first += size;
  }
  part.part.name = "lip_veil";
  part.part.material = "plain";
  part.part.palette = {{srgb, 0}};
  part.part.is_printed = false;
  part.mount = Mount::strands;
  return part;
}

}  // namespace mien

#include "head/skin_tint.hpp"

#include <array>
#include <cmath>
#include <map>

#include "core/smooth.hpp"
#include "head/beard.hpp"
#include "head/lids.hpp"
#include "head/strands.hpp"
#include "head/tubes.hpp"

namespace mien {

void tint_skin(Part& skin, const std::vector<float>& covers, const glm::vec3& srgb) {
  constexpr float kSteps = 96, kGlossSteps = 16;  // of a palette's channels: fewer show as bands
  constexpr float kLeast = 0.01f;
  std::map<std::array<int, 4>, std::uint16_t> known;
  for (std::size_t v = 0; v < covers.size() && v < skin.shade.size(); ++v) {
    if (covers[v] < kLeast) continue;
    const Shade from = skin.palette[skin.shade[v]];
    const glm::vec3 mixed = glm::round(glm::mix(from.srgb, srgb, covers[v]) * kSteps) / kSteps;
    const float gloss = std::round(from.gloss * (1 - 0.7f * covers[v]) * kGlossSteps) / kGlossSteps;
    const auto step = [](float value) { return static_cast<int>(std::lround(value * 1000)); };
    const auto [entry, is_new] = known.try_emplace({step(mixed.r), step(mixed.g), step(mixed.b), step(gloss)},
                                                   static_cast<std::uint16_t>(skin.palette.size()));
    if (is_new) skin.palette.push_back({mixed, gloss});
    skin.shade[v] = entry->second;
  }
}

std::vector<SkinTint> list_hair_tints(const NeutralHead& head, const HeadSpec& spec) {
  const auto scale = [](std::vector<float> covers, double by) {
    for (float& cover : covers) cover *= static_cast<float>(by);
    return covers;
  };
  const BrowNumbers& brow = head.data->parts.brow;
  const double youth = 1 - smooth_step(brow.grown_mm[0], brow.grown_mm[1], compute_eye_to_chin_mm(head));
  std::vector<SkinTint> tints;
  tints.push_back(
      {scale(paint_brows(head, brow), brow.paint * (1 - brow.infant_paint * youth)), spec.look.brow});
  if (spec.look.beard != "none")
    tints.push_back({scale(paint_beard(head, spec.look.beard), compute_beard_paint(head, spec.look.beard)),
                     compute_beard_colour(spec.look)});
  return tints;
}

}  // namespace mien

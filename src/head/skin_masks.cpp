#include "head/skin_masks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/smooth.hpp"
#include "head/cage.hpp"
#include "head/surface.hpp"

namespace mien {

namespace {

// A mask's value on points FIRST..LAST of a ring or column: "M2", 0, 12.
struct RingValue {
  SkinMask mask;
  const char* ring;
  int first, last;
  double value;
};

constexpr RingValue kRingValues[] = {
    {kLips, "M0", 0, 12, 1},
    {kLips, "M1", 0, 12, 1},
    {kLips, "M2", 0, 12, 0.85},  // the red's border: it fades
    {kLips, "M3", 0, 12, 0.30},
    {kLipInner, "MB1", 0, 12, 1},
    {kLipInner, "M0", 0, 12, 1},
    {kLipInner, "M1", 0, 12, 0.25},
    {kLipCorner, "M0", 5, 7, 1},
    {kLipCorner, "M1", 5, 7, 1},
    {kLipCorner, "M2", 5, 7, 1},
    {kLipCorner, "M1", 4, 4, 0.4},
    {kLipCorner, "M1", 8, 8, 0.4},
    {kLipCorner, "M2", 4, 4, 0.6},
    {kLipCorner, "M2", 8, 8, 0.6},
    {kMouth, "MB2", 0, 12, 1},
    {kThroat, "MB2", 0, 12, 1},
    {kMouth, "MB1", 0, 12, 1},
    {kMouth, "M0", 0, 12, 0.75},
    {kNostril, "nd", 0, 7, 1},
    {kNostril, "ni", 0, 7, 1},
    {kNostril, "nr", 0, 7, 0.6},
    {kRim, "EB", 0, 15, 1},
    {kRim, "E0", 0, 15, 1},
    {kRim, "E1", 0, 15, 0.8},
    {kRim, "E2", 9, 15, 0.15},
    {kRim, "E2", 0, 0, 0.5},
    {kLash, "E1", 1, 7, 0.9},
    {kLid, "E1", 0, 15, 1},
    {kLid, "E2", 0, 15, 1},
    {kLid, "E3", 0, 8, 0.8},
    {kLid, "E3", 9, 15, 0.5},
    {kBlood, "er3", 0, 15, 0.3},
    {kBlood, "er4", 0, 15, 0.6},
    {kBlood, "er5", 0, 15, 0.8},
    {kBlood, "er6", 0, 15, 0.8},
    {kBlood, "er7", 0, 15, 0.7},
    {kBlood, "er8", 0, 15, 0.6},
    {kBlood, "er9", 0, 15, 0.6},
    {kBlood, "er10", 0, 15, 0.8},
    {kBlood, "er11", 0, 15, 0.8},
    // Before the ear the cheek goes over into the tragus with no edge.
    {kBlood, "er3", 11, 15, 0.05},
    {kBlood, "er4", 11, 15, 0.15},
    {kBlood, "er5", 11, 15, 0.3},
    {kBlood, "er6", 11, 15, 0.45},
};

// A mask's soft spot about a point of the skin: exp(-(distance / radius)^2). Radii are an adult's.
struct Spot {
  SkinMask mask;
  const char* point;
  double radius_mm;
  double value;
};

constexpr Spot kSpots[] = {
    {kBlood, "q12_C2", 18, 0.46}, {kBlood, "q11_C3", 17, 0.30},  {kBlood, "p_tip", 11, 0.75},
    {kBlood, "c3_tip", 8, 0.6},   {kBlood, "k_it", 6, 0.5},      {kBlood, "M6_12", 12, 0.38},
    {kBlood, "E3_0", 6, 0.2},     {kBlood, "p_b2", 9, 0.3},      {kBlood, "p_s", 8, 0.15},
    {kForehead, "p_F2", 34, 1},   {kForehead, "f4_F2", 30, 0.8}, {kSocket, "E3_12", 8, 0.55},
    {kSocket, "E3_14", 7, 0.6},   {kSocket, "E3_0", 6, 0.6},     {kSocket, "E4_1", 7, 0.3},
    {kSocket, "E3_9", 7, 0.3},    {kBeard, "M6_12", 22, 0.6},    {kBeard, "q12_C8", 22, 0.8},
    {kBeard, "q11_D1", 22, 0.8},  {kBeard, "m11_D1", 22, 0.8},   {kBeard, "MA_1", 9, 0.5},
    {kBeard, "M6_9", 18, 0.8},    {kBrow, "E5_2", 4, 0.4},       {kBrow, "E5_3", 4.5, 0.7},
    {kBrow, "E5_4", 4.5, 0.7},    {kBrow, "E5_5", 4, 0.5},       {kShine, "p_tip", 8, 1},
    {kShine, "p_F1", 22, 0.6},    {kShine, "p_b1", 8, 0.7},      {kShine, "q12_C1", 14, 0.4},
    {kShine, "M6_12", 9, 0.4},
};

void add_rings(const NeutralHead& head, SkinMasks& masks) {
  std::array<std::vector<double>, kSkinMaskCount> values;
  for (std::vector<double>& v : values) v.assign(head.cage.points.size(), 0.0);
  for (const RingValue& rule : kRingValues)
    for (int i = rule.first; i <= rule.last; ++i) {
      const std::uint32_t point = find_point(head.cage, fmt::format("{}_{}", rule.ring, i));
      values[rule.mask][point] = values[rule.mask][head.cage.mirror[point]] = rule.value;
    }
  for (std::size_t mask = 0; mask < kSkinMaskCount; ++mask)
    masks[mask] = spread_over_surface(*head.surface, values[mask]);
}

// Spots lie on the left half; |x| puts their mirror images on the right one.
void add_spots(const NeutralHead& head, SkinMasks& masks) {
  constexpr float kNothing = 20;                           // exp(-20) from 1 is 1 in a float
  const double size = head.eye.centre.x / Eye{}.centre.x;  // of this face against the adult's
  for (const Spot& spot : kSpots) {
    const glm::vec3 centre = head.skin.positions[find_point(head.cage, spot.point)];
    const auto radius = static_cast<float>(spot.radius_mm * size);
    for (std::size_t i = 0; i < head.skin.positions.size(); ++i) {
      glm::vec3 p = head.skin.positions[i];
      p.x = std::abs(p.x);
      const glm::vec3 away = (p - centre) / radius;
      const float far = glm::dot(away, away);
      float& value = masks[spot.mask][i];
      // Spots of one mask overlap like veils, never past 1.
      const float veil = far > kNothing ? 0 : static_cast<float>(spot.value) * std::exp(-far);
      value = 1 - (1 - value) * (1 - veil);
    }
  }
}

// A lip has an edge, a spot has none.
void sharpen(std::vector<float>& mask, float low, float high) {
  for (float& value : mask) value = smooth_step(low, high, value);
}

}  // namespace

SkinMasks paint_skin_masks(const NeutralHead& head) {
  SkinMasks masks;
  add_rings(head, masks);
  add_spots(head, masks);
  sharpen(masks[kLips], 0.10f, 0.80f);
  sharpen(masks[kMouth], 0.15f, 0.85f);
  sharpen(masks[kLash], 0.30f, 0.70f);
  sharpen(masks[kNostril], 0.10f, 0.80f);
  return masks;
}

}  // namespace mien

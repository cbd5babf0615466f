// Where on the skin a colour or a gloss of its own lies.
#pragma once

#include <array>
#include <vector>

#include "head/head.hpp"

namespace mien {

// kLipInner is where the lips go over into the mouth, kLipCorner their corners, kRim is the wet edge of the
// lids, kLash the roots of the upper lashes, kBlood where it shows through, kBeard where one would grow,
// kShine where skin is oily.
enum SkinMask {
  kLips,
  kLipInner,
  kLipCorner,
  kMouth,
  kThroat,
  kNostril,
  kRim,
  kLid,
  kLash,
  kSocket,
  kBlood,
  kForehead,
  kBeard,
  kBrow,
  kShine,
  kSkinMaskCount
};

// For each mask a value from 0 to 1 a vertex of the skin; mirror images have the same.
using SkinMasks = std::array<std::vector<float>, kSkinMaskCount>;

// Painted by name, on rings and about points of the cage, so every head has them in the right place.
SkinMasks paint_skin_masks(const NeutralHead& head);

}  // namespace mien

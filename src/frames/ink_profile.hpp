// What who draws a profile does to a head that a camera from the side would not show.
#pragma once

#include <array>

#include "frames/ink.hpp"

namespace mien {

// How the head is seen, as shares: from the side (0 up to three-quarter view, 1 in profile), and from before;
// and the sines of the camera's way round it, more than 0 on its left, and below it; and the unit way to the
// camera.
struct InkSight {
  float beside = 0, faced = 0, aside = 0, below = 0;
  glm::vec3 to_camera{0, 0, 1};
};
InkSight measure_sight(const Ink& ink, const InkView& view, const Drawing& drawing);

// How far a corner of the mouth is lifted, 0..1, on side 0, the left, or 1.
float find_smile(const Pose& pose, std::size_t side);

// Eyes that are tall ovals would be slits, and open mouths notches: skin and balls about them are drawn out
// in depth, behind what stands forth of balls and lips, as far as the head is seen from the side, the mouth
// as far as its lips are `parted`, 0..1. A blush keeps its form. A head without a lens stays as it is: its
// eyes are not tall.
void widen_features(const Ink& ink, float beside, float parted, Drawing& drawing);

// 1 of an eye that is a slit, 0 of one that is open or shut, on side 0, the left, or 1.
float measure_slit(const Ink& ink, const std::vector<glm::vec3>& skin, std::size_t side);

// An eye that is nearly shut shows no iris from the side: its lids part a little, the upper one above all.
// `slits` are what measure_slit gives of both.
void part_lids(const Ink& ink, float beside, const std::array<float, 2>& slits, Drawing& drawing);

// Seen from below, a cheek's pad would cut the blush off: it lies farther back below the middle of that. So
// does a far cheek of a head that turns away, unless a smile raises it: a sliver of it would stand between
// nose and lip.
void flatten_cheeks(const Ink& ink, const Pose& pose, const InkSight& sight, Drawing& drawing);

// The shade is that of what looks down, jaw and chin: a cheek that bulges over a mouth's corner would have a
// blotch of it there. Lids, lips and ears, whose outlines are strokes, are lit: else chips of shade. Seen
// from before and from below, cheeks have more light than they get: its edge would cut a blush or go round
// it. From below the throat is in the shade, in one band along the jaw.
void lift_tones(const Ink& ink, const InkSight& sight, const glm::vec3& to_light,
                std::vector<glm::vec3>& tones);

}  // namespace mien

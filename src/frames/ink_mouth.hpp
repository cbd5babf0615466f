// What who draws makes of a mouth: of its inside, a dark with one band of teeth and a tongue, and of the far
// corner of one that is open.
#pragma once

#include "frames/ink.hpp"
#include "frames/ink_profile.hpp"

namespace mien {

// How far the lips' middles stand apart, on an adult's head, and what it makes of them: 0 they meet, 1 they
// are parted; 1 a slit, 0 wide open.
struct InkMouth {
  float gap_mm = 0, parted = 0, slit = 0;
};
InkMouth measure_mouth(const Ink& ink, const std::vector<glm::vec3>& skin);

// In three-quarter view the far end of an open mouth goes away around the teeth: a wide one would be cut off
// square, a round one would be a heart. Its corner comes forward, most where no smile lifts it, and a wide
// mouth's lips come together about the middle of its height; a round one is an ellipse, as it is seen. A head
// without a lens stays as it is.
void round_far_corner(const Ink& ink, const Pose& pose, const InkSight& sight, const InkMouth& mouth,
                      Drawing& drawing);

// From the side an open mouth's lips bow out between its middle and its corner, the lower one most: straight
// they are a beak.
void round_profile(const Ink& ink, const InkSight& sight, const InkMouth& mouth, Drawing& drawing);

// Seen from below, the corners of a smile would hang: they are lifted as far as it takes, and a little more.
// `pose` is the one that folds are drawn of.
void lift_corners(const Ink& ink, const Pose& pose, const InkSight& sight, Drawing& drawing);

// Teeth, gums, tongue and what is dark about them, on lips as they are drawn. `pose` is the one asked for,
// `line_mm` how wide a line is there.
void draw_mouth(const Ink& ink, const Pose& pose, const InkSight& sight, const InkMouth& mouth,
                double line_mm, Drawing& drawing);

}  // namespace mien

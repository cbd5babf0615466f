// What who draws makes of a round mouth that is seen aslant: still a round.
#pragma once

#include "frames/ink.hpp"

namespace mien {

// The edge of the lips as the camera sees it becomes, by `share`, the ellipse that fits its width and height;
// what lies inside comes along, the skin about it less and less. For lips that stand open: the edge must go
// once round the middle of what is seen of it. `inset` of its width it is narrower at the end that lies
// farther away, where it would hide the lips. `to_camera` is unit.
void round_mouth(const Ink& ink, float share, float inset, const glm::vec3& to_camera, Drawing& drawing);

}  // namespace mien

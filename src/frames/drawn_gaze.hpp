// The eyes of a drawn profile: who draws one turns its iris a little toward who looks at the picture, or it
// would be a line at the ball's edge.
#pragma once

#include "frames/figure.hpp"

namespace mien {

// The pose with eyes that go toward the camera where they are seen from the side, as far as they can. The
// camera stands at `camera_mm` of the world, the head where `world_from_head` puts it.
Pose turn_gaze_to_camera(const Figure& figure, const Pose& pose, const glm::dmat4& world_from_head,
                         const glm::dvec3& camera_mm);

}  // namespace mien

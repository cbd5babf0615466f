// The head's rotation about the top of the neck: what the skin and the gaze must agree on.
#pragma once

#include <glm/glm.hpp>

#include "config/clip_spec.hpp"

namespace mien {

// By `share` of its angles: world from rest, a rotation about `pivot` (mm).
glm::dmat4 find_turn(const glm::dvec3& pivot, const TurnKey& turn, double share);

}  // namespace mien

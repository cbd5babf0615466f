// The head's rotation about the top of the neck, and its rise with a breath: what the skin and the gaze must
// agree on.
#pragma once

#include <glm/glm.hpp>

#include "config/clip_spec.hpp"

namespace mien {

// What of the shoulders' rise comes to the head: the neck gives a little.
inline constexpr double kHeadRise = 0.6;

bool is_turned(const TurnKey& turn);

// By `share` of its angles: world from rest, a rotation about `pivot` (mm), risen with the breath. At share 0
// are the shoulders, at 1 the head.
glm::dmat4 compute_turn(const glm::dvec3& pivot, const TurnKey& turn, double share);

}  // namespace mien

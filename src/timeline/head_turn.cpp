#include "timeline/head_turn.hpp"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/conventions.hpp"

namespace mien {

bool is_turned(const TurnKey& turn) {
  return turn.turn_deg != 0 || turn.nod_deg != 0 || turn.tilt_deg != 0 || turn.breath_mm != 0;
}

glm::dmat4 compute_turn(const glm::dvec3& pivot, const TurnKey& turn, double share) {
  const double degrees = share * kRadiansPerDegree;
  const double rise_mm = turn.breath_mm * std::lerp(1.0, kHeadRise, share);
  glm::dmat4 world = glm::translate(glm::dmat4(1), pivot + glm::dvec3(0, rise_mm, 0));
  world = glm::rotate(world, turn.turn_deg * degrees, glm::dvec3(0, 1, 0));
  world = glm::rotate(world, turn.nod_deg * degrees, glm::dvec3(1, 0, 0));
  // The crown toward the character's left (+x) is a turn against the clock about z, which points at the
  // viewer.
  world = glm::rotate(world, -turn.tilt_deg * degrees, glm::dvec3(0, 0, 1));
  return glm::translate(world, -pivot);
}

}  // namespace mien

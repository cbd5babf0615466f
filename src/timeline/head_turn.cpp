#include "timeline/head_turn.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include "core/conventions.hpp"

namespace mien {

glm::dmat4 find_turn(const glm::dvec3& pivot, const TurnKey& turn, double share) {
  const double degrees = share * kRadiansPerDegree;
  glm::dmat4 world = glm::translate(glm::dmat4(1), pivot);
  world = glm::rotate(world, turn.turn_deg * degrees, glm::dvec3(0, 1, 0));
  world = glm::rotate(world, turn.nod_deg * degrees, glm::dvec3(1, 0, 0));
  // The crown toward the character's left (+x) is a turn against the clock about z, which points at the
  // viewer.
  world = glm::rotate(world, -turn.tilt_deg * degrees, glm::dvec3(0, 0, 1));
  return glm::translate(world, -pivot);
}

}  // namespace mien

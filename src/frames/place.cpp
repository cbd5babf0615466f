#include "frames/place.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include "core/conventions.hpp"

namespace mien {

glm::dmat4 find_place(const PlaceSpec& place) {
  return glm::rotate(glm::translate(glm::dmat4(1), place.at_mm), place.turn_deg * kRadiansPerDegree,
                     glm::dvec3(0, 1, 0));
}

glm::dmat4 find_motion(const PlaceSpec& first, const PlaceSpec& now) {
  return find_place(now) * glm::inverse(find_place(first));
}

void place_drawing(const glm::dmat4& world, Drawing& drawing) {
  if (world == glm::dmat4(1)) return;
  const glm::mat4 moved(world);
  const glm::mat3 turned(world);
  for (PartShape& shape : drawing.parts) {
    for (glm::vec3& position : shape.positions) position = glm::vec3(moved * glm::vec4(position, 1));
    for (glm::vec3& normal : shape.normals) normal = turned * normal;
    shape.world_from_rest = glm::mat4(world * glm::dmat4(shape.world_from_rest));
  }
}

}  // namespace mien

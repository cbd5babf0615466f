#include "head/adult_places.hpp"

#include "head/surface.hpp"

namespace mien {

std::vector<glm::vec3> compute_places_on_adult(const NeutralHead& head) {
  std::vector<Float4> packed;
  pack_points(head.adult_points, packed);
  std::vector<glm::vec3> places;
  deform_surface(*head.surface, packed, places);
  return places;
}

}  // namespace mien

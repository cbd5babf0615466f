#include "head/placed_scan.hpp"

namespace mien {

NearestPlace find_place(const PlacedScan& scan, const glm::dvec3& point, double reach_mm, bool is_right) {
  const glm::dvec3 at = is_right ? mirror(point) : point;
  NearestPlace place = find_nearest(scan.tree, glm::transpose(scan.turn) * (at - scan.shift), reach_mm);
  place.point = scan.turn * place.point + scan.shift;
  place.normal = scan.turn * place.normal;
  if (is_right) {
    place.point = mirror(place.point);
    place.normal = mirror(place.normal);
  }
  return place;
}

bool is_open(const PlacedScan& scan, const NearestPlace& place, double way_mm, bool is_right) {
  // Of the way: flat or round skin has nothing nearer than all of it, a soft hollow such as the groove of the
  // upper lip still most of it.
  constexpr double kClear = 0.6;
  const glm::dvec3 before = place.point + way_mm * place.normal;
  const glm::dvec3 at = is_right ? mirror(before) : before;
  return !is_within(scan.tree, glm::transpose(scan.turn) * (at - scan.shift), kClear * way_mm);
}

}  // namespace mien

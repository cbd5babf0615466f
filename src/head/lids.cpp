#include "head/lids.hpp"

#include "core/error.hpp"
#include "head/tubes.hpp"

namespace mien {

Lids build_lids(const NeutralHead& head, double adult_ball_mm) {
  Lids lids;
  lids.inner = find_named_ring(head, "E0_", 0, 15);
  lids.outer = find_named_ring(head, "E1_", 0, 15);
  lids.beyond = find_named_ring(head, "E2_", 0, 15);
  lids.centre = glm::vec3(head.eye.centre);
  lids.radius_mm = static_cast<float>(head.eye.radius_mm);
  lids.scale = head.eye.radius_mm / adult_ball_mm;
  Box box = compute_bounds(lids.outer);
  box.low -= 2.0f;  // mm: all of the margin's triangles
  box.high += 2.0f;
  lids.patch = build_skin_patch(head.skin, box);
  return lids;
}

glm::vec3 compute_on_margin(const Lids& lids, double t, double mix) {
  return glm::mix(sample_curve(lids.inner, t, true), sample_curve(lids.outer, t, true),
                  static_cast<float>(mix));
}

glm::vec3 find_named_point(const NeutralHead& head, std::string_view name) {
  const auto found = head.cage.index.find(name);
  if (found == head.cage.index.end()) throw RunError("the cage has no point '" + std::string(name) + "'");
  return head.skin.positions.at(found->second);
}

std::vector<glm::vec3> find_named_ring(const NeutralHead& head, const std::string& stem, int first,
                                       int last) {
  std::vector<glm::vec3> points;
  for (int i = first; i <= last; ++i) points.push_back(find_named_point(head, stem + std::to_string(i)));
  return points;
}

double compute_eye_to_chin_mm(const NeutralHead& head) {
  return head.eye.centre.y - static_cast<double>(find_named_point(head, "m12_D1").y) + head.shortened_mm;
}

}  // namespace mien

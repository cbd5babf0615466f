#include "frames/bust_foot.hpp"

#include <algorithm>

namespace mien {

namespace {

constexpr float kDrop = 0.36f;        // of half the chest's breadth: from its lowest edge to the foot
constexpr float kFootRadius = 0.28f;  // of half the chest's breadth; thinner would break off

}  // namespace

ChestBox measure_chest(const Loop& chest, const std::vector<glm::vec3>& positions) {
  ChestBox found;
  found.box = {positions[chest.front()], positions[chest.front()]};
  for (const std::uint32_t v : chest) {
    found.box.low = glm::min(found.box.low, positions[v]);
    found.box.high = glm::max(found.box.high, positions[v]);
  }
  found.half_breadth = (found.box.high.x - found.box.low.x) / 2;
  found.foot_y = found.box.low.y - kDrop * found.half_breadth;
  found.middle = {(found.box.low.x + found.box.high.x) / 2, found.foot_y,
                  (found.box.low.z + found.box.high.z) / 2};
  return found;
}

float compute_flat_y(const ChestBox& chest) { return chest.box.low.y - 0.04f * chest.half_breadth; }

void place_foot(const Loop& chest_edge, std::uint32_t first, Stand stand, std::vector<glm::vec3>& positions) {
  const ChestBox chest = measure_chest(chest_edge, positions);
  const float radius = kFootRadius * chest.half_breadth;
  for (int ring = 1; ring <= kFootRings; ++ring) {
    const float way = float(ring) / kFootRings;
    for (std::size_t i = 0; i < chest_edge.size(); ++i) {
      const glm::vec3 p = positions[chest_edge[i]];
      glm::vec3& at = positions[first + static_cast<std::size_t>(ring - 1) * chest_edge.size() + i];
      if (stand == Stand::flat) {
        at = {p.x, glm::mix(p.y, compute_flat_y(chest), way), p.z};
        continue;
      }
      const glm::vec3 out = glm::normalize(glm::vec3(p.x - chest.middle.x, 0, p.z - chest.middle.z));
      const glm::vec3 end = chest.middle + out * radius;
      at = glm::mix(p, end, way);
      at.y =
          glm::mix(p.y, end.y, 0.35f * way + 0.65f * way * way * way);  // flatter above, upright at the foot
    }
  }
}

}  // namespace mien

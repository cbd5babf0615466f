// What a bust ends in below its chest.
#pragma once

#include <cstdint>
#include <vector>

#include "core/holes.hpp"

namespace mien {

// What the figure is set on.
enum class Stand { foot, flat };  // a round foot for a base; the chest cut flat

inline constexpr int kFootRings = 6;

// The chest's edge, mm of the head.
struct ChestBox {
  Box box;
  float half_breadth = 0, foot_y = 0;
  glm::vec3 middle{0};  // of the foot
};

ChestBox measure_chest(const Loop& chest, const std::vector<glm::vec3>& positions);

// Where a chest is cut flat: a little below its edge, so that the rim is no knife.
float compute_flat_y(const ChestBox& chest);

// Places the kFootRings rings below the chest's edge, of as many vertices each, from `first` on: down to a
// round, flat foot, steep enough to print without support, as a bust on its socle has always been cut; or
// straight down to a plane a little below the edge.
void place_foot(const Loop& chest_edge, std::uint32_t first, Stand stand, std::vector<glm::vec3>& positions);

}  // namespace mien

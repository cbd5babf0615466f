// The skin of a print: the mouth bag cut out, every opening closed, a foot to stand on.
#pragma once

#include "core/mesh.hpp"
#include "head/head.hpp"

namespace mien {

// The closed skin of a bust, still where the drawing has it, and its foot.
struct BustSkin {
  Mesh mesh;          // closed; vertices below the number of the skin's own keep their index and meaning
  glm::vec3 foot{0};  // mm, centre of the flat underside
  float foot_radius_mm = 26;  // of the round flat underside
  float chest_y_mm = 0;       // below this height there is only the foot, which narrows
};

// `positions` are the skin's in one drawing.
BustSkin build_bust_skin(const NeutralHead& head, const std::vector<glm::vec3>& positions);

}  // namespace mien

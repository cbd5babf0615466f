// Hair seen as a colour of the skin it grows in: what single hairs are from afar.
#pragma once

#include <vector>

#include "head/head.hpp"

namespace mien {

// Mixes `srgb` into the vertices of a skin part, 0..1 of it a vertex; a vertex with 0 keeps its shade. Shades
// are shared in steps, so that the palette stays small. `covers` may have fewer values than there are
// vertices.
void tint_skin(Part& skin, const std::vector<float>& covers, const glm::vec3& srgb);

struct SkinTint {
  std::vector<float> covers;  // 0..1 a vertex
  glm::vec3 srgb{0};
};

// What brows and beard of a head put on its skin.
std::vector<SkinTint> list_hair_tints(const NeutralHead& head, const HeadSpec& spec);

}  // namespace mien

// A head's colours as ink has them: flat tones want more colour than lit ones.
#pragma once

#include <glm/glm.hpp>

namespace mien {

// srgb; `purer` times as far from the grey of the same brightness, `brighter` times as bright.
inline glm::vec3 purify(const glm::vec3& srgb, float purer, float brighter) {
  const glm::vec3 grey(glm::dot(srgb, glm::vec3(0.30f, 0.59f, 0.11f)));
  return glm::clamp((grey + purer * (srgb - grey)) * brighter, 0.0f, 1.0f);
}

inline glm::vec3 find_ink_hair(const glm::vec3& srgb) { return purify(srgb, 1.5f, 1.35f); }

}  // namespace mien

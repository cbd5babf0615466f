// A head's colours as ink has them: flat tones want more colour than lit ones.
#pragma once

#include <algorithm>

#include <glm/glm.hpp>

namespace mien {

// srgb; `purer` times as far from the grey of the same brightness, `brighter` times as bright.
inline glm::vec3 purify(const glm::vec3& srgb, float purer, float brighter) {
  const glm::vec3 grey(glm::dot(srgb, glm::vec3(0.30f, 0.59f, 0.11f)));
  return glm::clamp((grey + purer * (srgb - grey)) * brighter, 0.0f, 1.0f);
}

// Light hair keeps its hue: no channel of it is full.
inline glm::vec3 find_ink_hair(const glm::vec3& srgb) {
  constexpr float kPurer = 1.5f, kBrighter = 1.35f, kMost = 0.95f;
  const glm::vec3 grey(glm::dot(srgb, glm::vec3(0.30f, 0.59f, 0.11f)));
  const glm::vec3 hair = glm::max((grey + kPurer * (srgb - grey)) * kBrighter, 0.0f);
  return hair * std::min(1.0f, kMost / std::max({hair.r, hair.g, hair.b, 1e-6f}));
}

}  // namespace mien

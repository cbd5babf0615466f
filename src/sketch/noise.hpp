// Smooth noise, the same on every machine. Source: K. Perlin, "Improving Noise", SIGGRAPH 2002.
#pragma once

#include <glm/glm.hpp>

namespace mien {

// 0..1, mostly about 0.5; changes over lengths of 1.
float compute_noise(const glm::vec3& at);

// Three of them about 0, each in -1..1.
glm::vec3 compute_vector_noise(const glm::vec3& at);

}  // namespace mien

#include "sketch/noise.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace mien {

namespace {

// Corners of the lattice by number; mixed as in "squirrel" hashes, so that no two axes look alike.
std::uint32_t mix_corner(std::int32_t x, std::int32_t y, std::int32_t z) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9E3779B1u ^ static_cast<std::uint32_t>(y) * 0x85EBCA77u ^
                    static_cast<std::uint32_t>(z) * 0xC2B2AE3Du;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return h ^ (h >> 15);
}

// One of the twelve middles of a cube's edges, by the distance from the corner.
float lean(std::uint32_t hash, const glm::vec3& away) {
  const std::uint32_t h = hash & 15;
  const float u = h < 8 ? away.x : away.y, v = h < 4 ? away.y : (h == 12 || h == 14 ? away.x : away.z);
  return ((h & 1) != 0 ? -u : u) + ((h & 2) != 0 ? -v : v);
}

float fade(float t) { return t * t * t * (t * (t * 6 - 15) + 10); }

}  // namespace

float compute_noise(const glm::vec3& at) {
  constexpr float kSpread = 0.62f;  // Perlin's noise seldom passes 0.8
  const glm::vec3 low = glm::floor(at), in = at - low;
  const auto x = static_cast<std::int32_t>(low.x), y = static_cast<std::int32_t>(low.y),
             z = static_cast<std::int32_t>(low.z);
  const float fx = fade(in.x), fy = fade(in.y), fz = fade(in.z);
  const auto corner = [&](int dx, int dy, int dz) {
    return lean(mix_corner(x + dx, y + dy, z + dz), in - glm::vec3(dx, dy, dz));
  };
  const auto row = [&](int dy, int dz) { return std::lerp(corner(0, dy, dz), corner(1, dy, dz), fx); };
  const float near = std::lerp(row(0, 0), row(1, 0), fy), far = std::lerp(row(0, 1), row(1, 1), fy);
  return std::clamp(0.5f + kSpread * std::lerp(near, far, fz), 0.0f, 1.0f);
}

glm::vec3 compute_vector_noise(const glm::vec3& at) {
  const glm::vec3 apart(31.4f, -47.8f, 12.7f);
  return 2.0f * glm::vec3(compute_noise(at), compute_noise(at + apart), compute_noise(at - apart)) - 1.0f;
}

}  // namespace mien

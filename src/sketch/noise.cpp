#include "sketch/noise.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace mien {

namespace {

// Corners of the lattice by number; mixed as in "squirrel" hashes, so that no two axes look alike.
std::uint32_t mix_corner(std::int32_t x, std::int32_t y, std::int32_t z) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9E3779B1u ^
                    static_cast<std::uint32_t>(y) * 0x85EBCA77u ^ static_cast<std::uint32_t>(z) * 0xC2B2AE3Du;
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

constexpr float kSpread = 0.62f;  // Perlin's noise seldom passes 0.8

// What the lattice makes of a place: `Lean` gives each corner's part. A place on the plane z = 0, as all that
// lies on a grain, has half as many corners.
template <typename T, typename Lean>
T blend_corners(const glm::vec3& at, const Lean& lean_at) {
  const glm::vec3 low = glm::floor(at), in = at - low;
  const auto x = static_cast<std::int32_t>(low.x), y = static_cast<std::int32_t>(low.y),
             z = static_cast<std::int32_t>(low.z);
  const float fx = fade(in.x), fy = fade(in.y);
  const auto row = [&](int dy, int dz) {
    const T one = lean_at(mix_corner(x, y + dy, z + dz), in - glm::vec3(0, dy, dz));
    return one + fx * (lean_at(mix_corner(x + 1, y + dy, z + dz), in - glm::vec3(1, dy, dz)) - one);
  };
  const auto plane = [&](int dz) {
    const T one = row(0, dz);
    return one + fy * (row(1, dz) - one);
  };
  const T near = plane(0);
  return in.z == 0 ? near : near + fade(in.z) * (plane(1) - near);
}

}  // namespace

float compute_noise(const glm::vec3& at) {
  return std::clamp(0.5f + kSpread * blend_corners<float>(at, lean), 0.0f, 1.0f);
}

glm::vec3 compute_vector_noise(const glm::vec3& at) {
  const auto lean_three = [](std::uint32_t hash, const glm::vec3& away) {
    return glm::vec3(lean(hash, away), lean(hash >> 8, away), lean(hash >> 16, away));
  };
  return glm::clamp(2 * kSpread * blend_corners<glm::vec3>(at, lean_three), -1.0f, 1.0f);
}

}  // namespace mien

// Small figures for tests of prints: a ball on a neck, open at its foot, and the like.
#pragma once

#include <cmath>
#include <numbers>

#include "core/holes.hpp"
#include "core/mesh.hpp"

namespace mien {

// A surface of revolution about the z axis: rings of `sides` points at (radius, z) from the top down, the
// top closed by one vertex at `top_z`, open at the last ring. `squash` makes it oval along y.
inline Mesh build_turned(const std::vector<glm::vec2>& profile, float top_z, int sides, float squash = 1) {
  Mesh mesh;
  mesh.positions.emplace_back(0, 0, top_z);
  Loop last;
  for (const glm::vec2& at : profile) {
    Loop ring;
    for (int i = 0; i < sides; ++i) {
      const double turn = 2 * std::numbers::pi * (i + 0.5) / sides;
      ring.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.emplace_back(at.x * std::cos(turn), squash * at.x * std::sin(turn), at.y);
    }
    for (int i = 0; i < sides; ++i) {
      const int j = (i + 1) % sides;
      if (last.empty()) {
        mesh.triangles.push_back({0, ring[i], ring[j]});
      } else {
        mesh.triangles.push_back({last[i], ring[i], ring[j]});
        mesh.triangles.push_back({last[i], ring[j], last[j]});
      }
    }
    last = ring;
  }
  return mesh;
}

// A ball of `radius` on a neck, open at its foot: a ring of `neck` at `foot_z`, the neck `neck_mm` long.
inline Mesh build_ball_on_neck(float radius, float neck, float foot_z, float neck_mm, int sides = 48,
                               float squash = 1) {
  std::vector<glm::vec2> profile;
  const float low = -std::sqrt(radius * radius - neck * neck), centre = foot_z + neck_mm - low;
  const int rings = sides / 2;
  const double end = std::numbers::pi - std::asin(neck / radius);
  for (int k = 1; k <= rings; ++k) {
    const double down = end * k / rings;
    profile.emplace_back(radius * std::sin(down), centre + radius * std::cos(down));
  }
  const int steps = std::max(1, int(neck_mm / 2));
  for (int k = 1; k <= steps; ++k)
    profile.emplace_back(neck, foot_z + neck_mm * float(steps - k) / float(steps));
  return build_turned(profile, centre + radius, sides, squash);
}

inline std::vector<glm::vec3> list_points(const Mesh& mesh, const Loop& loop) {
  std::vector<glm::vec3> points;
  for (const std::uint32_t v : loop) points.push_back(mesh.positions[v]);
  return points;
}

}  // namespace mien

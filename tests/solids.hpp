// Small closed solids for tests of geometry.
#pragma once

#include <cmath>
#include <numbers>

#include "core/mesh.hpp"

namespace mien {

// An axis-parallel box of 12 triangles.
inline Mesh build_box(const glm::vec3& low, const glm::vec3& high) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
  //   6---7
  //  /|  /|    y up, x right, z toward us: 4..7 are the near face
  // 2-4-3-5
  // |/  |/
  // 0---1
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

// A ball of `rings` x 2 `rings` facets, poles on the y axis.
inline Mesh build_ball(const glm::vec3& centre, float radius, int rings) {
  Mesh mesh;
  const int spokes = 2 * rings;
  constexpr float kPi = std::numbers::pi_v<float>;
  mesh.positions.push_back(centre + glm::vec3(0, radius, 0));
  for (int ring = 1; ring < rings; ++ring)
    for (int spoke = 0; spoke < spokes; ++spoke) {
      const float down = kPi * float(ring) / float(rings), turn = 2 * kPi * float(spoke) / float(spokes);
      mesh.positions.push_back(centre + radius * glm::vec3(std::sin(down) * std::sin(turn), std::cos(down),
                                                           std::sin(down) * std::cos(turn)));
    }
  const auto last = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back(centre - glm::vec3(0, radius, 0));
  const auto vertex = [&](int ring, int spoke) {
    return static_cast<std::uint32_t>(1 + (ring - 1) * spokes + spoke % spokes);
  };
  for (int s = 0; s < spokes; ++s) {
    mesh.triangles.push_back({0, vertex(1, s), vertex(1, s + 1)});
    for (int ring = 1; ring + 1 < rings; ++ring) {
      mesh.triangles.push_back({vertex(ring, s), vertex(ring + 1, s), vertex(ring + 1, s + 1)});
      mesh.triangles.push_back({vertex(ring, s), vertex(ring + 1, s + 1), vertex(ring, s + 1)});
    }
    mesh.triangles.push_back({vertex(rings - 1, s), last, vertex(rings - 1, s + 1)});
  }
  return mesh;
}

}  // namespace mien

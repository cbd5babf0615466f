// A closed mesh to ask things of: how far its surface is, what a ray meets.
#pragma once

#include "core/mesh.hpp"
#include "core/surface_tree.hpp"

namespace mien {

SurfaceTree build_solid_tree(const Mesh& mesh);

struct RayHit {
  double distance = 1e9;  // 1e9: nothing within reach
  std::uint32_t triangle = 0;
  glm::dvec3 normal{0};  // of that triangle, unit
};

// The first triangle on the ray from `origin` along `direction` (unit), further than `start` and within
// `reach`. Triangles edge-on to the ray are not met.
RayHit find_hit(const SurfaceTree& tree, const glm::dvec3& origin, const glm::dvec3& direction, double start,
                double reach);

}  // namespace mien

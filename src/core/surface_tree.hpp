// The nearest place on a surface: a tree of boxes around its triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/float4.hpp"
#include "core/mesh.hpp"

namespace mien {

struct SurfaceTree {
  // Up to four children side by side: one look measures all their boxes.
  struct Node {
    std::array<Float4, 3> low, high;  // by axis, a little larger than what is inside; inverted if nothing is
    std::array<std::uint32_t, 4> children{};  // nodes, or triangles with kIsTriangle set
  };
  static constexpr std::uint32_t kIsTriangle = 1U << 31;
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;  // unit, one a position
  std::vector<bool> is_rim;         // the position lies on an open edge
  std::vector<Triangle> triangles;
  std::vector<Node> nodes;  // the first is the root
};

// Triangles without an area are left out.
SurfaceTree build_surface_tree(std::vector<glm::dvec3> positions, std::vector<Triangle> triangles);

struct NearestPlace {
  glm::dvec3 point{0};
  glm::dvec3 normal{0, 0, 1};  // of the surface, smoothed
  double distance = 1e9;
  bool is_rim = false;  // on an open edge: the surface may go on where nobody has seen it
};

// The place nearest to `point` within `reach`; distance 1e9 if there is none.
NearestPlace find_nearest(const SurfaceTree& tree, const glm::dvec3& point, double reach);

// Whether any of the surface is nearer than `distance`; the same, but no more is looked at than it takes.
bool is_within(const SurfaceTree& tree, const glm::dvec3& point, double distance);

}  // namespace mien

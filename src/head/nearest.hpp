// The nearest place on somebody else's surface: a tree of boxes around its triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh.hpp"
#include "import/polygons.hpp"

namespace mien {

struct SurfaceTree {
  struct Node {
    glm::dvec3 low{0}, high{0};
    std::uint32_t first = 0, count = 0;  // of `order`; count 0: two children, the next node and `right`
    std::uint32_t right = 0;
  };
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;   // unit, one a position
  std::vector<bool> is_rim;          // the position lies on an open edge
  std::vector<Triangle> triangles;   // polygons as fans
  std::vector<std::uint32_t> order;  // triangles, leaf after leaf
  std::vector<Node> nodes;
};

// Triangles without an area are left out.
SurfaceTree build_surface_tree(const Polygons& mesh);

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

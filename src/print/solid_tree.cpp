// The ray and the triangle: Moeller and Trumbore, "Fast, minimum storage ray-triangle intersection" (1997).
#include "print/solid_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mien {

namespace {

// A ray four times side by side. Directions along a face of a box would divide by 0: they lean by nothing
// that matters.
struct Ray {
  std::array<Float4, 3> origin, inverse;

  Ray(const glm::dvec3& from, const glm::dvec3& way) {
    constexpr double kLeast = 1e-12;
    for (int axis = 0; axis < 3; ++axis) {
      const auto start = static_cast<float>(from[axis]);
      const auto by = static_cast<float>(
          1 / (std::abs(way[axis]) < kLeast ? std::copysign(kLeast, way[axis]) : way[axis]));
      origin[axis] = Float4{start, start, start, start};
      inverse[axis] = Float4{by, by, by, by};
    }
  }
};

// Where the ray enters the four boxes; INFINITY for those that it does not meet within `reach`.
Float4 find_entries(const SurfaceTree::Node& node, const Ray& ray, double reach) {
  constexpr float kLonger = 1 + 1e-5f;  // rounding never hides a triangle
  const auto far = static_cast<float>(reach);
  Float4 from{}, to{far, far, far, far};
  for (int axis = 0; axis < 3; ++axis) {
    const Float4 a = (node.low[axis] - ray.origin[axis]) * ray.inverse[axis],
                 b = (node.high[axis] - ray.origin[axis]) * ray.inverse[axis];
    const Float4 near_side = a < b ? a : b, far_side = a < b ? b : a;
    from = from > near_side ? from : near_side;
    to = to < far_side ? to : far_side;
  }
  constexpr Float4 kNever{INFINITY, INFINITY, INFINITY, INFINITY};
  return from <= kLonger * to ? from : kNever;
}

}  // namespace

SurfaceTree build_solid_tree(const Mesh& mesh) {
  return build_surface_tree({mesh.positions.begin(), mesh.positions.end()}, mesh.triangles);
}

RayHit find_hit(const SurfaceTree& tree, const glm::dvec3& origin, const glm::dvec3& direction, double start,
                double reach) {
  RayHit best;
  if (tree.nodes.empty()) return best;
  const Ray ray(origin, direction);
  double least = reach;
  struct Open {
    float from;
    std::uint32_t child;
  };
  std::array<Open, 64> open{};  // begins with the root
  std::size_t count = 1;
  while (count > 0) {
    const auto [entry, child] = open[--count];
    if (entry > least) continue;
    if (child & SurfaceTree::kIsTriangle) {
      const std::uint32_t index = child & ~SurfaceTree::kIsTriangle;
      const auto& [a, b, c] = tree.triangles[index];
      const glm::dvec3 &p = tree.positions[a], u = tree.positions[b] - p, v = tree.positions[c] - p;
      const glm::dvec3 h = glm::cross(direction, v);
      const double det = glm::dot(u, h);
      if (det == 0) continue;
      const glm::dvec3 s = origin - p, q = glm::cross(s, u);
      const double x = glm::dot(s, h) / det, y = glm::dot(direction, q) / det, t = glm::dot(v, q) / det;
      constexpr double kBorder = -1e-9;  // a ray through an edge meets one of its triangles at least
      if (x < kBorder || y < kBorder || x + y > 1 - kBorder || t <= start || t >= least) continue;
      least = t;
      best = {t, index, glm::normalize(glm::cross(u, v))};
      continue;
    }
    const SurfaceTree::Node& node = tree.nodes[child];
    const Float4 entries = find_entries(node, ray, least);
    const std::size_t first = count;  // the nearest is looked at first
    for (int i = 0; i < 4; ++i) {
      if (std::isinf(entries[i]) || std::isinf(node.low[0][i])) continue;
      std::size_t at = count++;
      for (; at > first && open[at - 1].from < entries[i]; --at) open[at] = open[at - 1];
      open[at] = {entries[i], node.children[i]};
    }
  }
  return best;
}

}  // namespace mien

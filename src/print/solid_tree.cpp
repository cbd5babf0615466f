// The ray and the triangle: Moeller and Trumbore, "Fast, minimum storage ray-triangle intersection" (1997).
#include "print/solid_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace mien {

namespace {

// Where the ray enters the box, if it does within [0, reach].
std::optional<double> find_entry(const SurfaceTree::Node& node, const glm::dvec3& origin,
                                 const glm::dvec3& inverse, double reach) {
  double from = 0, to = reach;
  for (int i = 0; i < 3; ++i) {
    double near = (node.low[i] - origin[i]) * inverse[i], far = (node.high[i] - origin[i]) * inverse[i];
    if (std::isnan(near) || std::isnan(far)) continue;  // along a face of the box: inside it
    if (near > far) std::swap(near, far);
    from = std::max(from, near);
    to = std::min(to, far);
  }
  if (from > to * (1 + 1e-12) + 1e-12) return std::nullopt;
  return from;
}

}  // namespace

SurfaceTree build_solid_tree(const Mesh& mesh) {
  Polygons polygons;
  polygons.positions.assign(mesh.positions.begin(), mesh.positions.end());
  for (const Triangle& t : mesh.triangles) {
    polygons.corners.insert(polygons.corners.end(), t.begin(), t.end());
    polygons.first.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
  }
  return build_surface_tree(polygons);
}

RayHit find_hit(const SurfaceTree& tree, const glm::dvec3& origin, const glm::dvec3& direction, double start,
                double reach) {
  RayHit best;
  if (tree.nodes.empty()) return best;
  const glm::dvec3 inverse = 1.0 / direction;
  double least = reach;
  std::array<std::uint32_t, 64> open;  // the tree is some twenty levels deep
  std::size_t count = 0;
  open[count++] = 0;
  while (count > 0) {
    const std::uint32_t index = open[--count];
    const SurfaceTree::Node& node = tree.nodes[index];
    if (!find_entry(node, origin, inverse, least)) continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const auto& [a, b, c] = tree.triangles[tree.order[i]];
      const glm::dvec3 &p = tree.positions[a], u = tree.positions[b] - p, v = tree.positions[c] - p;
      const glm::dvec3 h = glm::cross(direction, v);
      const double det = glm::dot(u, h);
      if (det == 0) continue;
      const glm::dvec3 s = origin - p, q = glm::cross(s, u);
      const double x = glm::dot(s, h) / det, y = glm::dot(direction, q) / det, t = glm::dot(v, q) / det;
      constexpr double kBorder = -1e-9;  // a ray through an edge meets one of its triangles at least
      if (x < kBorder || y < kBorder || x + y > 1 - kBorder || t <= start || t >= least) continue;
      least = t;
      best = {t, tree.order[i], glm::normalize(glm::cross(u, v))};
    }
    if (node.count > 0) continue;
    const auto near = find_entry(tree.nodes[index + 1], origin, inverse, least);
    const auto far = find_entry(tree.nodes[node.right], origin, inverse, least);
    const bool is_left_first = near.value_or(1e9) <= far.value_or(1e9);
    if (far && is_left_first) open[count++] = node.right;
    if (near) open[count++] = index + 1;
    if (far && !is_left_first) open[count++] = node.right;
  }
  return best;
}

}  // namespace mien

// A bounding volume hierarchy split at the median; the nearest point of a triangle after Ericson, "Real-Time
// Collision Detection" (2005), 5.1.5.
#include "head/nearest.hpp"

#include <algorithm>
#include <array>

namespace mien {

namespace {

constexpr std::uint32_t kLeaf = 4;  // triangles; fewer would make more nodes than it saves tests

std::vector<Triangle> split_fans(const Polygons& mesh) {
  std::vector<Triangle> triangles;
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    for (std::uint32_t i = mesh.first[f] + 2; i < mesh.first[f + 1]; ++i) {
      const Triangle t{mesh.corners[mesh.first[f]], mesh.corners[i - 1], mesh.corners[i]};
      const glm::dvec3 area = glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                                         mesh.positions[t[2]] - mesh.positions[t[0]]);
      if (glm::dot(area, area) > 0) triangles.push_back(t);
    }
  return triangles;
}

void find_rims(SurfaceTree& tree) {
  std::vector<std::uint64_t> edges;  // whatever their direction, so that a wrongly wound face opens nothing
  edges.reserve(3 * tree.triangles.size());
  for (const Triangle& t : tree.triangles)
    for (int i = 0; i < 3; ++i) {
      const std::uint64_t a = t[i], b = t[(i + 1) % 3];
      edges.push_back(a < b ? a << 32 | b : b << 32 | a);
    }
  std::sort(edges.begin(), edges.end());
  tree.is_rim.assign(tree.positions.size(), false);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool is_shared =
        (i > 0 && edges[i - 1] == edges[i]) || (i + 1 < edges.size() && edges[i + 1] == edges[i]);
    if (!is_shared) tree.is_rim[edges[i] >> 32] = tree.is_rim[edges[i] & 0xFFFFFFFF] = true;
  }
}

void find_normals(SurfaceTree& tree) {
  tree.normals.assign(tree.positions.size(), glm::dvec3(0));
  for (const Triangle& t : tree.triangles) {
    const glm::dvec3 area =
        glm::cross(tree.positions[t[1]] - tree.positions[t[0]], tree.positions[t[2]] - tree.positions[t[0]]);
    for (const std::uint32_t v : t) tree.normals[v] += area;
  }
  for (glm::dvec3& n : tree.normals) {
    const double length = glm::length(n);
    n = length > 0 ? n / length : glm::dvec3(0, 0, 1);
  }
}

std::uint32_t build_node(SurfaceTree& tree, const std::vector<glm::dvec3>& centres, std::uint32_t first,
                         std::uint32_t count) {
  const auto index = static_cast<std::uint32_t>(tree.nodes.size());
  tree.nodes.emplace_back();
  glm::dvec3 low(1e300), high(-1e300), centre_low(1e300), centre_high(-1e300);
  for (std::uint32_t i = first; i < first + count; ++i) {
    for (const std::uint32_t v : tree.triangles[tree.order[i]]) {
      low = glm::min(low, tree.positions[v]);
      high = glm::max(high, tree.positions[v]);
    }
    centre_low = glm::min(centre_low, centres[tree.order[i]]);
    centre_high = glm::max(centre_high, centres[tree.order[i]]);
  }
  tree.nodes[index].low = low;
  tree.nodes[index].high = high;
  if (count <= kLeaf) {
    tree.nodes[index].first = first;
    tree.nodes[index].count = count;
    return index;
  }
  const glm::dvec3 size = centre_high - centre_low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::uint32_t half = count / 2;
  std::nth_element(tree.order.begin() + first, tree.order.begin() + first + half,
                   tree.order.begin() + first + count, [&](std::uint32_t a, std::uint32_t b) {
                     const double ca = centres[a][axis], cb = centres[b][axis];
                     return ca != cb ? ca < cb : a < b;
                   });
  build_node(tree, centres, first, half);
  const std::uint32_t right = build_node(tree, centres, first + half, count - half);
  tree.nodes[index].right = right;
  return index;
}

// Barycentric coordinates of the place of triangle a b c that is nearest to p.
glm::dvec3 find_nearest_barycentric(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                                    const glm::dvec3& c) {
  const glm::dvec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const glm::dvec3 bp = p - b;
  const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  const glm::dvec3 cp = p - c;
  const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }
  const double sum = va + vb + vc;
  return {1 - vb / sum - vc / sum, vb / sum, vc / sum};
}

double find_square_distance(const SurfaceTree::Node& node, const glm::dvec3& p) {
  const glm::dvec3 outside = glm::max(glm::max(node.low - p, p - node.high), glm::dvec3(0));
  return glm::dot(outside, outside);
}

}  // namespace

SurfaceTree build_surface_tree(const Polygons& mesh) {
  SurfaceTree tree;
  tree.positions = mesh.positions;
  tree.triangles = split_fans(mesh);
  find_rims(tree);
  find_normals(tree);
  std::vector<glm::dvec3> centres;
  for (const Triangle& t : tree.triangles) {
    centres.push_back((tree.positions[t[0]] + tree.positions[t[1]] + tree.positions[t[2]]) / 3.0);
    tree.order.push_back(static_cast<std::uint32_t>(tree.order.size()));
  }
  if (!tree.order.empty()) build_node(tree, centres, 0, static_cast<std::uint32_t>(tree.order.size()));
  return tree;
}

NearestPlace find_nearest(const SurfaceTree& tree, const glm::dvec3& point, double reach) {
  NearestPlace best;
  if (tree.nodes.empty()) return best;
  double least = reach * reach;
  std::uint32_t triangle = 0;
  glm::dvec3 share{0};
  std::array<std::pair<double, std::uint32_t>, 64> open;  // the tree is some twenty levels deep
  std::size_t count = 0;
  open[count++] = {find_square_distance(tree.nodes[0], point), 0};
  while (count > 0) {
    const auto [distance, index] = open[--count];
    if (distance > least) continue;
    const SurfaceTree::Node& node = tree.nodes[index];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Triangle& t = tree.triangles[tree.order[i]];
      const glm::dvec3 &a = tree.positions[t[0]], &b = tree.positions[t[1]], &c = tree.positions[t[2]];
      const glm::dvec3 at = find_nearest_barycentric(point, a, b, c);
      const glm::dvec3 place = at.x * a + at.y * b + at.z * c, way = place - point;
      const double square = glm::dot(way, way);
      if (square > least || (square == least && best.distance < 1e9)) continue;
      least = square;
      best.point = place;
      best.distance = 0;
      triangle = tree.order[i];
      share = at;
    }
    if (node.count > 0) continue;
    std::pair<double, std::uint32_t> near{find_square_distance(tree.nodes[index + 1], point), index + 1},
        far{find_square_distance(tree.nodes[node.right], point), node.right};
    if (far.first < near.first) std::swap(near, far);
    open[count++] = far;
    open[count++] = near;
  }
  if (best.distance > 0) return best;
  best.distance = std::sqrt(least);
  const Triangle& t = tree.triangles[triangle];
  glm::dvec3 normal{0};
  int touched = 0, rims = 0;
  for (int i = 0; i < 3; ++i) {
    normal += share[i] * tree.normals[t[i]];
    if (share[i] <= 1e-9) continue;
    ++touched;
    rims += tree.is_rim[t[i]];
  }
  best.is_rim = rims == touched && touched < 3;
  const double length = glm::length(normal);
  if (length > 0) best.normal = normal / length;
  return best;
}

bool is_within(const SurfaceTree& tree, const glm::dvec3& point, double distance) {
  const double square = distance * distance;
  std::array<std::uint32_t, 64> open;
  std::size_t count = 0;
  if (!tree.nodes.empty()) open[count++] = 0;
  while (count > 0) {
    const std::uint32_t index = open[--count];
    const SurfaceTree::Node& node = tree.nodes[index];
    if (find_square_distance(node, point) >= square) continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Triangle& t = tree.triangles[tree.order[i]];
      const glm::dvec3 &a = tree.positions[t[0]], &b = tree.positions[t[1]], &c = tree.positions[t[2]];
      const glm::dvec3 at = find_nearest_barycentric(point, a, b, c);
      const glm::dvec3 way = at.x * a + at.y * b + at.z * c - point;
      if (glm::dot(way, way) < square) return true;
    }
    if (node.count > 0) continue;
    open[count++] = node.right;
    open[count++] = index + 1;
  }
  return false;
}

}  // namespace mien

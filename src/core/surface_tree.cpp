// A bounding volume hierarchy of four children a node (Wald, Benthin and Boulos, "Getting rid of packets",
// 2008), split at the median; the nearest point of a triangle after Ericson, "Real-Time
// Collision Detection" (2005), 5.1.5.
#include "core/surface_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace mien {

namespace {

// Boxes are floats. They are padded by a share of the largest coordinate, and distances from them shortened
// by a share of themselves, so that rounding never hides a triangle.
constexpr double kPad = 1e-6;
constexpr float kShorter = 1 - 1e-5f;

void leave_out_flat(SurfaceTree& tree) {
  std::erase_if(tree.triangles, [&](const Triangle& t) {
    const glm::dvec3 area =
        glm::cross(tree.positions[t[1]] - tree.positions[t[0]], tree.positions[t[2]] - tree.positions[t[0]]);
    return !(glm::dot(area, area) > 0);
  });
}

void compute_rims(SurfaceTree& tree) {
  std::vector<std::uint64_t> edges;  // whatever their direction, so that a wrongly wound face opens nothing
  edges.reserve(3 * tree.triangles.size());
  for (const Triangle& t : tree.triangles)
    for (int i = 0; i < 3; ++i) {
      const std::uint64_t a = t[i], b = t[(i + 1) % 3];
      edges.push_back(a < b ? a << 32 | b : b << 32 | a);
    }
  std::sort(edges.begin(), edges.end());
  tree.is_rim.assign(tree.positions.size(), true);  // a position that no triangle has is no surface's
  for (const Triangle& t : tree.triangles)
    for (const std::uint32_t v : t) tree.is_rim[v] = false;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool is_shared =
        (i > 0 && edges[i - 1] == edges[i]) || (i + 1 < edges.size() && edges[i + 1] == edges[i]);
    if (!is_shared) tree.is_rim[edges[i] >> 32] = tree.is_rim[edges[i] & 0xFFFFFFFF] = true;
  }
}

void compute_normals(SurfaceTree& tree) {
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

// A triangle's box and twice its middle.
struct Item {
  Box box;
  glm::vec3 centre{0};
  std::uint32_t triangle = 0;
};

struct Builder {
  SurfaceTree& tree;
  std::vector<Item> items;
  float pad = 0;
};

Builder prepare(SurfaceTree& tree) {
  Builder builder{tree, {}, 0};
  double largest = 0;
  for (const glm::dvec3& p : tree.positions)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  builder.pad = static_cast<float>(kPad * largest);
  for (std::uint32_t t = 0; t < tree.triangles.size(); ++t) {
    const auto& [a, b, c] = tree.triangles[t];
    const glm::vec3 p(tree.positions[a]), q(tree.positions[b]), r(tree.positions[c]);
    const Box box{glm::min(p, glm::min(q, r)), glm::max(p, glm::max(q, r))};
    builder.items.push_back({box, box.low + box.high, t});
  }
  return builder;
}

// Puts the lower half of items[first, first + count) along its longest axis first; how many that is.
std::uint32_t split(Builder& builder, std::uint32_t first, std::uint32_t count) {
  const auto begin = builder.items.begin() + first;
  glm::vec3 low(INFINITY), high(-INFINITY);
  for (auto at = begin; at != begin + count; ++at) {
    low = glm::min(low, at->centre);
    high = glm::max(high, at->centre);
  }
  const glm::vec3 size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  std::nth_element(begin, begin + count / 2, begin + count, [&](const Item& a, const Item& b) {
    return a.centre[axis] != b.centre[axis] ? a.centre[axis] < b.centre[axis] : a.triangle < b.triangle;
  });
  return count / 2;
}

// A node for items[first, first + count), count at least 1; its index.
std::uint32_t build_node(Builder& builder, std::uint32_t first, std::uint32_t count) {
  const auto index = static_cast<std::uint32_t>(builder.tree.nodes.size());
  builder.tree.nodes.emplace_back();
  const std::uint32_t half = count > 1 ? split(builder, first, count) : 0;
  const std::uint32_t quarter = half > 1 ? split(builder, first, half) : 0;
  const std::uint32_t rest = count - half > 1 ? split(builder, first + half, count - half) : 0;
  const std::array<std::uint32_t, 5> ends{first, first + quarter, first + half, first + half + rest,
                                          first + count};
  for (int i = 0; i < 4; ++i) {
    Box box{glm::vec3(INFINITY), glm::vec3(-INFINITY)};
    for (std::uint32_t at = ends[i]; at < ends[i + 1]; ++at) {
      const Box& inner = builder.items[at].box;
      box = {glm::min(box.low, inner.low), glm::max(box.high, inner.high)};
    }
    std::uint32_t child = 0;
    if (ends[i + 1] - ends[i] == 1) child = builder.items[ends[i]].triangle | SurfaceTree::kIsTriangle;
    if (ends[i + 1] - ends[i] > 1) child = build_node(builder, ends[i], ends[i + 1] - ends[i]);
    SurfaceTree::Node& node = builder.tree.nodes[index];
    for (int axis = 0; axis < 3; ++axis) {
      node.low[axis][i] = box.low[axis] - builder.pad;
      node.high[axis][i] = box.high[axis] + builder.pad;
    }
    node.children[i] = child;
  }
  return index;
}

// Barycentric coordinates of the place of triangle a b c that is nearest to p.
glm::dvec3 compute_nearest_barycentric(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
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

struct Spot {
  Float4 x, y, z;  // four times the same
};

Spot spread(const glm::dvec3& p) {
  const glm::vec3 q(p);
  return {Float4{q.x, q.x, q.x, q.x}, Float4{q.y, q.y, q.y, q.y}, Float4{q.z, q.z, q.z, q.z}};
}

// At most the squares of the distances to what is inside the four boxes.
Float4 compute_square_distances(const SurfaceTree::Node& node, const Spot& p) {
  const auto outside = [](const Float4& low, const Float4& high, const Float4& at) {
    const Float4 below = low - at, above = at - high, most = below > above ? below : above;
    return most > 0.0f ? most : Float4{};
  };
  const Float4 x = outside(node.low[0], node.high[0], p.x), y = outside(node.low[1], node.high[1], p.y),
               z = outside(node.low[2], node.high[2], p.z);
  return kShorter * (x * x + y * y + z * z);
}

// What is still to be looked at, what was added last first: a tree of millions is a dozen levels deep.
struct Open {
  float square = 0;
  std::uint32_t child = 0;
};
using OpenList = std::array<Open, 64>;

// Adds the children that are nearer than `least`, the nearest last.
void add_children(const SurfaceTree::Node& node, const Float4& squares, double least, OpenList& open,
                  std::size_t& count) {
  const std::size_t first = count;
  for (int i = 0; i < 4; ++i) {
    if (!(squares[i] <= least) || std::isinf(node.low[0][i])) continue;
    std::size_t at = count++;
    for (; at > first && open[at - 1].square < squares[i]; --at) open[at] = open[at - 1];
    open[at] = {squares[i], node.children[i]};
  }
}

}  // namespace

SurfaceTree build_surface_tree(std::vector<glm::dvec3> positions, std::vector<Triangle> triangles) {
  SurfaceTree tree;
  tree.positions = std::move(positions);
  tree.triangles = std::move(triangles);
  leave_out_flat(tree);
  compute_rims(tree);
  compute_normals(tree);
  Builder builder = prepare(tree);
  if (!tree.triangles.empty()) build_node(builder, 0, static_cast<std::uint32_t>(tree.triangles.size()));
  return tree;
}

NearestPlace find_nearest(const SurfaceTree& tree, const glm::dvec3& point, double reach) {
  NearestPlace best;
  if (tree.nodes.empty()) return best;
  double least = reach * reach;
  std::uint32_t triangle = 0;
  glm::dvec3 share{0};
  const Spot spot = spread(point);
  OpenList open;  // begins with the root
  std::size_t count = 1;
  while (count > 0) {
    const auto [distance, child] = open[--count];
    if (distance > least) continue;
    if (!(child & SurfaceTree::kIsTriangle)) {
      const SurfaceTree::Node& node = tree.nodes[child];
      add_children(node, compute_square_distances(node, spot), least, open, count);
      continue;
    }
    const std::uint32_t index = child & ~SurfaceTree::kIsTriangle;
    const Triangle& t = tree.triangles[index];
    const glm::dvec3 &a = tree.positions[t[0]], &b = tree.positions[t[1]], &c = tree.positions[t[2]];
    const glm::dvec3 at = compute_nearest_barycentric(point, a, b, c);
    const glm::dvec3 place = at.x * a + at.y * b + at.z * c, way = place - point;
    const double square = glm::dot(way, way);
    if (square > least || (square == least && best.distance < 1e9)) continue;
    least = square;
    best.point = place;
    best.distance = 0;
    triangle = index;
    share = at;
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
  if (tree.nodes.empty()) return false;
  const Spot spot = spread(point);
  OpenList open;  // begins with the root
  std::size_t count = 1;
  while (count > 0) {
    const std::uint32_t child = open[--count].child;
    if (!(child & SurfaceTree::kIsTriangle)) {
      const SurfaceTree::Node& node = tree.nodes[child];
      add_children(node, compute_square_distances(node, spot), square, open, count);
      continue;
    }
    const Triangle& t = tree.triangles[child & ~SurfaceTree::kIsTriangle];
    const glm::dvec3 &a = tree.positions[t[0]], &b = tree.positions[t[1]], &c = tree.positions[t[2]];
    const glm::dvec3 at = compute_nearest_barycentric(point, a, b, c);
    const glm::dvec3 way = at.x * a + at.y * b + at.z * c - point;
    if (glm::dot(way, way) < square) return true;
  }
  return false;
}

}  // namespace mien

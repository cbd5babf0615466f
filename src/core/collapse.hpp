// What collapsing edges takes, whoever decides which ones (simplify.hpp, thin.hpp): quadrics, the triangles
// around each vertex, and what must not happen to a surface. Garland and Heckbert, "Surface simplification
// using quadric error metrics" (1997).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/mesh.hpp"

namespace mien {

// The sum of squared distances of a point from planes, each times its weight: p'Ap - 2b'p + c.
struct Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;  // A, which is symmetric
  glm::dvec3 b{0};
  double c = 0;

  // The plane normal . p = offset.
  void add_plane(const glm::dvec3& normal, double offset, double weight);
  void add(const Quadric& other);
  double measure(const glm::dvec3& p) const;
  glm::dmat3 build_matrix() const { return {xx, xy, xz, xy, yy, yz, xz, yz, zz}; }
};

// Triangles of which some are gone.
struct CollapseNet {
  std::vector<Triangle> triangles;
  std::vector<bool> is_alive;                      // a triangle
  std::vector<std::vector<std::uint32_t>> around;  // the living triangles of a vertex
  std::size_t alive = 0;
};

// All alive; `count` vertices.
CollapseNet build_collapse_net(std::vector<Triangle> triangles, std::size_t count);

// The vertices around `v`, into `found`, in ascending order.
void list_neighbours(const CollapseNet& net, std::uint32_t v, std::vector<std::uint32_t>& found);

// Whether the two ends of an edge may become one: it is one, exactly two vertices neighbour both (the link
// condition), and it is not a tetrahedron's. `rings` become the neighbours of `drop` and of `keep`.
bool keeps_surface(const CollapseNet& net, std::uint32_t drop, std::uint32_t keep,
                   std::array<std::vector<std::uint32_t>, 2>& rings);

// The triangles of `drop` become `keep`'s, but those between the two, which are gone.
void join_vertices(CollapseNet& net, std::uint32_t drop, std::uint32_t keep);

// The vertices on edges that are not used once in each direction; of `count` vertices.
std::vector<bool> compute_open_vertices(const std::vector<Triangle>& triangles, std::size_t count);

// Twice a triangle's area along its normal.
template <typename Vector>
Vector find_area_vector(const Vector& a, const Vector& b, const Vector& c) {
  return glm::cross(b - a, c - a);
}

// Whether a triangle keeps its side, and a sound shape: twice its area over its longest side squared is not
// below `slender` (0: any), as needles print as lines.
template <typename Vector>
bool keeps_triangle(const std::array<Vector, 3>& now, const std::array<Vector, 3>& then,
                    typename Vector::value_type slender) {
  using Number = typename Vector::value_type;
  constexpr Number kTurn = Number(0.5);  // cosine of the most that a triangle may turn
  const Vector before = find_area_vector(now[0], now[1], now[2]);
  const Vector after = find_area_vector(then[0], then[1], then[2]);
  const Number area = glm::length(after);
  if (area == 0 || glm::dot(before, after) < kTurn * glm::length(before) * area) return false;
  if (slender == 0) return true;
  Number longest = 0;
  for (int i = 0; i < 3; ++i) longest = std::max(longest, glm::distance(then[i], then[(i + 1) % 3]));
  return area >= slender * longest * longest;
}

}  // namespace mien

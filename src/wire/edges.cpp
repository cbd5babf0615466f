#include "wire/edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/conventions.hpp"

namespace mien {

namespace {

// The edges of one pen, by their ends, as lines: from each end that one edge or more than two share, then
// what is left, which goes round.
struct Chains {
  const WireSolid& solid;
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::vector<std::uint32_t>> at;  // of each vertex, its edges

  explicit Chains(const WireSolid& solid_) : solid(solid_), at(solid_.positions.size()) {}

  void add(std::uint32_t from, std::uint32_t to) {
    at[from].push_back(static_cast<std::uint32_t>(edges.size()));
    at[to].push_back(static_cast<std::uint32_t>(edges.size()));
    edges.push_back({from, to});
  }

  void append_line(std::uint32_t first_edge, std::uint32_t from, Pen pen, std::vector<bool>& is_used,
                   std::vector<WireLine>& lines) const {
    WireLine line{{solid.positions[from]}, pen};
    std::optional<std::uint32_t> edge = first_edge;
    while (edge) {
      is_used[*edge] = true;
      from = edges[*edge][0] == from ? edges[*edge][1] : edges[*edge][0];
      line.points.push_back(solid.positions[from]);
      edge.reset();
      if (at[from].size() == 2)
        for (const std::uint32_t next : at[from])
          if (!is_used[next]) edge = next;
    }
    lines.push_back(std::move(line));
  }

  void append_lines(Pen pen, std::vector<WireLine>& lines) const {
    std::vector<bool> is_used(edges.size(), false);
    for (std::uint32_t e = 0; e < edges.size(); ++e)
      for (const std::uint32_t end : edges[e])
        if (!is_used[e] && at[end].size() != 2) append_line(e, end, pen, is_used, lines);
    for (std::uint32_t e = 0; e < edges.size(); ++e)
      if (!is_used[e]) append_line(e, edges[e][0], pen, is_used, lines);
  }
};

glm::dvec3 find_normal(const WireSolid& solid, std::uint32_t triangle) {
  const auto& [a, b, c] = solid.triangles[triangle];
  const glm::dvec3 p(solid.positions[a]);
  return glm::cross(glm::dvec3(solid.positions[b]) - p, glm::dvec3(solid.positions[c]) - p);
}

}  // namespace

std::vector<WireEdge> list_edges(const std::vector<Triangle>& triangles) {
  struct Use {
    std::uint32_t low, high, triangle;
  };
  std::vector<Use> uses;
  uses.reserve(triangles.size() * 3);
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = triangles[t][i], b = triangles[t][(i + 1) % 3];
      uses.push_back({std::min(a, b), std::max(a, b), t});
    }
  std::ranges::sort(uses, [](const Use& a, const Use& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  std::vector<WireEdge> edges;
  for (const Use& use : uses) {
    if (edges.empty() || edges.back().from != use.low || edges.back().to != use.high)
      edges.push_back({use.low, use.high, use.triangle, WireEdge::kNone});
    else if (edges.back().right == WireEdge::kNone)
      edges.back().right = use.triangle;
  }
  return edges;
}

std::vector<WireLine> list_edge_lines(const WireSolid& solid, const std::vector<WireEdge>& edges,
                                      const WireCamera& camera) {
  std::vector<glm::dvec3> normals(solid.triangles.size());
  std::vector<bool> is_facing(solid.triangles.size());
  for (std::uint32_t t = 0; t < normals.size(); ++t) {
    const glm::dvec3 normal = find_normal(solid, t);
    const double length = glm::length(normal);
    normals[t] = length > 0 ? normal / length : glm::dvec3(0);
    is_facing[t] =
        glm::dot(normal, find_way_to(camera, glm::dvec3(solid.positions[solid.triangles[t][0]]))) > 0;
  }
  const double sharp = std::cos(solid.sharp_deg * kRadiansPerDegree);
  Chains contours(solid), borders(solid), creases(solid);
  for (const WireEdge& edge : edges) {
    if (edge.right == WireEdge::kNone) {
      if (solid.has_contour) borders.add(edge.from, edge.to);
    } else if (is_facing[edge.left] != is_facing[edge.right]) {
      if (solid.has_contour) contours.add(edge.from, edge.to);
    } else if (solid.sharp_deg < 180 && glm::dot(normals[edge.left], normals[edge.right]) < sharp) {
      creases.add(edge.from, edge.to);
    }
  }
  std::vector<WireLine> lines;
  contours.append_lines(Pen::contour, lines);
  borders.append_lines(Pen::border, lines);
  creases.append_lines(Pen::crease, lines);
  return lines;
}

}  // namespace mien

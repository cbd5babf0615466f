#include "core/mesh.hpp"

#include <algorithm>
#include <utility>

namespace mien {

Box compute_bounds(const std::vector<glm::vec3>& positions) {
  if (positions.empty()) return {};
  Box box{positions.front(), positions.front()};
  for (const glm::vec3& p : positions) {
    box.low = glm::min(box.low, p);
    box.high = glm::max(box.high, p);
  }
  return box;
}

void update_normals(Mesh& mesh) {
  mesh.normals.assign(mesh.positions.size(), glm::vec3(0));
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::vec3 area =
        glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    mesh.normals[a] += area;
    mesh.normals[b] += area;
    mesh.normals[c] += area;
  }
  for (glm::vec3& n : mesh.normals) {
    const float length = glm::length(n);
    n = length > 0 ? n / length : glm::vec3(0, 0, 1);
  }
}

std::size_t count_open_edges(const std::vector<Triangle>& triangles) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(triangles.size() * 3);
  for (const Triangle& t : triangles)
    for (int i = 0; i < 3; ++i) edges.emplace_back(t[i], t[(i + 1) % 3]);
  std::sort(edges.begin(), edges.end());

  std::size_t open = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool doubled =
        (i > 0 && edges[i - 1] == edges[i]) || (i + 1 < edges.size() && edges[i + 1] == edges[i]);
    const std::pair back{edges[i].second, edges[i].first};
    if (doubled || !std::binary_search(edges.begin(), edges.end(), back)) ++open;
  }
  return open;
}

double compute_volume_mm3(const Mesh& mesh) {
  double six_volumes = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::dvec3 p(mesh.positions[a]), q(mesh.positions[b]), r(mesh.positions[c]);
    six_volumes += glm::dot(p, glm::cross(q, r));
  }
  return six_volumes / 6;
}

void append_mesh(Mesh& mesh, const Mesh& addition) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), addition.positions.begin(), addition.positions.end());
  mesh.normals.insert(mesh.normals.end(), addition.normals.begin(), addition.normals.end());
  for (const auto& [a, b, c] : addition.triangles)
    mesh.triangles.push_back({a + first, b + first, c + first});
}

}  // namespace mien

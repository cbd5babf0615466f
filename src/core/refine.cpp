#include "core/refine.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace mien {

namespace {

constexpr float kRoundness = 0.75f;  // the paper's choice: 0 keeps facets flat, 1 bulges

glm::vec3 project(const glm::vec3& p, const glm::vec3& on, const glm::vec3& normal) {
  return p - glm::dot(p - on, normal) * normal;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

Edge order_edge(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

// The new vertex in the middle of each edge that is split.
std::map<Edge, std::uint32_t> split_edges(Mesh& mesh, std::vector<bool>& marks) {
  std::map<Edge, std::uint32_t> middles;
  for (const Triangle& t : mesh.triangles) {
    if (!marks[t[0]] && !marks[t[1]] && !marks[t[2]]) continue;
    for (int i = 0; i < 3; ++i) middles.emplace(order_edge(t[i], t[(i + 1) % 3]), 0);
  }
  for (auto& [edge, middle] : middles) {
    const auto [a, b] = edge;
    const glm::vec3 normal = mesh.normals[a] + mesh.normals[b];
    middle = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(
        compute_middle(mesh.positions[a], mesh.positions[b], mesh.normals[a], mesh.normals[b]));
    mesh.normals.push_back(glm::length(normal) > 0 ? glm::normalize(normal) : mesh.normals[a]);
    marks.push_back(marks[a] && marks[b]);
  }
  return middles;
}

// The triangle with some of its edges split: the corners and middles in order are cut into triangles.
void append_split(std::vector<Triangle>& out, const Triangle& t,
                  const std::array<std::optional<std::uint32_t>, 3>& middle) {
  const int count = int(middle[0].has_value()) + int(middle[1].has_value()) + int(middle[2].has_value());
  if (count == 0) return out.push_back(t);
  if (count == 3) {
    for (int i = 0; i < 3; ++i) out.push_back({t[i], *middle[i], *middle[(i + 2) % 3]});
    return out.push_back({*middle[0], *middle[1], *middle[2]});
  }
  int first = 0;  // with one split edge: that one; with two: the one whose next edge is split as well
  while (!middle[first] || (count == 2 && !middle[(first + 1) % 3])) ++first;
  const std::uint32_t a = t[first], b = t[(first + 1) % 3], c = t[(first + 2) % 3], ab = *middle[first];
  out.push_back({a, ab, c});
  if (count == 1) return out.push_back({ab, b, c});
  const std::uint32_t bc = *middle[(first + 1) % 3];
  out.push_back({ab, b, bc});
  out.push_back({ab, bc, c});
}

}  // namespace

glm::vec3 compute_middle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& normal_a,
                         const glm::vec3& normal_b) {
  const glm::vec3 flat = 0.5f * (a + b);
  return glm::mix(flat, 0.5f * (project(flat, a, normal_a) + project(flat, b, normal_b)), kRoundness);
}

std::vector<std::array<std::uint32_t, 2>> refine_marked(Mesh& mesh, std::vector<bool>& marks) {
  const std::map<Edge, std::uint32_t> middles = split_edges(mesh, marks);
  std::vector<bool> is_end(mesh.positions.size(), false);  // of a split edge
  for (const auto& [edge, middle] : middles) is_end[edge.first] = is_end[edge.second] = true;
  std::vector<Triangle> triangles;
  for (const Triangle& t : mesh.triangles) {
    std::array<std::optional<std::uint32_t>, 3> middle;
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      if (!is_end[a] || !is_end[b]) continue;
      if (const auto found = middles.find(order_edge(a, b)); found != middles.end())
        middle[i] = found->second;
    }
    append_split(triangles, t, middle);
  }
  mesh.triangles = std::move(triangles);
  std::vector<std::array<std::uint32_t, 2>> ends;  // the map's order is that of the new vertices
  for (const auto& [edge, middle] : middles) ends.push_back({edge.first, edge.second});
  return ends;
}

}  // namespace mien

#include "core/simplify.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <queue>
#include <vector>

#include "core/collapse.hpp"

namespace mien {

namespace {

// A collapse that was worth its cost when both ends had these versions.
struct Collapse {
  double cost = 0;
  std::uint32_t keep = 0, drop = 0, keep_version = 0, drop_version = 0;
  glm::dvec3 place{0};

  // For a queue with the cheapest on top; ties by index, so that the order never depends on the library.
  bool operator<(const Collapse& other) const {
    if (cost != other.cost) return cost > other.cost;
    return std::pair{keep, drop} > std::pair{other.keep, other.drop};
  }
};

struct Simplifier {
  std::vector<glm::dvec3> positions;
  CollapseNet net;
  std::vector<Quadric> quadrics;
  std::vector<std::uint32_t> version;
  std::vector<bool> is_fixed;  // a vertex that stays, such as those on open edges
  std::priority_queue<Collapse> queue;
  double tolerance_mm = 0;
  std::array<std::vector<std::uint32_t>, 2> rings;  // of one call
};

void push_collapse(Simplifier& s, std::uint32_t v, std::uint32_t w) {
  constexpr double kPull = 1e-3;   // toward the middle: decides where the planes leave the place open
  constexpr double kShort = 1e-6;  // of the squared length: among equals the shortest edge goes first
  const std::uint32_t keep = std::min(v, w), drop = std::max(v, w);
  if (s.is_fixed[keep] && s.is_fixed[drop]) return;
  const glm::dvec3 along = s.positions[keep] - s.positions[drop];
  const double square = glm::dot(along, along);
  Quadric sum = s.quadrics[keep];
  sum.add(s.quadrics[drop]);
  const glm::dvec3 middle = 0.5 * (s.positions[keep] + s.positions[drop]);
  const glm::dmat3 planes = sum.build_matrix();
  glm::dvec3 place = glm::inverse(planes + glm::dmat3(kPull)) * (sum.b + kPull * middle);
  if (s.is_fixed[keep]) place = s.positions[keep];
  if (s.is_fixed[drop]) place = s.positions[drop];
  const double error = std::max(0.0, glm::dot(place, planes * place) - 2 * glm::dot(sum.b, place) + sum.c);
  if (error > s.tolerance_mm * s.tolerance_mm) return;
  s.queue.push({error + kShort * square, keep, drop, s.version[keep], s.version[drop], place});
}

// Whether the triangles of `moved` that `other` has no part in keep their side and a sound shape at the new
// place.
bool keeps_shape(const Simplifier& s, std::uint32_t moved, std::uint32_t other, const glm::dvec3& place) {
  constexpr double kSlender = 0.08;
  for (const std::uint32_t t : s.net.around[moved]) {
    const Triangle& corners = s.net.triangles[t];
    if (std::find(corners.begin(), corners.end(), other) != corners.end()) continue;
    std::array<glm::dvec3, 3> now, then;
    for (int i = 0; i < 3; ++i) {
      now[i] = s.positions[corners[i]];
      then[i] = corners[i] == moved ? place : now[i];
    }
    if (!keeps_triangle(now, then, kSlender)) return false;
  }
  return true;
}

void collapse(Simplifier& s, const Collapse& c) {
  s.positions[c.keep] = c.place;
  s.quadrics[c.keep].add(s.quadrics[c.drop]);
  s.is_fixed[c.keep] = s.is_fixed[c.keep] || s.is_fixed[c.drop];
  join_vertices(s.net, c.drop, c.keep);
  ++s.version[c.keep];
  ++s.version[c.drop];
  list_neighbours(s.net, c.keep, s.rings[0]);
  for (const std::uint32_t v : s.rings[0]) push_collapse(s, c.keep, v);
}

Simplifier build_simplifier(const Mesh& mesh, double tolerance_mm) {
  Simplifier s;
  s.tolerance_mm = tolerance_mm;
  s.positions.assign(mesh.positions.begin(), mesh.positions.end());
  s.net = build_collapse_net(mesh.triangles, mesh.positions.size());
  s.quadrics.resize(mesh.positions.size());
  s.version.resize(mesh.positions.size());
  s.is_fixed = compute_open_vertices(mesh.triangles, mesh.positions.size());
  for (const Triangle& t : s.net.triangles) {
    const auto& [a, b, c] = t;
    const glm::dvec3 area = find_area_vector(s.positions[a], s.positions[b], s.positions[c]);
    if (area == glm::dvec3(0)) continue;
    const glm::dvec3 normal = glm::normalize(area);
    for (const std::uint32_t v : t) s.quadrics[v].add_plane(normal, glm::dot(normal, s.positions[a]), 1);
  }
  for (const Triangle& t : s.net.triangles)
    for (int i = 0; i < 3; ++i)
      if (t[i] < t[(i + 1) % 3]) push_collapse(s, t[i], t[(i + 1) % 3]);
  return s;
}

Mesh build_mesh(const Simplifier& s) {
  constexpr std::uint32_t kUnused = UINT32_MAX;
  Mesh mesh;
  std::vector<std::uint32_t> new_index(s.positions.size(), kUnused);
  for (std::size_t t = 0; t < s.net.triangles.size(); ++t) {
    if (!s.net.is_alive[t]) continue;
    Triangle corners = s.net.triangles[t];
    for (std::uint32_t& v : corners) {
      if (new_index[v] == kUnused) {
        new_index[v] = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.emplace_back(s.positions[v]);
      }
      v = new_index[v];
    }
    mesh.triangles.push_back(corners);
  }
  return mesh;
}

void run_collapses(Simplifier& s) {
  while (!s.queue.empty()) {
    const Collapse next = s.queue.top();
    s.queue.pop();
    if (s.version[next.keep] != next.keep_version || s.version[next.drop] != next.drop_version) continue;
    if (keeps_surface(s.net, next.drop, next.keep, s.rings) &&
        keeps_shape(s, next.keep, next.drop, next.place) && keeps_shape(s, next.drop, next.keep, next.place))
      collapse(s, next);
  }
}

}  // namespace

void simplify_mesh(Mesh& mesh, double tolerance_mm) {
  Simplifier s = build_simplifier(mesh, tolerance_mm);
  run_collapses(s);
  mesh = build_mesh(s);
}

}  // namespace mien

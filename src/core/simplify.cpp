#include "core/simplify.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <queue>
#include <set>
#include <vector>

namespace mien {

namespace {

// The sum of squared distances of a point from planes: p'Ap - 2b'p + c.
struct Quadric {
  glm::dmat3 a{0};
  glm::dvec3 b{0};
  double c = 0;

  void add_plane(const glm::dvec3& normal, double offset) {  // normal . p = offset
    a += glm::outerProduct(normal, normal);
    b += offset * normal;
    c += offset * offset;
  }
  void add(const Quadric& other) {
    a += other.a;
    b += other.b;
    c += other.c;
  }
  double measure(const glm::dvec3& p) const {
    return std::max(0.0, glm::dot(p, a * p) - 2 * glm::dot(b, p) + c);
  }
};

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
  std::vector<Triangle> triangles;
  std::vector<bool> is_alive;                      // a triangle
  std::vector<std::vector<std::uint32_t>> around;  // the triangles of a vertex, dead ones among them
  std::vector<Quadric> quadrics;
  std::vector<std::uint32_t> version;
  std::vector<bool> is_fixed;  // a vertex that stays, such as those on open edges
  std::priority_queue<Collapse> queue;
  double tolerance_mm = 0;
};

glm::dvec3 find_area_vector(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::cross(b - a, c - a);
}

std::set<std::uint32_t> list_neighbours(const Simplifier& s, std::uint32_t v) {
  std::set<std::uint32_t> found;
  for (const std::uint32_t t : s.around[v])
    if (s.is_alive[t]) found.insert(s.triangles[t].begin(), s.triangles[t].end());
  found.erase(v);
  return found;
}

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
  glm::dvec3 place = glm::inverse(sum.a + glm::dmat3(kPull)) * (sum.b + kPull * middle);
  if (s.is_fixed[keep]) place = s.positions[keep];
  if (s.is_fixed[drop]) place = s.positions[drop];
  const double error = sum.measure(place);
  if (error > s.tolerance_mm * s.tolerance_mm) return;
  s.queue.push({error + kShort * square, keep, drop, s.version[keep], s.version[drop], place});
}

// Whether the triangles of `moved` that `other` has no part in keep their side and a sound shape at the new
// place.
bool keeps_shape(const Simplifier& s, std::uint32_t moved, std::uint32_t other, const glm::dvec3& place) {
  constexpr double kTurn = 0.5;      // cosine of the most that a triangle may turn
  constexpr double kSlender = 0.08;  // twice the area over the longest side squared; needles print as lines
  for (const std::uint32_t t : s.around[moved]) {
    const Triangle& corners = s.triangles[t];
    if (!s.is_alive[t] || std::find(corners.begin(), corners.end(), other) != corners.end()) continue;
    std::array<glm::dvec3, 3> now, then;
    for (int i = 0; i < 3; ++i) {
      now[i] = s.positions[corners[i]];
      then[i] = corners[i] == moved ? place : now[i];
    }
    const glm::dvec3 before = find_area_vector(now[0], now[1], now[2]);
    const glm::dvec3 after = find_area_vector(then[0], then[1], then[2]);
    const double area = glm::length(after);
    if (glm::dot(before, after) < kTurn * glm::length(before) * area || area == 0) return false;
    double longest = 0;
    for (int i = 0; i < 3; ++i) longest = std::max(longest, glm::length(then[i] - then[(i + 1) % 3]));
    if (area < kSlender * longest * longest) return false;
  }
  return true;
}

// Two ends of an edge may become one only if exactly two vertices neighbour both (the link condition).
bool keeps_surface(const Simplifier& s, const Collapse& c) {
  const std::set<std::uint32_t> keep = list_neighbours(s, c.keep), drop = list_neighbours(s, c.drop);
  std::size_t common = 0;
  for (const std::uint32_t v : drop) common += keep.count(v);
  return keep.contains(c.drop) && common == 2 &&
         keep.size() + drop.size() > 7;  // not a tetrahedron's last edge
}

void collapse(Simplifier& s, const Collapse& c) {
  s.positions[c.keep] = c.place;
  s.quadrics[c.keep].add(s.quadrics[c.drop]);
  s.is_fixed[c.keep] = s.is_fixed[c.keep] || s.is_fixed[c.drop];
  for (const std::uint32_t t : s.around[c.drop]) {
    if (!s.is_alive[t]) continue;
    Triangle& corners = s.triangles[t];
    if (std::find(corners.begin(), corners.end(), c.keep) != corners.end()) {
      s.is_alive[t] = false;
      continue;
    }
    std::replace(corners.begin(), corners.end(), c.drop, c.keep);
    s.around[c.keep].push_back(t);
  }
  s.around[c.drop].clear();
  std::erase_if(s.around[c.keep], [&](std::uint32_t t) { return !s.is_alive[t]; });
  ++s.version[c.keep];
  ++s.version[c.drop];
  for (const std::uint32_t v : list_neighbours(s, c.keep)) push_collapse(s, c.keep, v);
}

// The vertices on edges that are not used once in each direction.
std::vector<bool> find_open_vertices(const Mesh& mesh) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) edges.push_back({t[i], t[(i + 1) % 3]});
  std::sort(edges.begin(), edges.end());
  std::vector<bool> is_open(mesh.positions.size(), false);
  for (const auto& [from, to] : edges)
    if (!std::binary_search(edges.begin(), edges.end(), std::array{to, from}))
      is_open[from] = is_open[to] = true;
  return is_open;
}

Simplifier build_simplifier(const Mesh& mesh, double tolerance_mm) {
  Simplifier s;
  s.tolerance_mm = tolerance_mm;
  s.positions.assign(mesh.positions.begin(), mesh.positions.end());
  s.triangles = mesh.triangles;
  s.is_alive.assign(mesh.triangles.size(), true);
  s.around.resize(mesh.positions.size());
  s.quadrics.resize(mesh.positions.size());
  s.version.resize(mesh.positions.size());
  s.is_fixed = find_open_vertices(mesh);
  for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
    const auto& [a, b, c] = s.triangles[t];
    const glm::dvec3 area = find_area_vector(s.positions[a], s.positions[b], s.positions[c]);
    for (const std::uint32_t v : s.triangles[t]) {
      s.around[v].push_back(t);
      if (area == glm::dvec3(0)) continue;
      const glm::dvec3 normal = glm::normalize(area);
      s.quadrics[v].add_plane(normal, glm::dot(normal, s.positions[a]));
    }
  }
  for (const Triangle& t : s.triangles)
    for (int i = 0; i < 3; ++i)
      if (t[i] < t[(i + 1) % 3]) push_collapse(s, t[i], t[(i + 1) % 3]);
  return s;
}

Mesh build_mesh(const Simplifier& s) {
  constexpr std::uint32_t kUnused = UINT32_MAX;
  Mesh mesh;
  std::vector<std::uint32_t> new_index(s.positions.size(), kUnused);
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    if (!s.is_alive[t]) continue;
    Triangle corners = s.triangles[t];
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
    if (keeps_surface(s, next) && keeps_shape(s, next.keep, next.drop, next.place) &&
        keeps_shape(s, next.drop, next.keep, next.place))
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

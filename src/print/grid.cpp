// Marching tetrahedra: Doi and Koide, "An efficient method of triangulating equi-valued surfaces" (1991);
// each cube of the grid is six tetrahedra around its diagonal, so that neighbours always agree (Kuhn 1960).
// The vertices are found as sphere tracing finds them: Hart (1996).
#include "print/grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "core/parallel.hpp"

namespace mien {

namespace {

// Which side of the directed edge a->b of a triangle the point is on, seen from above. Both triangles of an
// edge get the same answer, so that a column goes through exactly one of them.
bool is_left_of(const std::vector<glm::vec3>& positions, std::uint32_t a, std::uint32_t b, double x,
                double y) {
  const bool is_turned = a > b;
  if (is_turned) std::swap(a, b);
  const glm::dvec3 p(positions[a]), q(positions[b]);
  const bool is_left = (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x) > 0;
  return is_left != is_turned;
}

// The corners of a cube by bits: 1 is x, 2 is y, 4 is z. Each path from 0 to 7 is a tetrahedron; the odd
// ones are turned round, so that all have the same sense.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra{
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

struct Marcher {
  const Grid& grid;
  const std::function<double(const glm::dvec3&)>& value_at;
  std::unordered_map<std::uint64_t, std::uint32_t> vertex_of;  // of an edge
  std::vector<std::array<glm::dvec3, 2>> edges;                // from above 0 to not above 0, a vertex each
  std::vector<Triangle> triangles;

  // Corner `bits` of the cube at (i, j, k).
  std::size_t node(const glm::ivec3& at, int bits) const {
    return grid.index(at.x + (bits & 1), at.y + (bits >> 1 & 1), at.z + (bits >> 2));
  }
  glm::dvec3 place(const glm::ivec3& at, int bits) const {
    return grid.place(at.x + (bits & 1), at.y + (bits >> 1 & 1), at.z + (bits >> 2));
  }
  std::uint32_t find_vertex(const glm::ivec3& at, int a, int b) {
    const int low = std::min(a, b), way = a ^ b;  // the corners of a path contain one another
    const auto [found, is_new] =
        vertex_of.try_emplace(node(at, low) * 8 + way, static_cast<std::uint32_t>(edges.size()));
    if (is_new) edges.push_back({place(at, a), place(at, b)});
    return found->second;
  }
  void add_tetrahedron(const glm::ivec3& at, const std::array<int, 4>& corners) {
    std::array<int, 4> in{}, out{};
    int ins = 0, outs = 0;
    for (const int c : corners) (grid.values[node(at, c)] > 0 ? in[ins++] : out[outs++]) = c;
    if (ins == 0 || outs == 0) return;
    std::array<std::uint32_t, 4> v{};
    const int count = ins == 2 ? 4 : 3;
    if (ins == 1)
      for (int i = 0; i < 3; ++i) v[i] = find_vertex(at, in[0], out[i]);
    else if (ins == 3)
      for (int i = 0; i < 3; ++i) v[i] = find_vertex(at, in[i], out[0]);
    else
      v = {find_vertex(at, in[0], out[0]), find_vertex(at, in[0], out[1]), find_vertex(at, in[1], out[1]),
           find_vertex(at, in[1], out[0])};
    // The sense by the corners themselves: the vertices are somewhere on the edges between them.
    glm::dvec3 inner(0), outer(0);
    for (int i = 0; i < ins; ++i) inner += place(at, in[i]) / double(ins);
    for (int i = 0; i < outs; ++i) outer += place(at, out[i]) / double(outs);
    const auto middle = [&](int i) { return (edges[v[i]][0] + edges[v[i]][1]) * 0.5; };
    const glm::dvec3 normal = glm::cross(middle(1) - middle(0), middle(2) - middle(0));
    if (glm::dot(normal, inner - outer) < 0) std::reverse(v.begin(), v.begin() + count);
    triangles.push_back({v[0], v[1], v[2]});
    if (count == 4) triangles.push_back({v[0], v[2], v[3]});
  }
};

// Where the value falls to 0 on the way; never beyond.
glm::dvec3 find_zero(const std::array<glm::dvec3, 2>& edge, double cell_mm,
                     const std::function<double(const glm::dvec3&)>& value_at) {
  constexpr int kSteps = 12;
  const double length = glm::distance(edge[0], edge[1]), close = 0.002 * cell_mm;
  const glm::dvec3 way = (edge[1] - edge[0]) / length;
  // Vertices in one node would make triangles without an area.
  const double least = 0.02 * cell_mm, most = length - least;
  double at = 0;
  for (int i = 0; i < kSteps && at < most; ++i) {
    const double value = value_at(edge[0] + at * way);
    at += std::max(value, 0.0);
    if (value < close) break;
  }
  return edge[0] + std::clamp(at, least, most) * way;
}

}  // namespace

Grid place_grid(const Box& box, double cell_mm) {
  Grid grid;
  grid.cell_mm = cell_mm;
  grid.origin = glm::dvec3(double(box.low.x) - 1.381966 * cell_mm, double(box.low.y) - 1.236068 * cell_mm, 0);
  const glm::dvec3 size = (glm::dvec3(box.high) - grid.origin) / cell_mm;
  grid.count = glm::ivec3(int(size.x) + 3, int(size.y) + 3, int(size.z) + 3);
  return grid;
}

std::vector<std::vector<ColumnCrossing>> list_crossings(const Mesh& solid, const Grid& grid) {
  std::vector<std::vector<ColumnCrossing>> columns(static_cast<std::size_t>(grid.count.x) * grid.count.y);
  for (const auto& [a, b, c] : solid.triangles) {
    const glm::dvec3 p(solid.positions[a]), q(solid.positions[b]), r(solid.positions[c]);
    const glm::dvec3 low = (glm::min(p, glm::min(q, r)) - grid.origin) / grid.cell_mm;
    const glm::dvec3 high = (glm::max(p, glm::max(q, r)) - grid.origin) / grid.cell_mm;
    for (int j = int(std::ceil(low.y)); j <= int(std::floor(high.y)); ++j)
      for (int i = int(std::ceil(low.x)); i <= int(std::floor(high.x)); ++i) {
        const double x = grid.origin.x + grid.cell_mm * i, y = grid.origin.y + grid.cell_mm * j;
        const bool left = is_left_of(solid.positions, a, b, x, y);
        if (is_left_of(solid.positions, b, c, x, y) != left ||
            is_left_of(solid.positions, c, a, x, y) != left)
          continue;
        const glm::dvec3 n = glm::cross(q - p, r - p);
        if (n.z == 0) continue;
        const double z = p.z - (n.x * (x - p.x) + n.y * (y - p.y)) / n.z;
        columns[static_cast<std::size_t>(j) * grid.count.x + i].push_back({z, left ? -1 : 1});
      }
  }
  for (std::vector<ColumnCrossing>& column : columns)
    std::sort(column.begin(), column.end(), [](const ColumnCrossing& a, const ColumnCrossing& b) {
      return a.z != b.z ? a.z < b.z : a.turn < b.turn;
    });
  return columns;
}

Grid build_depth_grid(const Mesh& solid, const SurfaceTree& tree, double cell_mm, double reach_mm) {
  Grid grid = place_grid(find_bounds(solid.positions), cell_mm);
  grid.values.assign(static_cast<std::size_t>(grid.count.x) * grid.count.y * grid.count.z, float(-cell_mm));
  const auto columns = list_crossings(solid, grid);
  for_each_index(static_cast<std::size_t>(grid.count.y), count_cores(), [&](std::size_t row, int) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < grid.count.x; ++i) {
      const std::vector<ColumnCrossing>& column = columns[row * grid.count.x + i];
      std::size_t next = 0;
      int turns = 0;
      for (int k = 0; k < grid.count.z && next < column.size(); ++k) {
        const glm::dvec3 at = grid.place(i, j, k);
        for (; next < column.size() && column[next].z < at.z; ++next) turns += column[next].turn;
        if (turns <= 0) continue;
        const double distance = find_nearest(tree, at, reach_mm).distance;
        grid.values[grid.index(i, j, k)] = float(std::min(distance, reach_mm));
      }
    }
  });
  return grid;
}

Mesh build_level_surface(const Grid& grid, const std::function<double(const glm::dvec3&)>& value_at) {
  Marcher marcher{grid, value_at, {}, {}, {}};
  for (int k = 0; k + 1 < grid.count.z; ++k)
    for (int j = 0; j + 1 < grid.count.y; ++j)
      for (int i = 0; i + 1 < grid.count.x; ++i) {
        int in = 0;
        for (int bits = 0; bits < 8; ++bits) in += grid.values[marcher.node({i, j, k}, bits)] > 0;
        if (in == 0 || in == 8) continue;
        for (const std::array<int, 4>& corners : kTetrahedra) marcher.add_tetrahedron({i, j, k}, corners);
      }
  Mesh mesh;
  mesh.triangles = std::move(marcher.triangles);
  mesh.positions.resize(marcher.edges.size());
  constexpr std::size_t kBlock = 256;
  for_each_index((mesh.positions.size() + kBlock - 1) / kBlock, count_cores(), [&](std::size_t block, int) {
    for (std::size_t v = block * kBlock; v < std::min((block + 1) * kBlock, mesh.positions.size()); ++v)
      mesh.positions[v] = glm::vec3(find_zero(marcher.edges[v], grid.cell_mm, value_at));
  });
  return mesh;
}

}  // namespace mien

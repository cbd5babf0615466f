// Segment against triangle by the signs of tetrahedra's volumes: Ericson, "Real-Time Collision Detection",
// 2005, section 5.3.4. A rounded determinant is believed only where its error cannot change its sign
// (Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates", 1997).
#include "core/crossings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace mien {

namespace {

__extension__ using Wide = __int128;
using Whole = std::array<std::int64_t, 3>;  // a vertex, in grid steps
constexpr double kGrid_mm = 1e-6;
constexpr float kCell = 2;  // of the search grid, in mean sides of a triangle's box

// The sign of the volume of a b c d: six products of three differences of 32 bits are within 128.
int compute_side(const Whole& a, const Whole& b, const Whole& c, const Whole& d) {
  std::array<Whole, 3> e{};
  for (int i = 0; i < 3; ++i) e[0][i] = b[i] - a[i], e[1][i] = c[i] - a[i], e[2][i] = d[i] - a[i];
  const auto sum = [&]<typename Number>(Number) {
    const auto at = [&](int row, int column) { return static_cast<Number>(e[row][column]); };
    return at(0, 0) * (at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1)) +
           at(0, 1) * (at(1, 2) * at(2, 0) - at(1, 0) * at(2, 2)) +
           at(0, 2) * (at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0));
  };
  double bound = 1;
  for (const Whole& row : e)
    bound *= static_cast<double>(std::max({std::abs(row[0]), std::abs(row[1]), std::abs(row[2])}));
  const double rounded = sum(0.0);
  if (std::abs(rounded) > 1e-14 * bound) return rounded > 0 ? 1 : -1;  // 6 products, 5 roundings of 1.1e-16
  const Wide exact = sum(Wide{0});
  return exact > 0 ? 1 : (exact < 0 ? -1 : 0);
}

using Corners = std::array<const Whole*, 3>;

// Whether p and q, on either side of the triangle's plane, are joined through it.
bool is_pierced(const Corners& t, const Whole& p, const Whole& q) {
  int low = 0, high = 0;
  for (int i = 0; i < 3; ++i) {
    const int side = compute_side(p, q, *t[i], *t[(i + 1) % 3]);
    low = std::min(low, side);
    high = std::max(high, side);
  }
  return low == 0 || high == 0;
}

bool has(const Triangle& t, std::uint32_t v) { return v == t[0] || v == t[1] || v == t[2]; }

// Whether an edge of `by` that has no corner of `t` goes through it.
bool is_pierced_by(const std::vector<Whole>& places, const Triangle& t, const Triangle& by) {
  const Corners corners{&places[t[0]], &places[t[1]], &places[t[2]]};
  std::array<int, 3> sides{};
  for (int i = 0; i < 3; ++i)
    sides[i] = has(t, by[i]) ? 0 : compute_side(*corners[0], *corners[1], *corners[2], places[by[i]]);
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3;
    if (sides[i] * sides[next] < 0 && is_pierced(corners, places[by[i]], places[by[next]])) return true;
  }
  return false;
}

bool do_cross(const std::vector<Whole>& places, const Triangle& one, const Triangle& two) {
  if (has(two, one[0]) + has(two, one[1]) + has(two, one[2]) >= 2) return false;
  return is_pierced_by(places, one, two) || is_pierced_by(places, two, one);
}

// The triangles that reach into each cell of a grid over the mesh, cell after cell.
struct Grid {
  glm::vec3 low{0};
  float cell_mm = 1;
  glm::ivec3 size{1};
  std::vector<std::uint32_t> first, triangles;
  std::vector<Box> boxes;  // of each triangle

  glm::ivec3 find_cell(const glm::vec3& p) const { return glm::ivec3((p - low) / cell_mm); }
  std::size_t find_index(const glm::ivec3& cell) const {
    return static_cast<std::size_t>((cell.z * size.y + cell.y) * size.x + cell.x);
  }
  template <typename Use>
  void for_each_cell(const Box& box, const Use& use) const {
    const glm::ivec3 a = find_cell(box.low), b = find_cell(box.high);
    for (int z = a.z; z <= b.z; ++z)
      for (int y = a.y; y <= b.y; ++y)
        for (int x = a.x; x <= b.x; ++x) use(find_index({x, y, z}));
  }
};

Box compute_box(const std::vector<glm::vec3>& positions, const Triangle& t) {
  const glm::vec3 &a = positions[t[0]], &b = positions[t[1]], &c = positions[t[2]];
  return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
}

// Cells of `wished_mm`, or larger ones for a mesh that is wide.
void place_cells(const Box& all, float wished_mm, Grid& grid) {
  constexpr float kMostCells = 256;  // along a side
  const glm::vec3 extent = all.high - all.low;
  grid.low = all.low;
  grid.cell_mm = std::max({wished_mm, std::max({extent.x, extent.y, extent.z}) / kMostCells, 1e-3f});
  grid.size = glm::ivec3(extent / grid.cell_mm) + 1;
}

// With `is_asked`, one for each triangle, only the cells that those reach into are filled.
Grid build_grid(const std::vector<glm::vec3>& positions, const std::vector<Triangle>& triangles,
                const std::vector<bool>& is_asked) {
  Grid grid;
  Box all{glm::vec3(INFINITY), glm::vec3(-INFINITY)};
  float sides_mm = 0;
  for (const Triangle& t : triangles) {
    const Box& box = grid.boxes.emplace_back(compute_box(positions, t));
    all = {glm::min(all.low, box.low), glm::max(all.high, box.high)};
    const glm::vec3 extent = box.high - box.low;
    sides_mm += (extent.x + extent.y + extent.z) / 3;
  }
  place_cells(all, kCell * sides_mm / float(triangles.size()), grid);
  const std::size_t cells = static_cast<std::size_t>(grid.size.x) * grid.size.y * grid.size.z;
  std::vector<char> is_filled(cells, is_asked.empty());
  for (std::uint32_t t = 0; t < is_asked.size(); ++t)
    if (is_asked[t]) grid.for_each_cell(grid.boxes[t], [&](std::size_t cell) { is_filled[cell] = 1; });
  grid.first.assign(cells + 1, 0);
  for (const Box& box : grid.boxes)
    grid.for_each_cell(box, [&](std::size_t cell) { grid.first[cell + 1] += is_filled[cell]; });
  for (std::size_t i = 1; i < grid.first.size(); ++i) grid.first[i] += grid.first[i - 1];
  grid.triangles.resize(grid.first.back());
  std::vector<std::uint32_t> next = grid.first;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    grid.for_each_cell(grid.boxes[t], [&](std::size_t cell) {
      if (is_filled[cell]) grid.triangles[next[cell]++] = t;
    });
  return grid;
}

}  // namespace

std::vector<Crossing> find_crossings(const std::vector<glm::vec3>& positions,
                                     const std::vector<Triangle>& triangles,
                                     const std::vector<bool>& is_asked) {
  if (triangles.empty()) return {};
  std::vector<Whole> places;
  for (const glm::vec3& p : positions) {
    Whole place{};
    for (int i = 0; i < 3; ++i) place[i] = std::llround(static_cast<double>(p[i]) / kGrid_mm);
    places.push_back(place);
  }
  const Grid grid = build_grid(positions, triangles, is_asked);
  std::vector<Crossing> crossings;
  for (std::size_t cell = 0; cell + 1 < grid.first.size(); ++cell)
    for (std::uint32_t i = grid.first[cell]; i < grid.first[cell + 1]; ++i)
      for (std::uint32_t j = i + 1; j < grid.first[cell + 1]; ++j) {
        const std::uint32_t one = grid.triangles[i], two = grid.triangles[j];
        if (!is_asked.empty() && !is_asked[one] && !is_asked[two]) continue;
        const Box &a = grid.boxes[one], &b = grid.boxes[two];
        if (a.low.x > b.high.x || b.low.x > a.high.x || a.low.y > b.high.y || b.low.y > a.high.y ||
            a.low.z > b.high.z || b.low.z > a.high.z)
          continue;
        if (grid.find_index(grid.find_cell(glm::max(a.low, b.low))) != cell)
          continue;  // one cell of those they share
        if (do_cross(places, triangles[one], triangles[two])) crossings.push_back({one, two});
      }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

std::vector<glm::vec3> list_crossed_places(const std::vector<glm::vec3>& positions,
                                           const std::vector<Triangle>& triangles,
                                           const std::vector<Crossing>& crossings) {
  std::vector<glm::vec3> places;
  for (const auto& [one, two] : crossings) {
    const Box a = compute_box(positions, triangles[one]), b = compute_box(positions, triangles[two]);
    places.push_back(0.5f * (glm::max(a.low, b.low) + glm::min(a.high, b.high)));
  }
  return places;
}

}  // namespace mien

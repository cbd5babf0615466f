#include "print/grid.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace mien

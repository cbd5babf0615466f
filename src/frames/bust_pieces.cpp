#include "frames/bust_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "core/holes.hpp"

namespace mien {

namespace {

constexpr float kCell_mm = 2;  // of the grid that rays look their triangles up in: about a triangle's size
constexpr double kFlat_mm3 = 0.01;  // a piece of less volume is a sheet

std::array<int, 2> find_cell(float x, float z) {
  return {int(std::floor(x / kCell_mm)), int(std::floor(z / kCell_mm))};
}

// The triangles over each cell of the x-z plane.
std::map<std::array<int, 2>, std::vector<Triangle>> build_columns(const Mesh& mesh) {
  std::map<std::array<int, 2>, std::vector<Triangle>> columns;
  for (const Triangle& t : mesh.triangles) {
    const glm::vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const auto low = find_cell(std::min({a.x, b.x, c.x}), std::min({a.z, b.z, c.z}));
    const auto high = find_cell(std::max({a.x, b.x, c.x}), std::max({a.z, b.z, c.z}));
    for (int x = low[0]; x <= high[0]; ++x)
      for (int z = low[1]; z <= high[1]; ++z) columns[{x, z}].push_back(t);
  }
  return columns;
}

// Whether the ray from `p` along +y meets the triangle.
bool is_hit(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const auto side = [&](const glm::dvec3& from, const glm::dvec3& to) {
    return (to.x - from.x) * (p.z - from.z) - (to.z - from.z) * (p.x - from.x);
  };
  const double u = side(b, c), v = side(c, a), w = side(a, b);
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return false;
  const double area = u + v + w;
  return area != 0 && (u * a.y + v * b.y + w * c.y) / area > p.y;
}

}  // namespace

std::vector<bool> find_inside(const Mesh& mesh, const std::vector<glm::vec3>& points) {
  const auto columns = build_columns(mesh);
  std::vector<bool> is_inside(points.size(), false);
  for (std::size_t i = 0; i < points.size(); ++i) {
    // Off by an odd little step, so that the ray of a point on the mid-plane misses the mid-plane's edges.
    const glm::dvec3 p(points[i].x + 1.37e-4, points[i].y, points[i].z + 2.11e-4);
    const auto column = columns.find(find_cell(float(p.x), float(p.z)));
    if (column == columns.end()) continue;
    for (const auto& [a, b, c] : column->second)
      if (is_hit(p, glm::dvec3(mesh.positions[a]), glm::dvec3(mesh.positions[b]),
                 glm::dvec3(mesh.positions[c])))
        is_inside[i] = !is_inside[i];
  }
  return is_inside;
}

void append_pieces(std::vector<Solid>& solids, const std::string& name, const Mesh& mesh) {
  std::vector<Mesh> pieces = split_pieces(mesh);
  for (Mesh& piece : pieces) {
    close_holes(piece);
    if (compute_volume_mm3(piece) < 0)
      for (Triangle& t : piece.triangles) std::swap(t[1], t[2]);
  }
  std::erase_if(pieces, [](const Mesh& piece) { return compute_volume_mm3(piece) < kFlat_mm3; });
  for (std::size_t i = 0; i < pieces.size(); ++i)
    solids.push_back({pieces.size() == 1 ? name : fmt::format("{}_{}", name, i + 1), std::move(pieces[i])});
}

void keep_showing(std::vector<Solid>& solids, const Mesh& skin) {
  std::erase_if(solids, [&](const Solid& solid) {
    const std::vector<bool> inside = find_inside(skin, solid.mesh.positions);
    const auto count = std::count(inside.begin(), inside.end(), true);
    return count == 0 || count == std::ssize(inside);
  });
}

}  // namespace mien

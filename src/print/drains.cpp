#include "print/drains.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/error.hpp"
#include "print/solid_tree.hpp"

namespace mien {

namespace {

constexpr double kInto = 0.3;  // of a cell, into the cavity: past the node that is in it already

// Nodes of the largest connected hollow.
std::vector<bool> find_largest(const Grid& depth, double wall_mm) {
  std::vector<std::uint32_t> piece(depth.values.size(), 0);
  std::uint32_t pieces = 0, largest = 0;
  std::size_t most = 0;
  const std::size_t row = depth.count.x, layer = row * depth.count.y;
  for (std::size_t first = 0; first < piece.size(); ++first) {
    if (piece[first] != 0 || depth.values[first] <= wall_mm) continue;
    std::vector<std::size_t> open{first};
    std::size_t count = 0;
    for (piece[first] = ++pieces; !open.empty(); ++count) {
      const std::size_t at = open.back();
      open.pop_back();
      // A cell is free on all sides but below, where nothing is deep.
      for (const std::size_t next : {at - 1, at + 1, at - row, at + row, at - layer, at + layer})
        if (next < piece.size() && piece[next] == 0 && depth.values[next] > wall_mm) {
          piece[next] = pieces;
          open.push_back(next);
        }
    }
    if (count > most) most = count, largest = pieces;
  }
  std::vector<bool> is_in(piece.size());
  for (std::size_t i = 0; i < piece.size(); ++i) is_in[i] = most > 0 && piece[i] == largest;
  return is_in;
}

struct Planner {
  const Grid& depth;
  std::vector<bool> is_hollow;
  SurfaceTree sides;
  double rim_mm = 0;  // of a drain; as coarse as the grid
  double wall_mm = 0;

  // The lowest node of the hollow in a column; -1 if there is none.
  int find_floor(int i, int j) const {
    for (int k = 0; k < depth.count.z; ++k)
      if (is_hollow[depth.index(i, j, k)]) return k;
    return -1;
  }
  // Whether a drain leaves the wall to the sides its thickness.
  bool is_clear(const glm::dvec2& at, double floor_mm) const {
    constexpr int kWays = 8;
    for (const double z : {0.01, floor_mm / 2, floor_mm + kInto * depth.cell_mm})
      for (int i = 0; i < kWays; ++i) {
        const double turn = 2 * std::numbers::pi * i / kWays;
        const glm::dvec3 axis(at, z), way(std::cos(turn), std::sin(turn), 0);
        if (find_hit(sides, axis, way, 0, rim_mm + wall_mm).distance < 1e9) return false;
        if (find_nearest(sides, axis + rim_mm * way, wall_mm).distance < wall_mm) return false;
      }
    return true;
  }
  // The nearest column's floor in mm, or -1.
  double find_floor_mm(const glm::dvec2& at) const {
    const glm::dvec2 node = (at - glm::dvec2(depth.origin)) / depth.cell_mm;
    const int i = int(std::lround(node.x)), j = int(std::lround(node.y));
    if (i < 0 || j < 0 || i >= depth.count.x || j >= depth.count.y) return -1;
    const int k = find_floor(i, j);
    return k < 0 ? -1 : k * depth.cell_mm;
  }
};

// The places where a drain could be that are lowest, a cell more or less, with the floor above them for their
// top.
std::vector<Drain> list_places(const Planner& planner) {
  std::vector<Drain> columns, places;
  const Grid& depth = planner.depth;
  for (int j = 0; j < depth.count.y; ++j)
    for (int i = 0; i < depth.count.x; ++i) {
      const int k = planner.find_floor(i, j);
      if (k >= 0) columns.push_back({glm::dvec2(depth.place(i, j, 0)), k * depth.cell_mm});
    }
  std::stable_sort(columns.begin(), columns.end(),
                   [](const Drain& a, const Drain& b) { return a.top_mm < b.top_mm; });
  for (const Drain& column : columns) {
    if (!places.empty() && column.top_mm > places.front().top_mm + 1.01 * depth.cell_mm) break;
    if (planner.is_clear(column.at, column.top_mm)) places.push_back(column);
  }
  return places;
}

}  // namespace

SurfaceTree build_sides(const Mesh& body) {
  constexpr float kBed_mm = 1e-3f;
  Mesh sides;
  sides.positions = body.positions;
  for (const Triangle& t : body.triangles)
    if (std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return body.positions[v].z > kBed_mm; }))
      sides.triangles.push_back(t);
  return build_solid_tree(sides);
}

std::vector<Drain> plan_drains(const Mesh& body, const Grid& depth, const Hollow& hollow) {
  std::vector<Drain> drains;
  if (hollow.drains <= 0) return drains;
  const Planner planner{depth, find_largest(depth, hollow.wall_mm), build_sides(body),
                        hollow.drain_diameter_mm / 2 + depth.cell_mm, hollow.wall_mm};
  const std::vector<Drain> places = list_places(planner);
  if (places.empty())
    throw RunError(fmt::format("a wall of {} mm leaves no room for a drain of {} mm", hollow.wall_mm,
                               hollow.drain_diameter_mm));
  const double level = places.front().top_mm + 1.01 * depth.cell_mm;
  glm::dvec2 middle(0);
  for (const Drain& place : places) middle += place.at / double(places.size());
  // The first as far to the character's left as can be, the second opposite, others far from all.
  const auto rate = [&](const Drain& place) {
    if (drains.empty()) return place.at.x - std::abs(place.at.y - middle.y);
    double nearest = 1e9;
    for (const Drain& other : drains) nearest = std::min(nearest, glm::distance(place.at, other.at));
    return nearest;
  };
  const double apart = hollow.drain_diameter_mm + 2 * depth.cell_mm + hollow.wall_mm;
  while (static_cast<int>(drains.size()) < hollow.drains) {
    Drain best = *std::max_element(places.begin(), places.end(),
                                   [&](const Drain& a, const Drain& b) { return rate(a) < rate(b); });
    if (drains.size() == 1) {
      const glm::dvec2 opposite(-drains[0].at.x, drains[0].at.y);
      const double floor = planner.find_floor_mm(opposite);
      if (floor >= 0 && floor <= level && planner.is_clear(opposite, floor) &&
          glm::distance(opposite, drains[0].at) > apart)
        best = {opposite, floor};
    }
    if (!drains.empty() && rate(best) < apart) break;
    drains.push_back(best);
  }
  for (Drain& drain : drains) drain.top_mm += kInto * depth.cell_mm;
  return drains;
}

}  // namespace mien

// An offset surface by a distance grid: Pavic and Kobbelt, "High-resolution volumetric computation of offset
// surfaces with feature preservation" (2008), without the features: nobody sees them.
#include "print/hollow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/simplify.hpp"
#include "print/drains.hpp"
#include "print/grid.hpp"
#include "print/solid_tree.hpp"

namespace mien {

namespace {

constexpr double kLeastCell_mm = 1;
constexpr double kCells = 60;         // in the height; fewer lose the nose, more take longer than a second
constexpr double kReserve = 0.04;     // of the cell: chords across a hollow curve come nearer to the outside
constexpr double kShort = 0.5;        // of the cell: shorter edges belong to needles
constexpr double kTolerance = 0.2;    // of the cell, for fewer triangles
constexpr double kLeastWall = 0.975;  // of the wall asked: what comes nearer is pushed back
constexpr int kPushes = 6;            // two are enough for nearly all heads
constexpr int kSpeck_cells = 30;      // a cavity of fewer cells is not worth its hole

// How far inside the nearest drain, in mm; below 0 outside.
double find_drain_value(const std::vector<Drain>& drains, double radius, const glm::dvec3& p) {
  double value = -1e9;
  for (const Drain& drain : drains)
    value = std::max(value, std::min(radius - glm::distance(glm::dvec2(p), drain.at), drain.top_mm - p.z));
  return value;
}

// Where the wall is the drain's own: the tube and the rim around it, which is as coarse as the grid.
bool is_at_drain(const std::vector<Drain>& drains, double reach, const glm::dvec3& p) {
  return std::any_of(drains.begin(), drains.end(), [&](const Drain& drain) {
    return glm::distance(glm::dvec2(p), drain.at) < reach && p.z < drain.top_mm;
  });
}

double find_cell_mm(const Mesh& body) {
  return std::max(kLeastCell_mm, find_bounds(body.positions).high.z / kCells);
}

// Around a drain the wall ends; so far from its axis.
double find_rim_mm(const Mesh& body, const Hollow& hollow) {
  return hollow.drain_diameter_mm / 2 + 2 * find_cell_mm(body);
}

// Calls `visit` with places of the triangle a millimetre apart at most, corners and edges among them.
template <typename Visit>
void visit_samples(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const Visit& visit) {
  constexpr double kStep_mm = 1;
  const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
  const int steps = std::max(2, int(std::ceil(longest / kStep_mm)));
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; i + j <= steps; ++j) {
      const double u = double(i) / steps, v = double(j) / steps;
      visit(a + u * (b - a) + v * (c - a));
    }
}

// Moves vertices inward where the surface between them comes nearer to the outside than it may.
void push_inward(Mesh& wall, const SurfaceTree& tree, const std::vector<Drain>& drains, double rim_mm,
                 double least_mm) {
  const std::size_t count = wall.triangles.size();
  std::vector<glm::dvec3> push_of(count);  // the deepest lack of each triangle
  for_each_index(count, count_cores(), [&](std::size_t t, int) {
    const auto& [a, b, c] = wall.triangles[t];
    const glm::dvec3 p(wall.positions[a]), q(wall.positions[b]), r(wall.positions[c]);
    double deepest = 0;
    push_of[t] = glm::dvec3(0);
    visit_samples(p, q, r, [&](const glm::dvec3& at) {
      if (is_at_drain(drains, rim_mm, at)) return;
      const NearestPlace near = find_nearest(tree, at, least_mm);
      const double lack = least_mm - near.distance;
      if (lack <= deepest || near.distance <= 0) return;
      deepest = lack;
      push_of[t] = (at - near.point) / near.distance * lack;
    });
  });
  std::vector<glm::dvec3> move(wall.positions.size(), glm::dvec3(0));
  for (std::size_t t = 0; t < count; ++t)
    for (const std::uint32_t v : wall.triangles[t])
      if (glm::dot(push_of[t], push_of[t]) > glm::dot(move[v], move[v])) move[v] = push_of[t];
  for (std::size_t v = 0; v < wall.positions.size(); ++v)
    if (!is_at_drain(drains, rim_mm, wall.positions[v])) wall.positions[v] += glm::vec3(move[v]);
}

// Whether the wall keeps its distance at all samples.
bool is_thick_enough(const Mesh& wall, const SurfaceTree& tree, const std::vector<Drain>& drains,
                     double rim_mm, double least_mm) {
  std::vector<char> is_thin(wall.triangles.size(), 0);
  for_each_index(wall.triangles.size(), count_cores(), [&](std::size_t t, int) {
    const auto& [a, b, c] = wall.triangles[t];
    visit_samples(wall.positions[a], wall.positions[b], wall.positions[c], [&](const glm::dvec3& at) {
      if (!is_at_drain(drains, rim_mm, at) && find_nearest(tree, at, least_mm).distance < least_mm)
        is_thin[t] = 1;
    });
  });
  return std::find(is_thin.begin(), is_thin.end(), 1) == is_thin.end();
}

// The pieces that drain, or the largest one of a cavity that has no holes.
Mesh keep_cavities(const Mesh& surface, bool is_drained, double speck_mm3) {
  Mesh kept;
  double most = 0;
  for (const Mesh& piece : split_pieces(surface)) {
    if (is_drained) {
      if (count_open_edges(piece.triangles) > 0) append_mesh(kept, piece);
      continue;
    }
    const double volume = -compute_volume_mm3(piece);
    if (volume > std::max(most, speck_mm3)) {
      most = volume;
      kept = piece;
    }
  }
  return kept;
}

}  // namespace

Cavity build_cavity(const Mesh& body, const Hollow& hollow) {
  if (!(hollow.wall_mm > 0)) throw RunError(fmt::format("a wall of {} mm is not above 0", hollow.wall_mm));
  const SurfaceTree tree = build_solid_tree(body);
  const double cell = find_cell_mm(body), iso = hollow.wall_mm + kReserve * cell, reach = iso + 2 * cell;
  Grid grid = build_depth_grid(body, tree, cell, reach);
  const auto hollow_nodes =
      std::count_if(grid.values.begin(), grid.values.end(), [&](float depth) { return depth > iso; });
  if (hollow_nodes < kSpeck_cells)
    throw RunError(fmt::format("a wall of {} mm leaves nothing to hollow", hollow.wall_mm));

  Cavity cavity;
  cavity.drains = plan_drains(body, grid, hollow);
  const std::vector<Drain> joined = hollow.is_open ? cavity.drains : std::vector<Drain>();
  // The polygon's sides, not its corners, leave the drain its width.
  const double radius = hollow.drain_diameter_mm / 2 + 0.06 * cell;
  for (int k = 0; k < grid.count.z; ++k)
    for (int j = 0; j < grid.count.y; ++j)
      for (int i = 0; i < grid.count.x; ++i) {
        float& value = grid.values[grid.index(i, j, k)];
        value = std::max(value - float(iso), float(find_drain_value(joined, radius, grid.place(i, j, k))));
      }
  const Mesh surface = build_level_surface(grid, [&](const glm::dvec3& p) {
    const double at_drain = find_drain_value(joined, radius, p);
    return std::max(at_drain, std::min(find_nearest(tree, p, reach).distance, reach) - iso);
  });
  cavity.wall = keep_cavities(surface, !joined.empty(), kSpeck_cells * cell * cell * cell);
  merge_short_edges(cavity.wall, kShort * cell);
  simplify_mesh(cavity.wall, kTolerance * cell);
  const double rim = find_rim_mm(body, hollow), least = kLeastWall * hollow.wall_mm;
  for (int push = 0; push < kPushes && !is_thick_enough(cavity.wall, tree, joined, rim, least); ++push)
    push_inward(cavity.wall, tree, joined, rim, least + 0.005 * hollow.wall_mm);
  if (!joined.empty()) cavity.holes = find_boundary_loops(cavity.wall.triangles);
  return cavity;
}

double measure_wall_mm(const Mesh& body, const Cavity& cavity, const Hollow& hollow) {
  const SurfaceTree tree = build_solid_tree(body);
  const double rim = find_rim_mm(body, hollow);
  const std::vector<Drain> joined = hollow.is_open ? cavity.drains : std::vector<Drain>();
  double least = 1e9;
  for (const auto& [a, b, c] : cavity.wall.triangles)
    visit_samples(cavity.wall.positions[a], cavity.wall.positions[b], cavity.wall.positions[c],
                  [&](const glm::dvec3& at) {
                    if (!is_at_drain(joined, rim, at))
                      least = std::min(least, find_nearest(tree, at, 2 * hollow.wall_mm).distance);
                  });
  return least;
}

std::vector<Loop> append_cavity(Mesh& mesh, const Cavity& cavity) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.normals.clear();
  Mesh wall = cavity.wall;
  wall.normals.clear();
  append_mesh(mesh, wall);
  std::vector<Loop> holes = cavity.holes;
  for (Loop& hole : holes)
    for (std::uint32_t& v : hole) v += first;
  return holes;
}

}  // namespace mien

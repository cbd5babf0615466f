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
constexpr double kFinestCell_mm = 0.7;
constexpr double kCells = 60;         // in the height; fewer lose the nose, more take longer than a second
constexpr double kReserve = 0.04;     // of the cell: chords across a hollow curve come nearer to the outside
constexpr double kShort = 0.5;        // of the cell: shorter edges belong to needles
constexpr double kTolerance = 0.2;    // of the cell, for fewer triangles
constexpr double kLeastWall = 0.975;  // of the wall asked: what comes nearer is pushed back
constexpr double kKnot = 1.5;         // of the cell, around a place where it would go through itself
constexpr int kAttempts = 6;
constexpr int kPushes = 6;        // two are enough for nearly all heads
constexpr int kSpeck_cells = 30;  // a cavity of fewer cells is not worth its hole

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
    return glm::distance(glm::dvec2(p), drain.at) < reach && p.z < drain.top_mm + reach / 3;
  });
}

double find_cell_mm(const Mesh& body, const Hollow& hollow) {
  const double coarsest = std::max(kLeastCell_mm, find_bounds(body.positions).high.z / kCells);
  return std::clamp(hollow.wall_mm, kFinestCell_mm, coarsest);  // a cell wider than the wall would miss it
}

// Around a drain the wall ends; so far from its axis.
double find_rim_mm(const Mesh& body, const Hollow& hollow) {
  return hollow.drain_diameter_mm / 2 + 2 * find_cell_mm(body, hollow);
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

// What the wall must keep away from. Around the drains that is not the underside, which they go through.
struct Outside {
  const SurfaceTree& all;
  const SurfaceTree& sides;
  std::vector<Drain> drains;
  double rim_mm = 0;

  NearestPlace find(const glm::dvec3& p, double reach) const {
    return find_nearest(is_at_drain(drains, rim_mm, p) ? sides : all, p, reach);
  }
};

// For each triangle how much it lacks to `least_mm` where it is nearest to the outside, as the way inward.
std::vector<glm::dvec3> list_lacks(const Mesh& wall, const Outside& outside, double least_mm) {
  std::vector<glm::dvec3> lacks(wall.triangles.size(), glm::dvec3(0));
  for_each_index(lacks.size(), count_cores(), [&](std::size_t t, int) {
    const auto& [a, b, c] = wall.triangles[t];
    double deepest = 0;
    visit_samples(wall.positions[a], wall.positions[b], wall.positions[c], [&](const glm::dvec3& at) {
      const NearestPlace near = outside.find(at, least_mm);
      if (least_mm - near.distance <= deepest || near.distance <= 0) return;
      deepest = least_mm - near.distance;
      lacks[t] = (at - near.point) / near.distance * deepest;
    });
  });
  return lacks;
}

// Moves vertices inward where the surface between them comes nearer to the outside than it may; false if it
// does so nowhere. Those that `is_fixed` marks and those on the bed stay.
bool push_inward(Mesh& wall, const Outside& outside, double least_mm, double wish_mm,
                 const std::vector<bool>& is_fixed) {
  constexpr double kShare = 0.4;  // of the way to the cavity's other side, which may come as well
  const std::vector<glm::dvec3> lacks = list_lacks(wall, outside, least_mm);
  if (std::all_of(lacks.begin(), lacks.end(), [](const glm::dvec3& lack) { return lack == glm::dvec3(0); }))
    return false;
  std::vector<glm::dvec3> move(wall.positions.size(), glm::dvec3(0));
  for (std::size_t t = 0; t < lacks.size(); ++t)
    for (const std::uint32_t v : wall.triangles[t])
      if (glm::dot(lacks[t], lacks[t]) > glm::dot(move[v], move[v])) move[v] = lacks[t];
  const SurfaceTree inside = build_solid_tree(wall);
  for (std::size_t v = 0; v < wall.positions.size(); ++v) {
    const double lack = glm::length(move[v]);
    if (lack == 0 || is_fixed[v] || wall.positions[v].z <= 0) continue;
    const glm::dvec3 way = move[v] / lack;
    const double free = find_hit(inside, wall.positions[v], way, 1e-4, 1e3).distance;
    wall.positions[v] += glm::vec3(way * std::min(lack + wish_mm - least_mm, kShare * free));
  }
  return true;
}

// The vertices within `reach_mm` of any of the places.
std::vector<bool> find_close(const Mesh& mesh, const std::vector<glm::dvec3>& places, double reach_mm) {
  std::vector<bool> is_close(mesh.positions.size(), false);
  for (std::size_t v = 0; v < is_close.size(); ++v)
    is_close[v] = std::any_of(places.begin(), places.end(), [&](const glm::dvec3& place) {
      return glm::distance(glm::dvec3(mesh.positions[v]), place) < reach_mm;
    });
  return is_close;
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
  const double cell = find_cell_mm(body, hollow), iso = hollow.wall_mm + kReserve * cell,
               reach = iso + 2 * cell;
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
  const Mesh fine = keep_cavities(surface, !joined.empty(), kSpeck_cells * cell * cell * cell);
  const SurfaceTree sides = build_sides(body);
  const Outside outside{tree, sides, joined, find_rim_mm(body, hollow)};
  const double least = kLeastWall * hollow.wall_mm;
  std::vector<glm::dvec3> knots;  // where fewer triangles go through each other: all of them stay there
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    cavity.wall = fine;
    merge_short_edges(cavity.wall, kShort * cell, find_close(cavity.wall, knots, kKnot * cell));
    simplify_mesh(cavity.wall, kTolerance * cell, find_close(cavity.wall, knots, kKnot * cell));
    const bool is_stubborn = attempt > kAttempts / 2;  // then it was the pushing
    const std::vector<bool> is_fixed =
        find_close(cavity.wall, is_stubborn ? knots : std::vector<glm::dvec3>(), kKnot * cell);
    for (int push = 0; push < kPushes; ++push)
      if (!push_inward(cavity.wall, outside, least, least + 0.005 * hollow.wall_mm, is_fixed)) break;
    const std::vector<glm::dvec3> crossed = list_crossed_places(cavity.wall);
    if (crossed.empty()) break;
    knots.insert(knots.end(), crossed.begin(), crossed.end());
  }
  if (!joined.empty()) cavity.holes = find_boundary_loops(cavity.wall.triangles);
  return cavity;
}

double measure_wall_mm(const Mesh& body, const Cavity& cavity, const Hollow& hollow) {
  const SurfaceTree tree = build_solid_tree(body), sides = build_sides(body);
  const Outside outside{tree, sides, hollow.is_open ? cavity.drains : std::vector<Drain>(),
                        find_rim_mm(body, hollow)};
  double least = 1e9;
  for (const auto& [a, b, c] : cavity.wall.triangles)
    visit_samples(cavity.wall.positions[a], cavity.wall.positions[b], cavity.wall.positions[c],
                  [&](const glm::dvec3& at) {
                    least = std::min(least, outside.find(at, 2 * hollow.wall_mm).distance);
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

// Steps as long as the distance to the nearest surface, less the wall: Hart, "Sphere tracing" (1996).
#include "print/cavity_plan.hpp"

#include <algorithm>
#include <cmath>

#include "core/pool.hpp"
#include "print/solid_tree.hpp"

namespace mien {

namespace {

constexpr std::size_t kRows = 60;    // in the height; fewer cut the corner under the chin
constexpr double kReach_mm = 60;     // further away nothing is looked for
constexpr double kNear_mm = 0.03;    // of the wall, where the way along a ray ends
constexpr int kMostSteps = 60;       // of a ray; those that graze the wall end sooner than they should
constexpr double kReserve = 1.02;    // of the wall: between two rays the cavity is flat
constexpr double kLean = 4;          // mm outward for one of height: steeper, and a step is cut off
constexpr double kTurn = 2;          // the same for the way round
constexpr double kLeast_mm = 0.5;    // narrower rows are left out
constexpr std::size_t kFewRows = 6;  // fewer are no room

struct Tracer {
  const SurfaceTree& tree;

  // No more than `most_mm`, beyond which nothing is looked for.
  double find_depth(const glm::dvec3& p, double most_mm = kReach_mm) const {
    return std::min(find_nearest(tree, p, most_mm).distance, most_mm);
  }
  // How far from `origin` the depth is first `wall_mm`, from `start` on; below `start` if it is less there.
  // `most_mm` is no less than the depth at the start, and is that of the end afterwards.
  double trace(const glm::dvec3& origin, const glm::dvec3& way, double wall_mm, double start,
               double& most_mm) const {
    double at = start;
    for (int step = 0; step < kMostSteps; ++step) {
      const double free = find_depth(origin + at * way, most_mm) - wall_mm;
      most_mm = wall_mm + free + kNear_mm;
      if (free < kNear_mm) return free < 0 && at == start ? -1 : at;
      at += free;
      most_mm += free;  // it grows by no more than the way
    }
    return at;
  }
};

// The row's middle goes with the deepest place; above the deepest of all it goes straight up.
void compute_middles(const Tracer& tracer, double straight_mm, CavityPlan& plan) {
  constexpr int kWays = 3;        // to either side
  constexpr double kSlope = 0.9;  // of the way up
  const double step = plan.heights_mm[1] - plan.heights_mm[0];
  std::size_t deepest = 0;
  double depth = 0, last = 0;
  for (std::size_t k = 0; k < plan.heights_mm.size(); ++k) {
    double best = last, best_depth = -1;
    for (int i = -kWays; i <= kWays && plan.heights_mm[k] > straight_mm; ++i) {
      const double y = last + kSlope * step * i / kWays;
      const double here = tracer.find_depth({0, y, plan.heights_mm[k]});
      if (here > best_depth) best = y, best_depth = here;
    }
    last = best;
    plan.middles_mm.push_back(best);
    if (best_depth > depth) depth = best_depth, deepest = k;
  }
  std::fill(plan.middles_mm.begin() + static_cast<std::ptrdiff_t>(deepest), plan.middles_mm.end(),
            plan.middles_mm[deepest]);
}

// Rows that hold no cavity become zeros, and so do all below the lowest one that the top is joined to.
std::size_t leave_out_rows(const CavityPlan& plan, CavityPlan::Wall& wall) {
  const std::size_t columns = plan.directions.size();
  std::size_t rows = 0;
  bool has_ended = false;
  for (std::size_t k = plan.heights_mm.size(); k-- > 0;) {
    const auto first = wall.reaches_mm.begin() + static_cast<std::ptrdiff_t>(k * columns),
               end = first + static_cast<std::ptrdiff_t>(columns);
    const bool is_open = *std::min_element(first, end) > kLeast_mm && plan.heights_mm[k] < wall.top_mm;
    if (!is_open && rows > 0) has_ended = true;
    if (!is_open || has_ended)
      std::fill(first, end, 0);
    else
      ++rows;
  }
  return rows;
}

// No place reaches much further than its neighbours: between them the cavity is flat, and must not cut what
// is hidden there, such as the corner of chin and neck.
void limit_slopes(const CavityPlan& plan, std::vector<double>& reaches) {
  const std::size_t columns = plan.directions.size(), rows = plan.heights_mm.size();
  const double lean = kLean * (plan.heights_mm[1] - plan.heights_mm[0]);
  const auto limit_up = [&](std::size_t k, std::size_t other) {
    for (std::size_t j = 0; j < columns; ++j)
      if (const double beside = reaches[other * columns + j]; beside > 0)
        reaches[k * columns + j] = std::min(reaches[k * columns + j], beside + lean);
  };
  const auto limit_round = [&](std::size_t k, std::size_t j, std::size_t other) {
    const double gap = glm::distance(plan.directions[j], plan.directions[other]);
    double& reach = reaches[k * columns + j];
    reach = std::min(reach, reaches[k * columns + other] * (1 + kTurn * gap) + kLeast_mm * gap);
  };
  for (std::size_t k = 0; k < rows; ++k)
    for (std::size_t i = 0; i < 2 * columns; ++i) {
      const std::size_t up = i % columns, down = columns - 1 - up;
      limit_round(k, (up + 1) % columns, up);
      limit_round(k, down, (down + 1) % columns);
    }
  for (std::size_t k = 1; k < rows; ++k) limit_up(k, k - 1);
  for (std::size_t k = rows - 1; k-- > 0;) limit_up(k, k + 1);
}

// Draws in what comes nearer to the outside between the rays than the wall may be.
void draw_in(const CavityPlan& plan, const SurfaceTree& tree, CavityPlan::Wall& wall) {
  constexpr int kRounds = 5;
  constexpr double kStretch = 1.2;  // of the wall, between two samples
  constexpr int kMostParts = 8;
  constexpr double kMore = 1.5;  // of what lacks: the way inward is seldom straight to the middle
  const std::size_t columns = plan.directions.size(), rows = plan.heights_mm.size();
  const auto place = [&](std::size_t k, std::size_t j) {
    return glm::dvec3(
        wall.reaches_mm[k * columns + j] * plan.directions[j] + glm::dvec2(0, plan.middles_mm[k]),
        plan.heights_mm[k]);
  };
  const auto is_open = [&](std::size_t k) { return wall.reaches_mm[k * columns] > 0; };
  std::vector<char> is_asked(rows * columns, 1);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> shortfalls(rows * columns, 0);  // of the corners of each cell
    for_each_index(rows - 1, count_workers(), [&](std::size_t k, int) {
      for (std::size_t j = 0; j < columns; ++j) {
        if (!is_open(k) || !is_open(k + 1) || !is_asked[k * columns + j]) continue;
        const std::size_t next = (j + 1) % columns;
        const glm::dvec3 a = place(k, j), b = place(k, next), c = place(k + 1, j), d = place(k + 1, next);
        const double longest = std::max({glm::distance(a, c), glm::distance(a, d), glm::distance(b, c)});
        const int steps = std::clamp(int(std::ceil(longest / (kStretch * wall.wall_mm))), 2, kMostParts);
        for (int i = 1; i < steps; ++i)
          for (const glm::dvec3& at : {glm::mix(a, c, double(i) / steps), glm::mix(a, d, double(i) / steps),
                                       glm::mix(b, c, double(i) / steps)})
            shortfalls[k * columns + j] = std::max(
                shortfalls[k * columns + j], wall.wall_mm - find_nearest(tree, at, wall.wall_mm).distance);
      }
    });
    std::vector<char> is_moved(rows * columns, 0);
    std::vector<double> move(rows * columns, 0);
    bool has_moved = false;
    for (std::size_t k = 0; k + 1 < rows; ++k)
      for (std::size_t j = 0; j < columns; ++j)
        if (const double shortfall = shortfalls[k * columns + j]; shortfall > 0)
          for (const std::size_t row : {k, k + 1})
            for (const std::size_t column : {j, (j + 1) % columns}) {
              double& way = move[row * columns + column];
              way = std::max(way, kMore * shortfall);
              for (const std::size_t beside : {column, (column + columns - 1) % columns})
                is_moved[row * columns + beside] = is_moved[(row - (row > 0)) * columns + beside] = 1;
              has_moved = true;
            }
    if (!has_moved) return;
    for (std::size_t i = 0; i < move.size(); ++i)
      wall.reaches_mm[i] =
          std::max(std::min(wall.reaches_mm[i], kLeast_mm / 2), wall.reaches_mm[i] - move[i]);
    is_asked = std::move(is_moved);
  }
}

}  // namespace

CavityPlan plan_cavity(const Mesh& surfaces, const CavityRequest& request) {
  CavityPlan plan;
  plan.directions = request.directions;
  const double high = compute_bounds(surfaces.positions).high.z;
  for (std::size_t k = 0; k < kRows; ++k)
    plan.heights_mm.push_back(request.low_mm + (high - request.low_mm) * double(k) / double(kRows));
  const SurfaceTree tree = build_solid_tree(surfaces);
  const Tracer tracer{tree};
  compute_middles(tracer, request.straight_mm, plan);

  const std::size_t columns = plan.directions.size();
  std::vector<CavityPlan::Wall> walls(request.walls_mm.size());
  for (std::size_t w = 0; w < walls.size(); ++w) {
    walls[w].wall_mm = request.walls_mm[w];
    walls[w].reaches_mm.assign(kRows * columns, 0);
  }
  for_each_index(kRows, count_workers(), [&](std::size_t k, int) {
    const glm::dvec3 middle(0, plan.middles_mm[k], plan.heights_mm[k]);
    const double depth = tracer.find_depth(middle) + kNear_mm;
    for (std::size_t j = 0; j < columns; ++j) {
      double at = 0, most_mm = depth;
      for (std::size_t w = walls.size(); w-- > 0;) {  // the thickest has the shortest way
        const double found =
            tracer.trace(middle, {plan.directions[j], 0}, kReserve * walls[w].wall_mm, at, most_mm);
        if (found > at) at = found;
        walls[w].reaches_mm[k * columns + j] = at;
      }
    }
  });
  for (CavityPlan::Wall& wall : walls) {
    const double from = plan.heights_mm.back() - 0.3 * (high - request.low_mm);
    double most_mm = kReach_mm;
    const double up =
        tracer.trace({0, plan.middles_mm.back(), from}, {0, 0, 1}, kReserve * wall.wall_mm, 0, most_mm);
    wall.top_mm = up > 0 ? from + up : 0;
    limit_slopes(plan, wall.reaches_mm);
    leave_out_rows(plan, wall);
    draw_in(plan, tree, wall);
    if (leave_out_rows(plan, wall) >= kFewRows) plan.walls.push_back(std::move(wall));
  }
  return plan;
}

Mesh join_poses(const std::vector<Triangle>& triangles, const std::vector<std::vector<glm::vec3>>& poses) {
  constexpr float kInward_mm = 0.03f;  // less is within the wall's own tolerance
  constexpr float kFar = 0.0125f;      // of the height: so far the first pose's normal tells what is inward
  Mesh joined{poses.front(), {}, triangles};
  update_normals(joined);
  const std::vector<glm::vec3> normals = std::move(joined.normals);
  const float far_mm = kFar * compute_bounds(poses.front()).high.z;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    std::vector<bool> is_inward(poses[i].size());
    for (std::size_t v = 0; v < is_inward.size(); ++v) {
      const glm::vec3 way = poses[i][v] - poses[0][v];
      is_inward[v] = glm::dot(way, normals[v]) < -kInward_mm || glm::length(way) > far_mm;
    }
    std::vector<std::uint32_t> number(poses[i].size(), 0);  // in the joined mesh
    const auto find_number = [&](std::uint32_t v) {
      if (number[v] == 0) {
        number[v] = static_cast<std::uint32_t>(joined.positions.size());
        joined.positions.push_back(poses[i][v]);
      }
      return number[v];
    };
    for (const auto& [a, b, c] : triangles)
      if (is_inward[a] || is_inward[b] || is_inward[c])
        joined.triangles.push_back({find_number(a), find_number(b), find_number(c)});
  }
  joined.normals.clear();
  return joined;
}

}  // namespace mien

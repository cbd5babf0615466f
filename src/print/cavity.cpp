#include "print/cavity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "core/pool.hpp"
#include "core/print_numbers.hpp"
#include "print/solid_tree.hpp"

namespace mien {

namespace {

const CavityPlan::Wall& find_wall(const CavityPlan& plan, double wall_mm) {
  if (!(wall_mm > 0)) throw RunError(fmt::format("a wall of {} mm is not above 0", wall_mm));
  for (const CavityPlan::Wall& wall : plan.walls)
    if (wall.wall_mm == wall_mm) return wall;
  throw RunError(fmt::format("a wall of {} mm leaves nothing to hollow", wall_mm));
}

// The plan's row `k` and, if `share` is above 0, so much of the next one.
std::vector<glm::vec3> build_ring(const CavityPlan& plan, const CavityPlan::Wall& wall, std::size_t k,
                                  double share, double lift_mm) {
  const std::size_t columns = plan.directions.size();
  const auto mix = [&](double a, double b) { return a + share * (b - a); };
  const std::size_t next = share > 0 ? k + 1 : k;
  const double middle = mix(plan.middles_mm[k], plan.middles_mm[next]),
               z = mix(plan.heights_mm[k], plan.heights_mm[next]);
  std::vector<glm::vec3> ring;
  for (std::size_t j = 0; j < columns; ++j) {
    const double reach = mix(wall.reaches_mm[k * columns + j], wall.reaches_mm[next * columns + j]);
    ring.emplace_back(reach * plan.directions[j].x, middle + reach * plan.directions[j].y, z + lift_mm);
  }
  return ring;
}

// How far the ring is from the axis, sides and not corners taken.
double compute_inner_radius(const std::vector<glm::vec3>& ring) {
  double least = 1e9;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const glm::dvec2 a(ring[i]), b(ring[(i + 1) % ring.size()]), way = b - a;
    const double square = glm::dot(way, way);
    const double share = square > 0 ? std::clamp(-glm::dot(a, way) / square, 0.0, 1.0) : 0;
    least = std::min(least, glm::length(a + share * way));
  }
  return least;
}

double compute_drain_mm(const Cavity& cavity, const Hollow& hollow) {
  double drain = std::min(hollow.drain_mm, kDrainShare * 2 * compute_inner_radius(cavity.rings.front()));
  if (hollow.pocket_mm > 0) drain = std::min(drain, hollow.pocket_mm - 2 * kMagnetLedge_mm);
  if (drain < std::min(kLeastDrain_mm, hollow.drain_mm))
    throw RunError(
        fmt::format("a wall of {} mm leaves no room for a drain; a thinner wall, base: none or a greater "
                    "height have it, and drain: 0mm does without",
                    hollow.wall_mm));
  return drain;
}

}  // namespace

Cavity build_cavity(const CavityPlan& plan, const Hollow& hollow) {
  const CavityPlan::Wall& wall = find_wall(plan, hollow.wall_mm);
  const std::size_t columns = plan.directions.size(), rows = plan.heights_mm.size();
  const auto is_open = [&](std::size_t k) { return k < rows && wall.reaches_mm[k * columns] > 0; };
  // The floor, in the plan's heights.
  double floor = std::max(
      {0.0, hollow.wall_mm - hollow.lift_mm, hollow.pocket_depth_mm + hollow.wall_mm - hollow.lift_mm});
  std::size_t k = 0;
  while (k < rows && !is_open(k)) ++k;
  if (hollow.drain_mm == 0) floor = std::max(floor, plan.heights_mm[k]);
  while (k + 1 < rows && plan.heights_mm[k + 1] <= floor) ++k;
  Cavity cavity;
  if (is_open(k) && is_open(k + 1) && plan.heights_mm[k] <= floor) {
    const double share = (floor - plan.heights_mm[k]) / (plan.heights_mm[k + 1] - plan.heights_mm[k]);
    cavity.rings.push_back(build_ring(plan, wall, k, share, hollow.lift_mm));
    cavity.floor = {0, plan.middles_mm[k] + share * (plan.middles_mm[k + 1] - plan.middles_mm[k]),
                    floor + hollow.lift_mm};
  } else if (hollow.drain_mm == 0)
    throw RunError(fmt::format("a wall of {} mm leaves nothing to hollow", hollow.wall_mm));
  else
    cavity.rings.emplace_back(columns, glm::vec3(0));  // no drain goes through
  if (hollow.drain_mm > 0) cavity.drain_mm = compute_drain_mm(cavity, hollow);
  for (++k; is_open(k); ++k)
    if (plan.heights_mm[k] > floor + kCavityStep_mm && plan.heights_mm[k] < wall.top_mm - kCavityStep_mm)
      cavity.rings.push_back(build_ring(plan, wall, k, 0, hollow.lift_mm));
  cavity.top = {0, plan.middles_mm.back(), wall.top_mm + hollow.lift_mm};
  return cavity;
}

std::size_t append_cavity(Mesh& mesh, const Cavity& cavity, const Loop& drain, const VentMouth& outside) {
  mesh.normals.clear();
  const auto append_ring = [&](const std::vector<glm::vec3>& ring) {
    Loop loop(ring.size());
    std::iota(loop.begin(), loop.end(), static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.insert(mesh.positions.end(), ring.begin(), ring.end());
    return loop;
  };
  Loop tube;
  if (!drain.empty()) {
    std::vector<glm::vec3> high;
    for (const std::uint32_t v : drain)
      high.emplace_back(mesh.positions[v].x, mesh.positions[v].y, cavity.floor.z);
    tube = append_ring(high);
    const std::size_t first = mesh.triangles.size();
    append_band(mesh, drain, tube);
    if (outside.vent.width_mm > 0)
      append_tunnel(mesh, outside, cut_vent_mouth(mesh, first, drain, tube, outside.vent));
  }
  const std::size_t before = mesh.triangles.size();
  Loop last = append_ring(cavity.rings.front());
  if (drain.empty()) {
    append_fan_cap(mesh, {last.rbegin(), last.rend()}, cavity.floor);
  } else {  // several of the tube's for each of the ring's
    const std::size_t each = tube.size() / last.size();
    for (std::size_t i = 0; i < last.size(); ++i) {
      const std::uint32_t next = last[(i + 1) % last.size()];
      for (std::size_t t = 0; t < each; ++t)
        mesh.triangles.push_back({tube[i * each + t], tube[(i * each + t + 1) % tube.size()], last[i]});
      mesh.triangles.push_back({tube[(i * each + each) % tube.size()], next, last[i]});
    }
  }
  for (std::size_t k = 1; k < cavity.rings.size(); ++k) {
    const Loop ring = append_ring(cavity.rings[k]);
    append_band(mesh, last, ring);
    last = ring;
  }
  append_fan_cap(mesh, last, cavity.top);
  return before;
}

double measure_wall_mm(const Mesh& body, const Cavity& cavity) {
  constexpr double kSample_mm = 1;
  Mesh wall;
  append_cavity(wall, cavity, {});
  const SurfaceTree tree = build_solid_tree(body);
  std::vector<double> least(wall.triangles.size(), 1e9);
  for_each_index(least.size(), count_workers(), [&](std::size_t t, int) {
    const glm::dvec3 a(wall.positions[wall.triangles[t][0]]), b(wall.positions[wall.triangles[t][1]]),
        c(wall.positions[wall.triangles[t][2]]);
    const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    const int steps = std::max(2, int(std::ceil(longest / kSample_mm)));
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j)
        least[t] = std::min(
            least[t],
            find_nearest(tree, a + (b - a) * (double(i) / steps) + (c - a) * (double(j) / steps), 100)
                .distance);
  });
  return *std::min_element(least.begin(), least.end());
}

}  // namespace mien

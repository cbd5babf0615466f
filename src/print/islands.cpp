// Merging runs of columns from below, the elder part surviving: zero-dimensional persistence, Edelsbrunner
// and Harer, "Computational Topology" (2010), VII.
#include "print/islands.hpp"

#include <algorithm>
#include <numeric>

#include "print/grid.hpp"

namespace mien {

namespace {

constexpr double kStep_mm = 0.4;  // a nozzle's width
constexpr double kSteps = 250;    // at most, in the longest side
constexpr double kBed_mm = 0.05;  // a first layer reaches so high

// A stretch of a column within the solid.
struct Run {
  int i = 0, j = 0;
  double low = 0, high = 0;
};

std::vector<Run> list_runs(const Mesh& solid, const Grid& grid) {
  std::vector<Run> runs;
  const auto columns = list_crossings(solid, grid);
  for (int j = 0; j < grid.count.y; ++j)
    for (int i = 0; i < grid.count.x; ++i) {
      int turns = 0;
      for (const ColumnCrossing& crossing : columns[static_cast<std::size_t>(j) * grid.count.x + i]) {
        if (turns == 0 && crossing.turn > 0) runs.push_back({i, j, crossing.z, crossing.z});
        turns += crossing.turn;
        if (turns == 0 && crossing.turn < 0) runs.back().high = crossing.z;
      }
    }
  std::stable_sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.low < b.low; });
  return runs;
}

}  // namespace

std::vector<Island> find_islands(const Mesh& solid, double layer_mm) {
  const Box box = compute_bounds(solid.positions);
  const glm::dvec3 size(box.high - box.low);
  Grid grid = place_grid(box, std::max(kStep_mm, std::max({size.x, size.y, size.z}) / kSteps));
  const std::vector<Run> runs = list_runs(solid, grid);

  std::vector<std::uint32_t> elder(runs.size());  // towards the run where a part began: always one before
  std::iota(elder.begin(), elder.end(), 0U);
  const auto find_root = [&](std::uint32_t r) {
    while (elder[r] != r) r = elder[r] = elder[elder[r]];
    return r;
  };
  std::vector<std::vector<std::uint32_t>> begun(static_cast<std::size_t>(grid.count.x) * grid.count.y);
  std::vector<Island> islands;
  const auto add = [&](const Run& run, double until) {
    if (run.low > kBed_mm && until - run.low > layer_mm)
      islands.push_back(
          {{grid.place(run.i, run.j, 0).x, grid.place(run.i, run.j, 0).y, run.low}, until - run.low});
  };
  for (std::uint32_t r = 0; r < runs.size(); ++r) {
    const Run& run = runs[r];
    for (int j = run.j - 1; j <= run.j + 1; ++j)
      for (int i = run.i - 1; i <= run.i + 1; ++i) {
        if (i < 0 || j < 0 || i >= grid.count.x || j >= grid.count.y) continue;
        for (const std::uint32_t other : begun[static_cast<std::size_t>(j) * grid.count.x + i]) {
          if (runs[other].high < run.low) continue;
          const std::uint32_t a = find_root(r), b = find_root(other);
          if (a == b) continue;
          elder[std::max(a, b)] = std::min(a, b);
          add(runs[std::max(a, b)], run.low);
        }
      }
    begun[static_cast<std::size_t>(run.j) * grid.count.x + run.i].push_back(r);
  }
  for (std::uint32_t r = 0; r < runs.size(); ++r)
    if (elder[r] == r) add(runs[r], box.high.z);  // it never met what stands on the bed
  std::stable_sort(islands.begin(), islands.end(),
                   [](const Island& a, const Island& b) { return a.lowest.z < b.lowest.z; });
  return islands;
}

}  // namespace mien

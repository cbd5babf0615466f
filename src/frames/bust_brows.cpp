#include "frames/bust_brows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/holes.hpp"
#include "core/refine.hpp"
#include "core/smooth.hpp"

namespace mien {

namespace {

constexpr float kReach_mm = 2.2f;  // how far round a hair the skin rises: less leaves holes between hairs
constexpr int kSamples = 6;        // points along a hair
constexpr int kRefinements = 3;    // of the skin's triangles of 2.5 mm, so that a lock is ten of them wide

// A hair as three points: root, middle, tip.
using Strand = std::array<glm::vec3, 3>;

std::vector<Strand> list_strands(const Mesh& hairs) {
  std::vector<Strand> strands;
  for (const Mesh& hair : split_pieces(hairs)) {
    const std::vector<glm::vec3>& p = hair.positions;
    strands.push_back({p.front(), p[p.size() / 2], p.back()});
  }
  return strands;
}

glm::vec3 sample_strand(const Strand& strand, float way) {
  return way < 0.5f ? glm::mix(strand[0], strand[1], 2 * way) : glm::mix(strand[1], strand[2], 2 * way - 1);
}

// Points in cells of kReach_mm, to find those near a place.
struct PointGrid {
  Box box{glm::vec3(INFINITY), glm::vec3(-INFINITY)};  // of the points, and kReach_mm beyond
  glm::ivec3 first{0}, size{0};
  std::vector<std::vector<glm::vec3>> cells;

  glm::ivec3 find_cell(const glm::vec3& p) const { return glm::ivec3(glm::floor(p / kReach_mm)) - first; }
  std::vector<glm::vec3>& at(int x, int y, int z) { return cells[(z * size.y + y) * size.x + x]; }
  const std::vector<glm::vec3>& at(int x, int y, int z) const { return cells[(z * size.y + y) * size.x + x]; }

  // The sum over the points within reach of a bell that is 1 on a point and 0 at the reach.
  float sum_around(const glm::vec3& p) const {
    if (glm::any(glm::lessThan(p, box.low)) || glm::any(glm::greaterThan(p, box.high))) return 0;
    const glm::ivec3 cell = find_cell(p);
    const glm::ivec3 low = glm::max(cell - 1, 0), high = glm::min(cell + 1, size - 1);
    float sum = 0;
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x)
          for (const glm::vec3& q : at(x, y, z)) {
            const float share = 1 - glm::dot(p - q, p - q) / (kReach_mm * kReach_mm);
            if (share > 0) sum += share * share;
          }
    return sum;
  }
};

PointGrid build_grid(const std::vector<Strand>& strands) {
  std::vector<glm::vec3> points;
  for (const Strand& strand : strands)
    for (int i = 0; i < kSamples; ++i) points.push_back(sample_strand(strand, float(i) / (kSamples - 1)));
  PointGrid grid;
  const Box box = compute_bounds(points);
  grid.box = {box.low - kReach_mm, box.high + kReach_mm};
  grid.first = grid.find_cell(grid.box.low);
  grid.size = grid.find_cell(grid.box.high) + 1;
  grid.cells.resize(static_cast<std::size_t>(grid.size.x) * grid.size.y * grid.size.z);
  for (const glm::vec3& p : points) {
    const glm::ivec3 cell = grid.find_cell(p);
    grid.at(cell.x, cell.y, cell.z).push_back(p);
  }
  return grid;
}

// What `sum_around` comes to where the brow is full: that of the strand at nine tenths of them.
float compute_full_density(const PointGrid& grid, const std::vector<Strand>& strands) {
  std::vector<float> densities;
  for (const Strand& strand : strands) densities.push_back(grid.sum_around(strand[1]));
  const auto at = densities.begin() + static_cast<std::ptrdiff_t>(densities.size() * 9 / 10);
  std::nth_element(densities.begin(), at, densities.end());
  return *at;
}

float compute_distance_mm(const glm::vec3& p, const Strand& strand) {
  float nearest = INFINITY;
  for (int i = 0; i < 2; ++i) {
    const glm::vec3 along = strand[i + 1] - strand[i];
    const float squared = glm::dot(along, along);
    const float way = squared > 0 ? std::clamp(glm::dot(p - strand[i], along) / squared, 0.0f, 1.0f) : 0;
    nearest = std::min(nearest, glm::length(p - strand[i] - way * along));
  }
  return nearest;
}

// Strands that lie at least `apart_mm` from each other, the first ones first: the locks.
std::vector<Strand> pick_locks(const std::vector<Strand>& strands, float apart_mm) {
  std::vector<Strand> locks;
  for (const Strand& strand : strands) {
    const bool is_free = std::none_of(locks.begin(), locks.end(), [&](const Strand& lock) {
      return compute_distance_mm(strand[1], lock) < apart_mm;
    });
    if (is_free) locks.push_back(strand);
  }
  return locks;
}

void refine_under(Mesh& skin, const PointGrid& grid, RaisedBrows& brows) {
  for (int i = 0; i < kRefinements; ++i) {
    std::vector<bool> marks;
    for (const glm::vec3& p : skin.positions) marks.push_back(grid.sum_around(p) > 0);
    const auto ends = refine_marked(skin, marks);
    brows.ends.insert(brows.ends.end(), ends.begin(), ends.end());
  }
}

}  // namespace

RaisedBrows refine_brows(Mesh& skin, const std::vector<Mesh>& hairs, const BrowRelief& relief) {
  constexpr float kGroove = 0.45f;  // of the height: how deep the line between two locks is
  RaisedBrows brows;
  brows.skin_count = skin.positions.size();
  for (const Mesh& brow : hairs) {
    const std::vector<Strand> strands = list_strands(brow);
    if (strands.empty()) continue;
    const PointGrid grid = build_grid(strands);
    refine_under(skin, grid, brows);
    const float full = compute_full_density(grid, strands);
    const std::vector<Strand> locks = pick_locks(strands, relief.lock_mm);
    for (std::uint32_t v = 0; v < skin.positions.size(); ++v) {
      const glm::vec3& p = skin.positions[v];
      const float body = smooth_step(0.1f, 0.7f, grid.sum_around(p) / full);
      if (body <= 0) continue;
      float nearest = INFINITY;
      for (const Strand& lock : locks) nearest = std::min(nearest, compute_distance_mm(p, lock));
      const float groove = smooth_step(0.1f, 0.55f, nearest / relief.lock_mm);
      brows.heights.push_back({v, relief.height_mm * body * (1 - kGroove * groove)});
    }
  }
  brows.is_left_out.assign(brows.ends.size(), false);
  return brows;
}

void leave_out_brows(RaisedBrows& brows, const std::vector<bool>& is_kept) {
  brows.is_left_out.assign(brows.ends.size(), true);
  for (std::size_t i = brows.ends.size(); i-- > 0;) {
    if (is_kept[brows.skin_count + i]) brows.is_left_out[i] = false;
    if (brows.is_left_out[i]) continue;
    for (const std::uint32_t end : brows.ends[i])
      if (end >= brows.skin_count) brows.is_left_out[end - brows.skin_count] = false;
  }
  std::erase_if(brows.heights, [&](const auto& height) { return !is_kept[height.first]; });
}

void raise_brows(const RaisedBrows& brows, std::vector<glm::vec3>& positions,
                 std::vector<glm::vec3>& normals) {
  positions.resize(brows.skin_count);
  normals.resize(brows.skin_count);
  for (std::size_t i = 0; i < brows.ends.size(); ++i) {
    const auto [a, b] = brows.ends[i];
    if (brows.is_left_out[i]) {
      positions.emplace_back(0);
      normals.emplace_back(0);
      continue;
    }
    positions.push_back(compute_middle(positions[a], positions[b], normals[a], normals[b]));
    const glm::vec3 normal = normals[a] + normals[b];
    normals.push_back(glm::length(normal) > 0 ? glm::normalize(normal) : normals[a]);
  }
  for (const auto& [vertex, height_mm] : brows.heights) positions[vertex] += normals[vertex] * height_mm;
}

}  // namespace mien

#include "head/occlusion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/pool.hpp"

namespace mien {

namespace {

constexpr float kTexel_mm = 2.0f;  // of a depth map: larger blurs the nostrils away, smaller costs its square
constexpr int kDirections = 128;   // over the whole sphere; fewer show as faint outlines of single shadows
constexpr float kLift_mm = 1.2f;   // off the skin before looking, so that a vertex does not hide itself
constexpr float kSoft_mm = 3.0f;   // depth over which "hidden" fades in; a hard step would show the texels

// The mesh seen along -direction: depth of the nearest surface on a grid, larger is nearer.
struct DepthMap {
  glm::mat3 axes{1};  // rows of: right, up, toward the viewer
  glm::vec3 origin{0};
  int side = 0;
  std::vector<float> depth;

  glm::vec3 to_map(const glm::vec3& p) const {
    const glm::vec3 q = (p - origin) * axes;  // vector * matrix: dot with each column
    return {q.x / kTexel_mm + 0.5f * static_cast<float>(side),
            q.y / kTexel_mm + 0.5f * static_cast<float>(side), q.z};
  }
};

// Where std::ceil and std::floor call a library on a plain x86-64, for as much of a map as there is.
int round_up(float x) {
  const int whole = static_cast<int>(x);
  return whole + (static_cast<float>(whole) < x ? 1 : 0);
}
int round_down(float x) {
  const int whole = static_cast<int>(x);
  return whole - (static_cast<float>(whole) > x ? 1 : 0);
}

// Fills the texels whose centre a triangle covers, by its edge functions.
void draw_triangle(DepthMap& map, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (area <= 0) return;  // turned away: what it hides, a front face hides too
  const int x0 = std::max(0, round_up(std::min({a.x, b.x, c.x}) - 0.5f));
  const int x1 = std::min(map.side - 1, round_down(std::max({a.x, b.x, c.x}) - 0.5f));
  if (x0 > x1) return;  // most of them: they are smaller than a texel
  const int y0 = std::max(0, round_up(std::min({a.y, b.y, c.y}) - 0.5f));
  const int y1 = std::min(map.side - 1, round_down(std::max({a.y, b.y, c.y}) - 0.5f));
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const float px = static_cast<float>(x) + 0.5f, py = static_cast<float>(y) + 0.5f;
      const float u = (b.x - px) * (c.y - py) - (b.y - py) * (c.x - px);
      const float v = (c.x - px) * (a.y - py) - (c.y - py) * (a.x - px);
      const float w = area - u - v;
      if (u < 0 || v < 0 || w < 0) continue;
      float& depth = map.depth[static_cast<std::size_t>(y * map.side + x)];
      depth = std::max(depth, (u * a.z + v * b.z + w * c.z) / area);
    }
}

void draw_depth(DepthMap& map, const Mesh& mesh, const glm::vec3& direction,
                std::vector<glm::vec3>& scratch) {
  const glm::vec3 aside = std::abs(direction.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1);
  const glm::vec3 right = glm::normalize(glm::cross(aside, direction));
  map.axes = glm::mat3(right, glm::cross(direction, right), direction);
  map.depth.assign(static_cast<std::size_t>(map.side * map.side), std::numeric_limits<float>::lowest());
  scratch.resize(mesh.positions.size());
  for (std::size_t i = 0; i < scratch.size(); ++i) scratch[i] = map.to_map(mesh.positions[i]);
  for (const auto& [a, b, c] : mesh.triangles) draw_triangle(map, scratch[a], scratch[b], scratch[c]);
}

// 1 if nothing stands before `p` (in map coordinates), 0 if something does; the four nearest texels vote.
float look_up(const DepthMap& map, const glm::vec3& p) {
  const float x = p.x - 0.5f, y = p.y - 0.5f;
  const int x0 = std::clamp(static_cast<int>(x), 0, map.side - 2),
            y0 = std::clamp(static_cast<int>(y), 0, map.side - 2);
  const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
  const auto see = [&](int i, int j) {
    const float before = map.depth[static_cast<std::size_t>((y0 + j) * map.side + x0 + i)] - p.z;
    return 1 - std::clamp(before / kSoft_mm, 0.0f, 1.0f);
  };
  return (see(0, 0) * (1 - fx) + see(1, 0) * fx) * (1 - fy) + (see(0, 1) * (1 - fx) + see(1, 1) * fx) * fy;
}

// Even directions over the half sphere x > 0 (a Fibonacci spiral); the other half are their mirror images.
std::vector<glm::vec3> list_directions() {
  std::vector<glm::vec3> directions;
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int i = 0; i < kDirections; ++i) {
    const double y = 1 - (i + 0.5) * 2 / kDirections, r = std::sqrt(1 - y * y);
    const glm::dvec3 d(r * std::cos(turn * i), y, r * std::sin(turn * i));
    if (d.x > 0) directions.emplace_back(d);
  }
  return directions;
}

}  // namespace

std::vector<float> measure_openness(const Mesh& mesh, const std::vector<std::uint32_t>& mirror) {
  const std::size_t count = mesh.positions.size();
  const Box box = compute_bounds(mesh.positions);
  const std::vector<glm::vec3> directions = list_directions();
  std::vector<DepthMap> maps(directions.size());
  const int jobs = count_workers();
  std::vector<std::vector<glm::vec3>> scratch(static_cast<std::size_t>(jobs));
  for_each_index(maps.size(), jobs, [&](std::size_t i, int worker) {
    maps[i].origin = 0.5f * (box.low + box.high);
    maps[i].side = static_cast<int>(glm::length(box.high - box.low) / kTexel_mm) + 4;
    draw_depth(maps[i], mesh, directions[i], scratch[static_cast<std::size_t>(worker)]);
  });

  // Each vertex sums in the order of the directions, whoever does it.
  std::vector<float> open(count, 0.0f), all(count, 0.0f);
  constexpr std::size_t kShare = 2048;  // vertices at a time
  for_each_index((count + kShare - 1) / kShare, jobs, [&](std::size_t share, int) {
    for (std::size_t i = share * kShare; i < std::min(count, (share + 1) * kShare); ++i) {
      const glm::vec3 lifted = mesh.positions[i] + kLift_mm * mesh.normals[i];
      for (std::size_t d = 0; d < maps.size(); ++d) {
        const float cosine = glm::dot(mesh.normals[i], directions[d]);
        if (cosine <= 0) continue;
        all[i] += cosine;
        open[i] += cosine * look_up(maps[d], maps[d].to_map(lifted));
      }
    }
  });
  // What a vertex sees along a direction's mirror image is what its own mirror image sees along the
  // direction.
  std::vector<float> openness(count, 1.0f);
  for (std::size_t i = 0; i < count; ++i)
    if (const float sum = all[i] + all[mirror[i]]; sum > 0) openness[i] = (open[i] + open[mirror[i]]) / sum;
  return openness;
}

}  // namespace mien

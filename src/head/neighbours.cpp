#include "head/neighbours.hpp"

#include <algorithm>

namespace mien {

std::vector<PointRing> compute_rings(const Cage& cage) {
  std::vector<PointRing> rings(cage.points.size());
  const auto add_edge = [&](std::uint32_t from, std::uint32_t to) {
    auto& edges = rings[from].edges;
    if (std::find(edges.begin(), edges.end(), to) == edges.end()) edges.push_back(to);
  };
  std::vector<std::size_t> quads_at(cage.points.size(), 0);
  for (const Quad& quad : cage.quads)
    for (int i = 0; i < 4; ++i) {
      add_edge(quad[i], quad[(i + 1) % 4]);
      add_edge(quad[i], quad[(i + 3) % 4]);
      rings[quad[i]].diagonals.push_back(quad[(i + 2) % 4]);
      ++quads_at[quad[i]];
    }
  for (std::size_t i = 0; i < rings.size(); ++i) rings[i].is_boundary = rings[i].edges.size() != quads_at[i];
  return rings;
}

glm::dvec3 compute_limit(const PointRing& ring, std::uint32_t point, const std::vector<glm::dvec3>& points) {
  if (ring.is_boundary) return points[point];
  const auto n = static_cast<double>(ring.edges.size());
  glm::dvec3 sum = n * n * points[point];
  for (const std::uint32_t k : ring.edges) sum += 4.0 * points[k];
  for (const std::uint32_t k : ring.diagonals) sum += points[k];
  return sum / (n * (n + 5));
}

}  // namespace mien

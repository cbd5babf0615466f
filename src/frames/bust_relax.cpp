#include "frames/bust_relax.hpp"

#include <algorithm>
#include <utility>

#include "core/crossings.hpp"

namespace mien {

namespace {

// `wanted` and what lies beside it.
std::vector<bool> add_ring(const BustRelax& relax, const std::vector<bool>& wanted) {
  std::vector<bool> more = wanted;
  for (std::size_t v = 0; v < wanted.size(); ++v)
    if (wanted[v])
      for (std::uint32_t k = relax.first[v]; k < relax.first[v + 1]; ++k) more[relax.around[k]] = true;
  return more;
}

void smooth(const BustRelax& relax, const std::vector<bool>& wanted, std::vector<glm::vec3>& positions) {
  constexpr int kSteps = 3;
  for (int step = 0; step < kSteps; ++step) {
    const std::vector<glm::vec3> before = positions;
    for (std::size_t v = 0; v < wanted.size(); ++v) {
      const std::uint32_t first = relax.first[v], last = relax.first[v + 1];
      if (!wanted[v] || relax.is_fixed[v] || first == last) continue;
      glm::vec3 sum(0);
      for (std::uint32_t k = first; k < last; ++k) sum += before[relax.around[k]];
      positions[v] = 0.5f * (before[v] + sum / static_cast<float>(last - first));
    }
  }
}

}  // namespace

BustRelax build_bust_relax(const std::vector<Triangle>& triangles, std::vector<bool> is_fixed) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Triangle& t : triangles)
    for (int i = 0; i < 3; ++i) {
      edges.emplace_back(t[i], t[(i + 1) % 3]);
      edges.emplace_back(t[(i + 1) % 3], t[i]);
    }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  BustRelax relax;
  relax.first.assign(is_fixed.size() + 1, 0);
  for (const auto& [from, to] : edges) {
    ++relax.first[from + 1];
    relax.around.push_back(to);
  }
  for (std::size_t v = 0; v < is_fixed.size(); ++v) relax.first[v + 1] += relax.first[v];
  relax.is_fixed = std::move(is_fixed);
  return relax;
}

void relax_crossings(const BustRelax& relax, const std::vector<Triangle>& triangles,
                     const std::function<void(std::vector<glm::vec3>&)>& finish,
                     std::vector<glm::vec3>& positions) {
  constexpr int kRounds = 12;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<glm::vec3> print = positions;
    finish(print);
    const std::vector<Crossing> crossings = find_crossings(print, triangles);
    if (crossings.empty()) return;
    std::vector<bool> wanted(positions.size(), false);
    for (const Crossing& pair : crossings)
      for (const std::uint32_t t : pair)
        for (const std::uint32_t v : triangles[t]) wanted[v] = true;
    for (int ring = 0; ring <= round / 2; ++ring) wanted = add_ring(relax, wanted);
    smooth(relax, wanted, positions);
  }
}

}  // namespace mien

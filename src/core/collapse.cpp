#include "core/collapse.hpp"

namespace mien {

void Quadric::add_plane(const glm::dvec3& n, double offset, double weight) {
  xx += weight * n.x * n.x, xy += weight * n.x * n.y, xz += weight * n.x * n.z;
  yy += weight * n.y * n.y, yz += weight * n.y * n.z, zz += weight * n.z * n.z;
  b += weight * offset * n;
  c += weight * offset * offset;
}

void Quadric::add(const Quadric& other) {
  xx += other.xx, xy += other.xy, xz += other.xz, yy += other.yy, yz += other.yz, zz += other.zz;
  b += other.b;
  c += other.c;
}

double Quadric::measure(const glm::dvec3& p) const {
  const double square = xx * p.x * p.x + yy * p.y * p.y + zz * p.z * p.z +
                        2 * (xy * p.x * p.y + xz * p.x * p.z + yz * p.y * p.z);
  return std::max(0.0, square - 2 * glm::dot(b, p) + c);
}

CollapseNet build_collapse_net(std::vector<Triangle> triangles, std::size_t count) {
  CollapseNet net;
  net.triangles = std::move(triangles);
  net.alive = net.triangles.size();
  net.is_alive.assign(net.alive, true);
  net.around.resize(count);
  for (std::uint32_t t = 0; t < net.triangles.size(); ++t)
    for (const std::uint32_t v : net.triangles[t]) net.around[v].push_back(t);
  return net;
}

void list_neighbours(const CollapseNet& net, std::uint32_t v, std::vector<std::uint32_t>& found) {
  found.clear();
  for (const std::uint32_t t : net.around[v])
    for (const std::uint32_t w : net.triangles[t])
      if (w != v) found.push_back(w);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

bool keeps_surface(const CollapseNet& net, std::uint32_t drop, std::uint32_t keep,
                   std::array<std::vector<std::uint32_t>, 2>& rings) {
  std::vector<std::uint32_t>& dropped = rings[0];
  std::vector<std::uint32_t>& kept = rings[1];
  list_neighbours(net, drop, dropped);
  list_neighbours(net, keep, kept);
  if (!std::binary_search(dropped.begin(), dropped.end(), keep) || dropped.size() + kept.size() <= 7)
    return false;
  return std::ranges::count_if(
             dropped, [&](std::uint32_t v) { return std::binary_search(kept.begin(), kept.end(), v); }) == 2;
}

void join_vertices(CollapseNet& net, std::uint32_t drop, std::uint32_t keep) {
  for (const std::uint32_t t : net.around[drop]) {
    Triangle& corners = net.triangles[t];
    if (std::find(corners.begin(), corners.end(), keep) != corners.end()) {
      net.is_alive[t] = false;
      --net.alive;
      for (const std::uint32_t v : corners)
        if (v != drop) std::erase(net.around[v], t);
      continue;
    }
    std::replace(corners.begin(), corners.end(), drop, keep);
    net.around[keep].push_back(t);
  }
  net.around[drop].clear();
}

std::vector<bool> compute_open_vertices(const std::vector<Triangle>& triangles, std::size_t count) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
    for (int i = 0; i < 3; ++i) edges.push_back({t[i], t[(i + 1) % 3]});
  std::sort(edges.begin(), edges.end());
  std::vector<bool> is_open(count, false);
  for (const auto& [from, to] : edges)
    if (!std::binary_search(edges.begin(), edges.end(), std::array{to, from}))
      is_open[from] = is_open[to] = true;
  return is_open;
}

}  // namespace mien

#include "wire/slice.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

namespace mien {

namespace {

using CutEdge = std::pair<std::uint32_t, std::uint32_t>;  // of the surface, the lower index first

}  // namespace

std::vector<WireLine> slice_solid(const WireSolid& solid, const glm::dvec3& normal, double offset, Pen pen) {
  std::vector<double> above;
  for (const glm::vec3& p : solid.positions) above.push_back(glm::dot(normal, glm::dvec3(p)) - offset);
  // A triangle that is cut is cut in two edges: the way through it. A vertex on the plane counts as above.
  std::vector<std::array<CutEdge, 2>> ways;
  std::map<CutEdge, std::vector<std::uint32_t>> at;  // of each edge, the ways that end in it
  for (const Triangle& triangle : solid.triangles) {
    std::array<CutEdge, 2> ends;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
      if ((above[a] < 0) != (above[b] < 0) && count < 2) ends[count++] = std::minmax(a, b);
    }
    if (count < 2) continue;
    for (const CutEdge& end : ends) at[end].push_back(static_cast<std::uint32_t>(ways.size()));
    ways.push_back(ends);
  }
  const auto find_place = [&](const CutEdge& edge) {
    const auto [a, b] = edge;
    const double t = above[a] / (above[a] - above[b]);
    return glm::vec3(glm::mix(glm::dvec3(solid.positions[a]), glm::dvec3(solid.positions[b]), t));
  };
  std::vector<bool> is_used(ways.size(), false);
  std::vector<WireLine> lines;
  const auto follow = [&](std::uint32_t first, std::size_t end) {
    WireLine line{{find_place(ways[first][end])}, pen};
    CutEdge from = ways[first][end];
    std::optional<std::uint32_t> way = first;
    while (way) {
      is_used[*way] = true;
      from = ways[*way][0] == from ? ways[*way][1] : ways[*way][0];
      line.points.push_back(find_place(from));
      way.reset();
      for (const std::uint32_t next : at.at(from))
        if (!is_used[next]) way = next;
    }
    lines.push_back(std::move(line));
  };
  for (std::uint32_t w = 0; w < ways.size(); ++w)
    for (std::size_t end = 0; end < 2; ++end)
      if (!is_used[w] && at.at(ways[w][end]).size() == 1) follow(w, end);
  for (std::uint32_t w = 0; w < ways.size(); ++w)
    if (!is_used[w]) follow(w, 0);
  return lines;
}

}  // namespace mien

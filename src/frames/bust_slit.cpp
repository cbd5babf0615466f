#include "frames/bust_slit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>

#include "core/error.hpp"
#include "core/smooth.hpp"
#include "head/cage.hpp"
#include "head/contact.hpp"
#include "head/surface.hpp"

namespace mien {

namespace {

// The ring's vertices by their place round the opening in quarters of a cage's column.
std::map<int, std::uint32_t> list_quarters(const std::vector<MarginVertex>& ring) {
  std::map<int, std::uint32_t> quarters;
  for (const MarginVertex& v : ring) quarters[static_cast<int>(std::lround(4 * v.at)) % 64] = v.vertex;
  return quarters;
}

// The four-times finer way along an edge of the cage: from the point `from` to `to`, which is left out.
std::vector<std::uint32_t> find_edge(const std::vector<std::vector<std::uint32_t>>& neighbours,
                                     std::uint32_t from, std::uint32_t to) {
  std::map<std::uint32_t, std::uint32_t> came_from{{to, to}};
  std::queue<std::uint32_t> queue;
  for (queue.push(to); !queue.empty() && !came_from.contains(from); queue.pop())
    for (const std::uint32_t next : neighbours[queue.front()])
      if (came_from.emplace(next, queue.front()).second) queue.push(next);
  if (!came_from.contains(from)) throw RunError("internal: the lips are not joined");
  std::vector<std::uint32_t> path;
  for (std::uint32_t at = from; at != to; at = came_from[at]) path.push_back(at);
  return path;
}

// A ring of the lips ("M0"): the upper and the lower half, each from the right corner to the left one.
struct LipRow {
  std::vector<std::uint32_t> upper, lower;
};

LipRow compute_lip_row(const NeutralHead& head, const std::string& ring) {
  constexpr int kCorner = 6, kBottom = 12;  // of a half-ring: 0 is its top
  std::vector<std::vector<std::uint32_t>> neighbours(head.skin.positions.size());
  for (const Quad& q : head.surface->quads)
    for (int i = 0; i < 4; ++i) neighbours[q[i]].push_back(q[(i + 1) % 4]);
  const auto point = [&](int i, bool is_left) {
    const std::uint32_t p = find_point(head.cage, fmt::format("{}_{}", ring, i));
    return is_left ? p : head.cage.mirror[p];
  };
  const auto walk = [&](int first) {  // right corner, the middle, left corner
    const int step = first == 0 ? 1 : -1;
    std::vector<std::uint32_t> stops, path;
    for (int i = kCorner; i != first; i -= step) stops.push_back(point(i, false));
    for (int i = first; i != kCorner; i += step) stops.push_back(point(i, true));
    stops.push_back(point(kCorner, true));
    for (std::size_t i = 0; i + 1 < stops.size(); ++i)
      for (const std::uint32_t v : find_edge(neighbours, stops[i], stops[i + 1])) path.push_back(v);
    path.push_back(stops.back());
    return path;
  };
  return {walk(0), walk(kBottom)};
}

// Where a walk over the skin from the rims has come to.
struct Reached {
  float way_mm = std::numeric_limits<float>::infinity();
  std::uint32_t column = 0;
  float side = 0;

  bool operator>(const Reached& other) const { return way_mm > other.way_mm; }
};

std::vector<Reached> walk_from_rims(const Mesh& cut, const Slit& slit, float far_mm) {
  std::vector<std::vector<std::uint32_t>> neighbours(cut.positions.size());
  for (const Triangle& t : cut.triangles)
    for (int i = 0; i < 3; ++i) neighbours[t[i]].push_back(t[(i + 1) % 3]);
  using Step = std::pair<Reached, std::uint32_t>;
  const auto is_later = [](const Step& a, const Step& b) {
    return std::pair{a.first.way_mm, a.second} > std::pair{b.first.way_mm, b.second};
  };
  std::priority_queue<Step, std::vector<Step>, decltype(is_later)> queue(is_later);
  std::vector<Reached> reached(cut.positions.size());
  const auto reach = [&](std::uint32_t v, const Reached& how) {
    if (how.way_mm >= reached[v].way_mm || how.way_mm > far_mm) return;
    reached[v] = how;
    queue.push({how, v});
  };
  for (std::uint32_t c = 1; c + 1 < slit.columns.size(); ++c) {
    reach(slit.columns[c].upper.front(), {0, c, 1});
    reach(slit.columns[c].lower.front(), {0, c, -1});
  }
  while (!queue.empty()) {
    const auto [how, v] = queue.top();
    queue.pop();
    if (how.way_mm > reached[v].way_mm) continue;
    for (const std::uint32_t next : neighbours[v])
      reach(next, {how.way_mm + glm::distance(cut.positions[v], cut.positions[next]), how.column, how.side});
  }
  return reached;
}

// What a rim is at a place across the slit; `across` and `heights` of its columns, whose ends are corners.
float sample_rim(const std::vector<float>& across, const std::vector<float>& heights, float at) {
  std::size_t i = 2;
  while (i + 2 < across.size() && across[i] < at) ++i;
  const float width = across[i] - across[i - 1];
  const float share = width > 0 ? std::clamp((at - across[i - 1]) / width, 0.0f, 1.0f) : 0;
  return glm::mix(heights[i - 1], heights[i], share);
}

// How far apart the rims are in height, column by column: straight above and below one another, since lids
// slide when they shut and a column's two ends come to lie aside of each other on a line that slopes.
std::vector<float> measure_rooms(const Slit& slit, const std::vector<float>& lowest,
                                 const std::vector<float>& highest, const std::vector<glm::vec3>& positions) {
  std::vector<float> upper, lower, rooms(slit.columns.size(), 0);
  for (const SlitColumn& column : slit.columns) {
    upper.push_back(positions[column.upper.front()].x);
    lower.push_back(positions[column.lower.front()].x);
  }
  for (std::size_t c = 1; c + 1 < rooms.size(); ++c)
    rooms[c] = std::min(lowest[c] - sample_rim(lower, highest, upper[c]),
                        sample_rim(upper, lowest, lower[c]) - highest[c]);
  return rooms;
}

}  // namespace

Slit compute_eye_slit(const NeutralHead& head, int side) {
  constexpr int kOuter = 32, kAll = 64;  // quarters of a column: the outer corner, once round
  const auto inner = list_quarters(compute_lid_ring(*head.surface, head.cage));
  const auto outer = list_quarters(compute_lid_ring(*head.surface, head.cage, {"E0_", "E1_", "E2_"}));
  const auto vertex = [&](const std::map<int, std::uint32_t>& ring, int at) {
    const auto found = ring.find(at % kAll);
    if (found == ring.end()) throw RunError("internal: a ring of the lids has a gap");
    return side > 0 ? found->second : head.surface->mirror[found->second];
  };
  Slit slit;
  for (int at = 0; at <= kOuter; ++at)
    slit.columns.push_back(
        {{vertex(inner, at), vertex(outer, at)}, {vertex(inner, kAll - at), vertex(outer, kAll - at)}});
  if (side < 0) std::reverse(slit.columns.begin(), slit.columns.end());
  return slit;
}

Slit compute_mouth_slit(const NeutralHead& head) {
  const LipRow inner = compute_lip_row(head, "M0"), outer = compute_lip_row(head, "M1");
  Slit slit;
  slit.is_bulging = true;
  for (std::size_t i = 0; i < inner.upper.size(); ++i)
    slit.columns.push_back({{inner.upper[i], outer.upper[i]}, {inner.lower[i], outer.lower[i]}});
  return slit;
}

void spread_slit(const Mesh& cut, float near_mm, float far_mm, Slit& slit) {
  const std::vector<Reached> reached = walk_from_rims(cut, slit, far_mm);
  for (std::uint32_t v = 0; v < reached.size(); ++v)
    if (reached[v].way_mm <= far_mm)
      slit.vertices.push_back(
          {v, reached[v].column, reached[v].side * (1 - smooth_step(near_mm, far_mm, reached[v].way_mm))});
}

void part_slit(const Slit& slit, float width_mm, std::vector<glm::vec3>& positions) {
  constexpr float kMoved = 0.999f;  // of the rim's way
  constexpr float kEnd = 0.12f;     // of the slit: the line fades into its ends
  const std::size_t count = slit.columns.size();
  const auto find_from_end = [&](std::size_t c) {
    const float along = float(c) / float(count - 1);
    return std::min(along, 1 - along);
  };
  std::vector<float> lowest(count, std::numeric_limits<float>::infinity());  // of what is above, in y
  std::vector<float> highest(count, -std::numeric_limits<float>::infinity());
  for (std::size_t c = 1; c + 1 < count; ++c) {
    for (const std::uint32_t u : slit.columns[c].upper) lowest[c] = std::min(lowest[c], positions[u].y);
    for (const std::uint32_t l : slit.columns[c].lower) highest[c] = std::max(highest[c], positions[l].y);
  }
  for (const SlitVertex& v : slit.is_bulging ? slit.vertices : std::vector<SlitVertex>()) {
    if (find_from_end(v.column) < kEnd) continue;  // what is beside the corner, is not before the slit
    const float y = positions[v.vertex].y;
    if (v.share > kMoved) lowest[v.column] = std::min(lowest[v.column], y);
    if (v.share < -kMoved) highest[v.column] = std::max(highest[v.column], y);
  }
  const std::vector<float> rooms = measure_rooms(slit, lowest, highest, positions);
  std::vector<float> ways(count, 0.0f);
  for (std::size_t c = 1; c + 1 < count; ++c) {
    const float taper = smooth_step(0, kEnd, find_from_end(c));
    ways[c] = 0.5f * std::max(0.0f, width_mm * (0.25f + 0.75f * taper) - rooms[c]);
  }
  for (const SlitVertex& v : slit.vertices) positions[v.vertex].y += v.share * ways[v.column];
}

void cut_slit(Mesh& mesh, const Slit& slit, std::uint32_t seed) {
  std::vector<bool> is_wall(mesh.positions.size(), false), is_cut(mesh.positions.size(), false);
  for (const SlitColumn& column : slit.columns)
    is_wall[column.upper.front()] = is_wall[column.lower.front()] = true;
  is_cut[seed] = true;
  for (bool is_growing = true; is_growing;) {
    is_growing = false;
    for (const Triangle& t : mesh.triangles) {
      if (!is_cut[t[0]] && !is_cut[t[1]] && !is_cut[t[2]]) continue;
      for (const std::uint32_t v : t)
        if (!is_cut[v] && !is_wall[v]) is_cut[v] = is_growing = true;
    }
  }
  // What hangs on the rims only (a sliver between them) goes with it.
  std::erase_if(mesh.triangles,
                [&](const Triangle& t) { return is_cut[t[0]] || is_cut[t[1]] || is_cut[t[2]]; });
}

}  // namespace mien

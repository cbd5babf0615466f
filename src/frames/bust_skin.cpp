#include "frames/bust_skin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>
#include <numbers>
#include <set>
#include <string>

#include "core/error.hpp"
#include "core/holes.hpp"
#include "head/cage.hpp"
#include "head/surface.hpp"

namespace mien {

namespace {

constexpr int kLipPoints = 13;  // of a half-ring round the mouth: 0 top, 6 corner, 12 bottom

using Neighbours = std::vector<std::vector<std::uint32_t>>;

Neighbours find_neighbours(const std::vector<Quad>& quads, std::size_t vertex_count) {
  Neighbours neighbours(vertex_count);
  for (const Quad& q : quads)
    for (int i = 0; i < 4; ++i) neighbours[q[i]].push_back(q[(i + 1) % 4]);
  return neighbours;
}

// The vertices from `from` to `to` by the fewest edges, `to` itself left out. Along an edge of the cage there
// is only one such way.
Loop find_path(const Neighbours& neighbours, std::uint32_t from, std::uint32_t to) {
  std::map<std::uint32_t, std::uint32_t> came_from{{to, to}};
  std::deque<std::uint32_t> queue{to};
  while (!queue.empty() && !came_from.contains(from)) {
    for (const std::uint32_t next : neighbours[queue.front()])
      if (came_from.emplace(next, queue.front()).second) queue.push_back(next);
    queue.pop_front();
  }
  if (!came_from.contains(from)) throw RunError("internal: the lips are not joined");
  Loop path;
  for (std::uint32_t at = from; at != to; at = came_from[at]) path.push_back(at);
  return path;
}

// The ring of the lips called `ring` ("M1") as a loop of the fine mesh, from the top over the left corner,
// the bottom and the right corner back.
Loop find_lip_ring(const NeutralHead& head, const std::string& ring) {
  const Neighbours neighbours = find_neighbours(head.surface->quads, head.skin.positions.size());
  std::vector<std::uint32_t> points;
  for (int i = 0; i < kLipPoints; ++i) points.push_back(find_point(head.cage, fmt::format("{}_{}", ring, i)));
  for (int i = kLipPoints - 2; i > 0; --i) points.push_back(head.cage.mirror[points[i]]);
  Loop loop;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Loop path = find_path(neighbours, points[i], points[(i + 1) % points.size()]);
    loop.insert(loop.end(), path.begin(), path.end());
  }
  return loop;
}

// Takes the triangles out that can be reached from `seed` without crossing `border`.
void cut_out(Mesh& mesh, const Loop& border, std::uint32_t seed) {
  const std::set<std::uint32_t> walls(border.begin(), border.end());
  std::vector<bool> is_cut(mesh.positions.size(), false);
  is_cut[seed] = true;
  for (bool is_growing = true; is_growing;) {
    is_growing = false;
    for (const Triangle& t : mesh.triangles) {
      if (!is_cut[t[0]] && !is_cut[t[1]] && !is_cut[t[2]]) continue;
      for (const std::uint32_t v : t)
        if (!is_cut[v] && !walls.contains(v)) is_cut[v] = is_growing = true;
    }
  }
  std::erase_if(mesh.triangles,
                [&](const Triangle& t) { return is_cut[t[0]] || is_cut[t[1]] || is_cut[t[2]]; });
}

// A column of the mouth's opening: a vertex of the upper lip and the one of the lower lip beneath it.
struct LipPair {
  std::uint32_t upper = 0, lower = 0;
};

// From the right corner to the left one, both corners included (upper and lower are one there).
std::vector<LipPair> pair_lips(const Loop& ring) {
  const std::size_t half = ring.size() / 2, quarter = ring.size() / 4;
  std::vector<LipPair> pairs;
  for (std::size_t i = 0; i <= 2 * quarter; ++i)
    pairs.push_back({ring[(ring.size() - quarter + i) % ring.size()], ring[half + quarter - i]});
  return pairs;
}

float find_widest_gap_mm(const std::vector<glm::vec3>& positions, const std::vector<LipPair>& pairs) {
  float widest = 0;
  for (const LipPair& pair : pairs)
    widest = std::max(widest, positions[pair.upper].y - positions[pair.lower].y);
  return widest;
}

// Lips that touch or pass each other are moved apart, half and half, to a line that a solid can hold.
void part_lips(std::vector<glm::vec3>& positions, const std::vector<LipPair>& pairs) {
  constexpr float kLine_mm = 0.3f;
  for (std::size_t i = 1; i + 1 < pairs.size(); ++i) {
    glm::vec3 &upper = positions[pairs[i].upper], &lower = positions[pairs[i].lower];
    const float lack = kLine_mm - (upper.y - lower.y);
    if (lack <= 0) continue;
    upper.y += lack / 2;
    lower.y -= lack / 2;
  }
}

// The back of the mouth: from the upper to the lower lip over a hollow as deep as the mouth is open, up to a
// limit. Teeth stand out of its roof and floor.
void append_mouth_back(Mesh& mesh, const std::vector<LipPair>& pairs) {
  constexpr int kRows = 10;             // steps from lip to lip
  constexpr float kDepthPerGap = 0.9f;  // deeper would be hidden, and hard to clean of support
  constexpr float kDeepest_mm = 17;     // behind the teeth
  const std::size_t columns = pairs.size();
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::size_t c = 1; c + 1 < columns; ++c) {
    const glm::vec3 upper = mesh.positions[pairs[c].upper], lower = mesh.positions[pairs[c].lower];
    const float depth = std::min(kDepthPerGap * glm::length(upper - lower), kDeepest_mm);
    for (int row = 1; row < kRows; ++row) {
      // Even steps along a superellipse of the fourth degree: steep walls, a nearly flat back.
      const float angle = std::numbers::pi_v<float> * float(row) / kRows;
      const float across = (1 - std::copysign(std::sqrt(std::abs(std::cos(angle))), std::cos(angle))) / 2;
      const float back = std::sqrt(std::sin(angle));
      mesh.positions.push_back(glm::mix(upper, lower, across) - glm::vec3(0, 0, depth * back));
    }
  }
  const auto vertex = [&](std::size_t column, int row) -> std::uint32_t {
    if (row == 0 || column == 0 || column + 1 == columns) return pairs[column].upper;
    if (row == kRows) return pairs[column].lower;
    return first + static_cast<std::uint32_t>(column - 1) * (kRows - 1) + row - 1;
  };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) mesh.triangles.push_back({a, b, c});
  };
  for (std::size_t c = 0; c + 1 < columns; ++c)
    for (int row = 0; row < kRows; ++row) {
      add(vertex(c, row), vertex(c, row + 1), vertex(c + 1, row + 1));
      add(vertex(c, row), vertex(c + 1, row + 1), vertex(c + 1, row));
    }
}

// Cuts the mouth bag off at the lips and closes them.
void close_mouth(const NeutralHead& head, Mesh& mesh) {
  constexpr float kOpen_mm = 3;  // below it the line between the lips is all that a print can show
  Loop ring = find_lip_ring(head, "M1");
  if (find_widest_gap_mm(mesh.positions, pair_lips(ring)) > kOpen_mm) ring = find_lip_ring(head, "M0");
  cut_out(mesh, ring, find_point(head.cage, "MB2_0"));
  const std::vector<LipPair> pairs = pair_lips(ring);
  part_lips(mesh.positions, pairs);
  append_mouth_back(mesh, pairs);
}

// The loop that reaches lowest is the chest's edge.
std::size_t find_chest_loop(const Mesh& mesh, const std::vector<Loop>& loops) {
  const auto lowest = [&](const Loop& loop) {
    float y = mesh.positions[loop.front()].y;
    for (const std::uint32_t v : loop) y = std::min(y, mesh.positions[v].y);
    return y;
  };
  const auto found = std::min_element(loops.begin(), loops.end(),
                                      [&](const Loop& a, const Loop& b) { return lowest(a) < lowest(b); });
  return static_cast<std::size_t>(found - loops.begin());
}

// A funnel from the chest's edge down to a round, flat foot: steep enough to print without support, as a bust
// on its socle has always been cut.
void append_foot(BustSkin& skin, const Loop& chest) {
  constexpr int kRings = 10;
  constexpr float kDrop = 0.36f;    // of half the chest's breadth: from its lowest edge to the foot
  constexpr float kRadius = 0.28f;  // of half the chest's breadth: the foot's; thinner would break off
  Mesh& mesh = skin.mesh;
  Box box{mesh.positions[chest.front()], mesh.positions[chest.front()]};
  for (const std::uint32_t v : chest) {
    box.low = glm::min(box.low, mesh.positions[v]);
    box.high = glm::max(box.high, mesh.positions[v]);
  }
  skin.chest_y_mm = box.low.y;
  const float half_breadth = (box.high.x - box.low.x) / 2;
  skin.foot = {(box.low.x + box.high.x) / 2, box.low.y - kDrop * half_breadth, (box.low.z + box.high.z) / 2};
  skin.foot_radius_mm = kRadius * half_breadth;

  std::vector<glm::vec3> edge;
  for (const std::uint32_t v : chest) edge.push_back(mesh.positions[v]);
  Loop above = chest;
  for (int ring = 1; ring <= kRings; ++ring) {
    const float way = float(ring) / kRings;
    Loop below;
    for (const glm::vec3& p : edge) {
      const glm::vec3 out = glm::normalize(glm::vec3(p.x - skin.foot.x, 0, p.z - skin.foot.z));
      const glm::vec3 end = skin.foot + out * skin.foot_radius_mm;
      glm::vec3 at = glm::mix(p, end, way);
      at.y =
          glm::mix(p.y, end.y, 0.35f * way + 0.65f * way * way * way);  // flatter above, upright at the foot
      below.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.push_back(at);
    }
    append_band(mesh, above, below);
    above = below;
  }
  append_fan_cap(mesh, above, skin.foot);
}

// Lids end in a ring sunk into the eyeball: its cap is a flat cone whose tip lies inside the ball.
bool close_eye(const NeutralHead& head, Mesh& mesh, const Loop& loop) {
  const glm::vec3 middle = find_loop_centre(mesh.positions, loop);
  for (const float side : {1.0f, -1.0f}) {
    const glm::vec3 centre = glm::vec3(head.eye.centre) * glm::vec3(side, 1, 1);
    if (glm::length(middle - centre) > head.eye.radius_mm) continue;
    append_fan_cap(mesh, loop, glm::mix(middle, centre, 0.5f));
    return true;
  }
  return false;
}

}  // namespace

BustSkin build_bust_skin(const NeutralHead& head, const std::vector<glm::vec3>& positions) {
  BustSkin skin;
  // Without the vertices that only folds need.
  skin.mesh.positions.assign(positions.begin(),
                             positions.begin() + static_cast<std::ptrdiff_t>(head.skin.positions.size()));
  skin.mesh.triangles = head.skin.triangles;
  close_mouth(head, skin.mesh);
  const std::vector<Loop> loops = find_boundary_loops(skin.mesh.triangles);
  if (loops.empty()) throw RunError("internal: the skin has no edge to stand on");
  const std::size_t chest = find_chest_loop(skin.mesh, loops);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (i == chest)
      append_foot(skin, loops[i]);
    else if (!close_eye(head, skin.mesh, loops[i]))
      append_ear_cap(skin.mesh, loops[i]);
  }
  return skin;
}

}  // namespace mien

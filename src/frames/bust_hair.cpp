#include "frames/bust_hair.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "core/conventions.hpp"
#include "core/holes.hpp"
#include "core/smooth.hpp"

namespace mien {

namespace {

// Neighbours of each vertex, in rows.
std::vector<std::vector<std::uint32_t>> list_around(const Mesh& mesh) {
  std::vector<std::vector<std::uint32_t>> around(mesh.positions.size());
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) around[t[i]].push_back(t[(i + 1) % 3]);
  return around;
}

// What can be reached from `seed` over vertices that are `is_inside` or not as it is.
std::vector<bool> flood(const std::vector<std::vector<std::uint32_t>>& around,
                        const std::vector<bool>& is_inside, std::uint32_t seed) {
  std::vector<bool> is_reached(is_inside.size(), false);
  std::vector<std::uint32_t> open{seed};
  is_reached[seed] = true;
  while (!open.empty()) {
    const std::uint32_t v = open.back();
    open.pop_back();
    for (const std::uint32_t n : around[v])
      if (!is_reached[n] && is_inside[n] == is_inside[seed]) {
        is_reached[n] = true;
        open.push_back(n);
      }
  }
  return is_reached;
}

// How far the hair lies over each vertex, mm; of one piece, and so is what it leaves free. Empty: no hair.
std::vector<float> measure_cover(const NeutralHead& head, const HairRelief& relief, std::size_t skin_count,
                                 const Mesh& mesh) {
  constexpr float kFree_mm = -1, kCovered_mm = 1;
  const std::vector<HairGround> grounds = list_hair_grounds(head);
  std::vector<float> cover(mesh.positions.size(), kFree_mm);
  std::uint32_t top = 0;
  for (std::uint32_t v = 0; v < skin_count; ++v) {
    const glm::dvec3 at(mesh.positions[v]);
    const HairPlace place = compute_hair_place(relief.chart, at);
    const double out = glm::distance(compute_hair_point(relief.chart, place, 0), at);
    cover[v] = static_cast<float>(sample_hair_relief(relief, place) - out);
    if (v < grounds.size() && grounds[v] == HairGround::ear)
      cover[v] = relief.covers_ears ? std::max(cover[v], kCovered_mm) : std::min(cover[v], kFree_mm);
    if (at.y > mesh.positions[top].y) top = v;
  }
  if (cover[top] <= 0) return {};
  const auto around = list_around(mesh);
  std::vector<bool> is_inside;
  for (const float c : cover) is_inside.push_back(c > 0);
  const std::vector<bool> is_hair = flood(around, is_inside, top);
  const std::vector<bool> is_free =
      flood(around, is_hair, static_cast<std::uint32_t>(mesh.positions.size() - 1));
  for (std::size_t v = 0; v < cover.size(); ++v) {
    if (is_hair[v]) continue;
    cover[v] = is_free[v] ? std::min(cover[v], -0.1f) : kCovered_mm;
  }
  return cover;
}

// Cuts along the line where the cover is 0; what lies under it goes.
std::vector<HairEdgeVertex> cut_skin(const std::vector<float>& cover, Mesh& mesh) {
  constexpr float kLeast = 0.15f;  // of an edge, from its ends: nearer ones make slivers
  std::vector<HairEdgeVertex> edge;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto find_cut = [&](std::uint32_t a, std::uint32_t b) {
    if (a > b) std::swap(a, b);
    const auto [place, is_new] = known.try_emplace({a, b}, first + static_cast<std::uint32_t>(edge.size()));
    if (is_new) {
      const float share = std::clamp(cover[a] / (cover[a] - cover[b]), kLeast, 1 - kLeast);
      edge.push_back({{a, b}, share, glm::mix(mesh.positions[a], mesh.positions[b], share)});
    }
    return place->second;
  };
  std::vector<Triangle> left;
  for (const Triangle& t : mesh.triangles) {
    const auto is_under = [&](int i) { return cover[t[i % 3]] > 0; };
    const int count = is_under(0) + is_under(1) + is_under(2);
    if (count == 0) left.push_back(t);
    if (count == 0 || count == 3) continue;
    int lone = 0;  // the corner on its own side
    while (is_under(lone) != (count == 1)) ++lone;
    const std::uint32_t a = t[lone], b = t[(lone + 1) % 3], c = t[(lone + 2) % 3];
    const std::uint32_t ab = find_cut(a, b), ca = find_cut(c, a);
    if (count == 2) {
      left.push_back({a, ab, ca});
    } else {
      left.push_back({ab, b, c});
      left.push_back({ab, c, ca});
    }
  }
  mesh.triangles = std::move(left);
  for (const HairEdgeVertex& v : edge) mesh.positions.push_back(v.rest);
  return edge;
}

// The chart laid flat: the whorl in the middle, a way a radius, mm.
struct Plan {
  const HairRelief& relief;
  std::vector<glm::dvec2> points;  // by vertex; of the hair's alone

  glm::dvec2 lay(const HairPlace& place) const {
    const double turn = place.azimuth_deg * kRadiansPerDegree, out = place.way * relief.chart.drop_mm;
    return {out * std::sin(turn), out * std::cos(turn)};
  }
};

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

double compute_plan_area(const std::vector<glm::dvec2>& line) {
  double sum = 0;
  for (std::size_t i = 0; i < line.size(); ++i) sum += cross(line[i], line[(i + 1) % line.size()]) / 2;
  return sum;
}

bool is_crossed(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  const double e = cross(b - a, c - a), f = cross(b - a, d - a), g = cross(d - c, a - c),
               h = cross(d - c, b - c);
  return (e > 0) != (f > 0) && (g > 0) != (h > 0);
}

bool is_simple(const std::vector<glm::dvec2>& line) {
  const std::size_t n = line.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && is_crossed(line[i], line[i + 1], line[j], line[(j + 1) % n])) return false;
  return true;
}

// The edge on the plan, evened out until it does not cross itself; empty if it always does.
std::vector<glm::dvec2> even_out(std::vector<glm::dvec2> line) {
  constexpr int kFewest = 2, kMost = 60;
  const std::size_t n = line.size();
  for (int round = 0; round < kMost; ++round) {
    if (round >= kFewest && is_simple(line)) return line;
    const std::vector<glm::dvec2> before = line;
    for (std::size_t i = 0; i < n; ++i)
      line[i] = 0.25 * before[(i + n - 1) % n] + 0.5 * before[i] + 0.25 * before[(i + 1) % n];
  }
  return {};
}

bool is_within(const std::vector<glm::dvec2>& line, const glm::dvec2& p) {
  bool is_in = false;
  for (std::size_t i = 0, j = line.size() - 1; i < line.size(); j = i++)
    if ((line[i].y > p.y) != (line[j].y > p.y) &&
        p.x < line[j].x + (p.y - line[j].y) / (line[i].y - line[j].y) * (line[i].x - line[j].x))
      is_in = !is_in;
  return is_in;
}

// The vertex of the edge that is nearest to a place, and how far it is on the head, mm.
std::pair<std::size_t, double> find_nearest(const Plan& plan, const std::vector<glm::dvec2>& line,
                                            const glm::dvec2& p) {
  const double round_mm = 85 * plan.relief.chart.size, out = glm::length(p);
  const double narrow = out > round_mm ? round_mm / out : 1;  // what the plan makes too broad
  const glm::dvec2 along = out > 0 ? p / out : glm::dvec2(0, 1), aside(along.y, -along.x);
  std::pair<std::size_t, double> nearest{0, 1e18};
  for (std::size_t i = 0; i < line.size(); ++i) {
    const glm::dvec2 arm = line[i] - p;
    const double x = glm::dot(arm, along), y = narrow * glm::dot(arm, aside);
    if (const double squared = x * x + y * y; squared < nearest.second) nearest = {i, squared};
  }
  nearest.second = std::sqrt(nearest.second);
  return nearest;
}

// A band between two rings, each evenly around, counter-clockwise seen from their middle's outside.
void append_zip(std::vector<Triangle>& triangles, const Loop& outer, const Loop& inner) {
  const std::size_t n = outer.size(), m = inner.size();
  std::size_t i = 0, j = 0;
  while (i < n || j < m) {
    if (j == m || (i < n && (2 * i + 1) * m <= (2 * j + 1) * n)) {
      triangles.push_back({outer[i % n], outer[(i + 1) % n], inner[j % m]});
      ++i;
    } else {
      triangles.push_back({outer[i % n], inner[(j + 1) % m], inner[j % m]});
      ++j;
    }
  }
}

bool is_over_skin(const HairRelief& relief, const HairPlace& place) {
  constexpr double kOver_mm = 0.1;
  return sample_hair_relief(relief, place) >
         sample_hair_chart(relief.chart, relief.chart.skin_mm, place) + kOver_mm;
}

// Rings of triangles about the whorl, down to what the farthest of the edge needs.
std::vector<Triangle> append_rings(Plan& plan, double farthest, double step_mm, Mesh& mesh) {
  std::vector<Triangle> triangles;
  const HairChart& chart = plan.relief.chart;
  const auto add = [&](const HairPlace& place) {
    mesh.positions.emplace_back(compute_hair_point(chart, place, sample_hair_relief(plan.relief, place)));
    plan.points.push_back(plan.lay(place));
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
  };
  const std::uint32_t whorl = add({0, 0});
  const int rows = static_cast<int>(std::ceil(farthest * chart.drop_mm * 1.1 / step_mm));
  Loop inner{whorl};
  for (int row = 1; row <= rows; ++row) {
    const double way = farthest * row / rows;
    const double turn = std::min(1.0, way) * std::numbers::pi / 2;
    const auto count = std::max<std::size_t>(
        6, static_cast<std::size_t>(2 * std::numbers::pi * 95 * chart.size * std::sin(turn) / step_mm));
    Loop outer;
    for (std::size_t i = 0; i < count; ++i)
      outer.push_back(add({360.0 * static_cast<double>(i) / static_cast<double>(count) - 180, way}));
    if (row == 1)
      for (std::size_t i = 0; i < count; ++i) triangles.push_back({outer[i], outer[(i + 1) % count], whorl});
    else
      append_zip(triangles, outer, inner);
    inner = outer;
  }
  return triangles;
}

// One piece about the first triangle, without corners that hang on by a vertex.
void leave_whole(std::vector<Triangle>& triangles, std::size_t vertex_count) {
  for (bool is_done = false; !is_done;) {
    is_done = true;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> owner;
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (int i = 0; i < 3; ++i) owner[{triangles[t][i], triangles[t][(i + 1) % 3]}] = t;
    std::vector<bool> is_reached(triangles.size(), false);
    std::vector<std::size_t> open{0};
    is_reached[0] = true;
    std::vector<int> edges(vertex_count, 0);
    while (!open.empty()) {
      const std::size_t t = open.back();
      open.pop_back();
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t a = triangles[t][i], b = triangles[t][(i + 1) % 3];
        const auto found = owner.find({b, a});
        if (found == owner.end()) {
          ++edges[a];
        } else if (!is_reached[found->second]) {
          is_reached[found->second] = true;
          open.push_back(found->second);
        }
      }
    }
    std::vector<Triangle> left;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const bool is_pinched =
          std::ranges::any_of(triangles[t], [&](std::uint32_t v) { return edges[v] > 1; });
      if (is_reached[t] && !is_pinched) left.push_back(triangles[t]);
      if (is_reached[t] && is_pinched) is_done = false;
    }
    triangles = std::move(left);
    if (triangles.empty()) return;
  }
}

// Fills the strip between the edge and the inner loop, which runs the same way around, bridge by bridge;
// false if none can be built.
bool fill_strip(const Plan& plan, const Loop& edge, const std::vector<glm::dvec2>& line, const Loop& inner,
                Mesh& mesh) {
  constexpr std::size_t kSpan = 12;  // of the edge's vertices from bridge to bridge
  Mesh flat;
  flat.positions.resize(mesh.positions.size());
  for (std::size_t v = 0; v < plan.points.size(); ++v) flat.positions[v] = glm::vec3(plan.points[v], 0);
  std::vector<glm::dvec2> inside;
  for (const std::uint32_t v : inner) inside.push_back(plan.points[v]);
  const std::size_t n = edge.size(), m = inner.size();
  const auto is_free = [&](const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 p = glm::mix(a, b, 1e-4), q = glm::mix(a, b, 1 - 1e-4);
    for (const auto* round : {&line, static_cast<const std::vector<glm::dvec2>*>(&inside)})
      for (std::size_t k = 0; k < round->size(); ++k)
        if (is_crossed(p, q, (*round)[k], (*round)[(k + 1) % round->size()])) return false;
    return true;
  };
  struct Bridge {
    std::size_t outer, inner;  // inner counts on beyond a turn
  };
  std::vector<Bridge> bridges;
  for (std::size_t i = 0; i < n; i += kSpan) {
    const std::size_t j = find_nearest(plan, inside, line[i]).first;
    if (!is_free(line[i], inside[j])) continue;
    if (bridges.empty()) {
      bridges.push_back({i, j});
      continue;
    }
    const std::size_t first = bridges.front().inner, last = bridges.back().inner;
    const std::size_t on = first + (j + m - first % m) % m;
    if (on >= last && on - last < m / 2) bridges.push_back({i, on});
  }
  if (bridges.empty()) return false;
  bridges.push_back({bridges.front().outer + n, bridges.front().inner + m});
  for (std::size_t k = 0; k + 1 < bridges.size(); ++k) {
    Loop walk;
    for (std::size_t i = bridges[k].outer; i <= bridges[k + 1].outer; ++i) walk.push_back(edge[i % n]);
    for (std::size_t j = bridges[k + 1].inner + 1; j-- > bridges[k].inner;) walk.push_back(inner[j % m]);
    append_ear_cap(flat, walk);
  }
  mesh.triangles.insert(mesh.triangles.end(), flat.triangles.begin(), flat.triangles.end());
  return true;
}

// The mass within a loop of the edge: rings about the whorl as far as they lie inside, and a strip; false if
// there is no way.
bool append_mass(const HairRelief& relief, const Loop& loop, double fine_mm, BustHair& hair, Mesh& mesh) {
  constexpr double kStep = 0.42, kLeast_mm = 1.5;  // from vertex to vertex: of the print, of the head
  constexpr double kClear = 0.6;                   // of that, to the edge
  constexpr double kFollow_mm = 14;                // so far in the mass goes along with the edge
  const double size = relief.chart.size, step_mm = std::max(kStep * fine_mm, kLeast_mm * size);
  Plan plan{relief, std::vector<glm::dvec2>(mesh.positions.size())};
  std::vector<glm::dvec2> line;
  double farthest = 0;
  for (const std::uint32_t v : loop) {
    const HairPlace place = compute_hair_place(relief.chart, glm::dvec3(mesh.positions[v]));
    farthest = std::max(farthest, place.way);
    line.push_back(plan.lay(place));
  }
  const std::vector<glm::dvec2> exact = line;
  line = even_out(line);
  if (line.empty()) return false;
  for (std::size_t i = 0; i < loop.size(); ++i) plan.points[loop[i]] = line[i];
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  std::vector<Triangle> rings = append_rings(plan, farthest, step_mm, mesh);
  const double sign = compute_plan_area(line) > 0 ? 1 : -1;
  std::vector<bool> is_inside(mesh.positions.size(), false);
  for (std::uint32_t v = first; v < mesh.positions.size(); ++v) {
    const glm::dvec2& p = plan.points[v];
    HairMassVertex vertex{v, mesh.positions[v], 0, 0};
    const auto [nearest, far_mm] = find_nearest(plan, line, p);
    const HairPlace place = compute_hair_place(relief.chart, glm::dvec3(mesh.positions[v]));
    is_inside[v] = std::min(far_mm, find_nearest(plan, exact, p).second) > kClear * step_mm &&
                   is_within(line, p) && is_within(exact, p) && is_over_skin(relief, place);
    vertex.edge = loop[nearest] - hair.first;
    vertex.share = static_cast<float>(1 - smooth_step(0, kFollow_mm * size, far_mm));
    hair.mass.push_back(vertex);
  }
  std::erase_if(rings, [&](const Triangle& t) {
    return !std::ranges::all_of(t, [&](std::uint32_t v) { return is_inside[v]; });
  });
  for (Triangle& t : rings)
    if (sign * cross(plan.points[t[1]] - plan.points[t[0]], plan.points[t[2]] - plan.points[t[0]]) < 0)
      std::swap(t[1], t[2]);
  if (!rings.empty()) leave_whole(rings, mesh.positions.size());
  if (rings.empty()) return false;
  std::vector<Loop> inner = find_boundary_loops(rings);
  mesh.triangles.insert(mesh.triangles.end(), rings.begin(), rings.end());
  if (inner.size() != 1) return false;
  // A cap's loop runs against its mesh; the strip's inner side is one seen from the other side.
  Loop last = inner.back();
  std::ranges::reverse(last);
  return fill_strip(plan, loop, line, last, mesh);
}

}  // namespace

BustHair append_hair(const NeutralHead& head, const HairRelief& relief, std::size_t skin_count,
                     double fine_mm, Mesh& mesh) {
  BustHair hair;
  const std::vector<float> cover = measure_cover(head, relief, skin_count, mesh);
  if (cover.empty()) return hair;
  hair.first = static_cast<std::uint32_t>(mesh.positions.size());
  hair.edge = cut_skin(cover, mesh);
  const bool is_of_skin = std::ranges::all_of(
      hair.edge, [&](const HairEdgeVertex& v) { return v.ends[0] < skin_count && v.ends[1] < skin_count; });
  if (!is_of_skin) return {};
  std::vector<Loop> loops = find_boundary_loops(mesh.triangles);
  std::erase_if(loops, [&](const Loop& loop) { return loop.front() < hair.first; });
  if (loops.size() != 1 || !append_mass(relief, loops.front(), fine_mm, hair, mesh)) return {};
  return hair;
}

void place_hair(const BustHair& hair, std::vector<glm::vec3>& positions) {
  for (std::size_t i = 0; i < hair.edge.size(); ++i) {
    const HairEdgeVertex& v = hair.edge[i];
    positions[hair.first + i] = glm::mix(positions[v.ends[0]], positions[v.ends[1]], v.share);
  }
  for (const HairMassVertex& v : hair.mass) {
    positions[v.vertex] = v.rest;
    if (v.share > 0)
      positions[v.vertex] += v.share * (positions[hair.first + v.edge] - hair.edge[v.edge].rest);
  }
}

void leave_out_hair(BustHair& hair, const std::vector<bool>& is_kept, std::vector<bool>& is_needed) {
  std::erase_if(hair.mass, [&](const HairMassVertex& v) { return !is_kept[v.vertex]; });
  for (const HairEdgeVertex& v : hair.edge)
    for (const std::uint32_t end : v.ends) is_needed[end] = true;
}

}  // namespace mien

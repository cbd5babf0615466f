#include "core/holes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <span>

#include "core/error.hpp"

namespace mien {

namespace {

[[noreturn]] void fail_at(std::uint32_t vertex) {
  throw RunError(fmt::format("mesh is not a surface at vertex {}", vertex));
}

// For each vertex on an open edge the next one of its loop.
std::map<std::uint32_t, std::uint32_t> compute_open_steps(const std::vector<Triangle>& triangles) {
  std::uint32_t count = 0;
  for (const Triangle& t : triangles) count = std::max({count, t[0] + 1, t[1] + 1, t[2] + 1});
  std::vector<std::uint32_t> first(count + 1, 0),
      ends(3 * triangles.size());  // of the edges from each vertex
  for (const Triangle& t : triangles)
    for (const std::uint32_t v : t) ++first[v + 1];
  for (std::uint32_t v = 0; v < count; ++v) first[v + 1] += first[v];
  std::vector<std::uint32_t> free = first;
  for (const Triangle& t : triangles)
    for (int i = 0; i < 3; ++i) ends[free[t[i]]++] = t[(i + 1) % 3];
  const auto from_of = [&](std::uint32_t v) {
    return std::span(ends).subspan(first[v], first[v + 1] - first[v]);
  };
  std::map<std::uint32_t, std::uint32_t> next;
  for (std::uint32_t from = 0; from < count; ++from) {
    const auto of_vertex = from_of(from);
    std::sort(of_vertex.begin(), of_vertex.end());
    if (std::adjacent_find(of_vertex.begin(), of_vertex.end()) != of_vertex.end()) fail_at(from);
    for (const std::uint32_t to : of_vertex) {
      const auto back = from_of(to);
      if (std::find(back.begin(), back.end(), from) != back.end()) continue;
      if (!next.emplace(to, from).second) fail_at(to);
    }
  }
  return next;
}

double compute_smallest_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const auto angle = [](const glm::dvec3& at, const glm::dvec3& p, const glm::dvec3& q) {
    return std::atan2(glm::length(glm::cross(p - at, q - at)), glm::dot(p - at, q - at));
  };
  return std::min({angle(a, b, c), angle(b, c, a), angle(c, a, b)});
}

// Twice the loop's area as a vector along its mean normal (Newell).
glm::dvec3 find_area_vector(const std::vector<glm::vec3>& positions, const Loop& loop) {
  glm::dvec3 sum{0};
  const glm::dvec3 origin(positions[loop.front()]);
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += glm::cross(glm::dvec3(positions[loop[i]]) - origin,
                      glm::dvec3(positions[loop[(i + 1) % loop.size()]]) - origin);
  return sum;
}

// Whether `p` lies in the triangle, its border included, seen along `normal`.
bool is_inside(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
               const glm::dvec3& normal) {
  return glm::dot(glm::cross(b - a, p - a), normal) >= 0 && glm::dot(glm::cross(c - b, p - b), normal) >= 0 &&
         glm::dot(glm::cross(a - c, p - c), normal) >= 0;
}

// How good an ear the corner `at` of the walk is: its smallest angle, or below 0 if it is none.
double rate_ear(const std::vector<glm::vec3>& positions, const Loop& walk, std::size_t at,
                const glm::dvec3& normal) {
  const std::size_t n = walk.size();
  const std::uint32_t before = walk[(at + n - 1) % n], here = walk[at], after = walk[(at + 1) % n];
  const glm::dvec3 a(positions[before]), b(positions[here]), c(positions[after]);
  const double turn = glm::dot(glm::cross(b - a, c - b), normal);
  const double angle = compute_smallest_angle(a, b, c);
  if (turn <= 0) return -2 - std::abs(turn);
  for (const std::uint32_t other : walk) {
    if (other == before || other == here || other == after) continue;
    if (is_inside(glm::dvec3(positions[other]), a, b, c, normal)) return -1;
  }
  return angle;
}

}  // namespace

std::vector<Loop> find_boundary_loops(const std::vector<Triangle>& triangles) {
  std::map<std::uint32_t, std::uint32_t> next = compute_open_steps(triangles);
  std::vector<Loop> loops;
  while (!next.empty()) {
    Loop& loop = loops.emplace_back();
    const std::uint32_t start = next.begin()->first;
    std::uint32_t at = start;
    do {
      const auto step = next.find(at);
      if (step == next.end()) fail_at(at);
      loop.push_back(at);
      at = step->second;
      next.erase(step);
    } while (at != start);
  }
  return loops;
}

glm::vec3 compute_loop_centre(const std::vector<glm::vec3>& positions, const Loop& loop) {
  glm::dvec3 sum{0};
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const glm::dvec3 a(positions[loop[i]]), b(positions[loop[(i + 1) % loop.size()]]);
    const double step = glm::length(b - a);
    sum += (a + b) * 0.5 * step;
    length += step;
  }
  return length > 0 ? glm::vec3(sum / length) : positions[loop.front()];
}

void append_fan_cap(Mesh& mesh, const Loop& loop, const glm::vec3& apex) {
  mesh.normals.clear();
  const auto centre = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back(apex);
  for (std::size_t i = 0; i < loop.size(); ++i)
    mesh.triangles.push_back({loop[i], loop[(i + 1) % loop.size()], centre});
}

void append_ear_cap(Mesh& mesh, const Loop& loop) {
  mesh.normals.clear();
  const glm::dvec3 normal = find_area_vector(mesh.positions, loop);
  Loop walk = loop;
  std::vector<double> rating(walk.size());
  for (std::size_t i = 0; i < walk.size(); ++i) rating[i] = rate_ear(mesh.positions, walk, i, normal);
  while (walk.size() >= 3) {
    const auto best = std::max_element(rating.begin(), rating.end()) - rating.begin();
    const std::size_t n = walk.size(), at = static_cast<std::size_t>(best);
    mesh.triangles.push_back({walk[(at + n - 1) % n], walk[at], walk[(at + 1) % n]});
    walk.erase(walk.begin() + best);
    rating.erase(rating.begin() + best);
    if (walk.size() < 3) return;
    // Only the two corners beside the ear have changed their shape, but any may have come free of what hid
    // it.
    for (std::size_t i = 0; i < walk.size(); ++i)
      if (rating[i] < 0 || i == at % walk.size() || i == (at + walk.size() - 1) % walk.size())
        rating[i] = rate_ear(mesh.positions, walk, i, normal);
  }
}

void append_band(Mesh& mesh, const Loop& loop, const Loop& next) {
  mesh.normals.clear();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::size_t j = (i + 1) % loop.size();
    mesh.triangles.push_back({loop[i], loop[j], next[j]});
    mesh.triangles.push_back({loop[i], next[j], next[i]});
  }
}

std::size_t close_holes(Mesh& mesh) {
  const std::vector<Loop> loops = find_boundary_loops(mesh.triangles);
  for (const Loop& loop : loops) append_ear_cap(mesh, loop);
  return loops.size();
}

std::vector<Mesh> split_pieces(const Mesh& mesh) {
  std::vector<std::uint32_t> above(mesh.positions.size());
  std::iota(above.begin(), above.end(), 0U);
  const auto find_root = [&](std::uint32_t v) {
    while (above[v] != v) v = above[v] = above[above[v]];
    return v;
  };
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 2; ++i) {
      const std::uint32_t a = find_root(t[i]), b = find_root(t[i + 1]);
      above[std::max(a, b)] = std::min(a, b);
    }

  std::vector<bool> is_used(mesh.positions.size(), false);
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) is_used[v] = true;
  std::map<std::uint32_t, std::size_t> piece_of;  // root -> piece
  std::vector<std::uint32_t> new_index(mesh.positions.size());
  std::vector<Mesh> pieces;
  for (std::uint32_t v = 0; v < above.size(); ++v) {
    if (!is_used[v]) continue;
    const auto [place, is_new] = piece_of.emplace(find_root(v), pieces.size());
    if (is_new) pieces.emplace_back();
    new_index[v] = static_cast<std::uint32_t>(pieces[place->second].positions.size());
    pieces[place->second].positions.push_back(mesh.positions[v]);
  }
  for (const auto& [a, b, c] : mesh.triangles)
    pieces[piece_of[find_root(a)]].triangles.push_back({new_index[a], new_index[b], new_index[c]});
  return pieces;
}

}  // namespace mien

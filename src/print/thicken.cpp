#include "print/thicken.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/crossings.hpp"
#include "core/pool.hpp"
#include "print/opening.hpp"
#include "print/solid_tree.hpp"
#include "print/thickness.hpp"

namespace mien {

namespace {

constexpr int kRounds = 3;      // of measuring and moving; what is thin at the first is thinner than it looks
constexpr int kFades = 6;       // rings of neighbours that are moved along
constexpr double kFade = 0.75;  // from ring to ring
constexpr double kGapShare = 0.3;  // of the free space in front, so that two sides that meet keep 40 % of it
constexpr double kTurn = 0.6;      // the cosine of the most that a triangle may turn
constexpr int kHalvings = 8;
constexpr double kExtra = 1.02;  // chords of a thickened round are inside it
constexpr double kEdge = 0.2;    // beside what is thin, edges are thickened that are blunt enough elsewhere
constexpr double kSpeck_mm2 = 0.2;  // of surface: what is thin on less is a corner
constexpr float kBed_mm = 1e-3f;

struct Body {
  Mesh mesh;
  std::vector<std::vector<std::uint32_t>> neighbours;
  std::vector<bool> is_fixed;  // on an open edge or on the bed
};

Body build_thick_body(const Mesh& mesh) {
  Body body{mesh, {}, {}};
  body.neighbours.resize(mesh.positions.size());
  body.is_fixed.resize(mesh.positions.size());
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) body.neighbours[t[i]].push_back(t[(i + 1) % 3]);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    std::sort(body.neighbours[v].begin(), body.neighbours[v].end());
    body.is_fixed[v] = mesh.positions[v].z < kBed_mm;
  }
  std::vector<std::array<std::uint32_t, 2>> open;
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      if (!std::binary_search(body.neighbours[b].begin(), body.neighbours[b].end(), a))
        open.push_back({a, b});
    }
  for (const auto& [a, b] : open) {
    body.is_fixed[a] = body.is_fixed[b] = true;
    body.neighbours[b].push_back(a);
  }
  return body;
}

// Area-weighted, in double: float sums would not mirror.
std::vector<glm::dvec3> list_normals(const Mesh& mesh) {
  std::vector<glm::dvec3> normals(mesh.positions.size(), glm::dvec3(0));
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::dvec3 p(mesh.positions[a]), q(mesh.positions[b]), r(mesh.positions[c]);
    const glm::dvec3 area = glm::cross(q - p, r - p);
    for (const std::uint32_t v : {a, b, c}) normals[v] += area;
  }
  for (glm::dvec3& n : normals) {
    const double length = glm::length(n);
    n = length > 0 ? n / length : glm::dvec3(0);
  }
  return normals;
}

// How far each vertex should go along its normal, and how far it may.
struct Wish {
  double need_mm = 0, room_mm = 0;
};

// The free space that a vertex may take.
double compute_room_mm(const SurfaceTree& tree, const glm::dvec3& place, const glm::dvec3& normal,
                       double least_mm) {
  constexpr double kStart_mm = 1e-3;
  const double gap = find_hit(tree, place, normal, kStart_mm, 4 * least_mm).distance;
  return kGapShare * std::min(gap, 4 * least_mm);
}

double compute_need_mm(const SurfaceTree& tree, const glm::dvec3& place, const glm::dvec3& normal,
                       double least_mm) {
  return std::max(0.0, (least_mm - measure_thickness_mm(tree, place, normal, 2 * least_mm)) / 2);
}

// Where the body is finer than asked. Vertices have the needs of their triangles' middles as well: alone they
// would not tell of a dent between. Those kFades rings around have no need, but room.
std::vector<Wish> list_wishes(const Body& body, const SurfaceTree& tree,
                              const std::vector<std::uint32_t>& thin, const std::vector<glm::dvec3>& normals,
                              double least_mm) {
  const std::vector<glm::vec3>& positions = body.mesh.positions;
  std::vector<Wish> wishes(normals.size());
  std::vector<bool> is_asked(normals.size(), false);
  std::vector<std::uint32_t> ring;
  const auto ask = [&](std::uint32_t v) {
    if (is_asked[v] || body.is_fixed[v] || normals[v] == glm::dvec3(0)) return false;
    is_asked[v] = true;
    ring.push_back(v);
    wishes[v].room_mm = compute_room_mm(tree, positions[v], normals[v], least_mm);
    return true;
  };
  std::uint32_t last = UINT32_MAX;
  for (const FinePatch& patch : list_fine_patches(body.mesh, tree, thin, least_mm, kEdge)) {
    if (patch.triangle == last) continue;
    last = patch.triangle;
    const auto& [a, b, c] = body.mesh.triangles[last];
    const glm::dvec3 middle =
        (glm::dvec3(positions[a]) + glm::dvec3(positions[b]) + glm::dvec3(positions[c])) / 3.0;
    const double need = compute_need_mm(tree, middle, patch.normal, least_mm);
    const double room = compute_room_mm(tree, middle, patch.normal, least_mm);
    for (const std::uint32_t v : {a, b, c}) {
      if (ask(v)) wishes[v].need_mm = compute_need_mm(tree, positions[v], normals[v], least_mm);
      wishes[v] = {std::max(wishes[v].need_mm, need), std::min(wishes[v].room_mm, room)};
    }
  }
  for (int fade = 0; fade < kFades; ++fade) {
    const std::vector<std::uint32_t> inner = std::exchange(ring, {});
    for (const std::uint32_t v : inner)
      for (const std::uint32_t n : body.neighbours[v]) ask(n);
  }
  for (std::size_t v = 0; v < wishes.size(); ++v)
    if (body.is_fixed[v]) wishes[v] = {};
  return wishes;
}

// The wishes, fading out over their neighbours.
std::vector<double> spread(const Body& body, const std::vector<Wish>& wishes) {
  std::vector<double> amount(wishes.size()), next;
  for (std::size_t v = 0; v < wishes.size(); ++v) amount[v] = std::min(wishes[v].need_mm, wishes[v].room_mm);
  for (int fade = 0; fade < kFades; ++fade) {
    next = amount;
    for (std::size_t v = 0; v < wishes.size(); ++v) {
      double most = 0, sum = 0;
      for (const std::uint32_t n : body.neighbours[v]) most = std::max(most, amount[n]), sum += amount[n];
      if (body.is_fixed[v] || body.neighbours[v].empty()) continue;
      const double mean = sum / double(body.neighbours[v].size());
      next[v] = std::max(amount[v], std::min(kFade * (mean + most) / 2, wishes[v].room_mm));
    }
    std::swap(amount, next);
  }
  return amount;
}

// Takes back by halves what would turn a triangle over.
void keep_sides(const Body& body, const std::vector<glm::dvec3>& normals, std::vector<double>& amount) {
  for (int halving = 0; halving < kHalvings; ++halving) {
    std::vector<bool> is_bad(amount.size(), false);
    bool is_any = false;
    for (const Triangle& t : body.mesh.triangles) {
      std::array<glm::dvec3, 3> now, then;
      for (int i = 0; i < 3; ++i) {
        now[i] = glm::dvec3(body.mesh.positions[t[i]]);
        then[i] = now[i] + amount[t[i]] * normals[t[i]];
      }
      const glm::dvec3 before = glm::cross(now[1] - now[0], now[2] - now[0]);
      const glm::dvec3 after = glm::cross(then[1] - then[0], then[2] - then[0]);
      if (glm::dot(before, after) >= kTurn * glm::length(before) * glm::length(after)) continue;
      is_any = true;
      for (const std::uint32_t v : t) is_bad[v] = true;
    }
    if (!is_any) return;
    for (std::size_t v = 0; v < amount.size(); ++v)
      if (is_bad[v]) amount[v] = halving + 1 < kHalvings ? amount[v] / 2 : 0;
  }
}

// What the moves lead the surface through itself by.
std::vector<Crossing> list_new_crossings(const std::vector<glm::vec3>& before,
                                         const std::vector<glm::vec3>& after,
                                         const std::vector<Triangle>& triangles) {
  std::vector<bool> is_moved;
  for (const auto& [a, b, c] : triangles)
    is_moved.push_back(before[a] != after[a] || before[b] != after[b] || before[c] != after[c]);
  std::vector<Crossing> crossings = find_crossings(after, triangles, is_moved);
  if (crossings.empty()) return crossings;
  const std::vector<Crossing> old = find_crossings(before, triangles, is_moved);
  std::erase_if(crossings, [&](const Crossing& c) { return std::binary_search(old.begin(), old.end(), c); });
  return crossings;
}

std::vector<glm::vec3> add_moves(const std::vector<glm::vec3>& positions,
                                 const std::vector<glm::vec3>& moves) {
  std::vector<glm::vec3> moved = positions;
  for (std::size_t v = 0; v < moves.size(); ++v) moved[v] += moves[v];
  return moved;
}

// See hold_apart, for one pose.
void hold_apart_once(const std::vector<glm::vec3>& positions, const std::vector<Triangle>& triangles,
                     double least_mm, std::vector<glm::vec3>& moves) {
  // How wide the circles are, in halves of the least thickness, and what is left of the moves within.
  constexpr std::pair<float, float> kCircles[] = {{1, 0.5f}, {2, 0.5f}, {1, 0}, {2, 0.5f},
                                                  {2, 0},    {3, 0},    {4, 0}, {6, 0}};
  for (const auto& circle : kCircles) {
    const float reach = circle.first * float(least_mm / 2);
    const std::vector<glm::vec3> moved = add_moves(positions, moves);
    const std::vector<Crossing> crossings = list_new_crossings(positions, moved, triangles);
    if (crossings.empty()) return;
    const std::vector<glm::vec3> places = list_crossed_places(moved, triangles, crossings);
    for (std::size_t v = 0; v < moves.size(); ++v)
      if (moves[v] != glm::vec3(0) && std::any_of(places.begin(), places.end(), [&](const glm::vec3& place) {
            return glm::distance(moved[v], place) < reach;
          }))
        moves[v] *= circle.second;
  }
}

}  // namespace

// One pose after the other, as what one takes back decides what the next one meets; but those that have
// nothing to take back are found at once.
void hold_apart(const std::vector<std::vector<glm::vec3>>& poses, const std::vector<Triangle>& triangles,
                double least_mm, std::vector<glm::vec3>& moves) {
  const std::size_t most = 2 * static_cast<std::size_t>(count_workers());  // further on it may be in vain
  std::size_t next = 0;
  while (next < poses.size()) {
    const std::size_t end = std::min(next + most, poses.size());
    std::vector<char> is_bad(end - next, 0);
    for_each_index(is_bad.size(), count_workers(), [&](std::size_t i, int) {
      const std::vector<glm::vec3>& pose = poses[next + i];
      is_bad[i] = !list_new_crossings(pose, add_moves(pose, moves), triangles).empty();
    });
    for (const char bad : is_bad) {
      if (bad) hold_apart_once(poses[next], triangles, least_mm, moves);
      ++next;
      if (bad) break;
    }
  }
}

std::vector<glm::vec3> compute_thickening(const Mesh& mesh, double least_mm) {
  std::vector<glm::vec3> moves(mesh.positions.size(), glm::vec3(0));
  if (!(least_mm > 0)) return moves;
  Body body = build_thick_body(mesh);
  std::vector<std::uint32_t> thin;
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<glm::dvec3> normals = list_normals(body.mesh);
    const SurfaceTree tree = build_solid_tree(body.mesh);
    if (round == 0) thin = list_thin_triangles(body.mesh, tree, kExtra * least_mm, kSpeck_mm2);
    const std::vector<Wish> wishes = list_wishes(body, tree, thin, normals, kExtra * least_mm);
    if (std::all_of(wishes.begin(), wishes.end(), [](const Wish& wish) { return wish.need_mm <= 0; })) break;
    std::vector<double> amount = spread(body, wishes);
    keep_sides(body, normals, amount);
    std::vector<glm::vec3> steps;
    for (std::size_t v = 0; v < moves.size(); ++v) steps.emplace_back(amount[v] * normals[v]);
    hold_apart({body.mesh.positions}, body.mesh.triangles, least_mm, steps);
    for (std::size_t v = 0; v < moves.size(); ++v) {
      moves[v] += steps[v];
      body.mesh.positions[v] = mesh.positions[v] + moves[v];
    }
  }
  return moves;
}

}  // namespace mien

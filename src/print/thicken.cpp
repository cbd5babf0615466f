#include "print/thicken.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.hpp"
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

Wish find_wish(const SurfaceTree& tree, const glm::dvec3& place, const glm::dvec3& normal, double least_mm) {
  constexpr double kStart_mm = 1e-3;
  const double gap = find_hit(tree, place, normal, kStart_mm, 4 * least_mm).distance;
  const double thickness = measure_thickness_mm(tree, place, normal, 2 * least_mm);
  return {std::max(0.0, (least_mm - thickness) / 2), kGapShare * std::min(gap, 4 * least_mm)};
}

// Vertices have the wishes of their triangles' middles as well: alone they would not tell of a dent between.
std::vector<Wish> list_wishes(const Body& body, const std::vector<glm::dvec3>& normals, double least_mm) {
  const SurfaceTree tree = build_solid_tree(body.mesh);
  const std::vector<glm::vec3>& positions = body.mesh.positions;
  std::vector<Wish> wishes(normals.size()), middles(body.mesh.triangles.size());
  for_each_index(normals.size(), count_cores(), [&](std::size_t v, int) {
    if (normals[v] != glm::dvec3(0)) wishes[v] = find_wish(tree, positions[v], normals[v], least_mm);
  });
  for_each_index(middles.size(), count_cores(), [&](std::size_t t, int) {
    const auto& [a, b, c] = body.mesh.triangles[t];
    const glm::dvec3 p(positions[a]), q(positions[b]), r(positions[c]);
    const glm::dvec3 area = glm::cross(q - p, r - p);
    middles[t] = {0, 1e9};
    if (area != glm::dvec3(0))
      middles[t] = find_wish(tree, (p + q + r) / 3.0, glm::normalize(area), least_mm);
  });
  for (std::size_t t = 0; t < middles.size(); ++t)
    for (const std::uint32_t v : body.mesh.triangles[t])
      wishes[v] = {std::max(wishes[v].need_mm, middles[t].need_mm),
                   std::min(wishes[v].room_mm, middles[t].room_mm)};
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

// Takes back what would lead the surface through itself, in a wider and wider circle.
void keep_apart(const Body& body, const std::vector<glm::dvec3>& normals, double least_mm,
                std::vector<double>& amount) {
  constexpr int kCircles = 6;
  for (int circle = 1; circle <= kCircles; ++circle) {
    Mesh moved = body.mesh;
    for (std::size_t v = 0; v < amount.size(); ++v) moved.positions[v] += glm::vec3(amount[v] * normals[v]);
    const std::vector<glm::dvec3> crossed = list_crossed_places(moved);
    if (crossed.empty()) return;
    for (std::size_t v = 0; v < amount.size(); ++v)
      if (amount[v] > 0 && std::any_of(crossed.begin(), crossed.end(), [&](const glm::dvec3& place) {
            return glm::distance(glm::dvec3(moved.positions[v]), place) < circle * least_mm / 2;
          }))
        amount[v] = 0;
  }
}

}  // namespace

std::vector<glm::vec3> find_thickening(const Mesh& mesh, double least_mm) {
  std::vector<glm::vec3> moves(mesh.positions.size(), glm::vec3(0));
  if (!(least_mm > 0)) return moves;
  Body body = build_thick_body(mesh);
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<glm::dvec3> normals = list_normals(body.mesh);
    const std::vector<Wish> wishes = list_wishes(body, normals, kExtra * least_mm);
    if (std::all_of(wishes.begin(), wishes.end(), [](const Wish& wish) { return wish.need_mm <= 0; })) break;
    std::vector<double> amount = spread(body, wishes);
    keep_sides(body, normals, amount);
    keep_apart(body, normals, least_mm, amount);
    for (std::size_t v = 0; v < moves.size(); ++v) {
      moves[v] += glm::vec3(amount[v] * normals[v]);
      body.mesh.positions[v] = mesh.positions[v] + moves[v];
    }
  }
  return moves;
}

}  // namespace mien

// Splitting: Bank, Sherman and Weiser, "Some refinement algorithms and data structures for regular local mesh
// refinement", 1983 (a triangle with two long edges is quartered, with one is halved). Middles: Vlachos,
// Peters, Boyd and Mitchell, "Curved PN triangles", 2001, the cubic of an edge at its half.
#include "head/fine_skin.hpp"

#include <cmath>
#include <map>
#include <unordered_map>
#include <unordered_set>

namespace mien {

namespace {

constexpr int kRounds = 3;  // an edge becomes at most eight: 3 mm become less than half a millimetre

using Middles = std::unordered_map<std::uint64_t, std::uint32_t>;  // of edges that are split

std::uint64_t key_of(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
}

// A middle of an edge of the left half and its mirror image; one on the mid-plane is its own.
std::uint32_t add_middle(FineSkin& fine, std::vector<glm::vec3>& positions, std::uint32_t a,
                         std::uint32_t b) {
  const auto add = [&](std::uint32_t one, std::uint32_t other) {
    fine.parents.push_back({one, other});
    positions.push_back(0.5f * (positions[one] + positions[other]));
    return static_cast<std::uint32_t>(positions.size() - 1);
  };
  const std::uint32_t image_a = fine.mirror[a], image_b = fine.mirror[b], left = add(a, b);
  fine.mirror.push_back(left);
  if (image_a == a && image_b == b) return left;
  fine.mirror[left] = add(image_a, image_b);
  fine.mirror.push_back(left);
  return left;
}

// Edges to split, in the order in which they were found.
struct Marks {
  std::unordered_set<std::uint64_t> known;
  std::vector<std::uint64_t> order;
  std::vector<bool> has_vertex;  // whether an edge of the vertex is marked

  void add(std::uint32_t a, std::uint32_t b) {
    if (!known.insert(key_of(a, b)).second) return;
    order.push_back(key_of(a, b));
    has_vertex[a] = has_vertex[b] = true;
  }
};

// The long ones, and all of a triangle that has two of them.
Marks mark_edges(const std::vector<Triangle>& left, const std::vector<glm::vec3>& positions,
                 const EdgeLimit& limit) {
  Marks marks{{}, {}, std::vector<bool>(positions.size(), false)};
  for (const Triangle& t : left)
    for (int i = 0; i < 3; ++i) {
      const glm::vec3 &a = positions[t[i]], &b = positions[t[(i + 1) % 3]];
      if (glm::distance(a, b) > limit(0.5f * (a + b))) marks.add(t[i], t[(i + 1) % 3]);
    }
  for (bool is_growing = true; is_growing;) {
    is_growing = false;
    for (const Triangle& t : left) {
      if (!marks.has_vertex[t[0]] || !marks.has_vertex[t[1]] || !marks.has_vertex[t[2]]) continue;
      int count = 0;
      for (int i = 0; i < 3; ++i) count += marks.known.contains(key_of(t[i], t[(i + 1) % 3]));
      if (count != 2) continue;
      for (int i = 0; i < 3; ++i) marks.add(t[i], t[(i + 1) % 3]);
      is_growing = true;
    }
  }
  return marks;
}

void split(const Triangle& t, const Middles& middles, std::vector<Triangle>& into) {
  std::array<const std::uint32_t*, 3> middle{};  // of edges 01, 12, 20
  int count = 0, only = 0;
  for (int i = 0; i < 3; ++i)
    if (const auto found = middles.find(key_of(t[i], t[(i + 1) % 3])); found != middles.end()) {
      middle[i] = &found->second;
      only = i;
      ++count;
    }
  if (count == 0) {
    into.push_back(t);
  } else if (count == 1) {
    const std::uint32_t a = t[only], b = t[(only + 1) % 3], c = t[(only + 2) % 3], m = *middle[only];
    into.push_back({a, m, c});
    into.push_back({m, b, c});
  } else {
    const std::uint32_t ab = *middle[0], bc = *middle[1], ca = *middle[2];
    into.insert(into.end(), {{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}});
  }
}

std::uint16_t compute_nearest_shade(const std::vector<Shade>& palette, const Shade& wanted) {
  std::size_t best = 0;
  float least = 1e9f;
  for (std::size_t i = 0; i < palette.size(); ++i) {
    const glm::vec3 away = palette[i].srgb - wanted.srgb;
    const float gloss = palette[i].gloss - wanted.gloss, far = glm::dot(away, away) + 0.1f * gloss * gloss;
    if (far >= least) continue;
    least = far;
    best = i;
  }
  return static_cast<std::uint16_t>(best);
}

// Slots for the added vertices: a middle of the left half and its image follow each other.
void pair_up(const Surface& surface, FineSkin& fine) {
  fine.pairs = surface.pairs;
  fine.base_pairs = surface.pairs.size();
  std::vector<std::uint32_t> slot(fine.vertex_count(), 0);
  for (std::uint32_t i = 0; i < fine.pairs.size(); ++i) slot[fine.pairs[i].left] = i;
  for (std::size_t i = 0; i < fine.parents.size();) {
    const auto left = static_cast<std::uint32_t>(fine.base_count + i);
    slot[left] = static_cast<std::uint32_t>(fine.pairs.size());
    fine.pairs.push_back({left, fine.mirror[left]});
    fine.pair_parents.push_back({slot[fine.parents[i][0]], slot[fine.parents[i][1]]});
    i += fine.mirror[left] == left ? 1 : 2;
  }
}

}  // namespace

FineSkin refine_skin(const Surface& surface, const std::vector<Triangle>& triangles,
                     const std::vector<glm::vec3>& positions, const EdgeLimit& limit) {
  FineSkin fine{positions.size(), {}, surface.mirror, {}, {}, 0, {}};
  std::vector<glm::vec3> points = positions;
  std::vector<Triangle> left, next;
  for (const Triangle& t : triangles)
    if (positions[t[0]].x + positions[t[1]].x + positions[t[2]].x > 0) left.push_back(t);
  for (int round = 0; round < kRounds; ++round) {
    Middles middles;
    for (const std::uint64_t key : mark_edges(left, points, limit).order)
      middles[key] = add_middle(fine, points, static_cast<std::uint32_t>(key >> 32),
                                static_cast<std::uint32_t>(key & 0xffffffffu));
    if (middles.empty()) break;
    next.clear();
    for (const Triangle& t : left) split(t, middles, next);
    left.swap(next);
  }
  for (const Triangle& t : left) {
    fine.triangles.push_back(t);
    fine.triangles.push_back({fine.mirror[t[0]], fine.mirror[t[2]], fine.mirror[t[1]]});
  }
  pair_up(surface, fine);
  return fine;
}

void append_fine_points(const FineSkin& fine, std::vector<glm::vec3>& positions,
                        std::vector<glm::vec3>& normals) {
  const std::vector<MirrorPair> base(fine.pairs.begin(),
                                     fine.pairs.begin() + static_cast<std::ptrdiff_t>(fine.base_pairs));
  std::vector<Twin> places, shading;
  pack_pairs(base, positions, places);
  pack_pairs(base, normals, shading);
  append_fine_pairs(fine, places, shading);
  positions.resize(fine.vertex_count());
  normals.resize(fine.vertex_count());
  unpack_pairs(fine.pairs, places, positions);
  unpack_pairs(fine.pairs, shading, normals);
}

void refine_part(const FineSkin& fine, Part& part) {
  append_fine_points(fine, part.rest.positions, part.rest.normals);
  part.rest.triangles = fine.triangles;
  std::map<std::array<std::uint16_t, 2>, std::uint16_t> known;
  for (const auto& [a, b] : fine.parents) {
    if (!part.grain.empty()) part.grain.push_back(0.5f * (part.grain[a] + part.grain[b]));
    const auto [low, high] = std::minmax(part.shade[a], part.shade[b]);
    const auto [entry, is_new] = known.try_emplace({low, high}, low);
    const Shade &one = part.palette[low], &other = part.palette[high];
    if (is_new && low != high)
      entry->second = compute_nearest_shade(
          part.palette, {0.5f * (one.srgb + other.srgb), 0.5f * (one.gloss + other.gloss)});
    part.shade.push_back(entry->second);
  }
}

}  // namespace mien

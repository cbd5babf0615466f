#include "head/pairs.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "head/fine_skin.hpp"
#include "head/surface.hpp"

// Eight floats are passed within this file only.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace mien {

namespace {

using Float8 = float __attribute__((vector_size(32)));

namespace plain {
#include "head/pairs_work.inl"
}

// Where the compiler can build a function for another processor than the rest, the choice is made when the
// program runs.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#pragma GCC push_options
#pragma GCC target("avx2")
#define MIEN_HAS_AVX
namespace wide {
#include "head/pairs_work.inl"
}
#undef MIEN_HAS_AVX
#pragma GCC pop_options
#define MIEN_CHOOSE(call)                                       \
  do {                                                          \
    static const bool kIsWide = __builtin_cpu_supports("avx2"); \
    if (kIsWide)                                                \
      wide::call;                                               \
    else                                                        \
      plain::call;                                              \
  } while (false)
#else
#define MIEN_CHOOSE(call) plain::call
#endif

}  // namespace

void pair_points(const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& mirror,
                 std::vector<Twin>& paired) {
  paired.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::vec3 left(points[i]), right(points[mirror[i]]);
    paired[i] = {pack(left), pack(right)};
  }
}

void pair_points(const std::vector<Float4>& points, const std::vector<std::uint32_t>& mirror,
                 std::vector<Twin>& paired) {
  paired.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) paired[i] = {points[i], points[mirror[i]]};
}

void pack_pairs(const std::vector<MirrorPair>& pairs, const std::vector<glm::vec3>& vectors,
                std::vector<Twin>& paired) {
  paired.resize(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const glm::vec3 &left = vectors[pairs[i].left], &right = vectors[pairs[i].right];
    paired[i] = {pack(left), pack(right)};
  }
}

void unpack_pairs(const std::vector<MirrorPair>& pairs, const std::vector<Twin>& paired,
                  std::vector<glm::vec3>& vectors) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    vectors[pairs[i].left] = unpack(paired[i].left);
    vectors[pairs[i].right] = unpack(paired[i].right);
  }
}

void deform_pairs(const Surface& surface, const std::vector<Twin>& points, std::vector<Twin>& places) {
  places.resize(surface.pairs.size());
  MIEN_CHOOSE(deform(surface, points.data(), places.data()));
}

void update_pair_normals(const Surface& surface, const std::vector<Twin>& places,
                         std::vector<Twin>& normals) {
  normals.assign(surface.pairs.size(), Twin{});
  MIEN_CHOOSE(add_areas(surface, places.data(), normals.data()));
  MIEN_CHOOSE(normalize_all(normals.data(), normals.size()));
}

void append_fine_pairs(const FineSkin& fine, std::vector<Twin>& places, std::vector<Twin>& normals) {
  places.resize(fine.pairs.size());
  normals.resize(fine.pairs.size());
  MIEN_CHOOSE(append_fine(fine, places.data(), normals.data()));
}

void place_hairs(const HairRoots& roots, const std::vector<Twin>& places, const std::vector<Twin>& normals,
                 glm::vec3* placed, glm::vec3* shaded) {
  MIEN_CHOOSE(place_hairs(roots, places.data(), normals.data(), placed, shaded));
}

void press_pairs(const std::vector<MirrorPair>& pairs, const std::vector<Triangle>& triangles, float relief,
                 FoldPlaces& folded) {
  folded.slopes.assign(pairs.size(), Twin{});
  MIEN_CHOOSE(press(pairs, triangles, relief, folded));
}

}  // namespace mien

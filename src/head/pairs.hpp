// Both halves of the skin at once: a place of the left half and its mirror image lie side by side in eight
// floats. What is worked for one is worked for the other by the same instructions, and processors with wide
// registers do it in half as many. The sums are those of one vertex after the other, to the last bit.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/float4.hpp"
#include "core/mesh.hpp"

namespace mien {

// A place or a direction and its mirror image; of either half x, y, z and a fourth number.
struct Twin {
  Float4 left, right;
};

// A vertex and its mirror image; one of the mid-plane is its own. Their number in a list is their slot.
struct MirrorPair {
  std::uint32_t left = 0, right = 0;
  bool is_middle() const { return left == right; }
};

// Vertices of the mid-plane stand in both halves of their slot alike.

// Slots of `points`, one for each point: itself and its image. The fourth numbers are 0.
void pair_points(const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& mirror,
                 std::vector<Twin>& paired);
void pair_points(const std::vector<Float4>& points, const std::vector<std::uint32_t>& mirror,
                 std::vector<Twin>& paired);

// The slots of vertices that are not paired yet, and the fourth numbers 0.
void pack_pairs(const std::vector<MirrorPair>& pairs, const std::vector<glm::vec3>& vectors,
                std::vector<Twin>& paired);

// The vectors of the slots to their vertices in `vectors`, which is large enough.
void unpack_pairs(const std::vector<MirrorPair>& pairs, const std::vector<Twin>& paired,
                  std::vector<glm::vec3>& vectors);

struct Surface;
struct FineSkin;

// The skin's vertices as weighted sums of points: slot by slot of the surface, into `places` (resized).
void deform_pairs(const Surface& surface, const std::vector<Twin>& points, std::vector<Twin>& places);

// Area-weighted unit normals from the surface's quads, into `normals` (resized).
void update_pair_normals(const Surface& surface, const std::vector<Twin>& places, std::vector<Twin>& normals);

// Behind the surface's slots those of the vertices that a finer skin adds.
void append_fine_pairs(const FineSkin& fine, std::vector<Twin>& places, std::vector<Twin>& normals);

// Hairs that ride on the skin as rigid little things, laid out for place_hairs: bindings two by two (the last
// one twice if their number is odd; its second is of no vertices).
struct HairRoots {
  std::vector<Triangle>
      corners;               // of each binding: halves of slots, twice the slot and 1 more of the right one
  std::vector<Twin> shares;  // of two bindings: barycentric places
  std::vector<std::array<Twin, 3>> rest;  // of two bindings: tangents, bitangents and normals at rest
  std::vector<std::uint32_t> first;       // the vertices of binding b are those from first[b] to first[b + 1]
  std::vector<Twin> arms;                 // of each vertex at rest: mm from its root, and its normal
};

// The hairs on a skin of these slots: `placed` and `shaded` have room for roots.arms.size() vertices.
void place_hairs(const HairRoots& roots, const std::vector<Twin>& places, const std::vector<Twin>& normals,
                 glm::vec3* placed, glm::vec3* shaded);

// Some vertices of the skin, whose slots are their own, and the height at each over the smooth skin.
// Contents mean nothing between calls.
struct FoldPlaces {
  std::vector<Twin> places, normals;  // the fourth number of a place is its height, mm
  std::vector<Twin> slopes;           // sum of weight x slope, and of weight
};

// Moves the places by `relief` of their heights along the normals, which are shaded as if it were all of it.
// `triangles` are left ones by slots; they and their images have heights.
void press_pairs(const std::vector<MirrorPair>& pairs, const std::vector<Triangle>& triangles, float relief,
                 FoldPlaces& folded);

}  // namespace mien

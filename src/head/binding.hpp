// Places on the skin for what grows on it: the nearest place, and its mirror image on the other half.
#pragma once

#include <string>
#include <vector>

#include "head/head.hpp"

namespace mien {

struct SkinPlace {
  std::uint32_t triangle = 0;  // of the skin
  glm::vec3 barycentric{1, 0, 0};
  glm::vec3 point{0};         // on the skin, mm
  glm::vec3 normal{0, 0, 1};  // the skin's, smoothed
};

// The triangles of the skin that reach into a box, ready to be searched.
struct SkinPatch {
  const Mesh* skin = nullptr;  // must outlive the patch
  std::vector<std::uint32_t> triangles;
  std::vector<glm::vec3> centres;  // of a sphere around each
  std::vector<float> radii_mm;
};

SkinPatch build_skin_patch(const Mesh& skin, const Box& box);

// The place of the patch that is nearest to `point`. The patch must not be empty.
SkinPlace find_nearest_place(const SkinPatch& patch, const glm::vec3& point);

// The mirror images of `left` parts ("brow_left" gives "brow_right"), bit for bit: x negated, faces turned
// round, eye_left to eye_right, bindings to the mirrored triangles of the skin. Throws RunError when a
// binding's triangle has no exact mirror image in the skin.
std::vector<HeadPart> mirror_parts(const std::vector<HeadPart>& left, const Mesh& skin);

// The mirror image of all of `part` behind it, in the same part; nothing for a part without bindings.
void add_mirror_image(HeadPart& part, const Mesh& skin);

}  // namespace mien

// A slit of the face that a print must keep open: the line between shut lids, between closed lips.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/mesh.hpp"
#include "head/head.hpp"

namespace mien {

// A line across a slit: the vertices of the upper rim's rows and those of the lower rim beneath them. In the
// corners upper and lower are one vertex.
struct SlitColumn {
  std::vector<std::uint32_t> upper, lower;  // innermost row first
};

// A vertex that gives way as its column's rims do.
struct SlitVertex {
  std::uint32_t vertex = 0, column = 0;
  float share = 0;  // 0..1 of the rim's way; negative for the lower rim's side
};

struct Slit {
  std::vector<SlitColumn> columns;  // by rising x; first and last are the corners
  std::vector<SlitVertex> vertices;
  bool is_bulging = false;  // lips come nearest in front of the rows, somewhere among the vertices
};

// The opening of an eye (the margin's inner and outer edge; side 1 left, -1 right) and of the mouth (the
// lips' contact and the ring before it), without `vertices`.
Slit compute_eye_slit(const NeutralHead& head, int side);
Slit compute_mouth_slit(const NeutralHead& head);

// Fills `slit.vertices`: the skin along the rims, fully up to `near_mm` from the innermost row and
// fading to nothing at `far_mm`. `cut` is the skin without what lies inside the slits.
void spread_slit(const Mesh& cut, float near_mm, float far_mm, Slit& slit);

// Moves the rims apart where they are nearer than `width_mm` in height, half and half. The corners stay.
void part_slit(const Slit& slit, float width_mm, std::vector<glm::vec3>& positions);

// Takes the triangles out that can be reached from `seed` without crossing the slit's innermost row.
void cut_slit(Mesh& mesh, const Slit& slit, std::uint32_t seed);

}  // namespace mien

// The skin with more vertices where fine relief needs them: edges near it are halved until they are short
// enough.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/model.hpp"
#include "head/surface.hpp"

namespace mien {

// Vertices below `base_count` are those of the surface; each later one is the middle of two before it. The
// same for every head, whatever its shape: it is decided on the adult.
struct FineSkin {
  std::size_t base_count = 0;
  std::vector<std::array<std::uint32_t, 2>> parents;  // of vertex base_count + i
  std::vector<std::uint32_t> mirror;                  // of each vertex
  std::vector<Triangle> triangles;                    // each left one and then its mirror image
  std::vector<MirrorPair> pairs;                      // all vertices: the surface's slots, then what is added
  std::size_t base_pairs = 0;                         // of the surface
  std::vector<std::array<std::uint32_t, 2>> pair_parents;  // slots, of slot base_pairs + i

  std::size_t vertex_count() const { return base_count + parents.size(); }
};

// How long an edge may be at a place of the left half, mm.
using EdgeLimit = std::function<double(const glm::vec3&)>;

// Splits the edges of `triangles` (mirror-symmetric, over the vertices of `surface`) that are longer at
// `positions` than `limit` allows, at most three times each.
FineSkin refine_skin(const Surface& surface, const std::vector<Triangle>& triangles,
                     const std::vector<glm::vec3>& positions, const EdgeLimit& limit);

// Appends the added vertices to those of the surface, on the smooth curve between their parents: positions
// and unit normals.
void append_fine_points(const FineSkin& fine, std::vector<glm::vec3>& positions,
                        std::vector<glm::vec3>& normals);

// Gives a part that holds the surface's vertices all of `fine`: shape, triangles, grain, and of the palette
// the shade nearest to the parents'.
void refine_part(const FineSkin& fine, Part& part);

}  // namespace mien

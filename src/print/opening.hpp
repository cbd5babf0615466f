// What of a solid is too fine to print: the morphological opening by a ball, on samples of its surface.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh.hpp"
#include "core/surface_tree.hpp"

namespace mien {

// What an edge may lose, of the finest size: a line of a nozzle that needs two for it.
inline constexpr double kBlunt = 0.5;

// A patch of the surface around `place`.
struct FinePatch {
  glm::dvec3 place{0};
  glm::dvec3 normal{0, 0, 1};  // outward
  double area_mm2 = 0;
  std::uint32_t triangle = 0;
};

// The patches that no ball of diameter `size_mm` inside the solid comes nearer to than `blunt` times that:
// plates, threads and points finer than it. Of an edge such balls leave out what is sharp: with 0.5 nothing
// is listed of edges of 60 degrees and more, with 0.25 of 84. `tree` is build_solid_tree(mesh). By rising
// triangle; the same for any number of threads. After Matheron's granulometry as Hildebrand and Rueegsegger
// take it for "local thickness" (1997).
std::vector<FinePatch> list_fine_patches(const Mesh& mesh, const SurfaceTree& tree, double size_mm,
                                         double blunt = kBlunt);

// The same among some of the triangles, which rise.
std::vector<FinePatch> list_fine_patches(const Mesh& mesh, const SurfaceTree& tree,
                                         const std::vector<std::uint32_t>& triangles, double size_mm,
                                         double blunt);

// The triangles within `size_mm` and more of what is finer than that and has more surface than `speck_mm2`;
// rising.
std::vector<std::uint32_t> list_thin_triangles(const Mesh& mesh, const SurfaceTree& tree, double size_mm,
                                               double speck_mm2);

// A detail: fine patches that lie together.
struct FineDetail {
  glm::dvec3 place{0};   // its middle
  double area_mm2 = 0;   // of its surface
  double finest_mm = 0;  // balls of this size come everywhere but to a speck of it
};

// The details finer than `size_mm` (by a thirtieth of it at least: nearer is within the error of the search)
// with more surface than `speck_mm2`, the finest first.
std::vector<FineDetail> list_fine_details(const Mesh& mesh, const SurfaceTree& tree, double size_mm,
                                          double speck_mm2);

}  // namespace mien

// How thick a solid is below a place of its surface.
#pragma once

#include "core/mesh.hpp"
#include "core/surface_tree.hpp"

namespace mien {

// The thickness below `place`, whose outward normal is `normal` (unit): the median over a narrow cone of rays
// inward, each taken along the normal. Only what leaves the solid within 60 degrees of the other way counts;
// `reach_mm` if nothing does. After Shapira, Shamir and Cohen-Or, "Consistent mesh partitioning and
// skeletonisation using the shape diameter function" (2008). Mirrored solids give mirrored answers.
double measure_thickness_mm(const SurfaceTree& tree, const glm::dvec3& place, const glm::dvec3& normal,
                            double reach_mm);

// The same of many places of a mesh, a patch of surface each.
struct ThicknessSample {
  glm::dvec3 place{0};
  double thickness_mm = 0;
  double area_mm2 = 0;  // of the patch
};

// Ascending by thickness: one sample a triangle at least and about one a square millimetre; or, with
// `patch_mm2`, one for each so much surface, small triangles together.
std::vector<ThicknessSample> list_thicknesses(const Mesh& mesh, const SurfaceTree& tree, double reach_mm,
                                              double patch_mm2 = 0);

}  // namespace mien

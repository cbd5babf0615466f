// Surfaces with control points, as polygons.
#pragma once

#include "import/polygons.hpp"
#include "import/spline.hpp"

namespace mien {

// A net of control points between two axes.
struct SplinePatch {
  SplineAxis u, v;
  glm::dvec2 low{0}, high{1};      // the part of the axes that is the surface
  std::vector<glm::dvec4> points;  // x y z and a weight above 0; u runs fastest: u.point_count() *
                                   // v.point_count()
  int line = 0;                    // in the file
};

// Adds the patches to the mesh. Polygons lie within a 4000th of the size of all patches from the surface,
// or, where that takes too many, as near as half a million points can. Patches that meet along whole borders,
// with the same curve on either side, share the points there and face the same way, the one that more of
// their area had. Throws InputError when they are too many for any mesh, or have no size.
void add_patches(const std::string& file, const std::vector<SplinePatch>& patches, Polygons& mesh);

}  // namespace mien

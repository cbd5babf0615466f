// The nearest place on somebody else's surface.
#pragma once

#include "core/surface_tree.hpp"
#include "import/polygons.hpp"

namespace mien {

// Of its polygons as fans.
SurfaceTree build_surface_tree(const Polygons& mesh);

}  // namespace mien

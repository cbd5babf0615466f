// Fewer triangles over the same vertices, for pages on machines without a graphics card while the face moves.
#pragma once

#include <vector>

#include "live/view_model.hpp"

namespace mien {

// Of a closed surface those that are missed least go; of loose pieces (hairs) whole ones. `rest` is the
// part's at rest.
std::vector<Triangle> build_coarse(const ViewPart& part, const Mesh& rest);

}  // namespace mien

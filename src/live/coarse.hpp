// Fewer triangles over the same vertices, for pages on machines without a graphics card while the face moves.
#pragma once

#include <vector>

#include "live/view_model.hpp"

namespace mien {

// Some of the loose pieces (hairs) that a part is made of, at no cost; nothing for one of few pieces.
std::vector<Triangle> take_pieces(const ViewPart& part);

// Of a closed surface those that are missed least go; of loose pieces (hairs) whole ones. `rest` is the
// part's at rest.
std::vector<Triangle> build_coarse(const ViewPart& part, const Mesh& rest);

}  // namespace mien

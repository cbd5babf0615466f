// The skin as a picture: its colours on the atlas, and the atlas's lines for painters.
#pragma once

#include "core/atlas.hpp"
#include "core/model.hpp"
#include "render/picture.hpp"

namespace mien {

inline constexpr int kPaintSize_px = 1024, kLayoutSize_px = 2048;

// The colours of a part's vertices, spread over its triangles; where nothing lies, the colour of what is next
// to it in the row.
Pixels bake_colours(const Part& part, const Atlas& atlas, int size_px);

// The edges of the triangles over the baked colours, brightened: what lies where.
Pixels draw_layout(const Part& part, const Atlas& atlas, int size_px);

}  // namespace mien

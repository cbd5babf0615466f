// The layout of a figure's skin for painters.
#pragma once

#include "core/atlas.hpp"
#include "frames/figure.hpp"

namespace mien {

// The same for every figure that is no print. About half a second.
Atlas build_figure_atlas(const Figure& figure);

}  // namespace mien

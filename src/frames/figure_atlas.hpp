// The layout of a figure's skin for painters.
#pragma once

#include "core/atlas.hpp"
#include "frames/figure.hpp"

namespace mien {

// The same for every figure that is no print. About half a second.
Atlas build_figure_atlas(const Figure& figure);

// Paints the skin as `spec.look.texture` has it, if it has one. Throws InputError for a broken picture.
void paint_figure(const HeadStock& stock, const HeadSpec& spec, Figure& figure);

}  // namespace mien

// How far a figure's moves take its skin.
#pragma once

#include "frames/figure.hpp"
#include "timeline/advice.hpp"

namespace mien {

MoveReach compute_reach(const Figure& figure);

}  // namespace mien

// Easing: how the way from one key to the next is shared out over its time.
#pragma once

#include "config/clip_spec.hpp"

namespace mien {

// The share of the way gone when `fraction` of the time is gone; a fraction outside 0..1 is held there.
//   linear  evenly             in   slow at first, then quick      hold  0 until 1
//   in_out  slow at both ends  out  quick at first, then slow
// ease(e, 0) = 0 and ease(e, 1) = 1 exactly. Never leaves 0..1 and never turns back.
double ease(Easing easing, double fraction);

}  // namespace mien

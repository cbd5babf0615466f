// Easing: how the way from one key to the next is shared out over its time.
#pragma once

#include "config/clip_spec.hpp"

namespace mien {

// The share of the way gone when `fraction` of the time is gone; a fraction outside 0..1 is held there.
//   linear  evenly             in   slow at first, then quick      hold    0 until 1
//   in_out  slow at both ends  out  quick at first, then slow      bounce  falls upon the key and rebounds
//   back    passes the key by a tenth of the way and settles       bezier  a curve of two handles, as in CSS
// 0 at 0 and 1 at 1 exactly. But for bounce, back and bezier it never turns back; but for back and bezier it
// never leaves 0..1.
double ease(const Ease& ease, double fraction);

}  // namespace mien

// Slow in and slow out: Thomas and Johnston, "The Illusion of Life" (1981), chapter 3. The curves are the
// lowest polynomials that do it: squares for one end, the cubic 3t^2 - 2t^3 for both.
#include "timeline/easing.hpp"

#include <algorithm>

namespace mien {

double ease(Easing easing, double fraction) {
  const double t = std::clamp(fraction, 0.0, 1.0);
  switch (easing) {
    case Easing::linear:
      return t;
    case Easing::in:
      return t * t;
    case Easing::out:
      return t * (2 - t);
    case Easing::in_out:
      return t * t * (3 - 2 * t);
    case Easing::hold:
      return t < 1 ? 0.0 : 1.0;
  }
  return t;
}

}  // namespace mien

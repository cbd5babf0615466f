// back and bounce: R. Penner, "Programming Macromedia Flash MX" (2002), chapter 7. bezier: CSS Easing
// Functions, https://www.w3.org/TR/css-easing-1/#cubic-bezier-easing-functions.
#include "timeline/easing.hpp"

#include <algorithm>
#include <cmath>

#include "core/smooth.hpp"

namespace mien {

namespace {

// Penner's: passes the key by a tenth of the way. Animators settle an overshoot of 5 to 15 %; with 0 it is
// `out` of the third power.
constexpr double kOvershoot = 1.70158;

// The curve through 0 and 1 with handles `a` and `b`.
double sample_bezier(double a, double b, double s) {
  const double r = 1 - s;
  return 3 * r * r * s * a + 3 * r * s * s * b + s * s * s;
}

// x rises with s, as its handles lie within 0..1: halving always finds it.
double sample_bezier(const std::array<double, 4>& handles, double x) {
  double low = 0, high = 1;
  constexpr int kHalvings = 52;  // the digits of a double
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (sample_bezier(handles[0], handles[2], middle) < x ? low : high) = middle;
  }
  return sample_bezier(handles[1], handles[3], (low + high) / 2);
}

double sample_back(double t) {
  const double left = t - 1;
  return 1 + (kOvershoot + 1) * left * left * left + kOvershoot * left * left;
}

// Four parabolas; the later ones are rebounds, each lower than the one before.
double sample_bounce(double t) {
  constexpr double kSteepness = 7.5625, kPart = 2.75;
  if (t < 1 / kPart) return kSteepness * t * t;
  for (const auto& [end, middle, height] :
       {std::array{2 / kPart, 1.5 / kPart, 0.75}, std::array{2.5 / kPart, 2.25 / kPart, 0.9375},
        std::array{1.0, 2.625 / kPart, 0.984375}})
    if (t < end) return kSteepness * (t - middle) * (t - middle) + height;
  return 1;
}

}  // namespace

double ease(const Ease& ease, double fraction) {
  const double t = std::clamp(fraction, 0.0, 1.0);
  if (t == 0 || t == 1) return t;
  switch (ease.kind) {
    case Easing::linear:
      return t;
    case Easing::in:
      return t * t;
    case Easing::out:
      return t * (2 - t);
    case Easing::in_out:
      return smooth_share(t);
    case Easing::hold:
      return 0;
    case Easing::back:
      return sample_back(t);
    case Easing::bounce:
      return sample_bounce(t);
    case Easing::bezier:
      return sample_bezier(ease.handles, t);
  }
  return t;
}

}  // namespace mien

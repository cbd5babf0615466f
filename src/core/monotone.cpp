#include "core/monotone.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace mien {

MonotoneCurve build_monotone_curve(std::vector<glm::dvec2> knots) {
  if (knots.size() < 2) throw RunError("a curve needs two points at least");
  const std::size_t last = knots.size() - 1;
  std::vector<double> secants(last);
  for (std::size_t i = 0; i < last; ++i) {
    if (knots[i + 1].x <= knots[i].x) throw RunError("a curve's points must ascend");
    secants[i] = (knots[i + 1].y - knots[i].y) / (knots[i + 1].x - knots[i].x);
  }
  std::vector<double> slopes(knots.size());
  slopes[0] = secants[0];
  slopes[last] = secants[last - 1];
  for (std::size_t i = 1; i < last; ++i) {
    // The weighted harmonic mean of the secants: zero at an extremum, so nothing overshoots.
    const double a = secants[i - 1], b = secants[i];
    const double left = knots[i].x - knots[i - 1].x, right = knots[i + 1].x - knots[i].x;
    const double wa = 2 * right + left, wb = right + 2 * left;
    slopes[i] = a * b <= 0 ? 0 : (wa + wb) / (wa / a + wb / b);
  }
  return {std::move(knots), std::move(slopes)};
}

double sample_curve(const MonotoneCurve& curve, double x, bool goes_on) {
  const auto& k = curve.knots;
  if (x <= k.front().x) return k.front().y + (goes_on ? curve.slopes.front() * (x - k.front().x) : 0);
  if (x >= k.back().x) return k.back().y + (goes_on ? curve.slopes.back() * (x - k.back().x) : 0);
  const auto above =
      std::upper_bound(k.begin(), k.end(), x, [](double v, const glm::dvec2& p) { return v < p.x; });
  const auto i = static_cast<std::size_t>(above - k.begin()) - 1;
  const double width = k[i + 1].x - k[i].x, t = (x - k[i].x) / width, s = 1 - t;
  return s * s * ((1 + 2 * t) * k[i].y + t * width * curve.slopes[i]) +
         t * t * ((1 + 2 * s) * k[i + 1].y - s * width * curve.slopes[i + 1]);
}

}  // namespace mien

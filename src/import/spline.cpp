// De Boor, "On calculating with B-splines" (1972); in the order of Piegl, Tiller, "The NURBS Book" (1997),
// A2.2.
#include "import/spline.hpp"

#include <algorithm>

namespace mien {

namespace {

// Of the range: what two knots differ by that were meant to be one.
constexpr double kSameKnot = 1e-9;

// `at` lies within the span; the span has a length, so nothing is divided by 0.
SplineRow build_row(const SplineAxis& axis, std::size_t span, double at) {
  SplineRow row;
  row.first = span - static_cast<std::size_t>(axis.degree);
  std::array<double, kMaxSplineDegree + 1> before{}, behind{};
  row.shares[0] = 1;
  for (std::size_t j = 1; j <= static_cast<std::size_t>(axis.degree); ++j) {
    before[j] = at - axis.knots[span + 1 - j];
    behind[j] = axis.knots[span + j] - at;
    double carried = 0;
    for (std::size_t r = 0; r < j; ++r) {
      const double share = row.shares[r] / (behind[r + 1] + before[j - r]);
      row.shares[r] = carried + behind[r + 1] * share;
      carried = before[j - r] * share;
    }
    row.shares[j] = carried;
  }
  return row;
}

}  // namespace

SplineAxis build_bezier_axis(int degree, const std::vector<double>& breaks) {
  SplineAxis axis{degree, {breaks.front()}};
  for (const double at : breaks) axis.knots.insert(axis.knots.end(), static_cast<std::size_t>(degree), at);
  axis.knots.push_back(breaks.back());
  return axis;
}

double find_first_place(const SplineAxis& axis) { return axis.knots[static_cast<std::size_t>(axis.degree)]; }

double find_last_place(const SplineAxis& axis) { return axis.knots[axis.point_count()]; }

std::vector<std::size_t> list_spans(const SplineAxis& axis, double low, double high) {
  std::vector<std::size_t> spans;
  for (auto i = static_cast<std::size_t>(axis.degree); i < axis.point_count(); ++i)
    if (std::min(high, axis.knots[i + 1]) - std::max(low, axis.knots[i]) > kSameKnot * (high - low))
      spans.push_back(i);
  return spans;
}

std::vector<SplineRow> build_spline_rows(const SplineAxis& axis, const std::vector<std::size_t>& spans,
                                         double low, double high, int steps) {
  std::vector<SplineRow> rows;
  for (const std::size_t span : spans) {
    const double from = std::max(low, axis.knots[span]), to = std::min(high, axis.knots[span + 1]);
    const int last = span == spans.back() ? steps : steps - 1;  // elsewhere the next span begins there
    for (int i = 0; i <= last; ++i)
      rows.push_back(build_row(axis, span, i == steps ? to : from + (to - from) * i / steps));
  }
  return rows;
}

}  // namespace mien

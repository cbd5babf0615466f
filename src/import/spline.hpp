// The curves that surfaces are woven from: B-splines, and Bezier curves as B-splines whose knots repeat.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace mien {

inline constexpr int kMaxSplineDegree = 24;  // modellers go to 11; beyond this numbers lose their digits

// Control point i counts between knots[i] and knots[i + degree + 1].
struct SplineAxis {
  int degree = 1;             // from 1 to kMaxSplineDegree
  std::vector<double> knots;  // never falling, 2 * (degree + 1) at least

  std::size_t point_count() const { return knots.size() - static_cast<std::size_t>(degree) - 1; }
};

// What each of the control points [first, first + degree] counts at one place; together 1.
struct SplineRow {
  std::size_t first = 0;
  std::array<double, kMaxSplineDegree + 1> shares{};
};

// The axis of Bezier curves that follow each other and share their ends: `breaks` are where they begin and
// where the last one ends.
SplineAxis build_bezier_axis(int degree, const std::vector<double>& breaks);

// The first and the last place where the axis is a curve.
double find_first_place(const SplineAxis& axis);
double find_last_place(const SplineAxis& axis);

// The knots i whose pieces [knots[i], knots[i + 1]] lie in [low, high], in part or wholly, and have a length.
std::vector<std::size_t> list_spans(const SplineAxis& axis, double low, double high);

// `spans` as list_spans finds them, each in `steps` equal steps: spans * steps + 1 places.
std::vector<SplineRow> build_spline_rows(const SplineAxis& axis, const std::vector<std::size_t>& spans,
                                         double low, double high, int steps);

}  // namespace mien

#include "takes/smooth.hpp"

#include <cmath>
#include <numbers>

namespace mien {

namespace {

double compute_share(double cutoff_hz, double step_s) {
  const double over = 2 * std::numbers::pi * cutoff_hz * step_s;
  return over / (over + 1);
}

// One column one way, into `into`. `at` gives the row of a step.
template <typename RowAt>
void filter_column(const std::vector<double>& at_s, const std::vector<double>& column, const SmoothSpec& spec,
                   const RowAt& at, std::vector<double>& into) {
  double value = 0, speed = 0, asked = 0;
  for (std::size_t i = 0; i < column.size(); ++i) {
    const std::size_t row = at(i);
    if (i == 0) {
      value = asked = column[row];
      into[row] += value / 2;
      continue;
    }
    const double step_s = std::abs(at_s[row] - at_s[at(i - 1)]);
    const double raw_speed = (column[row] - asked) / step_s;
    asked = column[row];
    speed += compute_share(spec.speed_cutoff_hz, step_s) * (raw_speed - speed);
    const double cutoff_hz = spec.cutoff_hz + spec.per_speed * std::abs(speed);
    value += compute_share(cutoff_hz, step_s) * (column[row] - value);
    into[row] += value / 2;
  }
}

}  // namespace

void smooth_rows(const std::vector<double>& at_s, std::size_t width, const SmoothSpec& spec,
                 std::vector<float>& values) {
  const std::size_t rows = at_s.size();
  if (spec.cutoff_hz <= 0 || rows < 3) return;
  std::vector<double> column(rows), smooth(rows);
  for (std::size_t i = 0; i < width; ++i) {
    bool is_still = true;
    for (std::size_t row = 0; row < rows; ++row) {
      column[row] = static_cast<double>(values[row * width + i]);
      is_still = is_still && column[row] == column[0];
      smooth[row] = 0;
    }
    if (is_still) continue;
    filter_column(
        at_s, column, spec, [](std::size_t step) { return step; }, smooth);
    filter_column(
        at_s, column, spec, [&](std::size_t step) { return rows - 1 - step; }, smooth);
    for (std::size_t row = 0; row < rows; ++row) values[row * width + i] = static_cast<float>(smooth[row]);
  }
}

void smooth_angles(const std::vector<double>& at_s, const SmoothSpec& spec, double unit_deg,
                   std::vector<std::array<float, 3>>& angles_deg) {
  if (angles_deg.empty()) return;
  std::vector<float> values;
  values.reserve(3 * angles_deg.size());
  for (const auto& angles : angles_deg)
    for (const float angle : angles) values.push_back(angle / static_cast<float>(unit_deg));
  smooth_rows(at_s, 3, spec, values);
  for (std::size_t row = 0; row < angles_deg.size(); ++row)
    for (std::size_t i = 0; i < 3; ++i)
      angles_deg[row][i] = values[3 * row + i] * static_cast<float>(unit_deg);
}

}  // namespace mien

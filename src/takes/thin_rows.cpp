#include "takes/thin_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mien {

namespace {

// A row is always kept after so many: what is split unluckily costs the square of them.
constexpr std::size_t kChunk = 2048;

}  // namespace

std::vector<std::size_t> thin_rows(const std::vector<double>& at_s, std::span<const float> values,
                                   std::size_t width, const std::vector<KeyColumn>& columns,
                                   double tolerance) {
  const std::size_t rows = at_s.size();
  std::vector<bool> is_kept(rows, false);
  std::vector<std::pair<std::size_t, std::size_t>> open;  // spans, both ends kept
  for (std::size_t first = 0; first + 1 < rows; first += kChunk)
    open.emplace_back(first, std::min(first + kChunk, rows - 1));
  if (rows > 0) is_kept.front() = is_kept.back() = true;
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    is_kept[first] = is_kept[last] = true;
    double worst = tolerance;
    std::size_t at = 0;
    for (const auto& [column, way] : columns) {
      const double begin = static_cast<double>(values[first * width + column]);
      const double slope =
          (static_cast<double>(values[last * width + column]) - begin) / (at_s[last] - at_s[first]);
      for (std::size_t row = first + 1; row < last; ++row) {
        const double straight = begin + slope * (at_s[row] - at_s[first]);
        const double off = way * std::abs(static_cast<double>(values[row * width + column]) - straight);
        if (off > worst) {
          worst = off;
          at = row;
        }
      }
    }
    if (at == 0) continue;
    open.emplace_back(first, at);
    open.emplace_back(at, last);
  }
  std::vector<std::size_t> kept;
  for (std::size_t row = 0; row < rows; ++row)
    if (is_kept[row]) kept.push_back(row);
  return kept;
}

}  // namespace mien

// Keys out of rows: as few as leave no row further from the straight ways between them than allowed.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace mien {

// A column of the rows, and how far one of it takes the skin: what lies within the tolerance is not seen.
struct KeyColumn {
  std::size_t column = 0;
  double way = 1;
};

// The rows that are kept, ascending: the first and the last one, and between them those from which the
// straight way would be more than `tolerance` off (Ramer 1972, Douglas and Peucker 1973, in time and not in
// space). Ways of several columns are judged one by one. No more than that of `values` is looked at.
std::vector<std::size_t> thin_rows(const std::vector<double>& at_s, std::span<const float> values,
                                   std::size_t width, const std::vector<KeyColumn>& columns,
                                   double tolerance);

}  // namespace mien

// Points that lie nowhere near a scan's others: slips of a scanner, or of who put the file together.
#pragma once

#include "import/polygons.hpp"

namespace mien {

struct Strays {
  std::size_t count = 0;  // that were left out
  double furthest = 0,
         most_within = 0;  // from the middle, in the scan's unit: of them, and of 95 of 100 points
};

// Takes out the points that lie more than four times as far from the middle (the median of each coordinate)
// as 95 of 100 do, and their faces: one of them would decide how finely all others are looked at. A few
// points are left as they are.
Strays leave_out_strays(Polygons& mesh);

// Points that are equal to the last digit become one, the first of them.
void leave_out_doubles(Polygons& cloud);

}  // namespace mien

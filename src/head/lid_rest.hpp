// How the lids rest: the upper one over the top of the iris, the lower one at its lower edge. White above the
// iris is fright, whatever the rest of the face says.
#pragma once

#include "config/part_numbers.hpp"
#include "head/head.hpp"
#include "head/surface.hpp"

namespace mien {

// How much of the iris, straight from the front, each lid hides in the middle, in mm on the adult's eye: from
// the top of the iris down to the upper lid's edge, from its bottom up to the lower lid's. Negative: white
// lies between.
struct IrisCover {
  double upper_mm = 0, lower_mm = 0;
};

// Of the left eye, on the smooth skin of `cage`.
IrisCover measure_iris_cover(const Surface& surface, const Cage& cage, const EyeNumbers& numbers,
                             const Eye& eye);

// How much a lid at rest may hide: people's upper lid covers 1 to 2 mm, the lower one touches.
struct RestRange {
  double least_mm, most_mm;
};
inline constexpr RestRange kUpperLidRest{1.3, 2.2}, kLowerLidRest{0.0, 0.9};

// Turns lids that hide less or more than that about the eye until they do not, with the skin around them, the
// corners left where they are. Lids that rest well stay. Both eyes alike. Afterwards the margin may stand off
// the ball by a tenth of a millimetre: see seat_lids in head/contact.hpp.
void rest_lids(const Surface& surface, const EyeNumbers& numbers, const Eye& eye, Cage& cage);

}  // namespace mien

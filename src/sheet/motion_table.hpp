// What faces move of the skin, as the last fields of a sheet's table: a mean way for each region of
// frames/skin_motion.hpp, mm, and the likeness to another face.
#pragma once

#include "frames/figure.hpp"
#include "sheet/plans.hpp"

namespace mien {

// Headings of those fields, and fields that are to be filled.
std::vector<SheetField> list_motion_headings(const std::string& likeness);
std::vector<SheetField> list_motion_fields();

// Fills them on this head.
void fill_motions(const Figure& figure, SheetPlan& plan);

}  // namespace mien

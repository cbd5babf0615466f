// Which areas each expression uses, and which way: after the table of Yen, "Animation of Human Faces",
// Tamkang University, 1990, section 4.2, drawn from the values of the poses.
#pragma once

#include <vector>

#include "config/spec.hpp"
#include "sheet/plans.hpp"

namespace mien {

// Of each expression that moves, in their order, a row: an arrow of each area's move, as one who looks at the
// face sees it, the longer the further, and its values in words.
SheetTable build_area_table(const std::vector<Expression>& expressions);

}  // namespace mien

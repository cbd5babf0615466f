// Where everything of a sheet stands on its page.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/plate.hpp"
#include "sheet_plans.hpp"

namespace mien {

// A cell's upper left corner on the page, in pixels.
struct SheetPlace {
  int left_px = 0, top_px = 0;
};

struct SheetLayout {
  Plate plate;                     // the page with its words
  std::vector<SheetPlace> places;  // of each cell, block after block
};

// Pure. All sizes follow the cells' size. `captions`: of each cell, block after block.
SheetLayout build_sheet_layout(const SheetPlan& plan, const std::string& title,
                               const std::vector<std::string>& captions, std::pair<int, int> cell_px);

}  // namespace mien

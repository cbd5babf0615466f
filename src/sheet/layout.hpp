// Where everything of a sheet stands on its page.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/plate.hpp"
#include "sheet/plans.hpp"

namespace mien {

// A cell's upper left corner on the page, in pixels.
struct SheetPlace {
  int left_px = 0, top_px = 0;
};

struct SheetLayout {
  Plate plate;                     // the page with its words
  std::vector<SheetPlace> places;  // of each cell, block after block
};

// The file's title in letters that can be drawn, else its name.
std::string find_sheet_title(const Spec& spec);

// Throws InputError for a page that is too large, naming --size.
void check_sheet_page(const SheetLayout& layout);

// Pure. All sizes follow the cells' size; a block is as wide as the widest.
SheetLayout build_sheet_layout(const SheetPlan& plan, const std::string& title, std::pair<int, int> cell_px);

}  // namespace mien

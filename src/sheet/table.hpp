// The tables of a sheet on its page: rules, words, and strokes of the pen.
#pragma once

#include <utility>

#include "scene/plate.hpp"
#include "sheet/plans.hpp"

namespace mien {

// Lengths on a sheet are told in hundredths of a cell's size: the root of its width times its height.
struct SheetRuler {
  double unit_px = 1;
  int px(double hundredths) const;  // 1 at least
};

SheetRuler compute_sheet_ruler(std::pair<int, int> cell_px);

// With the air below it; 0 for a table without rows.
int compute_table_height(const SheetTable& table, const SheetRuler& ruler);

void append_table(const SheetTable& table, int left_px, int top_px, int width_px, const SheetRuler& ruler,
                  Plate& plate);

}  // namespace mien

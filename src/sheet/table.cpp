#include "sheet/table.hpp"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

// Hundredths of a cell's size.
constexpr double kRow = 4.3, kTallRow = 13.5;
constexpr double kTableWords = 2.85, kTallWords = 4.8, kSmallWords = 3.3;
constexpr double kAir = 4;  // below the table
constexpr double kPen = 0.75;
constexpr double kHairline = 0.15, kTableRule = 0.25;

constexpr double kTablePale = 0.62, kHairlineStrength = 0.22;
constexpr double kWordsLine = 0.7;        // of a row's height: where its words stand
constexpr double kSmallWordsLine = 0.88;  // and those below strokes
constexpr double kStrokesMiddle = 0.38;   // and where strokes have their middle
constexpr double kStrokes = 0.8;          // their size: below 1 so that rules and words stay clear of them
constexpr double kRoom = 0.95;            // of a column's width, for its words

double compute_row_height(const SheetTable& table, std::size_t row, const SheetRuler& ruler) {
  const bool is_header = row == 0 && table.has_header;
  return ruler.px(table.is_tall && !is_header ? kTallRow : kRow);
}

}  // namespace

int SheetRuler::px(double hundredths) const {
  return std::max(1, static_cast<int>(std::lround(unit_px * hundredths)));
}

SheetRuler compute_sheet_ruler(std::pair<int, int> cell_px) {
  return {std::sqrt(static_cast<double>(cell_px.first) * cell_px.second) / 100};
}

int compute_table_height(const SheetTable& table, const SheetRuler& ruler) {
  if (table.rows.empty()) return 0;
  double height = ruler.px(kAir);
  for (std::size_t row = 0; row < table.rows.size(); ++row) height += compute_row_height(table, row, ruler);
  return static_cast<int>(height);
}

void append_table(const SheetTable& table, int left_px, int top_px, int width_px, const SheetRuler& ruler,
                  Plate& plate) {
  double top = top_px;
  const auto add_rule = [&](double y, bool is_strong) {
    plate.rules.push_back({static_cast<double>(left_px), y, static_cast<double>(width_px),
                           static_cast<double>(ruler.px(is_strong ? kTableRule : kHairline)),
                           is_strong ? kTablePale : kHairlineStrength});
  };
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const bool is_header = row == 0 && table.has_header;
    const double height = compute_row_height(table, row, ruler);
    double left = left_px;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const auto [share, align] = table.columns[i];
      const double width = share * width_px;
      const SheetField& field = table.rows[row].at(i);
      const bool is_small = table.is_tall && i > 0 && !is_header;
      double size = is_small ? kSmallWords : table.is_tall && !is_header ? kTallWords : kTableWords;
      if (is_header && table.is_tall) size = kSmallWords;
      const double line = is_small ? kSmallWordsLine : kWordsLine;
      plate.words.push_back({field.words, left + width * align, top + height * line, ruler.unit_px * size,
                             align, width * kRoom, is_header || is_small ? kTablePale : 1});
      const double middle_x = left + width / 2, middle_y = top + height * kStrokesMiddle,
                   half = kStrokes * height / 2;
      for (PlateLine stroke : field.strokes) {
        stroke.x_px = middle_x + stroke.x_px * half;
        stroke.y_px = middle_y - stroke.y_px * half;
        stroke.to_x_px = middle_x + stroke.to_x_px * half;
        stroke.to_y_px = middle_y - stroke.to_y_px * half;
        stroke.thickness_px *= ruler.unit_px * kPen;
        plate.lines.push_back(stroke);
      }
      left += width;
    }
    top += height;
    add_rule(top, is_header);
  }
}

}  // namespace mien

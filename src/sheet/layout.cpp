#include "sheet/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "sheet/table.hpp"

namespace mien {

namespace {

constexpr int kMaxPage_px = 20000;  // a side; what holds the page in memory and reads it is sized for this

// Lengths in hundredths of a cell's size (SheetRuler). Nearer than these the page looks crowded, farther it
// falls apart into single pictures.
constexpr double kMargin = 15;  // of the page, on all sides
constexpr double kTitle = 9.5;  // letters
constexpr double kSubject = 6.5;
constexpr double kHead = 11;       // from the title's line of words to the first block
constexpr double kUnderTitle = 5;  // to the rule below it
constexpr double kHeading = 5.6, kNote = 4.8, kCaption = 5;
constexpr double kHeadingHeight = 8.5;  // a block's heading with the air below it
constexpr double kHeadingLine = 5.2;    // from its upper edge to the line its words stand on
constexpr double kCaptionHeight = 8, kCaptionLine = 5.8;
constexpr double kCellGap = 2.4, kBlockGap = 9, kRowGap = 4.5;
constexpr double kCellRowGap = 2.5;  // between rows of one block
constexpr double kRule = 0.25;
constexpr double kPale = 0.62;                          // of words that only explain
constexpr double kHeadingRoom = 0.36, kNoteRoom = 0.6;  // shares of a block's width

// How all blocks lie: each column of cells has its place whether a block fills it or not.
struct Grid {
  SheetRuler ruler;
  int cell_width = 0, cell_height = 0;
  int columns = 1;
  int heading_height = 0;

  int step_x() const { return cell_width + ruler.px(kCellGap); }
  int step_y() const { return cell_height + ruler.px(kCaptionHeight) + ruler.px(kCellRowGap); }
  int rows_height(int rows) const { return rows > 0 ? rows * step_y() - ruler.px(kCellRowGap) : 0; }
  int block_width() const { return columns * step_x() - ruler.px(kCellGap); }
};

int count_columns(const SheetBlock& block) {
  return static_cast<int>(block.columns > 0 ? block.columns : block.skipped + block.cells.size());
}

int count_rows(const SheetBlock& block) {
  const int columns = std::max(1, count_columns(block));
  return (static_cast<int>(block.skipped + block.cells.size()) + columns - 1) / columns;
}

Grid build_grid(const SheetPlan& plan, std::pair<int, int> cell_px) {
  Grid grid{compute_sheet_ruler(cell_px), cell_px.first, cell_px.second, 1, 0};
  for (const SheetBlock& block : plan.blocks) {
    grid.columns = std::max(grid.columns, count_columns(block));
    if (!block.heading.empty()) grid.heading_height = grid.ruler.px(kHeadingHeight);
  }
  return grid;
}

int find_height(const SheetBlock& block, const Grid& grid) {
  return grid.heading_height + grid.rows_height(count_rows(block)) +
         compute_table_height(block.table, grid.ruler);
}

void append_heading(const SheetBlock& block, int left_px, int top_px, const Grid& grid, Plate& plate) {
  const SheetRuler& ruler = grid.ruler;
  const int width_px = grid.block_width();
  const double line_px = top_px + ruler.px(kHeadingLine);
  const bool is_alone = block.note.empty();
  plate.words.push_back({block.heading, static_cast<double>(left_px), line_px, ruler.unit_px * kHeading, 0,
                         width_px * (is_alone ? 1.0 : kHeadingRoom), 1});
  plate.words.push_back({block.note, static_cast<double>(left_px + width_px), line_px, ruler.unit_px * kNote,
                         1, width_px * kNoteRoom, kPale});
}

void append_cells(const SheetBlock& block, int left_px, int top_px, const Grid& grid, SheetLayout& layout) {
  const int columns = count_columns(block);
  for (std::size_t i = 0; i < block.cells.size(); ++i) {
    const int place_number = static_cast<int>(block.skipped + i);
    const SheetPlace place{left_px + place_number % columns * grid.step_x(),
                           top_px + place_number / columns * grid.step_y()};
    layout.places.push_back(place);
    layout.plate.words.push_back(
        {block.cells[i].caption, place.left_px + grid.cell_width / 2.0,
         static_cast<double>(place.top_px + grid.cell_height + grid.ruler.px(kCaptionLine)),
         grid.ruler.unit_px * kCaption, 0.5, grid.cell_width * 0.96, 1});
  }
}

void append_title(const SheetPlan& plan, const std::string& title, int margin_px, int width_px, int line_px,
                  const SheetRuler& ruler, Plate& plate) {
  const double left = margin_px, width = width_px, line = line_px;
  plate.words.push_back({title, left, line, ruler.unit_px * kTitle, 0, width * 0.7, 1});
  plate.words.push_back({plan.subject, left + width, line, ruler.unit_px * kSubject, 1, width * 0.25, kPale});
  plate.rules.push_back(
      {left, line + ruler.px(kUnderTitle), width, static_cast<double>(ruler.px(kRule)), kPale});
}

}  // namespace

std::string find_sheet_title(const Spec& spec) {
  const std::string title = simplify_letters(spec.title);
  return title.find_first_not_of(' ') == title.npos ? spec.name : title;
}

void check_sheet_page(const SheetLayout& layout) {
  const auto [width, height] = std::pair(layout.plate.width_px, layout.plate.height_px);
  if (std::max(width, height) > kMaxPage_px)
    throw InputError(
        fmt::format("--size: the sheet would have {}x{} pixels; expected cells so small that no "
                    "side has more than {}",
                    width, height, kMaxPage_px));
}

SheetLayout build_sheet_layout(const SheetPlan& plan, const std::string& title, std::pair<int, int> cell_px) {
  const Grid grid = build_grid(plan, cell_px);
  const SheetRuler& ruler = grid.ruler;
  const int across = static_cast<int>(plan.across);
  const int margin = ruler.px(kMargin);
  const int width = across * grid.block_width() + (across - 1) * ruler.px(kBlockGap);
  const int title_line = margin + ruler.px(kTitle * 0.6);

  SheetLayout layout;
  append_title(plan, title, margin, width, title_line, ruler, layout.plate);
  int top = title_line + ruler.px(kHead), row_height = 0;
  for (std::size_t i = 0; i < plan.blocks.size(); ++i) {
    const SheetBlock& block = plan.blocks[i];
    const int column = static_cast<int>(i) % across;
    if (i > 0 && column == 0) {
      top += row_height + ruler.px(kRowGap);
      row_height = 0;
    }
    const int left = margin + column * (grid.block_width() + ruler.px(kBlockGap));
    append_heading(block, left, top, grid, layout.plate);
    const int cells_top = top + grid.heading_height;
    append_cells(block, left, cells_top, grid, layout);
    append_table(block.table, left, cells_top + grid.rows_height(count_rows(block)), grid.block_width(),
                 ruler, layout.plate);
    row_height = std::max(row_height, find_height(block, grid));
  }
  layout.plate.width_px = width + 2 * margin;
  layout.plate.height_px = top + row_height + margin - ruler.px(kCaptionHeight) / 2;
  return layout;
}

}  // namespace mien

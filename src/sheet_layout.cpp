#include "sheet_layout.hpp"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

// Lengths in hundredths of a cell's size (the root of width times height). Nearer than these the page looks
// crowded, farther it falls apart into single pictures.
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
constexpr double kRule = 0.25;
constexpr double kPale = 0.62;                          // of words that only explain
constexpr double kHeadingRoom = 0.36, kNoteRoom = 0.6;  // shares of a block's width

struct Ruler {
  double unit_px;
  int px(double hundredths) const { return std::max(1, static_cast<int>(std::lround(unit_px * hundredths))); }
};

bool has_headings(const SheetPlan& plan) {
  return std::any_of(plan.blocks.begin(), plan.blocks.end(),
                     [](const SheetBlock& block) { return !block.heading.empty(); });
}

void append_heading(const SheetBlock& block, int left_px, int top_px, int width_px, const Ruler& ruler,
                    Plate& plate) {
  const double line_px = top_px + ruler.px(kHeadingLine);
  const bool is_alone = block.note.empty();
  plate.words.push_back({block.heading, static_cast<double>(left_px), line_px, ruler.unit_px * kHeading, 0,
                         width_px * (is_alone ? 1.0 : kHeadingRoom), 1});
  plate.words.push_back({block.note, static_cast<double>(left_px + width_px), line_px, ruler.unit_px * kNote,
                         1, width_px * kNoteRoom, kPale});
}

}  // namespace

SheetLayout build_sheet_layout(const SheetPlan& plan, const std::string& title,
                               const std::vector<std::string>& captions, std::pair<int, int> cell_px) {
  const auto [cell_width, cell_height] = cell_px;
  const Ruler ruler{std::sqrt(static_cast<double>(cell_width) * cell_height) / 100};
  const int columns = static_cast<int>(plan.blocks.front().cells.size());
  const int across = static_cast<int>(plan.across);
  const int rows = (static_cast<int>(plan.blocks.size()) + across - 1) / across;
  const int heading_height = has_headings(plan) ? ruler.px(kHeadingHeight) : 0;
  const int block_width = columns * cell_width + (columns - 1) * ruler.px(kCellGap);
  const int block_height = heading_height + cell_height + ruler.px(kCaptionHeight);
  const int margin = ruler.px(kMargin);

  SheetLayout layout;
  Plate& plate = layout.plate;
  const int width = across * block_width + (across - 1) * ruler.px(kBlockGap);
  plate.width_px = width + 2 * margin;
  const int title_line = margin + ruler.px(kTitle * 0.6);
  const int first_top = title_line + ruler.px(kHead);
  plate.height_px = first_top + rows * block_height + (rows - 1) * ruler.px(kRowGap) + margin -
                    ruler.px(kCaptionHeight) / 2;
  plate.words.push_back({title, static_cast<double>(margin), static_cast<double>(title_line),
                         ruler.unit_px * kTitle, 0, width * 0.7, 1});
  plate.words.push_back({plan.subject, static_cast<double>(margin + width), static_cast<double>(title_line),
                         ruler.unit_px * kSubject, 1, width * 0.25, kPale});
  plate.rules.push_back({static_cast<double>(margin), static_cast<double>(title_line + ruler.px(kUnderTitle)),
                         static_cast<double>(width), static_cast<double>(ruler.px(kRule)), kPale});

  std::size_t cell = 0;
  for (std::size_t i = 0; i < plan.blocks.size(); ++i) {
    const SheetBlock& block = plan.blocks[i];
    const int row = static_cast<int>(i) / across, column = static_cast<int>(i) % across;
    const int left = margin + column * (block_width + ruler.px(kBlockGap));
    const int top = first_top + row * (block_height + ruler.px(kRowGap));
    append_heading(block, left, top, block_width, ruler, plate);
    for (int k = 0; k < columns; ++k, ++cell) {
      const SheetPlace place{left + k * (cell_width + ruler.px(kCellGap)), top + heading_height};
      layout.places.push_back(place);
      plate.words.push_back({captions.at(cell), place.left_px + cell_width / 2.0,
                             static_cast<double>(place.top_px + cell_height + ruler.px(kCaptionLine)),
                             ruler.unit_px * kCaption, 0.5, cell_width * 0.96, 1});
    }
  }
  return layout;
}

}  // namespace mien

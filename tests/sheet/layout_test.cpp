#include "sheet/layout.hpp"

#include <gtest/gtest.h>

#include <array>

namespace mien {
namespace {

SheetPlan build_plan(std::size_t blocks, std::size_t cells, std::size_t across) {
  SheetPlan plan;
  plan.subject = "Things";
  plan.across = across;
  for (std::size_t i = 0; i < blocks; ++i) {
    SheetBlock& block = plan.blocks.emplace_back();
    block.heading = "Heading";
    block.cells.resize(cells);
  }
  return plan;
}

// Whatever the plan: cells lie on the page, in rows, and none on another.
TEST(sheet_layout, keeps_cells_apart_and_on_the_page) {
  for (const auto& [blocks, cells, across] :
       std::vector<std::array<std::size_t, 3>>{{1, 1, 1}, {2, 4, 1}, {5, 3, 2}, {7, 2, 3}})
    for (const auto& [width, height] : {std::pair{16, 16}, {60, 75}, {400, 500}, {1200, 300}}) {
      const SheetLayout layout =
          build_sheet_layout(build_plan(blocks, cells, across), "Title", {width, height});
      ASSERT_EQ(layout.places.size(), blocks * cells);
      for (std::size_t i = 0; i < layout.places.size(); ++i) {
        const auto [left, top] = layout.places[i];
        EXPECT_GT(left, 0);
        EXPECT_GT(top, 0);
        EXPECT_LT(left + width, layout.plate.width_px);
        EXPECT_LT(top + height, layout.plate.height_px);
        for (std::size_t k = 0; k < i; ++k)
          EXPECT_TRUE(std::abs(layout.places[k].left_px - left) > width ||
                      std::abs(layout.places[k].top_px - top) > height);
      }
    }
}

TEST(sheet_layout, sets_each_caption_under_the_middle_of_its_cell) {
  SheetPlan plan = build_plan(1, 3, 1);
  for (std::size_t i = 0; i < 3; ++i)
    plan.blocks[0].cells[i].caption = (std::array{"one", "two", "three"}[i]);
  const SheetLayout layout = build_sheet_layout(plan, "A title", {200, 250});
  EXPECT_EQ(layout.plate.words.front().words, "A title");
  for (std::size_t i = 0; i < 3; ++i) {
    const PlateWords& words = layout.plate.words[layout.plate.words.size() - 3 + i];
    EXPECT_EQ(words.words, plan.blocks[0].cells[i].caption);
    EXPECT_EQ(words.align, 0.5);
    EXPECT_EQ(words.x_px, layout.places[i].left_px + 100);
    EXPECT_GT(words.y_px, layout.places[i].top_px + 250);
    EXPECT_LE(words.room_px, 200);
  }
}

TEST(sheet_layout, breaks_a_block_into_rows_and_leaves_places_empty) {
  SheetPlan plan = build_plan(1, 5, 1);
  plan.blocks[0].columns = 3;
  plan.blocks[0].skipped = 1;
  for (SheetCell& cell : plan.blocks[0].cells) cell.caption = "Caption";
  const SheetLayout layout = build_sheet_layout(plan, "", {200, 250});
  ASSERT_EQ(layout.places.size(), 5u);
  EXPECT_EQ(layout.places[0].left_px, layout.places[3].left_px);
  EXPECT_EQ(layout.places[0].top_px, layout.places[1].top_px);
  EXPECT_LT(layout.places[2].left_px, layout.places[0].left_px);
  EXPECT_GT(layout.places[2].top_px, layout.places[0].top_px + 250);
  const auto& words = layout.plate.words;
  for (std::size_t i = words.size() - 5; i < words.size() - 3; ++i) {
    ASSERT_EQ(words[i].words, "Caption");
    EXPECT_LT(words[i].y_px, layout.places[2].top_px) << "the next row lies below it";
  }
  EXPECT_LT(layout.places[4].top_px + 250, layout.plate.height_px);

  // A row that is not full is a row, too.
  SheetPlan four = build_plan(1, 4, 1);
  four.blocks[0].columns = 3;
  const SheetLayout rows = build_sheet_layout(four, "", {200, 250});
  EXPECT_GT(rows.places[3].top_px, rows.places[0].top_px + 250);
  EXPECT_LT(rows.places[3].top_px + 250, rows.plate.height_px);
}

// Words of a table stand in their columns, strokes in their fields, and the page is long enough for both.
TEST(sheet_layout, sets_a_table_under_the_cells) {
  SheetPlan plan = build_plan(2, 2, 1);
  SheetTable& table = plan.blocks[1].table;
  table.columns = {{0.25, 0}, {0.75, 1}};
  table.is_tall = true;
  table.rows.assign(3, {{"name"}, {"value", {{-1, 0.5, 1, -0.5, 1, 1, true}}}});
  const SheetLayout layout = build_sheet_layout(plan, "", {200, 250});
  const Plate& plate = layout.plate;
  ASSERT_EQ(plate.lines.size(), 3u);
  const int left = layout.places[2].left_px, right = layout.places[3].left_px + 200;
  double above = layout.places[2].top_px + 250;
  for (std::size_t i = 0; i < 3; ++i) {
    const PlateWords& name = plate.words[plate.words.size() - 6 + 2 * i];
    const PlateWords& value = plate.words[plate.words.size() - 5 + 2 * i];
    EXPECT_EQ(name.x_px, left);
    EXPECT_NEAR(value.x_px, right, 1);
    EXPECT_GT(name.y_px, above);
    above = name.y_px;
    const PlateLine& line = plate.lines[i];
    EXPECT_TRUE(line.has_tip);
    EXPECT_NEAR((line.x_px + line.to_x_px) / 2, left + 0.625 * (right - left), 1);
    EXPECT_LT(line.y_px, line.to_y_px) << "up is up";
    EXPECT_LT(line.to_y_px, value.y_px);
  }
  EXPECT_LT(above, plate.height_px);
}

}  // namespace
}  // namespace mien

#include "sheet_layout.hpp"

#include <gtest/gtest.h>

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
          build_sheet_layout(build_plan(blocks, cells, across), "Title",
                             std::vector<std::string>(blocks * cells), {width, height});
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
  const SheetLayout layout =
      build_sheet_layout(build_plan(1, 3, 1), "A title", {"one", "two", "three"}, {200, 250});
  EXPECT_EQ(layout.plate.words.front().words, "A title");
  for (std::size_t i = 0; i < 3; ++i) {
    const PlateWords& words = layout.plate.words[layout.plate.words.size() - 3 + i];
    EXPECT_EQ(words.words, (std::array{"one", "two", "three"}[i]));
    EXPECT_EQ(words.align, 0.5);
    EXPECT_EQ(words.x_px, layout.places[i].left_px + 100);
    EXPECT_GT(words.y_px, layout.places[i].top_px + 250);
    EXPECT_LE(words.room_px, 200);
  }
}

}  // namespace
}  // namespace mien

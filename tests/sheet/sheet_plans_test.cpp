#include "sheet_plans.hpp"

#include <gtest/gtest.h>

#include "config/words.hpp"
#include "core/error.hpp"
#include "head/shapes.hpp"
#include "places.hpp"

namespace mien {
namespace {

const std::filesystem::path kData = source_folder();

std::vector<std::string> list_captions(const SheetBlock& block) {
  std::vector<std::string> captions;
  for (const SheetCell& cell : block.cells) captions.push_back(cell.caption);
  return captions;
}

using Captions = std::vector<std::string>;

TEST(sheet_plans, have_blocks_of_one_length_and_heads_in_order) {
  for (const char* kind : {"views", "details", "ages", "skulls", "features"}) {
    const SheetPlan plan = build_sheet_plan(kind, Spec{}, kData);
    ASSERT_FALSE(plan.blocks.empty()) << kind;
    EXPECT_FALSE(plan.subject.empty());
    EXPECT_GE(plan.across, 1u);
    for (const SheetBlock& block : plan.blocks) {
      EXPECT_EQ(block.cells.size(), plan.blocks.front().cells.size()) << kind;
      for (const SheetCell& cell : block.cells) {
        EXPECT_LT(cell.head, plan.heads.size()) << kind;
        EXPECT_LE(cell.framing.scale_of, cell.head)
            << kind << ": the head that decides on the scale comes first";
      }
    }
  }
}

TEST(sheet_plans, show_a_head_from_four_sides_without_and_with_its_lines) {
  const SheetPlan plan = build_sheet_plan("views", Spec{}, kData);
  ASSERT_EQ(plan.blocks.size(), 2u);
  for (const SheetBlock& block : plan.blocks)
    EXPECT_EQ(list_captions(block), (Captions{"front", "three-quarter", "side", "back"}));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_FALSE(plan.blocks[0].cells[i].has_guides);
    EXPECT_TRUE(plan.blocks[1].cells[i].has_guides);
    EXPECT_EQ(plan.blocks[0].cells[i].angle_deg, plan.blocks[1].cells[i].angle_deg);
  }
}

TEST(sheet_plans, show_every_age_to_the_adults_scale_and_to_its_own) {
  Spec spec;
  spec.head.skull = {{"wide", 1.0}};
  spec.head.guides = {{"eye_line", 0.49}};
  const SheetPlan plan = build_sheet_plan("ages", spec, kData);
  ASSERT_EQ(plan.blocks.size(), 2u);
  for (const SheetBlock& block : plan.blocks)
    EXPECT_EQ(list_captions(block), (Captions{"infant", "child", "teenager", "young adult", "adult"}));
  for (std::size_t i = 0; i < 5; ++i) {
    const SheetCell& to_scale = plan.blocks[0].cells[i];
    const SheetCell& to_height = plan.blocks[1].cells[i];
    EXPECT_EQ(plan.heads[to_scale.head].age, (Mix{{kAges[i], 1.0}}));
    EXPECT_EQ(plan.heads[to_scale.head].skull, spec.head.skull);
    EXPECT_TRUE(plan.heads[to_scale.head].guides.empty());
    EXPECT_EQ(plan.heads[to_scale.framing.scale_of].age, (Mix{{"adult", 1.0}}));
    EXPECT_EQ(to_height.framing.scale_of, to_height.head);
  }
}

TEST(sheet_plans, show_every_skull_of_the_files_age) {
  Spec spec;
  spec.head.age = {{"child", 1.0}};
  const SheetPlan plan = build_sheet_plan("skulls", spec, kData);
  ASSERT_EQ(plan.blocks.size(), 2u);
  EXPECT_EQ(list_captions(plan.blocks[1]), kSkulls);
  for (const SheetCell& cell : plan.blocks[1].cells) EXPECT_EQ(plan.heads[cell.head].age, spec.head.age);
}

TEST(sheet_plans, show_every_feature_at_its_ends_and_at_rest) {
  const SheetPlan plan = build_sheet_plan("features", Spec{}, kData);
  const auto features = load_features(kData / "templates/head");
  ASSERT_EQ(plan.blocks.size(), features.size());
  EXPECT_EQ(plan.heads.size(), 1 + 2 * features.size());
  for (std::size_t i = 0; i < features.size(); ++i) {
    EXPECT_EQ(list_captions(plan.blocks[i]), (Captions{"-1", "0", "+1"}));
    EXPECT_EQ(plan.blocks[i].note, "1: " + features[i].meaning);
    EXPECT_EQ(plan.heads[plan.blocks[i].cells[0].head].features.at(features[i].name), -1);
    EXPECT_EQ(plan.blocks[i].cells[1].head, 0u);
    EXPECT_EQ(plan.heads[plan.blocks[i].cells[2].head].features.at(features[i].name), 1);
  }
}

TEST(sheet_plans, show_details_around_landmarks) {
  const SheetPlan plan = build_sheet_plan("details", Spec{}, kData);
  ASSERT_EQ(plan.blocks.size(), 4u);
  EXPECT_EQ(plan.blocks[0].heading, "Eye");
  EXPECT_EQ(plan.blocks[3].heading, "Ear");
  for (const SheetBlock& block : plan.blocks)
    for (const SheetCell& cell : block.cells) EXPECT_FALSE(cell.framing.around.empty());
}

TEST(sheet_plans, are_of_kinds_that_are_known) {
  const auto find_mistake = [](const std::string& kind) {
    try {
      check_sheet_kind(kind);
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(find_mistake("views"), "none");
  EXPECT_EQ(find_mistake("vews"), "unknown kind 'vews'; did you mean 'views'?");
  EXPECT_EQ(find_mistake("poster"),
            "unknown kind 'poster'; expected views, details, ages, skulls or features");
}

}  // namespace
}  // namespace mien

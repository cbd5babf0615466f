#include "sheet/plans.hpp"

#include <gtest/gtest.h>

#include <set>

#include "config/limits.hpp"
#include "config/load_spec.hpp"
#include "config/words.hpp"
#include "core/error.hpp"
#include "head/shapes.hpp"
#include "places.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

const std::filesystem::path kData = source_folder();

std::vector<std::string> list_captions(const SheetBlock& block) {
  std::vector<std::string> captions;
  for (const SheetCell& cell : block.cells) captions.push_back(cell.caption);
  return captions;
}

SheetSubject build_subject(const Spec& spec = {}) {
  SheetSubject subject{
      spec, {"smile", "mien", {}, 1, {}}, load_library_sources(kData / "configs/expressions")};
  subject.expression.pose.values.back() = 0.5;
  subject.speech = shipped_stock().language->speech;
  auto& all = subject.spec.expressions;
  const auto libraries = load_expression_libraries(kData / "configs/expressions");
  all.insert(all.end(), libraries.begin(), libraries.end());
  return subject;
}

using Captions = std::vector<std::string>;

TEST(sheet_plans, have_blocks_of_one_length_and_heads_in_order) {
  for (const char* kind : {"views", "details", "ages", "skulls", "features", "expressions", "libraries",
                           "people", "mouths", "heads", "areas", "limits"}) {
    const SheetPlan plan = build_sheet_plan(kind, build_subject(), *shipped_stock().head);
    ASSERT_FALSE(plan.blocks.empty()) << kind;
    EXPECT_FALSE(plan.subject.empty());
    EXPECT_GE(plan.across, 1u);
    for (const SheetBlock& block : plan.blocks) {
      EXPECT_TRUE(block.cells.size() + block.skipped == plan.blocks.front().cells.size() ||
                  !block.table.rows.empty())
          << kind;
      for (const SheetCell& cell : block.cells) {
        EXPECT_LT(cell.head, plan.heads.size()) << kind;
        EXPECT_LE(cell.framing.scale_of, cell.head)
            << kind << ": the head that decides on the scale comes first";
      }
    }
  }
}

TEST(sheet_plans, show_a_head_from_four_sides_without_and_with_its_lines) {
  const SheetPlan plan = build_sheet_plan("views", build_subject(), *shipped_stock().head);
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
  const SheetPlan plan = build_sheet_plan("ages", build_subject(spec), *shipped_stock().head);
  ASSERT_EQ(plan.blocks.size(), 2u);
  for (const SheetBlock& block : plan.blocks)
    EXPECT_EQ(list_captions(block), (Captions{"infant", "child", "teenager", "young adult", "adult", "old"}));
  for (std::size_t i = 0; i < 6; ++i) {
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
  const SheetPlan plan = build_sheet_plan("skulls", build_subject(spec), *shipped_stock().head);
  ASSERT_EQ(plan.blocks.size(), 2u);
  EXPECT_EQ(list_captions(plan.blocks[1]), kSkulls);
  for (const SheetCell& cell : plan.blocks[1].cells) EXPECT_EQ(plan.heads[cell.head].age, spec.head.age);
}

TEST(sheet_plans, show_every_feature_at_its_ends_and_at_rest) {
  const SheetPlan plan = build_sheet_plan("features", build_subject(), *shipped_stock().head);
  const auto features = shipped().stock.head->shapes.features;
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

TEST(sheet_plans, show_twelve_people_by_their_seeds) {
  SheetSubject subject = build_subject();
  subject.seed = 5;
  subject.spec.head.age = {{"child", 1.0}};
  subject.spec.head.hair = "bob";
  subject.spec.head.said = {"age", "hair"};
  const SheetPlan plan = build_sheet_plan("people", subject, *shipped_stock().head);
  ASSERT_EQ(plan.heads.size(), 12u);
  EXPECT_EQ(list_captions(plan.blocks.front()).front(), "5");
  EXPECT_EQ(list_captions(plan.blocks.front()).back(), "16");
  for (std::size_t i = 0; i < plan.heads.size(); ++i) {
    EXPECT_EQ(plan.heads[i].age, subject.spec.head.age) << "what the file says they have in common";
    EXPECT_EQ(plan.heads[i].hair, "bob");
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(plan.heads[i].features, plan.heads[j].features);
  }
  subject.seed = 1'000'000'000;
  EXPECT_EQ(list_captions(build_sheet_plan("people", subject, *shipped_stock().head).blocks.front()).back(),
            "1000000000");
}

TEST(sheet_plans, show_details_around_landmarks) {
  const SheetPlan plan = build_sheet_plan("details", build_subject(), *shipped_stock().head);
  ASSERT_EQ(plan.blocks.size(), 4u);
  EXPECT_EQ(plan.blocks[0].heading, "Eye");
  EXPECT_EQ(plan.blocks[3].heading, "Ear");
  for (const SheetBlock& block : plan.blocks)
    for (const SheetCell& cell : block.cells) EXPECT_FALSE(cell.framing.around.empty());
}

TEST(sheet_plans, show_all_of_a_library_neutral_first_and_the_areas_of_those_that_move) {
  SheetSubject subject = build_subject();
  subject.spec.library = "tezuka";
  const SheetPlan plan = build_sheet_plan("expressions", subject, *shipped_stock().head);
  ASSERT_EQ(plan.blocks.size(), 2u);
  EXPECT_EQ(plan.blocks[0].heading, "Library tezuka");
  EXPECT_EQ(plan.blocks[0].note, subject.sources.at("tezuka"));
  EXPECT_EQ(plan.blocks[0].columns, 5u);
  const Captions captions = list_captions(plan.blocks[0]);
  EXPECT_EQ(captions.size(), 10u);
  EXPECT_EQ(captions.front(), "neutral");
  EXPECT_EQ(plan.blocks[1].table.rows.size(), 10u) << "a header, and all but neutral";
}

TEST(sheet_plans, show_a_files_own_expressions_before_its_librarys) {
  Spec spec;
  spec.library = "emfacs";
  spec.expressions = {{"sly", "", {}}};
  const SheetPlan plan = build_sheet_plan("expressions", build_subject(spec), *shipped_stock().head);
  ASSERT_EQ(plan.blocks.size(), 3u);
  EXPECT_EQ(list_captions(plan.blocks[0]), Captions{"sly"});
  EXPECT_EQ(plan.blocks[1].heading, "Library emfacs");
}

// The table of the thesis, section 4.2: which areas each expression uses (eyeballs are free in all).
TEST(sheet_plans, draw_the_thesiss_table_from_the_library) {
  SheetSubject subject = build_subject();
  subject.spec.library = "tezuka";
  const SheetTable table =
      build_sheet_plan("expressions", subject, *shipped_stock().head).blocks.back().table;
  const std::map<std::string, std::set<std::string>> used{
      {"smile", {"right lids", "left lids", "lips", "mouth corners"}},
      {"laugh", {"right lids", "left lids", "lips", "mouth corners"}},
      {"anger", {"right brow", "left brow", "lips"}},
      {"surprise", {"right brow", "left brow", "right lids", "left lids"}},
      {"shout", {"right brow", "left brow", "right lids", "left lids", "lips", "mouth corners", "chin"}},
      {"fear", {"right brow", "left brow", "right lids", "left lids", "lips", "chin"}},
      {"sadness", {"right brow", "left brow", "right lids", "left lids", "mouth corners"}},
      {"doubt left", {"left brow", "right lids", "left lids", "lips", "mouth corners"}},
      {"doubt right", {"right brow", "right lids", "left lids", "lips", "mouth corners"}}};
  ASSERT_EQ(table.rows.size(), 1 + used.size());
  for (std::size_t row = 1; row < table.rows.size(); ++row) {
    std::set<std::string> areas;
    for (std::size_t i = 1; i < table.columns.size(); ++i) {
      const SheetField& field = table.rows[row].at(i);
      EXPECT_EQ(field.words.empty(), field.strokes.empty());
      if (!field.words.empty()) areas.insert(table.rows[0][i].words);
    }
    EXPECT_EQ(areas, used.at(table.rows[row][0].words)) << table.rows[row][0].words;
  }
}

// As one who looks at the face sees it: what goes outward on the character's left goes to the right.
TEST(sheet_plans, draw_arrows_the_way_that_areas_move) {
  Spec spec;
  Expression odd{"odd", "", {}};
  const auto set = [&](const char* area, Side side, const char* move, double value) {
    odd.pose.values[*find_move(area, side, move)] = value;
  };
  set("brow", Side::left, "out", 0.5);
  set("brow", Side::right, "out", 1);
  set("eye", Side::right, "side", 1);
  set("chin", Side::none, "down", 1);
  set("corner", Side::left, "up", -0.5);
  spec.expressions = {odd};
  const SheetTable table =
      build_sheet_plan("expressions", build_subject(spec), *shipped_stock().head).blocks.back().table;
  const auto& row = table.rows.at(1);
  const auto compute_way = [&](std::size_t column) {
    const PlateLine& stroke = row.at(column).strokes.at(0);
    return glm::dvec2(stroke.to_x_px - stroke.x_px, stroke.to_y_px - stroke.y_px);
  };
  EXPECT_EQ(row[0].words, "odd");
  EXPECT_LT(compute_way(1).x, 0);
  EXPECT_GT(compute_way(2).x, 0);
  EXPECT_LT(glm::length(compute_way(2)), glm::length(compute_way(1)));
  EXPECT_GT(compute_way(5).x, 0);
  EXPECT_TRUE(row[6].strokes.empty());
  EXPECT_LT(compute_way(8).y, 0);
  EXPECT_LT(compute_way(9).y, 0);
  EXPECT_EQ(row[1].words, "out 1");
  EXPECT_EQ(row[5].words, "to left 1");
  EXPECT_EQ(row[8].words, "left down 0.5");
  EXPECT_EQ(row[9].words, "down 1");
}

TEST(sheet_plans, set_the_libraries_feelings_one_below_the_other) {
  const SheetPlan plan = build_sheet_plan("libraries", build_subject(), *shipped_stock().head);
  ASSERT_EQ(plan.blocks.size(), 3u);
  EXPECT_EQ(list_captions(plan.blocks[0]),
            (Captions{"smile", "sadness", "surprise", "fear", "anger", "doubt left"}));
  EXPECT_EQ(list_captions(plan.blocks[1]),
            (Captions{"joy", "sadness", "surprise", "fear", "anger", "contempt left"}));
}

TEST(sheet_plans, show_one_expression_on_every_age_of_four_skulls) {
  Spec spec;
  spec.head.features = {{"nose_length", 1}};
  const SheetSubject subject = build_subject(spec);
  const SheetPlan plan = build_sheet_plan("heads", subject, *shipped_stock().head);
  EXPECT_EQ(plan.heads.size(), 24u);
  EXPECT_NE(plan.blocks[0].note.find("mien/smile"), std::string::npos);
  std::set<std::pair<Mix, Mix>> heads;
  for (const SheetBlock& block : plan.blocks)
    for (const SheetCell& cell : block.cells) {
      EXPECT_EQ(cell.pose, subject.expression.pose);
      EXPECT_EQ(plan.heads[cell.head].features, spec.head.features);
      heads.emplace(plan.heads[cell.head].age, plan.heads[cell.head].skull);
      const Look& look = plan.heads[cell.head].look;
      ASSERT_TRUE(look.hair_old.has_value()) << "an old head is grey";
      EXPECT_GT(look.hair_old->r, look.hair.r + 0.2f);
    }
  EXPECT_EQ(heads.size(), 24u);
}

TEST(sheet_plans, show_each_move_of_each_area_to_its_ends) {
  const SheetPlan plan = build_sheet_plan("areas", build_subject(), *shipped_stock().head);
  EXPECT_EQ(plan.blocks.size(), 35u);
  for (const SheetBlock& block : plan.blocks) {
    EXPECT_EQ(list_captions(block), block.skipped ? (Captions{"0", "+1"}) : (Captions{"-1", "0", "+1"}))
        << block.heading;
    // The tongue is seen in an open mouth, and lips that stay shut where the jaw opens.
    const bool is_inside = block.heading.starts_with("tongue") || block.heading == "lips: shut";
    for (const SheetCell& cell : block.cells) {
      const bool moves = cell.caption != "0";
      EXPECT_EQ(moves || is_inside, cell.pose != Pose{}) << block.heading;
      EXPECT_EQ(moves, !cell.marks.empty()) << block.heading;
      EXPECT_TRUE(cell.marks.empty() || cell.marks.back().shape == MarkShape::arrow) << block.heading;
    }
  }
}

TEST(sheet_plans, tell_every_limit_once) {
  const SheetPlan plan = build_sheet_plan("limits", build_subject(), *shipped_stock().head);
  std::multiset<std::string> told, known;
  for (const SheetBlock& block : plan.blocks)
    for (std::size_t row = 1; row < block.table.rows.size(); ++row)
      told.insert(block.table.rows[row][0].words);
  for (const LimitName& limit : list_limits()) known.insert(limit.name);
  EXPECT_EQ(told, known);
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
  EXPECT_EQ(
      find_mistake("poster"),
      "unknown kind 'poster'; expected views, details, ages, skulls, features, "
      "expressions, libraries, designs, doctrines, heads, people, mouths, areas, limits, wire, compare, "
      "proofs, strip, exposure or contact");
  EXPECT_EQ(find_mistake("stripp"), "unknown kind 'stripp'; did you mean 'strip'?");
  EXPECT_EQ(find_mistake("exposre"), "unknown kind 'exposre'; did you mean 'exposure'?");
}

}  // namespace
}  // namespace mien

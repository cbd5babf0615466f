// Takes as moves, and what is lost.
#include "takes/retarget.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace mien {
namespace {

Mapping build_jaw_mapping() {
  Mapping mapping{"small", "a test"};
  mapping.units.push_back({"jaw", {{0, 1.5}}, 4, 0.25});
  mapping.units.push_back({"puff", {}, 9, 1});
  mapping.units.push_back({"tongue", {}, 0, 1});
  return mapping;
}

TakeReach build_jaw_reach() {
  TakeReach reach;
  reach.ranges = {{0, 1}, {-1, 1}, {-1, 1}};
  reach.gaze = {{1, false}, {2, true}};
  return reach;
}

// Rows a tenth of a second apart.
Take build_jaw_take(const std::vector<std::array<float, 3>>& rows) {
  Take take;
  take.file = "a.csv";
  take.channels = {{"jaw", 1, 3}, {"puff", 1, 7}, {"tongue", 1, 12}};
  for (const auto& row : rows) {
    take.at_s.push_back(0.1 * static_cast<double>(take.at_s.size()));
    take.values.insert(take.values.end(), row.begin(), row.end());
  }
  return take;
}

TEST(takes_retarget, what_our_areas_cannot_do_is_told_in_mm2) {
  const Take take = build_jaw_take({{0.5F, 0, 0}, {0.5F, 1, 0}, {0.5F, 0.6F, 0}, {0.5F, 0, 0}});
  const TakeReport report = retarget_take(take, build_jaw_mapping(), build_jaw_reach()).report;
  // Of the jaw 0.25 * 4 a row, of which a quarter is lost; of the cheek 9 and 3.24 in two of four rows.
  EXPECT_NEAR(report.moved_mm2, 1 + (9 + 3.24) / 4, 1e-6);
  EXPECT_NEAR(report.lost_mm2, 0.25 + (9 + 3.24) / 4, 1e-6);
  ASSERT_EQ(report.losses.size(), 2u);
  EXPECT_EQ(report.losses[0].unit, "puff");
  EXPECT_NEAR(report.losses[0].most, 1, 1e-9);
  EXPECT_NEAR(report.losses[0].most_s, 0.1, 1e-9);
  EXPECT_NEAR(report.losses[0].from_s, 0.1, 1e-9);
  EXPECT_NEAR(report.losses[0].to_s, 0.2, 1e-9);
  EXPECT_NEAR(report.losses[1].lost_mm2, 0.25, 1e-6);
}

TEST(takes_retarget, what_moves_no_skin_is_told_too) {
  const Take take = build_jaw_take({{0, 0, 0.5F}, {0, 0, 0.02F}});
  const TakeReport report = retarget_take(take, build_jaw_mapping(), build_jaw_reach()).report;
  ASSERT_EQ(report.losses.size(), 1u);
  EXPECT_EQ(report.losses[0].unit, "tongue");
  EXPECT_EQ(report.losses[0].lost_mm2, 0);
  EXPECT_EQ(report.lost_percent(), 0);
}

TEST(takes_retarget, moves_are_held_at_their_limits_and_told) {
  const TakeMoves moves = retarget_take(build_jaw_take({{0.2F, 0, 0}, {0.9F, 0, 0}, {0.8F, 0, 0}}),
                                        build_jaw_mapping(), build_jaw_reach());
  EXPECT_NEAR(moves.values[0], 0.3, 1e-6);
  EXPECT_NEAR(moves.values[3], 1, 1e-6);
  ASSERT_EQ(moves.report.held.size(), 1u);
  EXPECT_EQ(moves.report.held[0].move, 0u);
  EXPECT_NEAR(moves.report.held[0].most, 1.35, 1e-6);
  EXPECT_NEAR(moves.report.held[0].most_s, 0.1, 1e-9);
  EXPECT_EQ(moves.report.held[0].rows, 2);
}

TEST(takes_retarget, rows_that_are_missing_are_a_gap) {
  Take take = build_jaw_take({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
  take.at_s = {0, 0.1, 0.2, 0.9, 1};
  const auto gaps = retarget_take(take, build_jaw_mapping(), build_jaw_reach()).report.gaps;
  ASSERT_EQ(gaps.size(), 1u);
  EXPECT_EQ(gaps[0].from_s, 0.2);
  EXPECT_EQ(gaps[0].to_s, 0.9);
}

TEST(takes_retarget, a_gaze_turns_the_eyes) {
  Take take = build_jaw_take({{0, 0, 0}});
  take.gaze_deg = {{15, -15}};
  const TakeMoves moves = retarget_take(take, build_jaw_mapping(), build_jaw_reach());
  EXPECT_NEAR(moves.values[1], 0.5, 1e-6);
  EXPECT_NEAR(moves.values[2], -0.5, 1e-6);
}

TEST(takes_retarget, an_unknown_unit_is_told_where_it_is_named) {
  Take take = build_jaw_take({{0, 0, 0}});
  take.channels[1].name = "pufff";
  try {
    retarget_take(take, build_jaw_mapping(), build_jaw_reach());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(format_diagnostic(error.diagnostics.at(0)),
              "a.csv:1:7: error: unknown unit 'pufff' of small; did you mean 'puff'?");
  }
}

TEST(takes_retarget, the_second_that_loses_most_is_told) {
  std::vector<std::array<float, 3>> rows(40, {0, 0.1F, 0});
  for (std::size_t i = 22; i < 27; ++i) rows[i][1] = 1;
  const TakeReport report =
      retarget_take(build_jaw_take(rows), build_jaw_mapping(), build_jaw_reach()).report;
  EXPECT_NEAR(report.worst_s, 2, 1e-9);
  EXPECT_NEAR(report.worst_mm2, (5 * 9 + 5 * 0.09) / 10, 1e-3);
}

}  // namespace
}  // namespace mien

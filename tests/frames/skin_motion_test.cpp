#include "frames/skin_motion.hpp"

#include <gtest/gtest.h>

#include "shipped.hpp"

namespace mien {
namespace {

const Figure& adult() {
  static const Figure figure = build_figure(shipped().heads, HeadSpec{}, FigureUse::print);
  return figure;
}

Pose pose_of(Area area, const char* move, double value) {
  Pose pose;
  for (const Side side : {Side::none, Side::left, Side::right})
    if (const auto found = find_move(area, side, move)) pose.values[*found] = value;
  return pose;
}

TEST(skin_motion, is_where_an_area_moves_and_nowhere_else) {
  const SkinMotion rest = measure_motion(adult(), Pose{});
  for (const double mean_mm : rest.mean_mm) EXPECT_EQ(mean_mm, 0);
  const SkinMotion brows = measure_motion(adult(), pose_of(Area::brow, "up", 1));
  EXPECT_GT(brows.mean_mm[0], 5);
  EXPECT_LT(brows.mean_mm[3], 0.2);
  EXPECT_LT(brows.mean_mm[4], 0.001);
  const SkinMotion jaw = measure_motion(adult(), pose_of(Area::chin, "down", 1));
  EXPECT_LT(jaw.mean_mm[0], 0.01);
  EXPECT_GT(jaw.mean_mm[4], 20);
  EXPECT_GT(jaw.mean_mm[3], 5);
}

TEST(skin_motion, is_alike_by_direction_and_proportion_and_not_by_amount) {
  const SkinMotion half = measure_motion(adult(), pose_of(Area::brow, "up", 0.5)),
                   whole = measure_motion(adult(), pose_of(Area::brow, "up", 1)),
                   down = measure_motion(adult(), pose_of(Area::brow, "up", -1)),
                   jaw = measure_motion(adult(), pose_of(Area::chin, "down", 1)),
                   rest = measure_motion(adult(), Pose{});
  EXPECT_NEAR(compute_likeness(whole, whole), 1, 1e-9);
  EXPECT_GT(compute_likeness(half, whole), 0.99);
  EXPECT_LT(compute_likeness(down, whole), -0.7);
  EXPECT_NEAR(compute_likeness(jaw, whole), 0, 0.01);
  EXPECT_EQ(compute_likeness(rest, whole), 0);
}

}  // namespace
}  // namespace mien

#include "sheet/marks.hpp"

#include <gtest/gtest.h>

namespace mien {
namespace {

constexpr std::pair kSize_px{400, 300};

// A face of two places: "a" goes 3 mm up and 4 mm forward with the whole pose, "b" stays.
PlacesOfPose find_places(const Pose& pose) {
  const double t = pose.values[0];
  return {{"a", {10, 3 * t, 90 + 4 * t}}, {"b", {-10, 5, 90}}};
}

CameraView build_view(double angle_deg) {
  CameraView view;
  view.is_orthographic = true;
  view.angle_deg = angle_deg;
  view.look_at = {0, 2, 80};
  view.frame_width_mm = view.frame_height_mm = 60;
  return view;
}

DrawnMarks draw(const SheetMark& mark, double angle_deg = 0) {
  SheetCell cell;
  cell.marks = {mark};
  return draw_marks(cell, find_places, build_view(angle_deg), kSize_px);
}

Pose whole() {
  Pose pose;
  pose.values[0] = 1;
  return pose;
}

TEST(sheet_marks, an_arrow_points_from_rest_to_where_the_place_goes) {
  const DrawnMarks drawn = draw({MarkShape::arrow, {"a"}, {Pose{}, whole()}, false, {}});
  EXPECT_NEAR(drawn.way_mm, 5, 1e-6) << "in space";
  ASSERT_EQ(drawn.overlay.lines.size(), 2u) << "a dot and an arrow";
  const OverlayLine& arrow = drawn.overlay.lines[1];
  ASSERT_EQ(arrow.tips.size(), 1u);
  EXPECT_NEAR(arrow.segments[0][0].x, 10, 1e-4);
  EXPECT_NEAR(arrow.segments[0][0].y, 0, 1e-4);
  EXPECT_NEAR(arrow.tips[0][1].x, 10, 1e-4);
  EXPECT_NEAR(arrow.tips[0][1].y, 3, 1e-4);
  EXPECT_EQ(arrow.segments[0][1], arrow.tips[0][0]);
  EXPECT_GT(arrow.segments[0][0].z, 150) << "before all of the head";
}

TEST(sheet_marks, an_arrow_from_the_side_goes_the_way_that_is_seen) {
  const DrawnMarks drawn = draw({MarkShape::arrow, {"a"}, {Pose{}, whole()}, false, {}}, 90);
  const OverlayLine& arrow = drawn.overlay.lines.at(1);
  const glm::vec3 way = arrow.tips[0][1] - arrow.segments[0][0];
  EXPECT_NEAR(way.y, 3, 1e-3);
  EXPECT_NEAR(way.z, 4, 1e-3);
  EXPECT_NEAR(way.x, 0, 1e-3);
}

TEST(sheet_marks, what_does_not_move_is_a_dot) {
  const DrawnMarks drawn = draw({MarkShape::arrow, {"b"}, {Pose{}, whole()}, false, {}});
  EXPECT_EQ(drawn.way_mm, 0);
  ASSERT_EQ(drawn.overlay.lines.size(), 1u);
  EXPECT_TRUE(drawn.overlay.lines[0].tips.empty());
}

TEST(sheet_marks, a_box_holds_the_places_in_all_poses) {
  const DrawnMarks drawn =
      draw({MarkShape::box, {"a", "b"}, {Pose{}, whole()}, false, {"up", "down", "in", "out"}});
  glm::vec3 low(1e9f), high(-1e9f);
  for (const auto& segment : drawn.overlay.lines.at(0).segments)
    for (const glm::vec3& end : segment) low = glm::min(low, end), high = glm::max(high, end);
  EXPECT_NEAR(low.x, -10, 1e-4);
  EXPECT_NEAR(high.x, 10, 1e-4);
  EXPECT_NEAR(low.y, 0, 1e-4);
  EXPECT_NEAR(high.y, 5, 1e-4);
  ASSERT_EQ(drawn.overlay.words.size(), 4u);
  EXPECT_GT(drawn.overlay.words[0].at.y, high.y);
  EXPECT_LT(drawn.overlay.words[1].at.y, low.y);
  EXPECT_LT(drawn.overlay.words[2].at.x, low.x);
  EXPECT_GT(drawn.overlay.words[3].at.x, high.x);
}

TEST(sheet_marks, a_box_from_the_side_has_its_words_on_their_sides) {
  const DrawnMarks drawn =
      draw({MarkShape::box, {"a", "b"}, {Pose{}, whole()}, false, {"up", "down", "in", "out"}}, 90);
  ASSERT_EQ(drawn.overlay.words.size(), 4u);
  // From the character's left the picture's right is behind.
  EXPECT_LT(drawn.overlay.words[3].at.z, drawn.overlay.words[2].at.z);
}

TEST(sheet_marks, a_level_crosses_the_picture) {
  const DrawnMarks drawn = draw({MarkShape::level, {"a"}, {whole()}, false, {"match level"}});
  const auto& [from, to] = drawn.overlay.lines.at(0).segments.at(0);
  EXPECT_NEAR(to.x - from.x, 80, 1e-3);  // 60 mm high, 4 to 3
  EXPECT_NEAR(from.y, 3, 1e-4);
  EXPECT_EQ(drawn.overlay.words.at(0).words, "match level");
}

TEST(sheet_marks, a_line_goes_through_its_places_and_leaves_out_what_a_head_has_not) {
  const DrawnMarks drawn = draw({MarkShape::line, {"b", "nowhere", "a"}, {Pose{}}, true, {}});
  const auto& segments = drawn.overlay.lines.at(0).segments;
  EXPECT_NEAR(segments.front()[0].x, -10, 1e-4);
  EXPECT_NEAR(segments.back()[1].x, 10, 1e-4);
  EXPECT_TRUE(draw({MarkShape::line, {"nowhere"}, {Pose{}}, true, {}}).overlay.lines.empty());
}

}  // namespace
}  // namespace mien

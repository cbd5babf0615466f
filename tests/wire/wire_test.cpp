#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "wire/edges.hpp"
#include "wire/slice.hpp"
#include "wire/solids.hpp"

namespace mien {
namespace {

using testing::HasSubstr;

TEST(wire_camera, a_perspective_one_sees_what_the_frame_holds_where_povray_does) {
  CameraView view;
  view.angle_deg = 90;
  view.look_at = {5, 7, 9};
  view.frame_width_mm = 100;
  view.frame_height_mm = 200;
  const WireCamera camera = build_wire_camera(view, {300, 400});
  const auto near = [](const glm::dvec2& a, const glm::dvec2& b) { return glm::distance(a, b) < 1e-4; };
  EXPECT_TRUE(near(find_paper_place(camera, {5, 7, 9}), {150, 200}));
  EXPECT_TRUE(near(find_paper_place(camera, {5, 107, 9}), {150, 0})) << "the frame's upper edge";
  EXPECT_TRUE(near(find_paper_place(camera, {5, 7, -41}), {250, 200}))
      << "seen from the left, the back of the head is on the right";
  const double off_mm = compute_camera_distance_mm(view);
  EXPECT_NEAR(compute_depth_mm(camera, {5, 7, 9}), off_mm, 1e-6);
  const glm::dvec2 nearer = find_paper_place(camera, {5 + off_mm / 2, 57, 9});
  EXPECT_NEAR(nearer.y, 0, 1e-3) << "at half the way all is twice as large";
}

TEST(wire_edges, of_a_cube_are_eighteen_with_two_triangles_each) {
  const WireModel cube = build_cube();
  const auto edges = list_edges(cube.solids[0].triangles);
  EXPECT_EQ(edges.size(), 18u) << "twelve, and six across";
  for (const WireEdge& edge : edges) EXPECT_NE(edge.right, WireEdge::kNone);
}

TEST(wire_edges, an_open_surface_has_a_border_and_a_sharp_one_creases) {
  WireSolid solid = build_cube().solids[0];
  solid.sharp_deg = 50;
  solid.triangles.resize(10);  // without its floor
  const WireCamera camera = build_flat_camera(0, 0);
  std::map<Pen, double> mm;
  solid.has_contour = true;
  for (const WireLine& line : list_edge_lines(solid, list_edges(solid.triangles), camera))
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
      mm[line.pen] += glm::distance(line.points[i], line.points[i + 1]);
  EXPECT_NEAR(mm[Pen::border], 80, 1e-3);
  EXPECT_NEAR(mm[Pen::border] + mm[Pen::contour] + mm[Pen::crease], 240, 1e-3) << "no edge across a face";
  EXPECT_NEAR(mm[Pen::contour], 60, 1e-3) << "around the front, but for the floor's edge";
}

TEST(wire_edges, a_balls_contour_is_one_closed_line_along_its_outline) {
  const WireSolid ball = build_ball(60);
  for (const double angle : {0.0, 17.0, 123.0}) {
    const WireCamera camera = build_flat_camera(angle, 0);
    const glm::dvec2 centre = find_paper_place(camera, glm::dvec3(0));
    std::size_t outlines = 0;
    for (const WireLine& line : list_edge_lines(ball, list_edges(ball.triangles), camera)) {
      if (line.points.size() < 60) continue;  // a sliver of a facet at a pole
      ++outlines;
      EXPECT_EQ(line.points.front(), line.points.back()) << angle;
      // Edges of the net zigzag about the true contour by less than a facet, which is 6 degrees.
      for (const glm::vec3& point : line.points) {
        const double px = glm::distance(find_paper_place(camera, glm::dvec3(point)), centre);
        EXPECT_GT(px, 0.985 * 200) << angle;
        EXPECT_LT(px, 200.1) << angle;
      }
    }
    EXPECT_EQ(outlines, 1u) << angle;
  }
}

TEST(wire_seen, of_a_cube_seen_from_a_corner_nine_edges_are_and_three_are_not) {
  for (const double angle : {35.0, 130.0, 222.0, 318.0}) {
    const WireModel cube = build_cube();
    const WireCamera camera = build_flat_camera(angle, 30);
    const WireStage stage(cube.solids);
    int whole = 0, hidden = 0;
    for (const WireLine& line : cube.lines) {
      const auto seen = find_seen(stage, camera, glm::dvec3(line.points[0]), glm::dvec3(line.points[1]), 1);
      if (seen.empty()) ++hidden;
      if (seen == std::vector<std::array<double, 2>>{{0, 1}}) ++whole;
    }
    EXPECT_EQ(whole, 9) << angle;
    EXPECT_EQ(hidden, 3) << angle;
  }
}

TEST(wire_seen, a_line_behind_a_cube_is_cut_where_the_cube_begins_and_ends) {
  const WireModel cube = build_cube();
  const WireStage stage(cube.solids);
  const WireCamera camera = build_flat_camera(0, 0);
  const auto seen = find_seen(stage, camera, {-20, 1, -15}, {20, 1, -15}, 1);
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_EQ(seen[0][0], 0);
  EXPECT_NEAR(seen[0][1], 0.25, 1e-4);
  EXPECT_NEAR(seen[1][0], 0.75, 1e-4);
  EXPECT_EQ(seen[1][1], 1);
  EXPECT_EQ(find_seen(stage, camera, {-20, 1, 15}, {20, 1, 15}, 1),
            (std::vector<std::array<double, 2>>{{0, 1}}))
      << "before it nothing is hidden";
}

TEST(wire_slice, a_ball_is_cut_in_a_circle) {
  const WireSolid ball = build_ball(90);
  const auto lines = slice_solid(ball, {0, 1, 0}, 12.05, Pen::guide);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].points.front(), lines[0].points.back()) << "closed";
  double mm = 0;
  for (std::size_t i = 0; i + 1 < lines[0].points.size(); ++i) {
    mm += glm::distance(lines[0].points[i], lines[0].points[i + 1]);
    EXPECT_NEAR(lines[0].points[i].y, 12.05, 1e-4);
  }
  EXPECT_NEAR(mm, 2 * std::numbers::pi * std::sqrt(400 - 12.05 * 12.05), 0.1);
  EXPECT_TRUE(slice_solid(ball, {0, 1, 0}, 21, Pen::guide).empty());
}

TEST(wire_drawing, draws_what_is_seen_within_the_picture_and_at_its_corner) {
  Paper paper;
  paper.size = {700, 700};
  WireModel cube = build_cube();
  WireCamera camera = build_flat_camera(0, 0);
  draw_wire(cube, camera, get_pen_looks(), {50, 20}, 1, paper);
  // Seen straight from the front: the four edges of the face that is turned to us; what runs away is a point.
  EXPECT_NEAR(measure_px(paper), 800, 0.5);
  for (const PaperStroke& stroke : paper.strokes)
    for (const glm::dvec2& p : stroke.points_px)
      EXPECT_TRUE(std::abs(p.x - 350) < 100.01 && std::abs(p.y - 320) < 100.01);
  paper.strokes.clear();
  camera.look_at.x += 25;
  camera.at.x += 25;
  draw_wire(cube, camera, get_pen_looks(), {0, 0}, 1, paper);
  double left_px = 1e9;
  for (const PaperStroke& stroke : paper.strokes)
    for (const glm::dvec2& p : stroke.points_px) left_px = std::min(left_px, p.x);
  EXPECT_NEAR(left_px, 0, 1e-6) << "the rest lies beside the picture";
}

TEST(wire_drawing, is_the_same_for_any_number_of_threads) {
  WireModel model = build_cube();
  model.solids.push_back(build_ball(30));
  const WireCamera camera = build_flat_camera(20, 20);
  Paper one, many;
  one.size = many.size = camera.size;
  draw_wire(model, camera, get_pen_looks(), {0, 0}, 1, one);
  draw_wire(model, camera, get_pen_looks(), {0, 0}, 7, many);
  EXPECT_EQ(build_paper_svg(one), build_paper_svg(many));
  EXPECT_FALSE(one.strokes.empty());
}

TEST(wire_paper, svg_and_pixels_have_the_same_strokes) {
  Paper paper;
  paper.size = {40, 20};
  paper.title = "a < b";
  paper.srgb = {255, 255, 255};
  paper.strokes.push_back({{{5, 10}, {35, 10}}, 4, {0, 0, 0}});
  paper.strokes.push_back({{{20, 2}, {20, 18}}, 0.5, {200, 0, 0}});
  paper.words.push_back({"x & y", {3, 18}});
  const std::string svg = build_paper_svg(paper);
  EXPECT_THAT(svg, HasSubstr("<title>a &lt; b</title>"));
  EXPECT_THAT(svg, HasSubstr("stroke=\"#000000\" stroke-width=\"4\" stroke-linecap=\"round\" "
                             "stroke-linejoin=\"round\" d=\"M5 10 35 10\"/>"));
  EXPECT_THAT(svg, HasSubstr("stroke=\"#c80000\" stroke-width=\"0.5\""));
  EXPECT_THAT(svg, HasSubstr(">x &amp; y</text>"));
  Pixels picture = make_pixels(paper.size);
  picture.rgb.assign(picture.rgb.size(), 255);
  draw_strokes(paper.strokes, picture);
  const auto red = [&](int x, int y) { return picture.rgb[static_cast<std::size_t>(3 * (y * 40 + x))]; };
  const auto green = [&](int x, int y) {
    return picture.rgb[static_cast<std::size_t>(3 * (y * 40 + x) + 1)];
  };
  EXPECT_EQ(red(10, 10), 0);
  EXPECT_EQ(red(10, 8), 0) << "four pixels wide";
  EXPECT_EQ(red(10, 7), 255);
  EXPECT_EQ(red(10, 12), 255);
  EXPECT_EQ(red(1, 10), 255) << "beyond the round end";
  EXPECT_NEAR(green(20, 4), 255 * 0.75, 3) << "half of a half covers";
  EXPECT_NEAR(green(19, 4), 255 * 0.75, 3);
}

}  // namespace
}  // namespace mien

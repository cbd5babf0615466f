// Busts of real heads: closed, whole, standing, and the face still on them.
#include "frames/bust.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/holes.hpp"
#include "frames/bust_brows.hpp"
#include "frames/bust_eyes.hpp"
#include "frames/bust_pieces.hpp"
#include "frames/bust_skin.hpp"
#include "frames/figure.hpp"
#include "places.hpp"
#include "solids.hpp"

namespace mien {
namespace {

using testing::Contains;
using testing::Not;

const Figure& adult() {
  static const Figure figure = build_figure(HeadSpec{}, source_folder());
  return figure;
}

// A pose of one or more moves; sided ones on both sides.
Pose build_pose(std::initializer_list<std::tuple<std::string_view, std::string_view, double>> moves) {
  Pose pose;
  for (const auto& [area, move, value] : moves)
    for (std::size_t i = 0; i < kMoveCount; ++i)
      if (kMoves[i].area == area && kMoves[i].move == move) pose.values[i] = value;
  return pose;
}

Drawing draw(const Figure& figure, const Pose& pose) {
  DeformBuffers buffers;
  Drawing drawing;
  deform_figure(figure, pose, {}, buffers, drawing);
  return drawing;
}

BustPrint print_pose(const Figure& figure, const Pose& pose, double height_mm = 80) {
  return build_bust(figure.head, figure.model, draw(figure, pose), height_mm, "a bust");
}

std::vector<std::string> list_names(const BustPrint& print) {
  std::vector<std::string> names;
  for (const Solid& solid : print.solids) names.push_back(solid.name);
  return names;
}

void expect_printable(const BustPrint& print, const std::string& what) {
  ASSERT_FALSE(print.solids.empty()) << what;
  EXPECT_EQ(print.solids.front().name, "skin") << what;
  for (const Solid& solid : print.solids) {
    EXPECT_EQ(count_open_edges(solid.mesh.triangles), 0U) << what << " " << solid.name;
    EXPECT_GT(compute_volume_mm3(solid.mesh), 0) << what << " " << solid.name;
    EXPECT_EQ(split_pieces(solid.mesh).size(), 1U) << what << " " << solid.name;
  }
  const Box box = find_bounds(print.solids.front().mesh.positions);
  EXPECT_NEAR(box.low.z, 0, 1e-3) << what;
  EXPECT_NEAR(box.high.z, print.height_mm - print.base_height_mm + kFootSink_mm, 0.02) << what;
}

TEST(bust, neutral_is_skin_and_eyes_alone) {
  const BustPrint print = print_pose(adult(), Pose{});
  expect_printable(print, "neutral");
  EXPECT_EQ(print.title, "a bust");
  EXPECT_THAT(list_names(print), Contains("eye_left"));
  EXPECT_THAT(list_names(print), Contains("eye_right"));
  for (const char* hidden : {"iris_left", "brow_left", "lash_left", "cornea_left", "teeth_upper", "tongue"})
    EXPECT_THAT(list_names(print), Not(Contains(hidden)));
  std::size_t triangles = 0;
  for (const Solid& solid : print.solids) triangles += solid.mesh.triangles.size();
  EXPECT_LT(triangles, 45000U);  // OpenSCAD takes 0.4 s a thousand
  // The face looks toward -y, the crown is up, and the foot stands around the origin.
  const Box eye = find_bounds(std::find_if(print.solids.begin(), print.solids.end(), [](const Solid& solid) {
                                return solid.name == "eye_left";
                              })->mesh.positions);
  EXPECT_LT(eye.high.y, 0);
  EXPECT_GT(eye.low.x, 0);
  EXPECT_GT(eye.low.z, 40);
}

TEST(bust, every_limit_is_closed) {
  for (const MoveInfo& info : kMoves)
    for (const double value : {info.low, info.high}) {
      if (value == 0 || info.side == Side::right) continue;
      const Pose pose = build_pose({{info.area, info.move, value}});
      const BustSkin skin = build_bust_skin(adult().head, draw(adult(), pose).parts.front().positions);
      EXPECT_EQ(count_open_edges(skin.mesh.triangles), 0U) << info.area << " " << info.move << " " << value;
      EXPECT_GT(compute_volume_mm3(skin.mesh), 3e6) << info.area << " " << info.move << " " << value;
    }
}

TEST(bust, an_open_mouth_shows_teeth_and_a_hollow) {
  const BustPrint shut = print_pose(adult(), Pose{});
  const BustPrint open = print_pose(adult(), build_pose({{"chin", "down", 0.8}, {"lips", "upper", 0.6}}));
  expect_printable(open, "shout");
  EXPECT_THAT(list_names(open), Contains("teeth_upper"));
  EXPECT_LT(compute_volume_mm3(open.solids.front().mesh), compute_volume_mm3(shut.solids.front().mesh));
}

TEST(bust, lips_that_meet_are_parted_by_a_line) {
  const Pose pose = build_pose({{"lips", "press", 1}, {"chin", "up", 1}, {"lids", "upper", -1}});
  expect_printable(print_pose(adult(), pose), "pressed");
}

TEST(bust, other_heads_and_heights_are_printable) {
  HeadSpec spec;
  spec.age = {{"infant", 1.0}};
  spec.skull = {{"square", 1.0}};
  const Figure infant = build_figure(spec, source_folder());
  for (const double height_mm : {40.0, 150.0})
    expect_printable(print_pose(infant, build_pose({{"corner", "up", 1}, {"corner", "out", 1}}), height_mm),
                     "infant");
}

TEST(bust, is_the_same_each_time) {
  const Pose pose = build_pose({{"corner", "up", 0.7}});
  const BustPrint one = print_pose(adult(), pose), two = print_pose(adult(), pose);
  ASSERT_EQ(one.solids.size(), two.solids.size());
  for (std::size_t i = 0; i < one.solids.size(); ++i) {
    EXPECT_EQ(one.solids[i].mesh.positions, two.solids[i].mesh.positions);
    EXPECT_EQ(one.solids[i].mesh.triangles, two.solids[i].mesh.triangles);
  }
}

TEST(bust, refuses_a_model_that_does_not_fit) {
  const Figure& figure = adult();
  const auto fail = [&](const Model& model, const Drawing& drawing) -> std::string {
    try {
      build_bust(figure.head, model, drawing, 80, "x");
    } catch (const RunError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(fail(Model{}, Drawing{}), "internal: the model has no part 'skin'");
  EXPECT_EQ(fail(figure.model, Drawing{}),
            fmt::format("internal: a drawing of 0 parts for a model of {}", figure.model.parts.size()));
}

TEST(bust_eyes, the_carved_ball_is_closed_and_hollowed_along_the_gaze) {
  CarvedEye eye;
  eye.centre = {1, 2, 3};
  eye.gaze = glm::normalize(glm::vec3(0.3f, -0.2f, 1));
  const Mesh ball = build_carved_eye(eye);
  EXPECT_EQ(count_open_edges(ball.triangles), 0U);
  EXPECT_GT(compute_volume_mm3(ball), 0);
  float nearest = eye.radius_mm, farthest = 0;
  for (const glm::vec3& p : ball.positions) {
    nearest = std::min(nearest, glm::length(p - eye.centre));
    farthest = std::max(farthest, glm::length(p - eye.centre));
  }
  EXPECT_NEAR(nearest, eye.radius_mm - eye.pupil_depth_mm, 1e-3);
  EXPECT_NEAR(farthest, eye.radius_mm, 1e-3);
  // Vertex 0 lies on the gaze, at the pupil's floor.
  EXPECT_LT(glm::length(ball.positions[0] - eye.centre - eye.gaze * nearest), 1e-3f);
}

TEST(bust_brows, raises_the_skin_under_hairs_and_nothing_else) {
  Mesh skin = build_ball({0, 0, 0}, 60, 60);
  Mesh hairs;  // forty thin tetrahedra across the front
  for (int i = 0; i < 40; ++i) {
    const glm::vec3 root(float(i) * 0.5f - 10, 0, 60), along(1, 4, 0), side(0.1f, 0, 0), up(0, 0, 0.1f);
    const auto first = static_cast<std::uint32_t>(hairs.positions.size());
    for (const glm::vec3& p : {root, root + side, root + up, root + along}) hairs.positions.push_back(p);
    for (const Triangle& t : {Triangle{0, 2, 1}, Triangle{0, 1, 3}, Triangle{1, 2, 3}, Triangle{2, 0, 3}})
      hairs.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  raise_brows(skin, {hairs}, {2, 3});
  EXPECT_EQ(count_open_edges(skin.triangles), 0U);
  float highest = 0;
  for (const glm::vec3& p : skin.positions) {
    highest = std::max(highest, glm::length(p));
    const bool is_apart = std::abs(p.x) > 16 || p.y < -6 || p.y > 10 || p.z < 0;
    EXPECT_TRUE(!is_apart || glm::length(p) < 60.05f);
  }
  EXPECT_GT(highest, 61.5f);
  EXPECT_LT(highest, 62.3f);
}

TEST(bust_pieces, knows_inside_from_outside) {
  const Mesh ball = build_ball({0, 0, 0}, 10, 20);
  EXPECT_EQ(
      find_inside(ball, {{0, 0, 0}, {0, 9, 0}, {0, 11, 0}, {0, -11, 0}, {20, 0, 0}, {6, 6, 0}, {8, 8, 0}}),
      (std::vector<bool>{true, true, false, false, false, true, false}));
}

TEST(bust_pieces, keeps_what_shows_and_holds) {
  std::vector<Solid> solids;
  Mesh two = build_box({-1, -1, 9}, {1, 1, 11});            // half out
  append_mesh(two, build_box({-1, -1, -1}, {1, 1, 1}));     // hidden
  append_mesh(two, build_box({-1, -1, 20}, {1, 1, 21}));    // in the air
  for (Triangle& t : two.triangles) std::swap(t[1], t[2]);  // all inside out
  two.triangles.erase(two.triangles.begin());               // and the first open
  append_pieces(solids, "teeth", two);
  ASSERT_EQ(solids.size(), 3U);
  for (const Solid& solid : solids) {
    EXPECT_EQ(count_open_edges(solid.mesh.triangles), 0U);
    EXPECT_GT(compute_volume_mm3(solid.mesh), 0);
  }
  keep_showing(solids, build_ball({0, 0, 0}, 10, 20));
  ASSERT_EQ(solids.size(), 1U);
  EXPECT_EQ(solids.front().name, "teeth_1");
}

}  // namespace
}  // namespace mien

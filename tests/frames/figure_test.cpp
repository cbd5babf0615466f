#include "frames/figure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "config/config_fixture.hpp"
#include "core/data.hpp"
#include "shipped.hpp"
#include "timeline/head_turn.hpp"

namespace mien {
namespace {

const Figure& adult() {
  static const Figure figure = build_figure(shipped().heads, HeadSpec{});
  return figure;
}

Drawing draw(const Pose& pose, const TurnKey& turn) {
  DeformBuffers buffers;
  Drawing drawing;
  deform_figure(adult(), pose, turn, buffers, drawing);
  return drawing;
}

TurnKey turned(double turn_deg, double nod_deg, double tilt_deg) {
  TurnKey turn;
  turn.turn_deg = turn_deg;
  turn.nod_deg = nod_deg;
  turn.tilt_deg = tilt_deg;
  return turn;
}

glm::vec3 point(const Drawing& drawing, const char* name) {
  return drawing.parts.front().positions[adult().head.cage.index.find(name)->second];
}

Drawing draw_smooth(const TurnKey& turn) {
  DeformBuffers buffers;
  buffers.has_folds = false;
  Drawing drawing;
  deform_figure(adult(), Pose{}, turn, buffers, drawing);
  return drawing;
}

TEST(figure, neutral_drawing_without_folds_is_the_rest_model_to_the_last_bit) {
  const Drawing drawing = draw_smooth(TurnKey{});
  ASSERT_EQ(drawing.parts.size(), adult().model.parts.size());
  for (std::size_t i = 0; i < drawing.parts.size(); ++i) {
    const Part& part = adult().model.parts[i];
    if (part.is_rigid) {
      EXPECT_TRUE(drawing.parts[i].world_from_rest == glm::mat4(1)) << part.name;
    } else {
      EXPECT_TRUE(drawing.parts[i].positions == part.rest.positions) << part.name;
      EXPECT_TRUE(drawing.parts[i].normals == part.rest.normals) << part.name;
    }
  }
}

// Folds are unlike on both sides.
Drawing draw_without_folds(const Pose& pose) {
  DeformBuffers buffers;
  buffers.has_folds = false;
  Drawing drawing;
  deform_figure(adult(), pose, TurnKey{}, buffers, drawing);
  return drawing;
}

TEST(figure, an_expression_of_one_side_is_the_other_sides_mirrored_to_the_last_bit) {
  const Spec spec = load_text("mien: 1\n");
  const std::vector<std::uint32_t>& mirror = adult().folds.skin.mirror;
  const glm::vec3 flip(-1, 1, 1);
  for (const std::string name : {"tezuka/doubt", "emfacs/contempt", "extras/wink"}) {
    const Drawing left = draw_without_folds(find_expression(spec, name + "_left").pose);
    const Drawing right = draw_without_folds(find_expression(spec, name + "_right").pose);
    const PartShape &here = left.parts.front(), &there = right.parts.front();
    ASSERT_EQ(here.positions.size(), mirror.size());
    EXPECT_FALSE(here.positions == there.positions) << name;
    for (std::size_t v = 0; v < mirror.size(); ++v) {
      ASSERT_TRUE(here.positions[v] * flip == there.positions[mirror[v]]) << name << " " << v;
      ASSERT_TRUE(here.normals[v] * flip == there.normals[mirror[v]]) << name << " " << v;
    }
  }
}

TEST(figure, the_head_turns_on_a_neck_that_stays) {
  const Drawing rest = draw(Pose{}, TurnKey{});
  const Drawing left = draw(Pose{}, turned(30, 0, 0));
  EXPECT_GT(point(left, "p_tip").x, 40);  // the nose goes to the character's left
  EXPECT_LT(glm::distance(point(left, "m12_N5"), point(rest, "m12_N5")), 0.5);  // the chest does not
  const Drawing nod = draw(Pose{}, turned(0, 20, 0));
  EXPECT_LT(point(nod, "p_tip").y, point(rest, "p_tip").y - 20);  // the face goes down
  const Drawing tilt = draw(Pose{}, turned(0, 0, 15));
  EXPECT_GT(point(tilt, "cap_0_2").x, 20);  // the crown toward the left shoulder
}

TEST(figure, a_breath_lifts_the_shoulders_and_less_of_it_the_head) {
  TurnKey breath;
  breath.breath_mm = 2;
  const Drawing drawing = draw_smooth(breath);
  const std::vector<glm::vec3>&rest = adult().model.parts.front().rest.positions,
        &now = drawing.parts.front().positions;
  const auto rise = [&](std::uint32_t i) { return now[i].y - rest[i].y; };
  std::uint32_t lowest = 0, highest = 0;
  for (std::uint32_t i = 0; i < rest.size(); ++i) {
    if (rest[i].y < rest[lowest].y) lowest = i;
    if (rest[i].y > rest[highest].y) highest = i;
    EXPECT_NEAR(now[i].x, rest[i].x, 1e-3);  // fine skin lies as its normals do, which tilt a little
    EXPECT_GT(rise(i), 1.2 - 1e-3);
    EXPECT_LT(rise(i), 2 + 1e-3);
  }
  EXPECT_NEAR(rise(lowest), 2, 1e-3);
  EXPECT_NEAR(rise(highest), 1.2, 1e-3);
  for (const auto& triangle : adult().model.parts.front().rest.triangles)
    EXPECT_LT(std::abs(rise(triangle[0]) - rise(triangle[1])), 0.2) << "the neck gives smoothly";
  for (std::size_t i = 0; i < drawing.parts.size(); ++i)
    if (adult().model.parts[i].is_rigid) {
      EXPECT_NEAR(glm::vec3(drawing.parts[i].world_from_rest[3]).y, 1.2, 1e-3);
    }
}

TEST(figure, rigid_parts_go_with_the_turned_skin) {
  const Drawing drawing = draw(Pose{}, turned(25, -10, 8));
  for (std::size_t i = 0; i < drawing.parts.size(); ++i) {
    const Part& part = adult().model.parts[i];
    if (part.name != "eye_left") continue;
    const glm::vec3 centre(drawing.parts[i].world_from_rest *
                           glm::vec4(glm::vec3(adult().head.eye.centre), 1));
    for (int column = 0; column < 16; ++column) {
      const std::string name = "E1_" + std::to_string(column);
      const glm::vec3 margin = point(drawing, name.c_str());
      const glm::vec3 rest = adult().head.skin.positions[adult().head.cage.index.find(name)->second];
      EXPECT_NEAR(glm::distance(margin, centre), glm::distance(rest, glm::vec3(adult().head.eye.centre)),
                  0.01);
    }
  }
}

TEST(figure, every_part_of_a_resting_face_turns_with_the_head) {
  const TurnKey turn = turned(25, -10, 8);
  const Drawing drawing = draw(Pose{}, turn);
  const glm::dmat4 whole = compute_turn(adult().face.turn_pivot, turn, 1);
  const auto find_middle = [](const std::vector<glm::vec3>& points) {
    glm::dvec3 sum(0);
    for (const glm::vec3& p : points) sum += glm::dvec3(p) / static_cast<double>(points.size());
    return sum;
  };
  int strands = 0, rigid = 0;
  for (std::size_t i = 1; i < drawing.parts.size(); ++i) {
    const Part& part = adult().model.parts[i];
    const glm::dvec3 rest = find_middle(part.rest.positions), there(whole * glm::dvec4(rest, 1));
    const bool is_rigid = part.is_rigid;
    const glm::dvec3 now = is_rigid
                               ? glm::dvec3(drawing.parts[i].world_from_rest * glm::vec4(glm::vec3(rest), 1))
                               : find_middle(drawing.parts[i].positions);
    EXPECT_LT(glm::distance(now, there), is_rigid ? 0.001 : 0.5) << part.name;
    ++(is_rigid ? rigid : strands);
  }
  EXPECT_GT(rigid, 6);
  EXPECT_GT(strands, 1);
}

TEST(figure, of_half_its_limits_does_half_of_what_it_is_asked) {
  Figure half = adult();
  half.limits.plus.fill(0.5);
  half.limits.minus.fill(0.5);
  Pose whole;
  for (std::size_t i = 0; i < kMoveCount; ++i) whole.values[i] = i % 3 == 0 ? 0.5 : 0.25;
  Pose asked = whole;
  for (double& value : asked.values) value *= 2;
  DeformBuffers buffers;
  Drawing limited;
  deform_figure(half, asked, TurnKey{}, buffers, limited);
  const Drawing wanted = draw(whole, TurnKey{});
  for (std::size_t i = 0; i < wanted.parts.size(); ++i) {
    EXPECT_EQ(limited.parts[i].positions, wanted.parts[i].positions) << adult().model.parts[i].name;
    EXPECT_EQ(limited.parts[i].world_from_rest, wanted.parts[i].world_from_rest);
  }
}

TEST(figure, random_moments_are_finite_with_unit_normals) {
  std::mt19937 random(9);
  for (int round = 0; round < 10; ++round) {
    Pose pose;
    for (std::size_t i = 0; i < kMoveCount; ++i)
      pose.values[i] = std::uniform_real_distribution<double>(kMoves[i].low, kMoves[i].high)(random);
    const Drawing drawing = draw(pose, turned(20, 5, -4));
    for (const PartShape& shape : drawing.parts) {
      for (const glm::vec3& p : shape.positions) ASSERT_TRUE(std::isfinite(p.x + p.y + p.z));
      for (const glm::vec3& n : shape.normals) ASSERT_NEAR(glm::length(n), 1, 1e-3);
    }
  }
}

TEST(figure, a_pose_drawn_after_another_is_the_same_drawing) {
  DeformBuffers buffers;
  Drawing used;
  Pose wide;
  wide.values.fill(0.7);
  deform_figure(adult(), wide, turned(20, 0, 0), buffers, used);
  Pose pose;
  pose.values[*find_move(Area::chin, Side::none, "down")] = 0.5;
  deform_figure(adult(), pose, TurnKey{}, buffers, used);
  const Drawing fresh = draw(pose, TurnKey{});
  for (std::size_t i = 0; i < fresh.parts.size(); ++i) {
    EXPECT_TRUE(used.parts[i].positions == fresh.parts[i].positions);
    EXPECT_TRUE(used.parts[i].world_from_rest == fresh.parts[i].world_from_rest);
  }
}

}  // namespace
}  // namespace mien

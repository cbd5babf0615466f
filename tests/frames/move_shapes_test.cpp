// Moves as shapes and joints: what a program that knows nothing of faces makes of them is the face's own.
#include "frames/move_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "core/data.hpp"
#include "poses.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

const Figure& adult() {
  static const Figure figure = build_figure(shipped().heads, HeadSpec{});
  return figure;
}

// The skin and all hairs of the adult, without folds, which are unlike on both sides.
struct Sampled {
  PlaceVertices place = place_bent_parts(adult(), false);
  std::vector<glm::vec3> neutral = place(Pose{});
  ShapeRequest request;
  std::vector<MoveShapes> moves = sample_move_shapes(place, neutral, request);
};
const Sampled& sampled() {
  static const Sampled made;
  return made;
}

// The same, but that hairs ask for nothing: they are not quite alike on both sides.
const Sampled& sampled_for_skin() {
  static const Sampled made = [] {
    Sampled skin = sampled();
    skin.request.is_left_out.assign(skin.neutral.size(), true);
    const BentPart part = list_bent_parts(adult()).front();
    std::fill_n(skin.request.is_left_out.begin(), part.count, false);
    skin.moves = sample_move_shapes(skin.place, skin.neutral, skin.request);
    return skin;
  }();
  return made;
}

Pose build_pose(std::size_t move, double value) {
  Pose pose;
  pose.values[move] = value;
  return pose;
}

std::string name_of(std::size_t move) {
  return std::string(kMoves[move].area) + " " + std::string(kMoves[move].move);
}

TEST(move_shapes, neutral_is_the_rest_model_part_behind_part) {
  const std::vector<BentPart> parts = list_bent_parts(adult());
  ASSERT_GT(parts.size(), 3U);
  std::size_t end = 0;
  for (const BentPart& bent : parts) {
    EXPECT_EQ(bent.first, end);
    end += bent.count;
    const Part& part = adult().model.parts[bent.part];
    EXPECT_FALSE(part.is_rigid);
    EXPECT_TRUE(std::equal(part.rest.positions.begin(), part.rest.positions.end(),
                           sampled().neutral.begin() + static_cast<std::ptrdiff_t>(bent.first)))
        << part.name;
  }
  EXPECT_EQ(sampled().neutral.size(), end);
}

TEST(move_shapes, values_rise_without_zero_from_end_to_end) {
  ASSERT_EQ(sampled().moves.size(), kMoveCount);
  for (std::size_t m = 0; m < kMoveCount; ++m) {
    const MoveShapes& move = sampled().moves[m];
    EXPECT_EQ(move.move, m);
    const std::vector<double> values = list_shape_values(move);
    EXPECT_EQ(values.back(), kMoves[m].high);
    if (kMoves[m].low < 0) {
      EXPECT_EQ(values.front(), kMoves[m].low);
    } else {
      EXPECT_GT(values.front(), 0);
    }
    EXPECT_TRUE(std::ranges::adjacent_find(values, std::greater_equal<>()) == values.end()) << name_of(m);
    EXPECT_TRUE(std::ranges::find(values, 0.0) == values.end()) << name_of(m);
    EXPECT_LE(values.size(), 16U);
  }
  // A lid turns about an axis: it does not go straight.
  EXPECT_GT(sampled().moves[find_move(Area::lid, Side::left, "upper").value()].shapes.size(), 4U);
}

TEST(move_shapes, a_shape_is_the_deformed_head_to_the_last_bit) {
  DeformBuffers buffers;
  buffers.has_folds = false;
  Drawing drawing;
  for (const MoveShapes& move : sampled().moves)
    for (const MoveShape& shape : move.shapes) {
      deform_figure(adult(), build_pose(move.move, shape.value), {}, buffers, drawing);
      for (const BentPart& bent : list_bent_parts(adult())) {
        const std::vector<glm::vec3>& own = drawing.parts[bent.part].positions;
        ASSERT_TRUE(std::equal(own.begin(), own.end(),
                               shape.positions.begin() + static_cast<std::ptrdiff_t>(bent.first)))
            << name_of(move.move) << " " << shape.value;
      }
      EXPECT_TRUE(blend_shapes(sampled().neutral, move, shape.value) == shape.positions);
    }
}

// The bounds that the header states.
TEST(move_shapes, between_its_shapes_the_skin_stays_on_its_way) {
  const Sampled& skin = sampled_for_skin();
  for (const MoveShapes& move : skin.moves)
    EXPECT_LT(measure_between_mm(skin.place, skin.neutral, move, skin.request, 5), 0.06)
        << name_of(move.move);
}

TEST(move_shapes, between_its_shapes_hairs_stay_on_their_way) {
  const Sampled& all = sampled();
  for (const MoveShapes& move : all.moves) {
    const double most_mm = name_of(move.move) == "lid upper" ? 0.4 : 0.05;
    EXPECT_LT(measure_between_mm(all.place, all.neutral, move, all.request, 5), most_mm)
        << name_of(move.move);
  }
}

TEST(move_shapes, more_tolerance_asks_for_fewer_shapes_and_vertices_left_out_for_none) {
  const std::size_t lid = find_move(Area::lid, Side::left, "upper").value();
  ShapeRequest rough;
  rough.tolerance_mm = 1;
  const std::size_t few = sample_move_shapes(sampled().place, sampled().neutral, rough)[lid].shapes.size();
  EXPECT_LT(few, sampled().moves[lid].shapes.size());
  rough.tolerance_mm = 0;
  rough.is_left_out.assign(sampled().neutral.size(), true);
  EXPECT_EQ(sample_move_shapes(sampled().place, sampled().neutral, rough)[lid].shapes.size(), 2U);
}

TEST(move_shapes, mirrored_moves_have_mirrored_shapes) {
  const std::vector<std::uint32_t>& mirror = adult().folds.skin.mirror;
  for (std::size_t m = 0; m < kMoveCount; ++m) {
    if (kMoves[m].side != Side::left) continue;
    const double sign = kMoves[m].area == "eye" && kMoves[m].move == "side" ? -1 : 1;
    const std::size_t image = find_move(kMoves[m].area, Side::right, kMoves[m].move).value();
    const std::vector<MoveShapes>& moves = sampled_for_skin().moves;
    const std::vector<MoveShape>&left = moves[m].shapes, &right = moves[image].shapes;
    ASSERT_EQ(left.size(), right.size()) << name_of(m);
    for (std::size_t i = 0; i < left.size(); ++i) {
      const MoveShape& other = right[sign > 0 ? i : right.size() - 1 - i];
      EXPECT_EQ(left[i].value, sign * other.value) << name_of(m);
      for (std::size_t v = 0; v < mirror.size(); ++v)  // the skin is the first of the parts
        ASSERT_TRUE(left[i].positions[v] * glm::vec3(-1, 1, 1) == other.positions[mirror[v]])
            << name_of(m) << " " << v;
    }
  }
}

TEST(move_shapes, weights_of_neighbours_share_the_way) {
  const std::vector<double> values{-1, -0.5, 0.25, 1};
  const auto list = [&](double value) {
    std::vector<double> weights;
    for (std::size_t i = 0; i < values.size(); ++i) weights.push_back(compute_shape_weight(values, i, value));
    return weights;
  };
  EXPECT_EQ(list(0), (std::vector<double>{0, 0, 0, 0}));
  EXPECT_EQ(list(-1), (std::vector<double>{1, 0, 0, 0}));
  EXPECT_EQ(list(-0.75), (std::vector<double>{0.5, 0.5, 0, 0}));
  EXPECT_EQ(list(-0.25), (std::vector<double>{0, 0.5, 0, 0}));
  EXPECT_EQ(list(0.125), (std::vector<double>{0, 0, 0.5, 0}));
  EXPECT_EQ(list(0.625), (std::vector<double>{0, 0, 0.5, 0.5}));
  EXPECT_EQ(list(1), (std::vector<double>{0, 0, 0, 1}));
}

TEST(move_shapes, offsets_leave_out_what_is_slight) {
  const std::vector<glm::vec3> from(3, glm::vec3(0)), to{{0, 0.1f, 0}, {0, 1, 0}, {5, 0, 0}};
  const VertexOffsets found = compute_offsets(from, to, {0.5, 0.5, INFINITY});
  EXPECT_EQ(found.vertices, (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(found.offsets, (std::vector<glm::vec3>{{0, 1, 0}}));
}

double find_difference(const glm::mat4& a, const glm::mat4& b) {
  double worst = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) worst = std::max(worst, double(std::abs(a[i][j] - b[i][j])));
  return worst;
}

TEST(joints, turn_rigid_parts_as_the_face_does) {
  HeadSpec narrow;  // limits of its own: they are in a joint's reach
  narrow.limits = {{"eye.left.up", 0.5}, {"chin.down", 0.7}};
  std::mt19937 random(5);
  for (const Figure& figure : {adult(), build_figure(shipped().heads, narrow)}) {
    const std::vector<Joint> joints = list_joints(figure);
    ASSERT_EQ(joints.size(), 3U);
    DeformBuffers buffers;
    Drawing drawing;
    for (int i = 0; i < 8; ++i) {
      const Pose pose = build_random_pose(random);
      deform_figure(figure, pose, {}, buffers, drawing);
      for (const Joint& joint : joints) {
        EXPECT_FALSE(joint.parts.empty()) << joint.name;
        for (const std::size_t part : joint.parts) {
          EXPECT_TRUE(figure.model.parts[part].is_rigid);
          EXPECT_LT(find_difference(drawing.parts[part].world_from_rest, glm::mat4(place_joint(joint, pose))),
                    1e-5)
              << joint.name;
        }
      }
    }
  }
}

TEST(joints, every_rigid_part_rides_on_one_or_stays) {
  std::vector<int> rides(adult().model.parts.size(), 0);
  for (const Joint& joint : list_joints(adult()))
    for (const std::size_t part : joint.parts) ++rides[part];
  DeformBuffers buffers;
  Drawing drawing;
  std::mt19937 random(6);
  deform_figure(adult(), build_random_pose(random), {}, buffers, drawing);
  for (std::size_t i = 0; i < rides.size(); ++i) {
    if (!adult().model.parts[i].is_rigid) {
      EXPECT_EQ(rides[i], 0) << adult().model.parts[i].name;
      continue;
    }
    EXPECT_LE(rides[i], 1);
    if (rides[i] == 0) {
      EXPECT_TRUE(drawing.parts[i].world_from_rest == glm::mat4(1));
    }
  }
}

TEST(joints, eyes_turn_about_their_centres) {
  const std::vector<Joint> joints = list_joints(adult());
  for (const std::size_t eye : {kLeftEyeJoint, kRightEyeJoint}) {
    const glm::dvec4 centre(joints[eye].pivot_mm, 1);
    Pose pose;
    for (const JointTurn& turn : joints[eye].turns) pose.values[turn.move] = 0.7;
    EXPECT_LT(glm::distance(place_joint(joints[eye], pose) * centre, centre), 1e-9);
    EXPECT_GT(find_difference(glm::mat4(place_joint(joints[eye], pose)), glm::mat4(1)), 0.1);
  }
  EXPECT_EQ(joints[kLeftEyeJoint].pivot_mm * glm::dvec3(-1, 1, 1), joints[kRightEyeJoint].pivot_mm);
}

}  // namespace
}  // namespace mien

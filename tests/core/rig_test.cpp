#include "core/rig.hpp"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

namespace mien {
namespace {

// A joint at the origin and one 10 mm above it, which turns a quarter to the left.
struct Bent {
  Rig rig{{{"root", -1, {0, 0, 0}}, {"arm", 0, {0, 10, 0}}}, {"stretch"}, {}};
  RigPose pose{
      {{{1, 0, 0, 0}, {0, 0, 0}}, {glm::angleAxis(glm::half_pi<double>(), glm::dvec3(0, 0, 1)), {0, 10, 0}}},
      {1}};
};

TEST(rig, turns_about_its_joints) {
  const Bent bent;
  const std::vector<glm::dmat4> worlds = compute_joint_worlds(bent.rig, bent.pose);
  const RigPart part{0, {{0, 1, 0}, {0, 1, 1}, {0, 1, 0.5f}}, {}};
  const std::vector<glm::vec3> placed =
      place_rig_part(part, {{0, 15, 0}, {0, 15, 0}, {0, 15, 0}}, {0}, worlds);
  EXPECT_LT(glm::distance(placed[0], glm::vec3(0, 15, 0)), 1e-5f);
  EXPECT_LT(glm::distance(placed[1], glm::vec3(-5, 10, 0)), 1e-5f);
  EXPECT_LT(glm::distance(placed[2], glm::vec3(-2.5f, 12.5f, 0)), 1e-5f) << "halfway on a straight line";
}

TEST(rig, adds_targets_before_joints_turn) {
  const Bent bent;
  const std::vector<glm::dmat4> worlds = compute_joint_worlds(bent.rig, bent.pose);
  const RigPart part{1, {}, {{0, {{0}, {{0, 2, 0}}}, {}}}};
  EXPECT_LT(glm::distance(place_rig_part(part, {{0, 15, 0}}, {0.5f}, worlds)[0], glm::vec3(-6, 10, 0)),
            1e-5f);
}

TEST(rig, goes_half_way_between_poses) {
  const Bent bent;
  RigPose rest = bent.pose;
  rest.joints[1].turn = {1, 0, 0, 0};
  rest.weights = {0};
  const RigPose half = blend_poses(rest, bent.pose, 0.5);
  EXPECT_NEAR(glm::angle(half.joints[1].turn), glm::quarter_pi<double>(), 1e-12);
  EXPECT_EQ(half.weights[0], 0.5f);
}

}  // namespace
}  // namespace mien

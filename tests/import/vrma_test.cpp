// VRM animations, and expressions of MPFB and MakeHuman.
#include "import/take_samples.hpp"
#include "import/unit_pose.hpp"

namespace mien {
namespace {

TEST(vrma, expressions_and_head_are_read) {
  const Take take = load_take(find_take_sample("gesture.vrma"), TakeKind::vrma);
  EXPECT_EQ(take.mapping, "vrm");
  ASSERT_EQ(take.at_s.size(), 61u);
  EXPECT_NEAR(find_take_value(take, 15, "happy"), 0.5, 1e-5);
  EXPECT_NEAR(find_take_value(take, 45, "happy"), 0.6, 1e-5);
  EXPECT_NEAR(find_take_value(take, 15, "blink"), 1, 1e-5);
  EXPECT_NEAR(find_take_value(take, 30, "jawOpen"), 0.5, 1e-5);
  EXPECT_NEAR(take.turn_deg[15][0], 10, 0.01);  // to the character's left
  EXPECT_NEAR(take.turn_deg[60][0], 20, 0.01);
  EXPECT_NEAR(take.turn_deg[60][1], 0, 0.01);
  EXPECT_EQ(guess_take_kind(find_take_sample("gesture.vrma")), TakeGuess::vrma);
}

TEST(vrma, what_is_wrong_is_told) {
  const auto fault = [](const std::string& from, const std::string& to) {
    return find_broken_take_fault("gesture.vrma", TakeKind::vrma, from, to);
  };
  EXPECT_EQ(fault("glTF", "glTX"), "gesture.vrma: error: it is no JSON; expected glTF 2.0");
  EXPECT_EQ(fault("VRMC_vrm_animation\": {", "VRMC_vrm_animatiom\": {"),
            "gesture.vrma: error: has no VRMC_vrm_animation; expected an animation of VRM");
  EXPECT_EQ(fault("\"count\": 4, \"type\": \"SCALAR\"", "\"count\": 3, \"type\": \"SCALAR\""),
            "gesture.vrma: error: the way of node 2 has 3 times and 4 values, or times that do not rise; "
            "expected an animation of glTF 2.0");
  EXPECT_EQ(fault("\"count\": 4, \"type\": \"SCALAR\"", "\"count\": 9, \"type\": \"SCALAR\""),
            "gesture.vrma: error: accessor 0 ends behind its buffer; expected the whole file");
  EXPECT_EQ(fault("5126", "5123"),
            "gesture.vrma: error: accessor 0 holds numbers of kind 5123; expected floats");
}

TEST(unit_pose, an_expression_of_makehuman_is_read) {
  const UnitPose pose = load_unit_pose(find_take_sample("smile.mhpose"));
  EXPECT_EQ(pose.mapping, "makehuman");
  EXPECT_EQ(pose.name, "Smile");
  ASSERT_EQ(pose.units.size(), 4u);
  EXPECT_EQ(pose.units[0].name, "MouthLeftPullUp");
  EXPECT_EQ(pose.units[0].value, 0.7);
  EXPECT_EQ(pose.units[0].line, 5);
}

TEST(unit_pose, an_expression_of_mpfb_is_read) {
  const UnitPose pose = load_unit_pose(find_take_sample("mpfb.json"));
  EXPECT_EQ(pose.mapping, "arkit");
  EXPECT_EQ(pose.units.size(), 3u);
  EXPECT_TRUE(is_unit_pose(find_take_sample("mpfb.json")));
  EXPECT_FALSE(is_unit_pose(find_take_sample("arkit.json")));
}

TEST(unit_pose, what_is_wrong_is_told_at_its_place) {
  const auto fault = [](const std::string& text) -> std::string {
    try {
      load_unit_pose(write_take_file("a.mhpose", text));
    } catch (const InputError& e) {
      Diagnostic diagnostic = e.diagnostics.at(0);
      diagnostic.place.file = "a.mhpose";
      return format_diagnostic(diagnostic);
    }
    return "";
  };
  EXPECT_EQ(fault("{\"unit_poses\": {\n \"JawDrop\": 7}}"),
            "a.mhpose:2:13: error: 'JawDrop' is 7; expected a number from 0 to 1");
  EXPECT_EQ(fault("{\"unit_poses\": {\n \"JawDrop\": \"x\"}}"),
            "a.mhpose:2:13: error: 'JawDrop' is a text; expected a number from 0 to 1");
  EXPECT_EQ(fault("{\"unit_poses\": [1]}"),
            "a.mhpose:1:16: error: 'unit_poses' is a list; expected one object of units");
  EXPECT_EQ(fault("{\"name\": \"a\"}"),
            "a.mhpose:1:1: error: the object has no 'face_units' and no 'unit_poses'; expected one of them");
  EXPECT_EQ(fault("{\"unit_poses\": {}, \"mien\": {\"lips.press\": \"x\"}}"),
            "a.mhpose:1:43: error: 'lips.press' is a text; expected a number from 0 to 1");
  EXPECT_EQ(fault("{\"unit_poses\": {\"JawDrop\": 1, \"JawDrop\": 1}}"),
            "a.mhpose:1:42: error: 'JawDrop' is there twice; expected it once");
}

}  // namespace
}  // namespace mien

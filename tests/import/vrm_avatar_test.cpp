// Avatars of VRM.
#include "import/vrm_avatar.hpp"

#include <random>

#include "import/take_samples.hpp"

namespace mien {
namespace {

// A binary glTF of a JSON alone.
std::filesystem::path write_avatar(const std::string& json) {
  std::string text = json;
  while (text.size() % 4 != 0) text += ' ';
  const auto word = [](std::size_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 255);
    return bytes;
  };
  return write_take_file("face.vrm",
                         "glTF" + word(2) + word(20 + text.size()) + word(text.size()) + "JSON" + text);
}

std::string find_avatar_fault(const std::string& json) {
  try {
    load_vrm_avatar(write_avatar(json));
  } catch (const InputError& e) {
    const std::string what = e.what();
    return what.substr(what.find("face.vrm"));
  }
  return "";
}

const std::string kMesh = R"("nodes": [{}, {"mesh": 0}],
  "meshes": [{"primitives": [{}], "extras": {"targetNames": ["Fcl_MTH_A", "jawOpen", "eyeBlink_L"]}}])";

TEST(vrm_avatar, expressions_are_read_with_the_shapes_they_are_made_of) {
  const VrmAvatar avatar = load_vrm_avatar(write_avatar(R"({"extensions": {"VRMC_vrm": {"expressions": {
    "custom": {"Wow": {"isBinary": true, "morphTargetBinds": [
      {"node": 1, "index": 1, "weight": 0.5}, {"node": 1, "index": 2, "weight": 1}]}},
    "preset": {"happy": {"overrideBlink": "block", "overrideMouth": "none", "overrideLookAt": "blend"},
               "aa": {"morphTargetBinds": [{"node": 1, "index": 0, "weight": 1}]}}}}},)" +
                                                        kMesh + "}"));
  ASSERT_EQ(avatar.expressions.size(), 3u);
  EXPECT_EQ(avatar.expressions[0].name, "aa");
  EXPECT_EQ(avatar.expressions[0].binds.at(0).target, "Fcl_MTH_A");
  EXPECT_EQ(avatar.expressions[1].name, "happy");
  EXPECT_EQ(avatar.expressions[1].overrides, (std::vector<std::string>{"blink block", "gaze blend"}));
  EXPECT_FALSE(avatar.expressions[1].is_binary);
  const VrmExpression& wow = avatar.expressions[2];
  EXPECT_TRUE(wow.is_custom && wow.is_binary);
  ASSERT_EQ(wow.binds.size(), 2u);
  EXPECT_EQ(wow.binds[0].target, "jawOpen");
  EXPECT_EQ(wow.binds[0].weight, 0.5);
  EXPECT_EQ(wow.binds[1].target, "eyeBlink_L");
}

TEST(vrm_avatar, those_of_the_first_version_have_their_new_names) {
  const VrmAvatar avatar = load_vrm_avatar(write_avatar(
      R"({"extensions": {"VRM": {"blendShapeMaster": {"blendShapeGroups": [
    {"name": "Mine", "presetName": "unknown", "binds": [{"mesh": 0, "index": 2, "weight": 25}]},
    {"name": "Joy", "presetName": "joy", "binds": []},
    {"name": "A", "presetName": "a", "binds": [{"mesh": 0, "index": 0, "weight": 100}]}]}}},)" +
      kMesh + "}"));
  ASSERT_EQ(avatar.expressions.size(), 3u);
  EXPECT_EQ(avatar.expressions[0].name, "happy");
  EXPECT_EQ(avatar.expressions[1].name, "aa");
  EXPECT_EQ(avatar.expressions[1].binds.at(0).weight, 1);
  EXPECT_EQ(avatar.expressions[2].name, "Mine");
  EXPECT_TRUE(avatar.expressions[2].is_custom);
  EXPECT_EQ(avatar.expressions[2].binds.at(0).weight, 0.25);
}

TEST(vrm_avatar, what_is_wrong_is_told) {
  const auto of = [](const std::string& bind) {
    return R"({"extensions": {"VRMC_vrm": {"expressions": {"preset": {"aa": {"morphTargetBinds": [)" + bind +
           "]}}}}}, " + kMesh + "}";
  };
  EXPECT_EQ(find_avatar_fault("{}"), "face.vrm: error: has no VRMC_vrm; expected an avatar of VRM");
  EXPECT_EQ(find_avatar_fault(R"({"extensions": {"VRMC_vrm": {}}})"),
            "face.vrm: error: has no expressions; expected an avatar of VRM");
  EXPECT_EQ(find_avatar_fault(of("{\"index\": 0, \"weight\": 1}")),
            "face.vrm: error: expression 'aa' has a bind without 'node'; expected an avatar of VRM");
  EXPECT_EQ(
      find_avatar_fault(of("{\"node\": 0, \"index\": 0, \"weight\": 1}")),
      "face.vrm: error: expression 'aa' has a bind to a node without a mesh; expected an avatar of VRM");
  EXPECT_EQ(find_avatar_fault(of("{\"node\": 1, \"index\": 0, \"weight\": 1.5}")),
            "face.vrm: error: expression 'aa' has a bind whose weight is not from 0 to 1; expected an avatar "
            "of VRM");
  EXPECT_EQ(
      find_avatar_fault(of("7")),
      "face.vrm: error: 'morphTargetBinds' of expression 'aa' is no list of 1000 binds at most; expected an "
      "avatar of VRM");
}

// Cut, changed, with pieces lost, twice or of other words: read, or told with the file's name.
TEST(vrm_avatar, broken_ones_are_told) {
  const std::string whole =
      R"({"extensions": {"VRMC_vrm": {"expressions": {"preset": {"aa": {"morphTargetBinds": [{"node": 0, "index": 0, )"
      R"("weight": 1}], "overrideBlink": "block"}, "happy": {}}}}}, "nodes": [{"mesh": 0}], "meshes": [{"extras": )"
      R"({"targetNames": ["jawOpen"]}, "primitives": [{}]}]})";
  const char* words[] = {"null", "[", "}", "-1", "1e9", "\"x\"", "{}", ":"};
  std::mt19937 random(11);
  for (int round = 0; round < 60; ++round) {
    std::string json = whole;
    const std::size_t at = random() % json.size(), length = 1 + random() % 20;
    if (round % 4 == 0) json = json.substr(0, at);
    if (round % 4 == 1) json.insert(at, words[random() % std::size(words)]);
    if (round % 4 == 2) json.erase(at, length);
    if (round % 4 == 3) json[at] = static_cast<char>(random() % 256);
    const std::string fault = find_avatar_fault(json);
    if (!fault.empty()) {
      EXPECT_EQ(fault.find("face.vrm: error: "), 0U) << json << "\n" << fault;
      EXPECT_NE(fault.find("expected"), fault.npos) << json << "\n" << fault;
    }
  }
}

}  // namespace
}  // namespace mien

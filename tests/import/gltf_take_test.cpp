// Heads that glTF animates. The sample has targets of our names, one of ARKit's, one that mends and one that
// is nobody's; its joints "neck" and "head" turn, the first straight and the second by steps.
#include "import/take_samples.hpp"

namespace mien {
namespace {

Take read_head(double fps = 0) { return load_take(find_take_sample("head.glb"), TakeKind::gltf, fps); }

std::size_t find_row(const Take& take, double at_s) {
  for (std::size_t row = 0; row < take.at_s.size(); ++row)
    if (std::abs(take.at_s[row] - at_s) < 1e-6) return row;
  ADD_FAILURE() << "no row at " << at_s;
  return 0;
}

TEST(gltf_take, weights_are_read_by_the_names_of_targets) {
  const Take take = read_head();
  EXPECT_EQ(guess_take_kind(find_take_sample("head.glb")), TakeGuess::gltf);
  EXPECT_TRUE(take.is_animation);
  std::vector<std::string> names;
  for (const TakeChannel& channel : take.channels) names.push_back(channel.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"mien.corner.left.up", "mien.lid.left.shut", "jawOpen", "viseme_PP"}));
  const std::size_t middle = find_row(take, 0.5), last = find_row(take, 1);
  EXPECT_NEAR(find_take_value(take, middle, "mien.corner.left.up"), 0.5, 1e-6);
  EXPECT_NEAR(find_take_value(take, middle, "mien.lid.left.shut"), 0.5, 1e-6);
  EXPECT_NEAR(find_take_value(take, middle, "jawOpen"), 0.25, 1e-6);
  EXPECT_NEAR(find_take_value(take, last, "mien.lid.left.shut"), 0.75, 1e-6);
}

TEST(gltf_take, between_keys_it_goes_as_the_file_says) {
  const Take take = read_head(8);
  ASSERT_EQ(take.at_s.size(), 9u);
  EXPECT_NEAR(find_take_value(take, 2, "mien.corner.left.up"), 0.25, 1e-6);
  EXPECT_NEAR(take.turn_deg[4][0], 20, 0.01);  // the neck, turned to the left
  EXPECT_NEAR(take.turn_deg[7][1], 0, 0.01);   // the head nods in its last step only
  EXPECT_NEAR(take.turn_deg[8][1], 20, 0.01);
}

TEST(gltf_take, the_joint_of_the_head_has_a_name_that_ends_so) {
  const auto read_named = [](const std::string& node) {  // of as many letters
    const std::string told = "\"name\": \"head\" }";
    std::string text = read_take_sample("head.glb");
    EXPECT_EQ(node.size(), told.size());
    return load_take(write_take_file("named.glb", text.replace(text.find(told), told.size(), node)),
                     TakeKind::gltf);
  };
  EXPECT_NEAR(read_named("\"name\": \"HEAD\" }").turn_deg.back()[1], 20, 0.01);
  EXPECT_NEAR(read_named("\"name\":\"C_Head\"}").turn_deg.back()[1], 20, 0.01);
  EXPECT_TRUE(read_named("\"name\":\"Xhead\" }").turn_deg.empty()) << "a forehead";
}

TEST(gltf_take, a_head_without_an_animation_is_one_row) {
  std::string text = read_take_sample("head.glb");
  const std::size_t at = text.find("animations");
  text.replace(at, 10, "animaTions");
  const Take take = load_take(write_take_file("still.glb", text), TakeKind::gltf);
  EXPECT_EQ(take.at_s, std::vector<double>{0});
  EXPECT_TRUE(take.turn_deg.empty());
}

TEST(gltf_take, what_is_wrong_is_told) {
  const auto fault = [](const std::string& from, const std::string& to) {
    return find_broken_take_fault("head.glb", TakeKind::gltf, from, to);
  };
  EXPECT_EQ(
      fault("\"count\": 18", "\"count\": 12"),
      "head.glb: error: the way of node 2 has 4 weights a time where the mesh names 6 targets; expected "
      "as many");
  EXPECT_EQ(fault("\"count\": 18", "\"count\": 99"),
            "head.glb: error: accessor 3 ends behind its buffer; expected the whole file");
  EXPECT_EQ(fault("\"input\": 2", "\"input\": 9"),
            "head.glb: error: accessors 9 is not there; expected glTF 2.0");
  EXPECT_EQ(fault("\"channels\": [", "\"chanmels\": ["),
            "head.glb: error: an animation has no channels or no samplers; expected glTF 2.0");
  EXPECT_EQ(fault("\"targetNames\"", "\"targetnames\""),
            "head.glb: error: has no units of a face; expected some, such as jawOpen");
}

TEST(gltf_take, a_file_that_is_not_there_is_told) {
  EXPECT_EQ(guess_take_kind("nowhere.glb"), TakeGuess::gltf);
  try {
    load_take("nowhere.glb", TakeKind::gltf);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "nowhere.glb: error: there is no such file; expected a take of a face");
  }
}

TEST(gltf_take, joints_that_are_no_list_are_passed) {
  const std::string text =
      R"({"asset": {"version": "2.0"}, "nodes": [{"name": "head"}], "skins": [{"joints": {"a": 0}, )"
      R"("inverseBindMatrices": 0}]})";
  EXPECT_EQ(find_take_fault("a.gltf", text, TakeKind::gltf),
            "a.gltf: error: has no units of a face; expected some, such as jawOpen");
}

}  // namespace
}  // namespace mien

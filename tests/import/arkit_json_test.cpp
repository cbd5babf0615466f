// ARKit's units as JSON, and OpenFaceFX's tracks.
#include "import/take_samples.hpp"

namespace mien {
namespace {

TEST(arkit_json, frames_of_mediapipe_are_read) {
  const Take take = load_take(find_take_sample("mediapipe.json"), TakeKind::arkit);
  EXPECT_EQ(take.channels.size(), 7u);  // of no unit at all: _neutral
  EXPECT_EQ(take.row_count, 6);
  EXPECT_EQ(take.unseen_count, 1);
  ASSERT_EQ(take.at_s.size(), 5u);
  EXPECT_NEAR(take.at_s[3], 0.132, 1e-9);
  EXPECT_NEAR(find_take_value(take, 4, "jawOpen"), 0.5, 1e-6);
  EXPECT_NEAR(find_take_value(take, 4, "mouthSmileLeft"), 0.25, 1e-6);
  ASSERT_EQ(take.turn_deg.size(), 5u);
  EXPECT_NEAR(take.turn_deg[4][0], 15, 1e-3);  // to the character's left
  EXPECT_NEAR(take.turn_deg[4][1], 0, 1e-3);
  EXPECT_EQ(guess_take_kind(find_take_sample("mediapipe.json")), TakeGuess::arkit);
}

TEST(arkit_json, a_matrix_by_rows_is_the_same_turn) {
  const Take take = load_take(
      write_take_file("rows.json",
                      R"([{"time": 0, "blendshapes": {"jawOpen": 1}, "facial_transformation_matrixes":
[[[0.9848, 0, 0.1736, 1.5], [0, 1, 0, -2], [-0.1736, 0, 0.9848, -40], [0, 0, 0, 1]]]}])"),
      TakeKind::arkit);
  EXPECT_NEAR(take.turn_deg[0][0], 10, 0.01);
}

TEST(arkit_json, frames_of_recorders_are_read) {
  const Take take = load_take(find_take_sample("arkit.json"), TakeKind::arkit);
  ASSERT_EQ(take.at_s.size(), 5u);
  EXPECT_NEAR(take.at_s[4], 4.0 / 60, 1e-4);
  EXPECT_NEAR(find_take_value(take, 4, "tongueOut"), 0.4, 1e-6);
  EXPECT_NEAR(find_take_value(take, 4, "mouthSmileRight"), 0.5, 1e-6);
}

TEST(arkit_json, times_are_what_their_steps_let_them_be) {
  const auto load = [](const std::string& text) {
    return load_take(write_take_file("times.json", text), TakeKind::arkit);
  };
  EXPECT_NEAR(load(R"([{"timestamp": 5000, "blendShapes": {"jawOpen": 0}}, {"timestamp": 5033,
    "blendShapes": {"jawOpen": 1}}])")
                  .at_s[1],
              0.033, 1e-9);
  EXPECT_NEAR(load(R"([{"timestamp": 12.5, "blendShapes": {"jawOpen": 0}}, {"timestamp": 12.6,
    "blendShapes": {"jawOpen": 1}}])")
                  .at_s[1],
              0.1, 1e-9);
  EXPECT_NEAR(
      load(R"({"fps": 25, "frames": [{"blendShapes": {"jawOpen": 0}}, {"blendShapes": {"jawOpen": 1}}]})")
          .at_s[1],
      0.04, 1e-9);
  EXPECT_NEAR(load(R"([{"blendShapes": {"jawOpen": 0}}, {"blendShapes": {"jawOpen": 1}}])").at_s[1], 1.0 / 30,
              1e-9);
}

TEST(arkit_json, a_unit_that_comes_later_was_at_rest) {
  const Take take = load_take(
      write_take_file("later.json", R"([{"blendShapes": {"jawOpen": 0.5}}, {"blendShapes": {"jawOpen": 0.6,
        "cheekPuff": 0.7}}])"),
      TakeKind::arkit);
  EXPECT_NEAR(find_take_value(take, 0, "jawOpen"), 0.5, 1e-6);
  EXPECT_NEAR(find_take_value(take, 0, "cheekPuff"), 0, 1e-6);
  EXPECT_NEAR(find_take_value(take, 1, "cheekPuff"), 0.7, 1e-6);
}

TEST(arkit_json, what_is_wrong_is_told_at_its_place) {
  const auto fault = [](const std::string& text) { return find_take_fault("a.json", text, TakeKind::arkit); };
  EXPECT_EQ(fault("[{\"blendShapes\": {\"jawOpen\": 0.5,}}]"),
            "a.json:1:34: error: '}' cannot stand here; expected JSON");
  EXPECT_EQ(fault("[{\"blendShapes\":\n  {\"jawOpen\": 0.5}"),
            "a.json:2:19: error: the file ends within its JSON; expected the rest");
  EXPECT_EQ(fault("[{\"blendShapes\":\n  {\"jawOpen\": 77}}]"),
            "a.json:2:15: error: 'jawOpen' is 77; expected a number from -10 to 10");
  EXPECT_EQ(fault("[{\"blendShapes\":\n  {\"jawOpen\": \"x\"}}]"),
            "a.json:2:15: error: 'jawOpen' is a text; expected a number from 0 to 1");
  EXPECT_EQ(fault("[{\"faceBlendshapes\": [{\"categories\":\n [{\"categoryName\": \"jawOpen\"}]}]}]"),
            "a.json:2:20: error: 'jawOpen' has no score; expected one");
  EXPECT_EQ(
      fault("[{\"time\": 1, \"blendShapes\": {\"jawOpen\": 1}},\n {\"time\": 0.5, \"blendShapes\": {}}]"),
      "a.json:2:2: error: this time is before the one of the row before; expected rising times");
  EXPECT_EQ(fault("[1, 2]"),
            "a.json:1:2: error: a number in the list of frames; expected an object for each");
  EXPECT_EQ(fault("{\"a\": 1}"),
            "a.json: error: has no frames; expected a list of objects with faceBlendshapes");
  EXPECT_EQ(fault("[{\"blendShapes\": {\"jawOpen\": 1, \"JawOpen\": 1}}]"),
            "a.json:1:44: error: 'jawOpen' is there twice in a frame; expected one face");
  EXPECT_EQ(fault(std::string(100, '[')),
            "a.json:1:2: error: a list within the list of frames; expected an object for each");
  EXPECT_EQ(fault(""), "a.json: error: is empty; expected a take of ARKit");
}

TEST(face_tracks, keys_are_straight_between_their_times) {
  const Take take = load_take(find_take_sample("openfacefx.json"), TakeKind::tracks);
  EXPECT_EQ(take.channels.size(), 2u);
  ASSERT_EQ(take.at_s.size(), 31u);
  EXPECT_NEAR(find_take_value(take, 6, "jawOpen"), 0.6, 1e-6);
  EXPECT_NEAR(find_take_value(take, 15, "jawOpen"), 0.4, 1e-6);
  EXPECT_NEAR(find_take_value(take, 0, "mouthPucker"), 0, 1e-6);
  EXPECT_NEAR(find_take_value(take, 21, "mouthPucker"), 0.8, 1e-6);
  EXPECT_EQ(guess_take_kind(find_take_sample("openfacefx.json")), TakeGuess::tracks);
}

TEST(face_tracks, what_is_wrong_is_told_at_its_place) {
  const auto fault = [](const std::string& text) {
    return find_take_fault("a.json", text, TakeKind::tracks);
  };
  EXPECT_EQ(fault("{\"channels\": [{\"name\": \"jawOpen\",\n \"keys\": [[0.2, 0], [0.1, 1]]}]}"),
            "a.json:2:21: error: a key at 0.1 s; expected rising times from 0 on");
  EXPECT_EQ(fault("{\"channels\": [{\"name\": \"jawOpen\", \"keys\": [[0, 0, 0]]}]}"),
            "a.json:1:44: error: a key of 3 numbers; expected a time and a value");
  EXPECT_EQ(fault("{\"channels\": [{\"keys\": [[0, 0]]}]}"),
            "a.json:1:15: error: a channel without a name; expected one");
  EXPECT_EQ(fault("{\"fps\": 0}"), "a.json:1:9: error: 'fps' is 0; expected 1 to 240");
}

}  // namespace
}  // namespace mien

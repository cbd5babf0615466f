// Takes as tracks of a clip, and as files of ours.
#include "config/config_fixture.hpp"
#include "config/load_takes.hpp"
#include "config/take_text.hpp"
#include "import/take_samples.hpp"

namespace mien {
namespace {

const MappingData& find_mapping_data() { return *find_language()->libraries.mappings; }

// A clip of one track of a sample, beside which the file lies.
Spec load_track_spec(const std::string& track, const std::string& sample, const std::string& more = "") {
  const auto file = make_test_folder() / "test.yaml";
  std::filesystem::copy_file(find_take_sample(sample), file.parent_path() / sample);
  write_file(file, "mien: 1\nclip:\n  tracks: [{" + track + "}]\n" + more);
  return load_spec(file, *find_language());
}

double find_table_value(const TimeTable& table, std::size_t row, std::size_t move) {
  for (std::size_t i = 0; i < table.moves.size(); ++i)
    if (table.moves[i] == move) return table.values[row * table.moves.size() + i];
  return 0;
}

TEST(takes, of_live_link_is_a_track) {
  const Spec spec = load_track_spec("live_link: live_link.csv, at: 1s", "live_link.csv");
  ASSERT_EQ(spec.clip.cues.size(), 1u);
  const CueSpec& cue = spec.clip.cues[0];
  EXPECT_NEAR(cue.full_s, 1, 1e-9);
  EXPECT_NEAR(cue.ebb_s, 1 + 23.0 / 60, 1e-6);
  const std::size_t smile = *find_move(Area::corner, Side::left, "up"),
                    shut = *find_move(Area::lid, Side::right, "upper");
  EXPECT_TRUE(cue.owns[smile]);
  EXPECT_GT(find_table_value(*cue.table, 23, smile), 0.3);
  EXPECT_EQ(find_table_value(*cue.table, 10, shut), -1);  // noise is taken out, and shut is shut
  EXPECT_GT(find_table_value(*cue.table, 10, *find_move(Area::eye, Side::right, "side")), 0.2);
  // The head's turn comes along.
  ASSERT_GE(spec.clip.turn.size(), 2u);
  EXPECT_NEAR(spec.clip.turn.back().turn_deg, 5.73, 0.5);
  EXPECT_NEAR(spec.clip.turn.back().at_s, 1 + 23.0 / 60, 1e-6);
}

TEST(takes, a_clips_own_turn_is_kept) {
  const Spec spec =
      load_track_spec("live_link: live_link.csv", "live_link.csv", "  turn: [{at: 0s, turn: 20deg}]\n");
  ASSERT_EQ(spec.clip.turn.size(), 1u);
  EXPECT_EQ(spec.clip.turn[0].turn_deg, 20);
}

TEST(takes, of_each_kind_is_a_track) {
  EXPECT_EQ(load_track_spec("arkit: mediapipe.json", "mediapipe.json").clip.cues.size(), 1u);
  EXPECT_EQ(load_track_spec("openface: openface.csv, smooth: 0", "openface.csv").clip.cues.size(), 1u);
  EXPECT_EQ(load_track_spec("openfacefx: openfacefx.json", "openfacefx.json").clip.cues.size(), 1u);
  const Spec spec = load_track_spec("gltf: head.glb", "head.glb");
  ASSERT_EQ(spec.clip.cues.size(), 1u);
  const TimeTable& table = *spec.clip.cues[0].table;
  EXPECT_NEAR(find_table_value(table, table.at_s.size() - 1, *find_move(Area::lid, Side::left, "upper")),
              -0.75, 1e-6);
  EXPECT_NEAR(spec.clip.turn.back().turn_deg, 20, 0.3);
}

TEST(takes, an_animation_of_nothing_known_is_told) {
  const MappingData& data = find_mapping_data();
  Take take = load_take(find_take_sample("head.glb"), TakeKind::gltf);
  EXPECT_EQ(build_take_moves(take, find_usual_reading(TakeKind::gltf), data).report.passed,
            std::vector<std::string>{"viseme_PP"});
  for (TakeChannel& channel : take.channels) channel.name = "x" + channel.name;
  take.file = "head.glb";
  try {
    build_take_moves(take, {}, data);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "head.glb: none of its 4 targets is a unit of a face, such as 'xmien.corner.left.up'; expected "
        "names of mien's moves, of ARKit's units or of VRM's expressions");
  }
}

TEST(takes, a_mistake_in_the_file_is_told_there) {
  const auto file = make_test_folder() / "test.yaml";
  write_file(file.parent_path() / "take.csv", "Timecode,JawOpenn\n00:00:00:00.0,1\n");
  write_file(file, "mien: 1\nclip:\n  tracks: [{live_link: take.csv}]\n");
  EXPECT_EQ(find_mistakes(file),
            "take.csv:1:10: error: unknown unit 'jawOpenn' of arkit; did you mean 'jawOpen'?");
}

TEST(takes, a_file_of_ours_says_the_same_within_the_tolerance) {
  const Take take = load_take(find_take_sample("live_link.csv"), TakeKind::live_link);
  const TakeMoves moves = build_take_moves(take, {}, find_mapping_data());
  for (const double tolerance_mm : {0.1, 0.5, 2.0}) {
    const TakeText built =
        build_take_text(moves, find_mapping_data(), {"said", "live_link.csv", "live_link", tolerance_mm});
    const Spec spec = load_text(built.text);
    EXPECT_NEAR(spec.clip.length_s, 23.0 / 60, 1e-3);
    ASSERT_EQ(spec.clip.cues.size(), 5u);  // lids, eyes, corners, chin, cheeks: no brow moves, and no lip
    EXPECT_LT(built.key_count, 80u);
    for (const CueSpec& cue : spec.clip.cues)
      for (const PoseKey& key : cue.script->keys) {
        std::size_t row = 0;
        while (row + 1 < moves.at_s.size() && moves.at_s[row] < key.at_s - 1e-3) ++row;
        for (std::size_t i = 0; i < kMoveCount; ++i)
          if (cue.owns[i]) {
            EXPECT_NEAR(key.pose.values[i], moves.values[row * kMoveCount + i], 0.0051) << built.text;
          }
      }
  }
}

TEST(takes, fewer_keys_are_further_off) {
  const Take take = load_take(find_take_sample("live_link.csv"), TakeKind::live_link);
  const TakeMoves moves = build_take_moves(take, {}, find_mapping_data());
  const auto count = [&](double tolerance_mm) {
    return build_take_text(moves, find_mapping_data(), {"a", "a.csv", "", tolerance_mm}).key_count;
  };
  EXPECT_GT(count(0.05), count(0.5));
  EXPECT_GT(count(0.5), count(5));
}

TEST(takes, moves_are_written_as_an_author_would) {
  Pose pose;
  const auto set = [&](Area area, Side side, std::string_view move, double value) {
    pose.values[*find_move(area, side, move)] = value;
  };
  set(Area::brow, Side::left, "up", 0.25);
  set(Area::brow, Side::right, "up", 0.25);
  set(Area::lid, Side::left, "upper", -1);
  set(Area::lips, Side::none, "press", 0.004);
  set(Area::chin, Side::none, "down", 0.333);
  EXPECT_EQ(build_moves_text(pose), "brows: {up: 0.25}, lid.left: {upper: -1}, chin: {down: 0.33}");
}

}  // namespace
}  // namespace mien

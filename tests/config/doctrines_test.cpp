// How muscles, units and parameters are written, and what a file's doctrine chooses.
#include <fmt/format.h>

#include "config/config_fixture.hpp"
#include "config/ledger.hpp"
#include "config/load_areas.hpp"
#include "config/parke.hpp"

namespace mien {
namespace {

Pose express(const std::string& words) {
  return find_expression(load_text("mien: 1\nexpressions: {probe: {" + words + "}}\n"), "probe").pose;
}

double value_of(const Pose& pose, std::string_view key, Side side, std::string_view name) {
  return pose.values.at(find_channel(key, side, name).value());
}

TEST(doctrines, are_written_for_both_sides_or_for_one) {
  const Pose pose = express(
      "muscles: {zygomatic_major.left: 0.6, zygomatic_major: 0.2, orbicularis_oris: 0.3, corrugator.right: "
      "0.4}");
  EXPECT_EQ(value_of(pose, kMusclesKey, Side::left, "zygomatic_major"), 0.6);
  EXPECT_EQ(value_of(pose, kMusclesKey, Side::right, "zygomatic_major"), 0.2);
  EXPECT_EQ(value_of(pose, kMusclesKey, Side::none, "orbicularis_oris"), 0.3);
  EXPECT_EQ(value_of(pose, kMusclesKey, Side::left, "lateral_corrugator"), 0);
  EXPECT_EQ(value_of(pose, kMusclesKey, Side::right, "lateral_corrugator"), 0.4);
  const Pose units = express("candide: {AU10: 0.5, jaw_drop: 0.25, lip_corner_depressor: -0.5}");
  EXPECT_EQ(value_of(units, kCandideKey, Side::none, "upper_lip_raiser"), 0.5);
  EXPECT_EQ(value_of(units, kCandideKey, Side::none, "jaw_drop"), 0.25);
  EXPECT_EQ(value_of(units, kCandideKey, Side::none, "lip_corner_depressor"), -0.5);
}

// A tracker of CANDIDE's: its animation units by frame move ours, by either name.
TEST(doctrines, of_candide_are_followed_as_columns_of_a_table) {
  const auto folder = make_test_folder();
  write_file(folder / "units.csv",
             "time,candide.upper_lip_raiser,candide.AU26,candide.AU15\n0,0,0,0\n1,0.5,0.4,-1\n");
  write_file(folder / "main.yaml", "mien: 1\nclip: {tracks: [{csv: units.csv}]}\n");
  const Spec spec = load_spec(folder / "main.yaml", *find_language());
  const TimeTable& table = *spec.clip.cues.at(0).table;
  EXPECT_EQ(table.moves,
            (std::vector<std::size_t>{*find_channel(kCandideKey, Side::none, "upper_lip_raiser"),
                                      *find_channel(kCandideKey, Side::none, "jaw_drop"),
                                      *find_channel(kCandideKey, Side::none, "lip_corner_depressor")}));
  EXPECT_EQ(table.values, (std::vector<double>{0, 0, 0, 0.5, 0.4, -1}));
}

TEST(doctrines, have_no_name_twice_and_a_twin_for_each_side) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < kChannelCount; ++i)
    EXPECT_TRUE(names.insert(name_move(i)).second) << name_move(i);
  EXPECT_TRUE(names.contains("muscles.zygomatic_major.left"));
  EXPECT_TRUE(names.contains("candide.jaw_drop"));
  for (std::size_t i = kMoveCount; i < kChannelCount; ++i) {
    EXPECT_EQ(find_twin(i) == i, kChannels[i].side == Side::none) << name_move(i);
    EXPECT_EQ(find_twin(find_twin(i)), i);
    EXPECT_FALSE(find_stop(i, 1).empty());
  }
}

TEST(doctrines, are_held_at_their_limits_which_nothing_lifts) {
  const Spec spec =
      load_text("mien: 1\nexpressions: {probe: {muscles: {zygomatic_major: 1.4}, exaggerate: 1.5}}\n");
  EXPECT_EQ(value_of(spec.expressions.front().pose, kMusclesKey, Side::left, "zygomatic_major"), 1);
  const std::vector<HeldNote> notes = build_notes(list_held(spec));
  ASSERT_EQ(notes.size(), 1);
  EXPECT_EQ(notes[0].text, "muscles.zygomatic_major asked for 2.1; held at 1: a muscle contracts no further");
}

TEST(doctrines, of_parke_are_sums_of_moves_within_their_limits) {
  const Pose pose = express("parke: {mouth_expression: 1, mouth_width: 0.5, jaw_rotation: 0.25}");
  const auto move = [&](Area area, Side side, const char* name) {
    return pose.values[find_move(area, side, name).value()];
  };
  EXPECT_DOUBLE_EQ(move(Area::corner, Side::left, "up"), 1);
  EXPECT_DOUBLE_EQ(move(Area::corner, Side::right, "out"), 0.8);
  EXPECT_DOUBLE_EQ(move(Area::chin, Side::none, "down"), 0.25);
  EXPECT_FALSE(has_doctrine(pose));
  // An area beside it has the last word.
  const Pose both = express("parke: {jaw_rotation: 0.25}, chin: {down: 0.1}");
  EXPECT_DOUBLE_EQ(both.values[find_move(Area::chin, Side::none, "down").value()], 0.1);
  for (const ParkeRow& row : kParkeRows)
    for (const auto& moves : {row.plus, row.minus})
      for (const ChannelMove& each : moves)
        if (!each.area.empty()) {
          const auto found = find_move(each.area, Side::none, each.move);
          EXPECT_TRUE(found || find_move(each.area, Side::left, each.move)) << row.name;
          EXPECT_TRUE(row.low < 0 || row.minus[0].area.empty()) << row.name;
        }
}

TEST(doctrines, choose_whose_expression_a_plain_name_is) {
  EXPECT_EQ(find_expression(load_text("mien: 1\n"), "smile").library, "mien");
  EXPECT_EQ(find_expression(load_text("mien: 1\ndoctrine: areas\n"), "smile").library, "mien");
  const Spec spec = load_text("mien: 1\ndoctrine: muscles\nclip: {keys: [{at: 0s, express: smile}]}\n");
  EXPECT_EQ(find_expression(spec, "smile").library, "muscles");
  EXPECT_EQ(find_expression(spec, "sleepy").library, "extras");
  EXPECT_TRUE(has_doctrine(spec.clip.keys.front().pose));
  const Spec own =
      load_text("mien: 1\nexpressions: {glad: {from: smile, doctrine: candide, strength: 0.5}}\n");
  EXPECT_DOUBLE_EQ(
      value_of(own.expressions.front().pose, kCandideKey, Side::none, "lip_stretcher"),
      0.5 * value_of(find_expression(own, "candide/smile").pose, kCandideKey, Side::none, "lip_stretcher"));
}

TEST(doctrines, may_be_formulas_in_a_clip) {
  const Spec spec =
      load_text("mien: 1\nclip: {keys: [{at: 0s, areas: {muscles: {risorius: \"0.5 + t\"}}}, {at: 1s}]}\n");
  ASSERT_TRUE(spec.clip.keys[0].live != nullptr);
  EXPECT_DOUBLE_EQ(
      value_of(evaluate_pose(*spec.clip.keys[0].live, 0.25).pose, kMusclesKey, Side::left, "risorius"), 0.75);
}

TEST(doctrines, tell_what_is_wrong_where_it_stands) {
  const auto mistakes = [](const std::string& text) {
    const auto file = make_test_folder() / "test.yaml";
    write_file(file, text);
    const std::string all = find_mistakes(file);
    return all.substr(0, all.find('\n'));  // without the line itself
  };
  EXPECT_EQ(mistakes("mien: 1\nexpressions: {a: {muscles: {zygomatik_major: 1}}}\n"),
            "test.yaml:2:29: error: unknown muscle 'zygomatik_major' in 'expressions.a.muscles'; did you "
            "mean 'zygomatic_major'?");
  EXPECT_EQ(mistakes("mien: 1\nexpressions: {a: {candide: {AU12: 1}}}\n"),
            "test.yaml:2:29: error: unknown unit 'AU12' in 'expressions.a.candide'; did you mean 'AU10'?");
  EXPECT_EQ(mistakes("mien: 1\nexpressions: {a: {doctrine: muscles}}\n"),
            "test.yaml:2:29: error: 'doctrine' chooses nothing here; expected 'from' beside it");
  EXPECT_EQ(mistakes("mien: 1\ndoctrine: muskles\n"),
            "test.yaml:2:11: error: unknown doctrine 'muskles'; did you mean 'muscles'?");
  EXPECT_EQ(
      mistakes("mien: 1\nlibrary: tezuka\ndoctrine: muscles\n"),
      "test.yaml:3:11: error: 'doctrine' and 'library' both say whose expressions a name means; expected one "
      "of them");
  EXPECT_EQ(
      mistakes("mien: 1\nhead: {areas: nine}\nexpressions: {a: {muscles: {risorius: 1}}}\n"),
      "test.yaml:3:29: error: 'muscles.risorius' is beyond the nine areas, which 'head' says with 'areas: "
      "nine'; expected one of them, or 'areas: all'");
  EXPECT_EQ(mistakes("mien: 1\nexpressions: {a: {parke: {jaw_rotation: 2}}}\n"),
            "test.yaml:2:41: error: 'expressions.a.parke.jaw_rotation' is '2'; expected a number from 0 to 1 "
            "times its limit");
}

}  // namespace
}  // namespace mien

// What the limits hold back, and what the ledger says of it.
#include "config/ledger.hpp"

#include <algorithm>
#include <random>

#include "config/config_fixture.hpp"
#include "config/pose_mix.hpp"

namespace mien {
namespace {

std::string report(const Spec& spec) {
  std::string text;
  for (HeldNote note : build_notes(list_held(spec))) {
    note.held.place.file = std::filesystem::path(note.held.place.file).filename();
    text += format_note(note) + "\n";
  }
  return text;
}

TEST(ledger, names_each_value_that_a_limit_held_and_its_line) {
  const Spec spec = load_text(R"(mien: 1
expressions:
  sly:
    from: smile
    exaggerate: 1.5
    brow.left: {up: 0.7}
  wide: {brows: {up: 1.3}, lids: {upper: -1.2}}
clip:
  keys:
    - {at: 0s, express: wide}
    - {at: 0.6s, express: {surprise: 1, fear: 0.8}}
    - {at: 2s, express: sly, areas: {eyes: {side: 1.5}, brow.left: {up: 1.8}}}
    - {at: 3s, express: sly, exaggerate: 1.5}
)");
  EXPECT_EQ(report(spec),
            "test.yaml:7:22: note: brows.up asked for 1.3; held at its limit, 1\n"
            "test.yaml:7:42: note: lids.upper asked for -1.2; held at -1: shut is shut\n"
            "test.yaml:11:28: note: brows.up asked for 1.6 (surprise 1 + fear 0.8); held at its limit, 1\n"
            "test.yaml:11:28: note: lids.upper asked for 1.7 (surprise 1 + fear 0.8); held at its limit, 1\n"
            "test.yaml:12:51: note: eyes.side asked for 1.5; held at 1: an eye turns no further\n"
            "test.yaml:12:73: note: brow.left.up asked for 1.8; held at its limit, 1.5\n"
            "test.yaml:13:25: note: corners.up asked for 2.137 (sly); held at its limit, 2\n");
  EXPECT_EQ(find_value(spec.clip.keys[0].pose, "brow", Side::left, "up"), 1);
  EXPECT_EQ(find_value(spec.clip.keys[1].pose, "brow", Side::left, "up"), 1);
  EXPECT_EQ(find_value(spec.clip.keys[2].pose, "brow", Side::left, "up"), 1.5);
  EXPECT_EQ(find_value(spec.clip.keys[2].pose, "eye", Side::left, "side"), 1);
  EXPECT_EQ(find_value(spec.clip.keys[3].pose, "corner", Side::left, "up"), 2);
}

TEST(ledger, is_empty_for_every_library_and_what_stays_within_its_limits) {
  for (const Expression& expression : load_expression_libraries(kData / "configs/expressions"))
    EXPECT_TRUE(expression.held.empty()) << expression.library << "/" << expression.name;
  const Spec spec = load_text("mien: 1\nclip: {keys: [{at: 0s, express: laugh, exaggerate: 2}]}\n");
  EXPECT_EQ(report(spec), "");
}

TEST(ledger, names_the_line_of_a_library_that_asks_for_too_much) {
  const auto data = make_test_folder("_data");
  std::filesystem::create_directories(data / "configs/expressions");
  std::filesystem::copy(kData / "templates", data / "templates", std::filesystem::copy_options::recursive);
  write_file(data / "configs/expressions/mien.yaml",
             "mien: 1\nlibrary: mien\nexpressions:\n  neutral: {}\n  gape: {chin: {down: 1.25}}\n");
  EXPECT_EQ(report(load_text("mien: 1\n", data)), "");
  EXPECT_EQ(report(load_text("mien: 1\nbusts: [{express: gape}]\n", data)),
            "mien.yaml:5:23: note: chin.down asked for 1.25; held at its limit, 1\n");
}

TEST(ledger, tells_a_side_alone_and_a_line_of_a_mix_by_what_asks_most) {
  const Spec spec = load_text(R"(mien: 1
expressions:
  a1: {chin: {down: 0.8}, brow.left: {up: 0.7}}
  a2: {chin: {down: 0.9}, brow.left: {up: 0.6}}
clip:
  keys:
    - at: 0s
      express:
        a1: 1
        a2: 1
)");
  EXPECT_EQ(report(spec),
            "test.yaml:9:9: note: brow.left.up asked for 1.3 (a1 1 + a2 1); held at its limit, 1\n"
            "test.yaml:10:9: note: chin.down asked for 1.7 (a1 1 + a2 1); held at its limit, 1\n");
}

TEST(exaggerate, is_a_gain_with_the_limits_lifted) {
  const Spec spec = load_text(R"(mien: 1
exaggerate: 1.5
clip:
  keys:
    - {at: 0s, express: surprise}
    - {at: 1s, express: surprise, exaggerate: 1}
    - {at: 2s, express: wink}
    - {at: 3s, areas: {lips: {press: 0.8}}}
busts: [{express: surprise}, {express: surprise, exaggerate: 2}]
)");
  EXPECT_DOUBLE_EQ(find_value(spec.clip.keys[0].pose, "brow", Side::left, "up"), 1.5);
  EXPECT_EQ(spec.clip.keys[1].pose, find_expression(spec, "surprise").pose);
  EXPECT_EQ(find_value(spec.clip.keys[2].pose, "lid", Side::left, "upper"), -1);
  EXPECT_EQ(find_value(spec.clip.keys[3].pose, "lips", Side::none, "press"), 1);
  EXPECT_DOUBLE_EQ(find_value(spec.busts[0].expression.pose, "brow", Side::left, "up"), 1.5);
  EXPECT_DOUBLE_EQ(find_value(spec.busts[1].expression.pose, "brow", Side::left, "up"), 2);
  EXPECT_EQ(take_expression(spec, "surprise").pose, spec.clip.keys[0].pose);
  EXPECT_EQ(report(spec), "");
}

TEST(exaggerate, an_expression_in_braces_goes_as_far_as_it_says) {
  const Spec spec = load_text("mien: 1\nexaggerate: 1.5\nexpressions: {sly: {brow.left: {up: 0.4}}}\n");
  const Expression posed = take_expression(spec, "{from: sly, strength: 0.5, lips: {press: 0.3}}");
  EXPECT_EQ(posed.name, "posed");
  EXPECT_DOUBLE_EQ(find_value(posed.pose, "brow", Side::left, "up"), 0.2);
  EXPECT_DOUBLE_EQ(find_value(posed.pose, "lips", Side::none, "press"), 0.3);
  EXPECT_EQ(take_expression(spec, "{}").pose, Pose{});
  EXPECT_DOUBLE_EQ(find_value(take_expression(spec, "sly").pose, "brow", Side::left, "up"), 0.6);
}

TEST(exaggerate, an_expression_in_braces_is_told_what_is_wrong_with_it) {
  const Spec spec = load_text("mien: 1\n");
  const auto find_mistake = [&](const std::string& words) {
    try {
      take_expression(spec, words);
    } catch (const InputError& error) {
      return error.diagnostics.front().message;
    }
    return std::string("none");
  };
  EXPECT_EQ(find_mistake("{brws: {up: 1}}"),
            "--express: unknown key 'brws' in 'expressions.posed'; did you mean 'brows'?");
  EXPECT_EQ(find_mistake("{from: smlie}"), "--express: unknown expression 'smlie'; did you mean 'smile'?");
  EXPECT_EQ(find_mistake("{}, two: {}"),
            "--express is '{}, two: {}'; expected a name or one expression in braces");
}

TEST(exaggerate, closes_lids_by_the_lowest_and_not_the_sum) {
  const Spec spec = load_text(R"(mien: 1
clip:
  keys:
    - {at: 0s, express: {extras/wink: 1, sadness: 1, contempt: 1}, exaggerate: 2}
    - {at: 1s, express: {sadness: 1, contempt: 1}, exaggerate: 1.5}
)");
  EXPECT_EQ(find_value(spec.clip.keys[0].pose, "lid", Side::left, "upper"), -1);
  const double lowest =
      std::min(find_value(find_expression(spec, "sadness").pose, "lid", Side::left, "upper"),
               find_value(find_expression(spec, "contempt").pose, "lid", Side::left, "upper"));
  EXPECT_DOUBLE_EQ(find_value(spec.clip.keys[1].pose, "lid", Side::left, "upper"), 1.5 * lowest);
}

TEST(pose_mix, holds_any_values_within_their_reach_and_tells_all_it_held) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(-3, 3), gain(1, 2), share(0, 1);
  for (int i = 0; i < 500; ++i) {
    PoseAsk ask{{}, gain(random), share(random), {}, gain(random)};
    for (double& v : ask.pose.values) v = value(random);
    for (std::size_t m = 0; m < kMoveCount; m += 3) ask.areas.values[m] = value(random);
    const HeldPose built = hold_pose(ask);
    EXPECT_LE(built.reach, kMaxExaggerate);
    for (std::size_t m = 0; m < kMoveCount; ++m) {
      EXPECT_GE(built.pose.values[m], kMoves[m].low * built.reach);
      EXPECT_LE(built.pose.values[m], kMoves[m].high * built.reach);
      const double asked = ask.exaggerate * ask.areas.values[m].value_or(ask.pose.values[m] * ask.strength);
      const bool is_reported = std::ranges::any_of(built.held, [&](const Held& h) {
        return h.move == m && h.asked == asked && h.held == built.pose.values[m];
      });
      if (find_stop(m, asked < 0 ? -1 : 1).empty()) {
        EXPECT_EQ(is_reported, built.pose.values[m] != asked);
      }
    }
  }
}

}  // namespace
}  // namespace mien

#include "timeline/parts.hpp"

#include "config/config_fixture.hpp"
#include "timeline/rehearsal.hpp"

namespace mien {
namespace {

std::vector<std::string> list_notes(const std::string& clip) {
  const Spec spec = load_text("mien: 1\nclip:\n" + clip);
  std::vector<std::string> notes;
  for (HeldNote note : build_notes(rehearse(build_performance(spec.clip)).held)) {
    note.held.place.file = "a.yaml";
    notes.push_back(format_note(note));
  }
  return notes;
}

TEST(parts, of_a_moment_are_the_keys_around_it_and_the_cues_upon_them) {
  const Spec spec = load_text(
      "mien: 1\nclip: {keys: [{at: 0s}, {at: 2s, express: smile, ease: linear}], cues: [{from: 1s, express: "
      "surprise, attack: 0.5s, hold: 1s}]}\n");
  const auto parts = list_parts(build_performance(spec.clip), 1.5);
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].label, "neutral");
  EXPECT_DOUBLE_EQ(parts[0].share, 0.25);
  EXPECT_EQ(parts[1].label, "smile");
  EXPECT_DOUBLE_EQ(parts[1].share, 0.75);
  EXPECT_TRUE(parts[2].is_cue);
  EXPECT_FALSE(parts[2].is_endless);
  EXPECT_EQ(parts[2].share, 1);
}

TEST(parts, tell_of_a_cue_that_has_no_end) {
  const Spec spec = load_text(
      "mien: 1\nclip: {keys: [{at: 0s}, {at: 2s, express: smile}], cues: [{from: 0.5s, express: surprise, "
      "to: 1s}, "
      "{from: 1s, express: smile}]}\n");
  const auto parts = list_parts(build_performance(spec.clip), 1.2);
  ASSERT_EQ(parts.size(), 4u);
  EXPECT_FALSE(parts[2].is_endless);
  EXPECT_TRUE(parts[3].is_endless);
}

TEST(parts, a_clip_that_stays_within_its_limits_has_no_notes) {
  EXPECT_EQ(list_notes("  keys: [{at: 0s}, {at: 1s, express: smile}]\n").size(), 0u);
}

TEST(parts, a_curve_that_passes_a_limit_is_told_with_its_key) {
  const auto notes = list_notes(
      "  between: spline\n"
      "  keys:\n"
      "    - {at: 0s}\n"
      "    - {at: 1s, areas: {brows: {up: 1}}}\n"
      "    - {at: 2s, areas: {brows: {up: 1}}}\n"
      "    - {at: 3s}\n");
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0], "a.yaml:7:7: note: brows.up asked for 1.15 (neutral at 1.5s); held at its limit, 1");
}

TEST(parts, sums_and_formulas_are_told_where_they_ask_for_most) {
  const auto notes = list_notes(
      "  keys: [{at: 0s, areas: {lips: {upper: 0.7}}}]\n"
      "  cues: [{from: 0s, areas: {lips: {upper: 0.5}}, attack: 0.5s, hold: 1s, rule: add}]\n"
      "  laws: [{area: chin, move: down, value: \"1.5*sin(pi*t)\", range: [0, 1]},\n"
      "         {area: corners, move: up, value: \"1.4*t\"}]\n");
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0],
            "a.yaml:4:10: note: lips.upper asked for 1.2 (neutral at 0.4583s); held at its limit, 1");
}

TEST(parts, a_look_past_the_eyes_reach_is_told_with_its_key) {
  const std::vector<std::string> expected{
      "a.yaml:5:7: note: eyes.side asked for 1.5 (look 45deg aside, 0deg up at 1s); held at 1: an eye turns "
      "no further",
      "a.yaml:6:7: note: eyes.up asked for -1.333 (look 0deg aside, -40deg up at 2s); held at -1: an eye "
      "turns "
      "no further"};
  const std::string gaze =
      "  gaze:\n"
      "    - {at: 0s, look: left}\n"
      "    - {at: 1s, look: {side: 45deg}}\n"
      "    - {at: 2s, look: {up: -40deg}}\n"
      "    - {at: 3s, look: ahead}\n";
  EXPECT_EQ(list_notes(gaze), expected);
  // A head that turns toward it lets the eyes reach it.
  EXPECT_EQ(list_notes(gaze + "  turn: [{at: 0.9s}, {at: 1s, turn: 20deg}, {at: 1.9s}, {at: 2s, nod: 12deg, "
                              "turn: 0deg}]\n")
                .size(),
            0u);
}

TEST(parts, a_look_adds_up_with_what_the_face_says_of_the_eyes) {
  const auto notes = list_notes(
      "  keys: [{at: 0s, areas: {eyes: {side: 0.5}}}]\n"
      "  length: 1s\n"
      "  gaze: [{at: 0s, look: left}]\n");
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(
      notes[0],
      "a.yaml:5:10: note: eyes.side asked for 1.167 (look 20deg aside, 0deg up at 0s); held at 1: an eye "
      "turns no further");
}

TEST(parts, small_looks_about_a_place_are_no_affair_of_the_ledger) {
  EXPECT_EQ(list_notes("  length: 20s\n"
                       "  gaze: {look: {side: 29deg}, wander: 1}\n")
                .size(),
            0u);
}

}  // namespace
}  // namespace mien

#include "timeline/rehearsal.hpp"

#include "config/config_fixture.hpp"
#include "timeline/drawings.hpp"

namespace mien {
namespace {

// Everything that a clip can have at once, on twos for a while.
Spec load_full_clip(const std::string& changes = "") {
  return load_text(
      "mien: 1\nclip:\n  length: 4s\n  draw: ones\n  blink: natural\n  drift: 0.5\n  asymmetry: 0.1\n"
      "  keys: [{at: 0s}, {at: 1s, express: smile}, {at: 2s, express: surprise}, {at: 4s}]\n"
      "  turn: [{at: 0s}, {at: 2s, turn: 20deg}]\n"
      "  gaze: {wander: 0.5, keys: [{at: 0s, look: camera}, {at: 1s, look: left}, {at: 3s, look: up}]}\n"
      "  cues: [{from: 0.5s, express: o, areas: [lips, chin], hold: 1s}]\n"
      "  laws: [{area: brows, move: up, value: \"0.3*sin(3*t)\", rule: add}]\n" +
      changes);
}

TEST(rehearsal, shows_what_the_performance_shows_at_the_times_of_the_drawings) {
  for (const int draw : {1, 3}) {
    ClipSpec clip = load_full_clip().clip;
    clip.draw = draw;
    const Performance performance = build_performance(clip);
    const Rehearsal rehearsal = rehearse(performance);
    ASSERT_EQ(rehearsal.shown.size(), 96u);
    for (int frame = 0; frame < 96; ++frame) {
      const auto i = static_cast<std::size_t>(frame);
      const double time_s = compute_drawing_time_s(performance.clip, frame);
      EXPECT_EQ(rehearsal.drawn_s[i], time_s);
      const Moment moment = sample_performance(performance, time_s);
      EXPECT_EQ(rehearsal.shown[i].pose, moment.pose);
      EXPECT_EQ(rehearsal.shown[i].turn_deg, moment.turn.turn_deg);
      EXPECT_EQ(rehearsal.shown[i].nod_deg, moment.turn.nod_deg);
      EXPECT_EQ(rehearsal.shown[i].tilt_deg, moment.turn.tilt_deg);
    }
    EXPECT_EQ(rehearsal.drawings, list_drawing_keys(performance));
  }
}

TEST(rehearsal, knows_what_was_asked_without_life_and_without_cues) {
  const ClipSpec clip = load_full_clip().clip;
  const Rehearsal rehearsal = rehearse(build_performance(clip));
  ClipSpec still = clip;
  still.blink = {};
  still.drift = {};
  still.asymmetry = {};
  still.gaze = {};
  ClipSpec keys = still;
  keys.cues.clear();
  const Performance asked = build_performance(still), alone = build_performance(keys);
  ASSERT_EQ(rehearsal.keys.size(), rehearsal.asked.size());
  for (std::size_t frame = 0; frame < rehearsal.asked.size(); ++frame) {
    const double time_s = rehearsal.drawn_s[frame];
    EXPECT_EQ(rehearsal.asked[frame], sample_performance(asked, time_s).pose);
    EXPECT_EQ(rehearsal.keys[frame], sample_performance(alone, time_s).pose);
  }
  EXPECT_TRUE(rehearse(alone).keys.empty()) << "they are what is asked for";
}

TEST(rehearsal, tells_drawings_apart_by_what_a_head_could_show) {
  // Beyond the reach of these eyes; another head's might be looser.
  const Spec spec = load_text(
      "mien: 1\nclip: {length: 1s, keys: [{at: 0s}], gaze: {keys: [{at: 0s, look: {side: 50deg}}, {at: 0.5s, "
      "look: {side: 60deg}}]}}\n");
  const Performance performance = build_performance(spec.clip);
  const Rehearsal rehearsal = rehearse(performance);
  EXPECT_EQ(rehearsal.shown.front().pose, rehearsal.shown.back().pose);
  EXPECT_NE(rehearsal.drawings.front(), rehearsal.drawings.back());
}

}  // namespace
}  // namespace mien

#include "timeline/advice.hpp"

#include <gtest/gtest.h>

namespace mien {
namespace {

PoseKey build_key(double at_s, std::string label, double value, int line) {
  PoseKey key;
  key.at_s = at_s;
  key.label = std::move(label);
  for (const Side side : {Side::left, Side::right})
    key.pose.values[*find_move(Area::brow, side, "up")] = value;
  key.pose.values[*find_move(Area::chin, Side::none, "down")] = value;
  key.place = {"a.yaml", line, 7};
  return key;
}

MoveReach build_reach() {
  MoveReach reach;
  reach.plus_mm.fill(10);
  reach.minus_mm.fill(10);
  reach.plus_mm[*find_move(Area::chin, Side::none, "down")] = 40;
  return reach;
}

std::vector<Diagnostic> advise(const ClipSpec& clip, const MoveReach& reach) {
  const Performance performance = build_performance(clip);
  return advise_clip(performance.clip, rehearse(performance), reach);
}

std::string advise(const ClipSpec& clip) {
  std::string text;
  for (const Diagnostic& advice : advise(clip, build_reach())) text += format_diagnostic(advice) + "\n";
  return text;
}

ClipSpec build_clip(std::vector<PoseKey> keys) {
  ClipSpec clip;
  clip.keys = std::move(keys);
  clip.length_s = clip.keys.back().at_s;
  return clip;
}

TEST(advice, has_nothing_to_say_of_a_plain_clip) {
  ClipSpec clip = build_clip({build_key(0, "rest", 0, 1), build_key(0.5, "gasp", 1, 2),
                              build_key(1.5, "gasp", 1, 3), build_key(2.5, "rest", 0, 4)});
  clip.blink = kNaturalBlink;
  clip.gaze.wander = 1;
  clip.drift.amount = 1;
  clip.asymmetry.amount = 0.3;
  EXPECT_EQ(advise(clip), "");
  clip.draw = 3;
  EXPECT_EQ(advise(clip), "");
}

TEST(advice, warns_of_holds_too_short_to_read) {
  ClipSpec clip = build_clip({build_key(0, "rest", 0, 1), build_key(1, "gasp", 1, 2),
                              build_key(1 + 4 / 24.0, "gasp", 1, 3), build_key(2, "rest", 0, 4)});
  EXPECT_EQ(advise(clip),
            "a.yaml:3:7: warning: 'gasp' is held for 4 frames; a hold is read from 6 on (until 1.25s)\n");
  clip.keys[2].at_s = 1 + 5 / 24.0;
  EXPECT_EQ(advise(clip),
            "a.yaml:3:7: warning: 'gasp' is held for 5 frames; a hold is read from 6 on (until 1.25s)\n");
  clip.keys[2].at_s = 1.25;
  EXPECT_EQ(advise(clip), "");
}

TEST(advice, warns_of_skin_that_jumps) {
  ClipSpec clip = build_clip(
      {build_key(0, "rest", 0, 1), build_key(1, "rest", 0, 2), build_key(1 + 2 / 24.0, "gasp", 1, 3)});
  clip.length_s = 2;
  EXPECT_EQ(
      advise(clip),
      "a.yaml:3:7: warning: on the way to 'gasp' the chin moves 20.0 mm a frame (at 1.042s); more than 12 mm "
      "is seen as a jump\n");
}

TEST(advice, warns_of_releases_of_what_does_not_move) {
  ClipSpec clip =
      build_clip({build_key(0, "gasp", 1, 1), build_key(1, "rest", 0, 2), build_key(2, "rest", 0, 3)});
  clip.keys[0].release[static_cast<std::size_t>(LeadPart::brows)] = 0.5;
  EXPECT_EQ(advise(clip), "");
  clip.keys[0].release[static_cast<std::size_t>(LeadPart::corners)] = 0.5;
  EXPECT_EQ(
      advise(clip),
      "a.yaml:1:7: warning: 'gasp' releases its corners, of which nothing moves on the way to 'rest'\n");
}

TEST(advice, lets_lids_and_eyes_be_quick) {
  ClipSpec clip = build_clip({build_key(0, "open", 0, 1), build_key(1, "open", 0, 2)});
  clip.keys[1].pose.values[*find_move(Area::lid, Side::left, "upper")] = -1;
  clip.keys[1].pose.values[*find_move(Area::eye, Side::left, "side")] = 1;
  clip.keys[1].ease = Easing::hold;
  MoveReach reach;
  reach.plus_mm.fill(100);
  reach.minus_mm.fill(100);
  clip.length_s = 2;
  EXPECT_TRUE(advise(clip, reach).empty());
}

TEST(advice, warns_of_faces_that_are_never_drawn_in_full) {
  ClipSpec clip = build_clip({build_key(0, "rest", 0, 1), build_key(1.01, "rest", 0, 2),
                              build_key(1.05, "gasp", 0.2, 3), build_key(1.09, "rest", 0, 4)});
  clip.draw = 4;
  clip.length_s = 2;
  EXPECT_EQ(
      advise(clip),
      "a.yaml:3:7: warning: 'gasp' is never fully drawn, 0 % of it at most; drawings near it are at 1s and "
      "1.167s\n");
}

TEST(advice, does_not_ask_for_a_face_that_a_cue_covers) {
  ClipSpec clip = build_clip({build_key(0, "rest", 0, 1), build_key(1, "gasp", 0.5, 2),
                              build_key(2, "gasp", 0.5, 3), build_key(3, "rest", 0, 4)});
  CueSpec cue;
  cue.from_s = 0.2;
  cue.full_s = 0.6;
  cue.ebb_s = 2.2;
  cue.end_s = 2.8;
  cue.owns.set();
  clip.cues = {cue};
  EXPECT_EQ(advise(clip), "");
}

TEST(advice, warns_of_keys_after_the_end) {
  ClipSpec clip =
      build_clip({build_key(0, "rest", 0, 1), build_key(1, "gasp", 1, 2), build_key(3, "rest", 0, 3)});
  clip.length_s = 2;
  EXPECT_EQ(advise(clip), "a.yaml:3:7: warning: 'rest' comes at 3s, after the clip's end at 2s\n");
  clip.length_s = 3;  // the key at the end is a loop's first
  EXPECT_EQ(advise(clip), "");
}

TEST(advice, warns_of_cues_that_are_never_fully_drawn) {
  ClipSpec clip = build_clip({build_key(0, "rest", 0, 1)});
  clip.length_s = 2;
  CueSpec cue;
  cue.what = build_key(0, "gasp", 1, 5);
  cue.from_s = 1;
  cue.full_s = 1.02;
  cue.ebb_s = 1.03;
  cue.end_s = 1.05;  // between two frames of 24 a second but for the edges
  clip.cues = {cue};
  EXPECT_EQ(advise(clip),
            "a.yaml:5:7: warning: the cue 'gasp' is never fully drawn, 38 % of it at most; it is all there "
            "from 1.02s to 1.03s\n");
  clip.fps = 100;
  EXPECT_EQ(advise(clip), "");
  clip.cues[0].from_s = 2;
  clip.cues[0].full_s = clip.cues[0].ebb_s = 2.5;
  clip.cues[0].end_s = 3;
  EXPECT_EQ(advise(clip),
            "a.yaml:5:7: warning: the cue 'gasp' comes at 2s, after the clip's last drawing at 1.99s\n");
  clip.cues[0].from_s = 1.8;
  clip.cues[0].end_s = kForever_s;
  clip.cues[0].ebb_s = kForever_s;
  EXPECT_EQ(advise(clip),
            "a.yaml:5:7: warning: the cue 'gasp' is never fully drawn, 18 % of it at most; it is all there "
            "from 2.5s on\n");
}

CueSpec build_open_cue(double from_s, const std::string& label, double value) {
  CueSpec cue;
  cue.what = build_key(from_s, label, value, 9);
  cue.from_s = cue.start_s = from_s;
  cue.full_s = from_s + 0.25;
  cue.owns[*find_move(Area::chin, Side::none, "down")] = true;
  return cue;
}

TEST(advice, warns_of_a_cue_without_an_end_that_holds_what_keys_ask_for) {
  ClipSpec clip = build_clip({build_key(0, "rest", 0, 1), build_key(2, "gasp", 1, 2),
                              build_key(4, "gasp", 1, 3), build_key(6, "rest", 0, 4)});
  clip.cues.push_back(build_open_cue(2.5, "ooh", 0.3));
  EXPECT_EQ(
      advise(clip),
      "a.yaml:9:7: warning: the cue 'ooh' has no end: from 2.75s to the clip's end at 6s it holds chin over "
      "'gasp' at 2s and 'gasp' at 4s; give it 'hold' or 'to', 'to: 6s' if it is meant to stay\n");
  clip.cues[0].ebb_s = 5;
  clip.cues[0].end_s = 5.5;
  EXPECT_EQ(advise(clip), "");
}

TEST(advice, has_nothing_to_say_of_an_endless_cue_that_hides_nothing) {
  ClipSpec clip =
      build_clip({build_key(0, "rest", 0, 1), build_key(2, "gasp", 1, 2), build_key(6, "gasp", 1, 3)});
  clip.cues.push_back(build_open_cue(2.5, "as the key", 1));
  EXPECT_EQ(advise(clip), "");
  clip.cues[0] = build_open_cue(0, "a mood from the beginning", 0.3);
  EXPECT_EQ(advise(clip), "");
  clip.cues[0] = build_open_cue(5.5, "the clip's last breath", 0.3);
  EXPECT_EQ(advise(clip), "");
  clip.cues[0] = build_open_cue(2.5, "on top", 0.3);
  clip.cues[0].rule = Rule::add;
  EXPECT_EQ(advise(clip), "");
}

TEST(advice, names_three_keys_that_a_cue_holds_and_counts_the_others) {
  ClipSpec clip =
      build_clip({build_key(0, "rest", 0, 1), build_key(1, "gasp", 1, 2), build_key(2, "gasp", 1, 3),
                  build_key(3, "gasp", 1, 4), build_key(4, "gasp", 1, 5), build_key(5, "gasp", 1, 6),
                  build_key(6, "gasp", 1, 7)});
  clip.cues.push_back(build_open_cue(0.5, "ooh", 0.3));
  EXPECT_EQ(
      advise(clip),
      "a.yaml:9:7: warning: the cue 'ooh' has no end: from 0.75s to the clip's end at 6s it holds chin over "
      "'rest' at 0s, 'gasp' at 1s, 'gasp' at 2s and 3 more; give it 'hold' or 'to', 'to: 6s' if it is meant "
      "to "
      "stay\n");
}

}  // namespace
}  // namespace mien

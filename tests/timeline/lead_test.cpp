// Who leads on the way from one face to another, and how areas come off a key one by one.
#include "timeline/lead.hpp"

#include "config/config_fixture.hpp"
#include "timeline/parts.hpp"

namespace mien {
namespace {

double value_of(const Pose& pose, std::string_view area, Side side, std::string_view move) {
  return pose.values[*find_move(area, side, move)];
}

double compute_share(double from, double to, double now) { return (now - from) / (to - from); }

// How far along each area is at a time of the way from the key at 0s to that at `end_s`.
struct Shares {
  double jaw, corners_out, corners_up, brows;
};

Shares find_shares(const Performance& performance, double end_s, double time_s) {
  const Pose from = sample_performance(performance, 0).pose, to = sample_performance(performance, end_s).pose,
             now = sample_performance(performance, time_s).pose;
  const auto share = [&](std::string_view area, Side side, std::string_view move) {
    return compute_share(value_of(from, area, side, move), value_of(to, area, side, move),
                         value_of(now, area, side, move));
  };
  return {share("chin", Side::none, "down"), share("corner", Side::left, "out"),
          share("corner", Side::left, "up"), share("brow", Side::left, "turn")};
}

Performance build_way(const std::string& from, const std::string& to, double end_s,
                      const std::string& lead = "natural") {
  return build_performance(load_text(fmt::format("mien: 1\nclip: {{lead: {}, keys: [{{at: 0s, express: {}}}, "
                                                 "{{at: {}s, express: {}}}]}}\n",
                                                 lead, from, end_s, to))
                               .clip);
}

// A wide open mouth is a grin: while corners are not in, the jaw stays up.
TEST(lead, narrows_the_corners_before_a_mouth_rounds) {
  for (const char* round : {"surprise", "mouths/o", "mouths/E"})
    for (const char* from : {"smile", "neutral"})
      for (const double end_s : {0.25, 0.5, 1.0}) {
        const Performance way = build_way(from, round, end_s);
        for (double time_s = 0; time_s < end_s; time_s += 1.0 / 48) {
          const Shares now = find_shares(way, end_s, time_s);
          EXPECT_GE(now.corners_out, now.jaw) << from << " to " << round << " at " << time_s;
          if (now.jaw > 0.35) {
            EXPECT_GT(now.corners_out, 0.65) << from << " to " << round;
          }
        }
      }
  // Without it half of the jaw's way finds the corners half way too.
  const Shares together = find_shares(build_way("smile", "surprise", 1, "none"), 1, 0.5);
  EXPECT_NEAR(together.jaw, together.corners_out, 1e-9);
}

TEST(lead, shuts_a_round_mouth_before_its_corners_widen) {
  const Performance way = build_way("surprise", "smile", 0.5);
  for (double time_s = 0; time_s < 0.5; time_s += 1.0 / 48)
    EXPECT_LE(find_shares(way, 0.5, time_s).corners_out, find_shares(way, 0.5, time_s).jaw);
}

// The way of an area that is half gone, s.
double find_half_s(const Performance& way, double end_s, double Shares::*part) {
  double time_s = 0;
  while (find_shares(way, end_s, time_s).*part < 0.5) time_s += 1.0 / 240;
  return time_s;
}

TEST(lead, shuts_the_jaw_of_a_laugh_before_corners_fall_and_brows_grieve) {
  const Performance way = build_way("laugh", "sadness", 1.2);
  const double jaw_s = find_half_s(way, 1.2, &Shares::jaw),
               corners_s = find_half_s(way, 1.2, &Shares::corners_up),
               brows_s = find_half_s(way, 1.2, &Shares::brows);
  EXPECT_GE((corners_s - jaw_s) * 24, 3) << "frames";
  EXPECT_LE((corners_s - jaw_s) * 24, 4.2);
  EXPECT_GE((brows_s - corners_s) * 24, 3);
}

TEST(lead, meets_every_key_and_leaves_plain_ways_as_they_were) {
  for (const char* to : {"surprise", "sadness", "anger"}) {
    const Performance way = build_way("laugh", to, 0.7);
    EXPECT_EQ(sample_performance(way, 0).pose,
              sample_performance(build_way("laugh", to, 0.7, "none"), 0).pose);
    EXPECT_EQ(sample_performance(way, 0.7).pose,
              sample_performance(build_way("laugh", to, 0.7, "none"), 0.7).pose);
  }
  const LeadSpec given{kNaturalLead.after_s};
  const auto at = [](const LeadSpec& lead, const std::string& to) {
    ClipSpec clip =
        load_text("mien: 1\nclip: {keys: [{at: 0s, express: smile, strength: 0.5}, {at: 1s, express: " + to +
                  "}]}\n")
            .clip;
    clip.lead = lead;
    return sample_performance(build_performance(clip), 0.4).pose;
  };
  EXPECT_EQ(at(kNaturalLead, "anger"), at(given, "anger")) << "a shut mouth's way is plain";
  EXPECT_NE(at(kNaturalLead, "surprise"), at(given, "surprise"));
}

// The thesis' in-betweens to the letter.
TEST(lead, is_nobodys_on_straight_ways_and_curves) {
  for (const char* between : {"linear", "smooth", "spline"}) {
    const auto at = [&](const std::string& lead) {
      return sample_performance(
                 build_performance(
                     load_text(fmt::format("mien: 1\nclip: {{lead: {}, between: {}, keys: [{{at: 0s, "
                                           "express: laugh}}, {{at: 1s, express: sadness}}]}}\n",
                                           lead, between))
                         .clip),
                 0.3)
          .pose;
    };
    EXPECT_EQ(at("natural"), at("none")) << between;
  }
}

TEST(lead, narrows_a_cue_too) {
  const Performance clip = build_performance(
      load_text(
          "mien: 1\nclip: {keys: [{at: 0s}], cues: [{from: 0s, express: surprise, attack: 0.5s, hold: 0.5s, "
          "release: 0.5s}]}\n")
          .clip);
  const Pose full = sample_performance(clip, 0.7).pose;
  for (const double time_s : {0.15, 0.25, 0.35, 1.15, 1.25, 1.35}) {
    const Pose now = sample_performance(clip, time_s).pose;
    EXPECT_GT(value_of(now, "corner", Side::left, "out") / value_of(full, "corner", Side::left, "out"),
              value_of(now, "chin", Side::none, "down") / value_of(full, "chin", Side::none, "down"))
        << time_s;
  }
}

constexpr const char* kReleased =
    "mien: 1\nclip:\n  keys:\n"
    "    - {at: 0s, express: laugh, release: {brows: 12f, corners: 6f}}\n"
    "    - {at: 1s, express: sadness}\n    - {at: 2s, express: sadness}\n";

TEST(release, takes_each_area_as_long_as_it_says) {
  const Performance clip = build_performance(load_text(kReleased).clip);
  const Shares at_0 = find_shares(clip, 1, 0), at_3 = find_shares(clip, 1, 0.125),
               at_6 = find_shares(clip, 1, 0.25), at_12 = find_shares(clip, 1, 0.5);
  EXPECT_EQ(at_0.corners_up, 0);
  EXPECT_NEAR(at_3.corners_up, 0.5, 1e-12);
  EXPECT_EQ(at_6.corners_up, 1);
  EXPECT_NEAR(at_6.brows, 0.5, 1e-12);
  EXPECT_EQ(at_12.brows, 1);
  EXPECT_LT(at_12.jaw, 1) << "what is not named goes as it is led";
  EXPECT_EQ(sample_performance(clip, 1).pose, sample_performance(clip, 2).pose);
}

TEST(release, of_the_whole_face_is_a_time_alone) {
  const ClipSpec clip =
      load_text("mien: 1\nclip: {keys: [{at: 0s, express: laugh, release: 0.5s}, {at: 2s}]}\n").clip;
  for (const double part_s : clip.keys[0].release) EXPECT_EQ(part_s, 0.5);
  EXPECT_EQ(clip.keys[1].release, kNoRelease);
  EXPECT_EQ(sample_performance(build_performance(clip), 0.5).pose, Pose{});
}

TEST(release, lets_go_of_lifted_limits_in_time) {
  const Performance clip = build_performance(
      load_text(
          "mien: 1\nclip: {keys: [{at: 0s}, {at: 1s, release: 0.2s}, {at: 2s, express: surprise, exaggerate: "
          "1.5}, {at: 3s, express: surprise, exaggerate: 1.5}]}\n")
          .clip);
  EXPECT_EQ(sample_performance(clip, 1.2).pose, sample_performance(clip, 3).pose);
}

TEST(release, is_told_by_explain) {
  const auto parts = list_parts(build_performance(load_text(kReleased).clip), 0.25);
  ASSERT_EQ(parts.size(), 2u);
  ASSERT_EQ(parts[0].released.size(), 2u);
  EXPECT_EQ(parts[0].released[0].first, "brows");
  EXPECT_NEAR(parts[0].released[0].second, 0.5, 1e-12);
  EXPECT_EQ(parts[0].released[1].first, "corners");
  EXPECT_EQ(parts[0].released[1].second, 1);
  EXPECT_EQ(parts[1].order, "the jaw shuts before the corners fall, the brows come last");
}

}  // namespace
}  // namespace mien

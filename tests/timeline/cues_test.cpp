#include "timeline/cues.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "timeline/layers.hpp"
#include "timeline/performance.hpp"

namespace mien {
namespace {

const std::size_t kCorner = *find_move(Area::corner, Side::left, "up");
const std::size_t kBrow = *find_move(Area::brow, Side::left, "up");
const std::size_t kLid = *find_move(Area::lid, Side::left, "upper");

CueSpec build_cue(std::array<double, 4> times_s, std::size_t move, double value, Rule rule = Rule::over) {
  CueSpec cue;
  cue.from_s = times_s[0], cue.full_s = times_s[1], cue.ebb_s = times_s[2], cue.end_s = times_s[3];
  cue.owns.set(move);
  cue.what.pose.values[move] = value;
  cue.rule = rule;
  return cue;
}

// The value of a move of a clip of these cues over one key.
struct Stage {
  Performance performance;

  explicit Stage(std::vector<CueSpec> cues, std::size_t move = kCorner, double base = 0, LeadSpec lead = {}) {
    ClipSpec clip;
    clip.keys.emplace_back();
    clip.keys[0].pose.values[move] = base;
    clip.cues = std::move(cues);
    clip.lead = lead;
    clip.length_s = 10;
    performance = build_performance(clip);
  }
  double at(double time_s, std::size_t move = kCorner) const {
    return sample_performance(performance, time_s).pose.values[move];
  }
};

TEST(cues, come_stay_and_go) {
  const Stage stage({build_cue({1, 1.4, 2.4, 3.2}, kCorner, 0.8)});
  EXPECT_EQ(stage.at(1), 0);
  EXPECT_NEAR(stage.at(1.1), 0.8 * 0.15625, 1e-9);  // a quarter of the time is 5/32 of the way
  EXPECT_DOUBLE_EQ(stage.at(1.2), 0.4);
  EXPECT_NEAR(stage.at(1.3), 0.8 * 0.84375, 1e-9);
  EXPECT_EQ(stage.at(1.4), 0.8);
  EXPECT_EQ(stage.at(2.4), 0.8);
  EXPECT_NEAR(stage.at(2.6), 0.8 * 0.84375, 1e-9);
  EXPECT_DOUBLE_EQ(stage.at(2.8), 0.4);
  EXPECT_NEAR(stage.at(3), 0.8 * 0.15625, 1e-9);
  EXPECT_EQ(stage.at(3.2), 0);
}

TEST(cues, reach_further_as_they_come_and_go) {
  for (const Rule rule : {Rule::over, Rule::add, Rule::max, Rule::share}) {
    ClipSpec clip;
    clip.cues = {build_cue({1, 1.4, 2.4, 3.2}, kCorner, 0.8, rule)};
    clip.cues[0].what.reach = 2;
    LayerStore store;
    const CueStack stack = build_cue_stack(clip, store);
    const auto find_reach = [&](double time_s, std::size_t move) {
      FaceState face;
      face.reach.fill(1);
      apply_cues(stack, compute_ticks(time_s), face);
      return face.reach[move];
    };
    EXPECT_EQ(find_reach(1, kCorner), 1);
    EXPECT_NEAR(find_reach(1.1, kCorner), 1.15625, 1e-9);
    EXPECT_DOUBLE_EQ(find_reach(1.2, kCorner), 1.5);
    EXPECT_EQ(find_reach(2, kCorner), 2);
    EXPECT_NEAR(find_reach(3, kCorner), 1.15625, 1e-9);
    EXPECT_EQ(find_reach(2, kBrow), 1) << "it does not own the brow";
  }
}

TEST(cues, leave_alone_what_they_do_not_own) {
  ClipSpec clip;
  clip.keys.emplace_back();
  clip.keys[0].pose.values[kBrow] = -0.6;
  clip.cues = {build_cue({0, 1, 2, 3}, kCorner, 0.8)};
  const Performance performance = build_performance(clip);
  for (double t = 0; t < 4; t += 0.1) EXPECT_EQ(sample_performance(performance, t).pose.values[kBrow], -0.6);
}

TEST(cues, in_a_row_never_pass_through_rest) {
  // The second begins as the first goes, while it goes, and before it goes; the first may outlast the second.
  for (const double begin_s : {2.0, 2.3, 1.5, 1.2})
    for (const double end_s : {2.8, 6.0}) {
      const Stage stage({build_cue({1, 1.2, end_s - 0.8, end_s}, kCorner, 0.8),
                         build_cue({begin_s, begin_s + 0.7, 4, 5}, kCorner, 0.8)});
      const double least = std::min(0.8, stage.at(begin_s)) - 1e-12;
      for (double t = begin_s; t <= 4; t += 0.01) EXPECT_GE(stage.at(t), least) << begin_s << " " << t;
    }
}

TEST(cues, three_that_come_over_each_other_do_not_jump) {
  const Stage stage({build_cue({0, 0.3, 0.5, 0.9}, kCorner, 0.9),
                     build_cue({0.6, 1.4, 1.5, 3}, kCorner, -0.5),
                     build_cue({1, 2, 2.2, 2.5}, kCorner, 0.3)});
  for (double t = 0; t < 3.2; t += 0.001) EXPECT_LT(std::abs(stage.at(t + 0.001) - stage.at(t)), 0.02) << t;
}

TEST(cues, share_an_area_by_their_rules) {
  const auto value = [](Rule rule, double base, double asked) {
    return Stage({build_cue({0, 0, 9, 9}, kCorner, asked, rule)}, kCorner, base).at(1);
  };
  EXPECT_EQ(value(Rule::over, 0.5, 0.3), 0.3);
  EXPECT_DOUBLE_EQ(value(Rule::add, 0.5, 0.3), 0.8);
  EXPECT_EQ(value(Rule::add, 0.9, 0.3), 1);  // held at the limit
  EXPECT_EQ(value(Rule::max, 0.5, 0.3), 0.5);
  EXPECT_EQ(value(Rule::max, 0.2, 0.3), 0.3);
  EXPECT_EQ(value(Rule::max, -0.2, -0.3), -0.3);
  EXPECT_EQ(value(Rule::share, 0.5, 0.3), 0.3);
  const Stage both({build_cue({0, 0, 9, 9}, kCorner, 0.2, Rule::share),
                    build_cue({0, 0, 9, 9}, kCorner, 0.8, Rule::share)});
  EXPECT_DOUBLE_EQ(both.at(1), 0.5);
  // Two lids that close do not close twice.
  EXPECT_EQ(Stage({build_cue({0, 0, 9, 9}, kLid, -0.5, Rule::add)}, kLid, -0.4).at(1, kLid), -0.5);
}

TEST(cues, lead_of_the_eyes) {
  const std::size_t eye = *find_move(Area::eye, Side::left, "side");
  CueSpec cue = build_cue({0, 1, 2, 3}, kCorner, 0.8);
  cue.owns.set(eye);
  cue.what.pose.values[eye] = 0.8;
  const Stage stage({cue}, kCorner, 0, kNaturalLead);
  EXPECT_GT(stage.at(0.1, eye), 0);
  EXPECT_EQ(stage.at(0.1), 0);
  EXPECT_EQ(stage.at(1, eye), 0.8);
  EXPECT_EQ(stage.at(1), 0.8);
}

TEST(cues, play_scripts_again_and_again) {
  auto script = std::make_shared<ClipSpec>();
  script->keys.resize(3);
  script->keys[1].at_s = 0.25;
  script->keys[1].pose.values[kCorner] = 1;
  script->keys[2].at_s = 0.5;
  script->turn.resize(2);
  script->turn[1].at_s = 0.5;
  script->turn[1].nod_deg = 10;
  script->length_s = 0.5;
  CueSpec cue = build_cue({1, 1, 2.5, 2.5}, kCorner, 0);
  cue.start_s = 1;
  cue.script = script;
  cue.is_repeated = true;
  const Stage stage({cue});
  for (const double start_s : {1.0, 1.5, 2.0}) {
    EXPECT_EQ(stage.at(start_s), 0);
    EXPECT_EQ(stage.at(start_s + 0.25), 1);
  }
  EXPECT_EQ(stage.at(2.75), 0);
  EXPECT_DOUBLE_EQ(sample_performance(stage.performance, 1.25).turn.nod_deg, 5);
  EXPECT_EQ(sample_performance(stage.performance, 3).turn.nod_deg, 0);
}

}  // namespace
}  // namespace mien

// Random performances: every number is one, held within its limits, and goes from frame to frame without a
// jump.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <thread>

#include "timeline/performance.hpp"
#include "timeline/rehearsal.hpp"

namespace mien {
namespace {

struct Dice {
  std::mt19937_64 random;

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  }
  std::size_t pick(std::size_t count) { return random() % count; }
  bool flip() { return random() % 2 == 0; }
};

FormulaPointer build_random_formula(Dice& dice) {
  const std::vector<std::string> texts{"0.7*sin(2*pi*t/1.5)",   "2*sin(3*t) + mood", "t > 2 ? 0.5 : t/4",
                                       "clamp(t, 0, 1) - mood", "abs(cos(t))",       "exp(-t)*mood"};
  FormulaFault fault;
  const FormulaPointer mood = build_formula("0.5 + 0.4*sin(t)", {}, 0, fault);
  return build_formula(texts[dice.pick(texts.size())], {{"mood", 0, mood}}, dice.uniform(0, 1), fault);
}

Pose build_random_pose(Dice& dice) {
  Pose pose;
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (dice.flip()) pose.values[i] = dice.uniform(kMoves[i].low, kMoves[i].high);
  return pose;
}

void build_random_key(Dice& dice, PoseKey& key) {
  key.pose = build_random_pose(dice);
  if (dice.pick(4) != 0) return;
  auto live = std::make_shared<LivePose>();
  live->shares.push_back({{1, {}}, key.pose});
  live->strength.formula = build_random_formula(dice);
  const std::size_t move = dice.pick(kMoveCount);
  live->values.push_back({move, build_random_formula(dice), -2, 2, {}});
  key.live = live;
  key.pose = evaluate_pose(*live, key.at_s).pose;
}

constexpr double kLength_s = 6;

CueSpec build_random_cue(Dice& dice) {
  CueSpec cue;
  cue.from_s = dice.uniform(0, kLength_s);
  cue.full_s = cue.from_s + dice.uniform(0.2, 0.8);
  cue.ebb_s = cue.full_s + dice.uniform(-0.2, 1.5);
  cue.end_s = cue.ebb_s + dice.uniform(0.2, 1.5);
  cue.layer = static_cast<Layer>(dice.pick(3));
  cue.rule = dice.flip() ? Rule::over : static_cast<Rule>(dice.pick(4));
  cue.has_lead = dice.flip();
  for (std::size_t i = 0; i < kMoveCount; ++i) cue.owns[i] = dice.flip();
  build_random_key(dice, cue.what);
  return cue;
}

ClipSpec build_random_clip(std::uint64_t seed) {
  Dice dice{std::mt19937_64(seed)};
  ClipSpec clip;
  clip.length_s = kLength_s;
  if (dice.flip()) clip.lead = kNaturalLead;
  double at_s = dice.uniform(0, 1);
  for (std::size_t i = 0, count = 1 + dice.pick(6); i < count; ++i, at_s += dice.uniform(0.3, 1.5)) {
    PoseKey key;
    key.at_s = at_s;
    key.between = static_cast<Between>(dice.pick(4));
    constexpr Easing kSmooth[]{Easing::linear, Easing::in,   Easing::out,
                               Easing::in_out, Easing::back, Easing::bounce};
    key.ease = kSmooth[dice.pick(std::size(kSmooth))];
    build_random_key(dice, key);
    clip.keys.push_back(key);
    TurnKey turn;
    turn.at_s = at_s;
    turn.between = key.between;
    turn.nod_deg = dice.uniform(-40, 40);
    if (dice.pick(4) == 0) turn.live[1] = build_random_formula(dice);
    clip.turn.push_back(turn);
  }
  for (std::size_t i = 0, count = dice.pick(8); i < count; ++i) clip.cues.push_back(build_random_cue(dice));
  return clip;
}

TEST(timeline_fuzz, has_only_numbers_within_their_limits_and_no_jumps) {
  constexpr double kStep_s = 0.002;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Performance performance = build_performance(build_random_clip(seed));
    Moment before = sample_performance(performance, 0);
    for (double time_s = 0; time_s < kLength_s + 1; time_s += kStep_s) {
      const Moment now = sample_performance(performance, time_s);
      for (std::size_t i = 0; i < kMoveCount; ++i) {
        ASSERT_TRUE(std::isfinite(now.pose.values[i])) << seed << " " << time_s;
        ASSERT_GE(now.pose.values[i], kMoves[i].low);
        ASSERT_LE(now.pose.values[i], kMoves[i].high);
        // Two limits' way in a fifth of a second, at twice an ease's middle speed, is a third of that.
        ASSERT_LT(std::abs(now.pose.values[i] - before.pose.values[i]), 0.1)
            << "seed " << seed << " at " << time_s << " " << kMoves[i].area << "." << kMoves[i].move;
      }
      ASSERT_TRUE(std::isfinite(now.turn.nod_deg));
      ASSERT_LE(std::abs(now.turn.nod_deg), 40);
      before = now;
    }
  }
}

TEST(timeline_fuzz, the_frame_at_a_key_is_that_key_alone) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    ClipSpec clip = build_random_clip(seed);
    clip.cues.clear();
    const Performance performance = build_performance(clip);
    for (const PoseKey& key : clip.keys) {
      ClipSpec alone;
      alone.keys = {key};
      EXPECT_EQ(sample_performance(performance, key.at_s).pose,
                sample_performance(build_performance(alone), key.at_s).pose);
    }
  }
}

TEST(timeline_fuzz, any_number_of_threads_see_the_same) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Performance performance = build_performance(build_random_clip(seed));
    std::vector<Pose> alone;
    for (int i = 0; i < 500; ++i) alone.push_back(sample_performance(performance, i * 0.01).pose);
    std::vector<int> wrong(4, 0);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < wrong.size(); ++t)
      threads.emplace_back([&, t] {
        for (int i = 499; i >= 0; --i)
          wrong[t] += sample_performance(performance, i * 0.01).pose != alone[static_cast<std::size_t>(i)];
      });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, std::vector<int>(4, 0));
  }
}

TEST(timeline_fuzz, tells_every_value_that_its_limit_held) {
  for (std::uint64_t seed = 0; seed < 30; ++seed)
    for (const Held& held : rehearse(build_performance(build_random_clip(seed))).held) {
      const MoveInfo& info = kMoves[held.move];
      EXPECT_TRUE(held.asked < info.low || held.asked > info.high);
      EXPECT_TRUE(held.held == info.low || held.held == info.high);
    }
}

}  // namespace
}  // namespace mien

#include "timeline/performance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace mien {
namespace {

PoseKey build_key(double at_s, double value, Easing ease = Easing::linear) {
  PoseKey key{at_s, ease, {}, {}};
  key.pose.values.fill(value);
  return key;
}

// A clip of a few keys at times on and off the frames, with values all over the range.
ClipSpec build_random_clip(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  ClipSpec clip;
  clip.draw = 1 + static_cast<int>(random() % 3);
  const int count = 1 + static_cast<int>(random() % 6);
  for (int i = 0; i < count; ++i) {
    const auto ease = static_cast<Easing>(random() % 5);
    PoseKey key{uniform(0, 5), ease, {}, {}};
    for (std::size_t move = 0; move < kMoveCount; ++move)
      key.pose.values[move] = uniform(kMoves[move].low, kMoves[move].high);
    clip.keys.push_back(key);
    clip.turn.push_back({uniform(0, 5), ease, uniform(-60, 60), uniform(-30, 30), uniform(-30, 30)});
    clip.camera.push_back({uniform(0, 5),
                           ease,
                           uniform(-180, 180),
                           uniform(-60, 60),
                           uniform(0.3, 3),
                           {},
                           {},
                           kPortraitLens_mm,
                           {}});
  }
  clip.length_s = 5;
  return clip;
}

TEST(performance, holds_each_move_at_its_limit_times_its_reach_or_where_it_is_stopped) {
  std::size_t stopped = 0, lifted = 0;
  for (std::size_t move = 0; move < kMoveCount; ++move)
    for (const int sign : {-1, 1}) {
      const double end = sign < 0 ? kMoves[move].low : kMoves[move].high;
      const bool is_stopped = !find_stop(move, sign).empty();
      if (end == 0) continue;
      EXPECT_EQ(hold_value(move, 5.0 * sign, 1.5), is_stopped ? end : 1.5 * end) << move;
      EXPECT_EQ(hold_value(move, end, 1), end);
      EXPECT_EQ(hold_value(move, end / 2, 1), end / 2);
      ++(is_stopped ? stopped : lifted);
    }
  EXPECT_GT(stopped, 0u);
  EXPECT_GT(lifted, stopped);
}

TEST(performance, shows_a_key_exactly_at_its_time) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Performance performance = build_performance(build_random_clip(seed));
    for (const PoseKey& key : performance.clip.keys)
      EXPECT_EQ(sample_performance(performance, key.at_s).pose, key.pose);
    for (const TurnKey& key : performance.clip.turn)
      EXPECT_EQ(sample_performance(performance, key.at_s).turn.nod_deg, key.nod_deg);
    for (const CameraKey& key : performance.clip.camera)
      EXPECT_EQ(sample_performance(performance, key.at_s).camera.distance, key.distance);
  }
}

TEST(performance, stays_between_the_neighbouring_keys) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Performance performance = build_performance(build_random_clip(seed));
    const std::vector<PoseKey>& keys = performance.clip.keys;
    for (double time_s = -0.5; time_s < 6; time_s += 0.0137) {
      const auto after =
          std::find_if(keys.begin(), keys.end(), [&](const PoseKey& k) { return k.at_s > time_s; });
      const PoseKey& from = after == keys.begin() ? keys.front() : *(after - 1);
      const PoseKey& to = after == keys.end() ? keys.back() : *after;
      const Pose pose = sample_performance(performance, time_s).pose;
      for (std::size_t i = 0; i < kMoveCount; ++i) {
        const auto [low, high] = std::minmax(from.pose.values[i], to.pose.values[i]);
        ASSERT_TRUE(std::isfinite(pose.values[i]));
        ASSERT_GE(pose.values[i], low);
        ASSERT_LE(pose.values[i], high);
      }
    }
  }
}

TEST(performance, rests_on_the_first_key_before_it_and_on_the_last_after_it) {
  ClipSpec clip;
  clip.keys = {build_key(1, 0.25), build_key(2, 0.75)};
  const Performance performance = build_performance(clip);
  EXPECT_EQ(sample_performance(performance, 0).pose, build_key(0, 0.25).pose);
  EXPECT_EQ(sample_performance(performance, 99).pose, build_key(0, 0.75).pose);
  EXPECT_EQ(sample_performance(performance, 1.5).pose, build_key(0, 0.5).pose);
}

TEST(performance, goes_to_a_key_with_that_keys_easing) {
  ClipSpec clip;
  clip.keys = {build_key(0, 0, Easing::hold), build_key(1, 1, Easing::in), build_key(2, 0, Easing::hold)};
  const Performance performance = build_performance(clip);
  EXPECT_DOUBLE_EQ(sample_performance(performance, 0.5).pose.values[0], 0.25);
  EXPECT_EQ(sample_performance(performance, 1.999).pose.values[0], 1);
  EXPECT_EQ(sample_performance(performance, 2).pose.values[0], 0);
}

TEST(performance, takes_keys_in_any_order_and_the_last_of_two_at_one_time) {
  ClipSpec clip;
  clip.keys = {build_key(2, 1), build_key(0, 0), build_key(1, 0.3), build_key(1, 0.6)};
  const Performance performance = build_performance(clip);
  EXPECT_EQ(sample_performance(performance, 1).pose.values[0], 0.6);
  EXPECT_NEAR(sample_performance(performance, 0.999).pose.values[0], 0.3, 0.001);
  EXPECT_EQ(sample_performance(performance, 2).pose.values[0], 1);
}

TEST(performance, of_an_empty_clip_is_a_neutral_face_seen_from_the_front) {
  const Moment moment = sample_performance(build_performance(ClipSpec{}), 1);
  EXPECT_EQ(moment.pose, Pose{});
  EXPECT_EQ(moment.turn.turn_deg, 0);
  EXPECT_EQ(moment.camera.angle_deg, 0);
  EXPECT_EQ(moment.camera.distance, 1);
}

TEST(performance, holds_a_drawing_on_twos_and_threes) {
  ClipSpec clip;
  clip.draw = 2;
  for (const auto& [frame, shown] : {std::pair{0, 0}, {1, 0}, {2, 2}, {3, 2}, {47, 46}})
    EXPECT_EQ(compute_drawing_time_s(clip, frame), shown / 24.0);
  clip.draw = 3;
  for (const auto& [frame, shown] : {std::pair{0, 0}, {2, 0}, {3, 3}, {5, 3}, {47, 45}})
    EXPECT_EQ(compute_drawing_time_s(clip, frame), shown / 24.0);
  clip.draw = 1;
  for (int frame = 0; frame < 48; ++frame) EXPECT_EQ(compute_drawing_time_s(clip, frame), frame / 24.0);
}

TEST(performance, changes_how_long_drawings_are_held) {
  ClipSpec clip;
  clip.draw = 2;
  clip.draw_changes = {{5 / 24.0, 3}, {1, 1}};
  for (const auto& [frame, shown] :
       {std::pair{0, 0}, {1, 0}, {4, 4}, {5, 5}, {7, 5}, {8, 8}, {23, 23}, {24, 24}, {25, 25}})
    EXPECT_EQ(compute_drawn_frame(clip, frame), shown) << frame;
}

TEST(performance, is_the_same_at_the_same_times_whatever_the_frame_rate) {
  ClipSpec clip = build_random_clip(5);
  clip.draw = 1;
  clip.length_s = 3600;
  const Performance performance = build_performance(clip);
  const auto sample = [&](int fps, int frame) {
    ClipSpec other = clip;
    other.fps = fps;
    return sample_performance(performance, compute_drawing_time_s(other, frame)).pose;
  };
  // Seconds and halves of them, from the first to one an hour later.
  for (const int half : {0, 1, 3, 7, 9, 7199, 7200})
    for (const int fps : {12, 24, 30, 60})
      EXPECT_EQ(sample(fps, half * fps / 2), sample(24, half * 12)) << half;
  for (const int second : {0, 1, 3599, 3600})
    for (const int fps : {11, 25, 50, 120}) EXPECT_EQ(sample(fps, second * fps), sample(24, second * 24));
  for (int frame = 0; frame < 60; ++frame) EXPECT_EQ(sample(12, frame), sample(60, 5 * frame));
}

TEST(performance, counts_time_in_whole_ticks) {
  for (const int fps : {12, 24, 25, 30, 48, 50, 60, 120})
    for (const int frame : {1, 7, 1001, 360001})
      EXPECT_EQ(compute_seconds(compute_frame_ticks(frame, fps)), static_cast<double>(frame) / fps);
  EXPECT_EQ(compute_ticks(0.1) + compute_ticks(0.2), compute_ticks(0.3));
  EXPECT_EQ(compute_ticks(kForever_s), kEndless);
  EXPECT_EQ(compute_frame_ticks(22, 11), 2 * kTicksPerSecond);
}

TEST(performance, blinks_on_top_of_its_pose) {
  ClipSpec clip;
  clip.length_s = 2;
  clip.blinks_s = {1};
  clip.keys = {build_key(0, 0.5)};
  const Performance performance = build_performance(clip);
  const std::size_t left = *find_move(Area::lid, Side::left, "upper");
  const std::size_t lower = *find_move(Area::lid, Side::left, "lower");
  EXPECT_EQ(sample_performance(performance, 0.9).pose.values[left], 0.5);
  EXPECT_EQ(sample_performance(performance, 1).pose.values[left], -1);
  EXPECT_EQ(sample_performance(performance, 1).pose.values[lower], 0.5);
}

}  // namespace
}  // namespace mien

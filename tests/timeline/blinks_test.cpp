#include "timeline/blinks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "timeline/performance.hpp"

namespace mien {
namespace {

constexpr std::size_t kLeft = *find_move(Area::lid, Side::left, "upper");
constexpr std::size_t kRight = *find_move(Area::lid, Side::right, "upper");

ClipSpec build_clip(double length_s, int draw, double per_minute, std::uint64_t seed) {
  ClipSpec clip;
  clip.length_s = length_s;
  clip.draw = draw;
  clip.blink.per_minute = per_minute;
  clip.blink.seed = seed;
  return clip;
}

std::vector<double> list_times(const ClipSpec& clip) {
  std::vector<double> times_s;
  for (const Blink& blink : place_blinks(clip)) times_s.push_back(blink.at_s);
  return times_s;
}

TEST(blinks, are_none_unless_asked_for) { EXPECT_TRUE(place_blinks(build_clip(60, 1, 0, 1)).empty()); }

TEST(blinks, keep_their_rate_over_a_long_clip) {
  for (const double per_minute : {6.0, 15.0, 40.0}) {
    const auto blinks_s = list_times(build_clip(3600, 1, per_minute, 7));
    EXPECT_NEAR(static_cast<double>(blinks_s.size()) / 60, per_minute, 0.08 * per_minute);
  }
}

TEST(blinks, are_shut_on_the_drawing_nearest_to_their_time) {
  ClipSpec clip = build_clip(1, 2, 0, 1);  // drawings at the frames 0, 2, 4
  for (const auto& [asked, shut] : {std::pair{0.9, 0.0}, std::pair{1.6, 2.0}, std::pair{2.9, 2.0}}) {
    clip.blinks_s = {asked / 24};
    EXPECT_EQ(list_times(clip), std::vector<double>{shut / 24}) << asked;
  }
}

TEST(blinks, of_their_own_leave_an_open_eye_between_them_on_the_coarsest_drawings) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    ClipSpec clip = build_clip(60, 3, 150, seed);
    clip.fps = 12;
    const auto blinks_s = list_times(clip);
    ASSERT_GT(blinks_s.size(), 50u);
    for (std::size_t i = 1; i < blinks_s.size(); ++i)
      EXPECT_GE(blinks_s[i] - blinks_s[i - 1], kBlinkGap_s - 1e-9) << seed << " at " << blinks_s[i];
  }
}

TEST(blinks, are_as_uneven_as_a_persons) {
  const auto blinks_s = list_times(build_clip(3600, 1, 15, 3));
  std::vector<double> intervals_s;
  for (std::size_t i = 1; i < blinks_s.size(); ++i) intervals_s.push_back(blinks_s[i] - blinks_s[i - 1]);
  const auto count = static_cast<double>(intervals_s.size());
  const double mean = std::accumulate(intervals_s.begin(), intervals_s.end(), 0.0) / count;
  double squares = 0, shorter = 0;
  for (const double interval_s : intervals_s) {
    squares += (interval_s - mean) * (interval_s - mean);
    shorter += interval_s < mean;
  }
  const double variation = std::sqrt(squares / count) / mean;
  EXPECT_GT(variation, 0.3);         // no metronome
  EXPECT_LT(variation, 0.8);         // no fits of blinking
  EXPECT_GT(shorter / count, 0.52);  // many short intervals, a few long ones
}

TEST(blinks, are_the_same_for_the_same_seed_and_others_for_another) {
  const auto blinks_s = list_times(build_clip(120, 2, 15, 7));
  EXPECT_EQ(blinks_s, list_times(build_clip(120, 2, 15, 7)));
  EXPECT_NE(blinks_s, list_times(build_clip(120, 2, 15, 8)));
}

TEST(blinks, are_shut_in_a_drawing_on_ones_twos_and_threes) {
  for (const int draw : {1, 2, 3})
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      ClipSpec clip = build_clip(10, draw, 20, seed);
      clip.blinks_s = {0.333, 9.99};
      const Performance performance = build_performance(clip);
      std::size_t shut = 0;
      for (int frame = 0; frame < count_frames(clip); frame += draw) {
        const Pose pose = sample_performance(performance, compute_drawing_time_s(clip, frame)).pose;
        EXPECT_EQ(pose.values[kLeft], pose.values[kRight]);
        shut += pose.values[kLeft] == -1;
      }
      EXPECT_EQ(shut, performance.idle.blinks.size()) << "draw " << draw << ", seed " << seed;
      EXPECT_GE(shut, 2u);
    }
}

TEST(blinks, keep_apart_and_give_way_to_those_asked_for) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    ClipSpec clip = build_clip(20, 1, 120, seed);
    clip.blinks_s = {12, 5};
    const auto blinks_s = list_times(clip);
    EXPECT_EQ(std::count(blinks_s.begin(), blinks_s.end(), 5.0), 1);
    EXPECT_EQ(std::count(blinks_s.begin(), blinks_s.end(), 12.0), 1);
    for (std::size_t i = 1; i < blinks_s.size(); ++i)
      EXPECT_GE(blinks_s[i] - blinks_s[i - 1], kBlinkGap_s - 1e-9) << "seed " << seed;
  }
}

TEST(blinks, close_faster_than_they_open) {
  const std::vector<Blink> blinks{{1.0, 1}};
  EXPECT_EQ(compute_blink_closure(blinks, 1.0), 1);
  EXPECT_EQ(compute_blink_closure(blinks, 1.0 - kBlinkClosing_s), 0);
  EXPECT_NEAR(compute_blink_closure(blinks, 1.0 + kBlinkOpening_s), 0, 1e-12);
  EXPECT_EQ(compute_blink_closure(blinks, 0.5), 0);
  EXPECT_EQ(compute_blink_closure(blinks, 1.5), 0);
  for (const double away_s : {0.02, 0.04, 0.06, 0.079})
    EXPECT_LT(compute_blink_closure(blinks, 1.0 - away_s), compute_blink_closure(blinks, 1.0 + away_s));
}

TEST(blinks, take_two_frames_down_and_some_more_up) {
  const std::vector<Blink> blinks{{1.0, 1}};
  int down = 0, up = 0;
  for (int frame = 0; frame < 48; ++frame)
    if (const double closure = compute_blink_closure(blinks, frame / 24.0); closure > 0)
      (frame <= 24 ? down : up) += 1;
  EXPECT_EQ(down, 2);
  EXPECT_EQ(up, 4);
}

TEST(blinks, never_open_a_lid) {
  for (const double rest : {-1.0, -0.7, 0.0, 0.6, 1.0}) {
    double before = rest;
    for (int i = 0; i <= 100; ++i) {
      Pose pose;
      pose.values[kLeft] = pose.values[kRight] = rest;
      close_lids(pose, i / 100.0);
      EXPECT_LE(pose.values[kLeft], before);
      EXPECT_GE(pose.values[kLeft], -1);
      before = pose.values[kLeft];
    }
    EXPECT_EQ(before, -1);
  }
  Pose pressed;  // beyond shut, as an exaggerated pose may be
  pressed.values[kLeft] = -1.2;
  close_lids(pressed, 0.5);
  EXPECT_EQ(pressed.values[kLeft], -1.2);
}

TEST(blinks, move_nothing_but_the_upper_lids) {
  Pose pose;
  close_lids(pose, 1);
  for (std::size_t i = 0; i < kMoveCount; ++i) EXPECT_EQ(pose.values[i], i == kLeft || i == kRight ? -1 : 0);
}

}  // namespace
}  // namespace mien

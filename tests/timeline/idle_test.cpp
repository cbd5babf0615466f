// Drift, asymmetry, natural blinks, and all of it together.
#include "timeline/idle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "config/config_fixture.hpp"
#include "core/seeded.hpp"
#include "timeline/drawings.hpp"
#include "timeline/performance.hpp"

namespace mien {
namespace {

PoseKey build_key(double at_s, double value) {
  PoseKey key;
  key.at_s = at_s;
  for (std::size_t i = 0; i < kMoveCount; ++i)
    key.pose.values[i] = std::clamp(value, kMoves[i].low, kMoves[i].high);
  return key;
}

double value_of(const Pose& pose, std::string_view area, Side side, std::string_view move) {
  return pose.values[*find_move(area, side, move)];
}

TEST(seeded, numbers_are_the_standards_own) {
  std::mt19937_64 random(5489);
  random.discard(9999);
  EXPECT_EQ(random(), 9981545732273789042u) << "the C++ standard, [rand.predef]";
  std::mt19937_64 other = build_random(7, 1);
  const double first = sample_uniform(other);
  EXPECT_GE(first, 0);
  EXPECT_LT(first, 1);
  std::mt19937_64 next = build_random(7, 2);
  EXPECT_NE(first, sample_uniform(next)) << "each use has numbers of its own";
}

TEST(drift, is_slow_smooth_and_small) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Drift drift = build_drift({1, seed});
    for (const Sway::Wave& wave : drift.turn.waves) {
      EXPECT_GE(wave.hz, kSlowest_hz);
      EXPECT_LE(wave.hz, kFastest_hz);
    }
    double last = 0, least = 0, most = 0;
    for (int frame = 0; frame < 24 * 60; ++frame) {
      TurnKey turn;
      Pose pose;
      add_drift(drift, frame / 24.0, pose, turn);
      if (frame > 0) {
        EXPECT_LT(std::abs(turn.turn_deg - last), 0.3) << "degrees a frame";
      }
      last = turn.turn_deg;
      least = std::min(least, last);
      most = std::max(most, last);
      EXPECT_LE(std::abs(turn.nod_deg), 2);
      EXPECT_EQ(value_of(pose, "brow", Side::left, "up"), value_of(pose, "brow", Side::right, "up"));
      EXPECT_EQ(value_of(pose, "lips", Side::none, "upper"), 0);
    }
    EXPECT_GT(most - least, 1) << "it is seen";
    EXPECT_LE(std::max(most, -least), 2.5);
  }
}

TEST(drift, is_the_same_for_the_same_seed_and_none_at_0) {
  const auto turn_at = [](const DriftSpec& spec) {
    TurnKey turn;
    Pose pose;
    add_drift(build_drift(spec), 1.7, pose, turn);
    return turn.turn_deg;
  };
  EXPECT_EQ(turn_at({0.5, 3}), turn_at({0.5, 3}));
  EXPECT_NE(turn_at({0.5, 3}), turn_at({0.5, 4}));
  EXPECT_DOUBLE_EQ(turn_at({1, 3}), 2 * turn_at({0.5, 3}));
  EXPECT_EQ(turn_at({0, 3}), 0);
}

TEST(drift, drives_nothing_past_its_limit) {
  Pose pose;
  pose.values.fill(1);
  pose.values[*find_move(Area::brow, Side::left, "up")] = 1.4;  // exaggerated
  for (int i = 0; i < 200; ++i) {
    TurnKey turn{0, Easing::linear, kMaxTurn_deg, -kMaxNod_deg, kMaxTilt_deg};
    Pose drifted = pose;
    add_drift(build_drift({1, 9}), i * 0.3, drifted, turn);
    for (std::size_t k = 0; k < kMoveCount; ++k) EXPECT_LE(drifted.values[k], pose.values[k]);
    EXPECT_LE(turn.turn_deg, kMaxTurn_deg);
    EXPECT_GE(turn.nod_deg, -kMaxNod_deg);
  }
}

TEST(breath, fills_sooner_than_it_empties_and_then_rests) {
  EXPECT_EQ(sample_breath(0), 0);
  EXPECT_EQ(sample_breath(0.4), 1);
  EXPECT_EQ(sample_breath(0.95), 0);
  double fullest = 0, in = 0, out = 0;
  for (int i = 0; i < 1000; ++i) {
    const double now = sample_breath(i / 1000.0), next = sample_breath((i + 1) / 1000.0);
    (next > now ? in : out) += next != now;
    fullest = std::max(fullest, now);
    EXPECT_LT(std::abs(next - now), 0.01) << "it never jumps";
  }
  EXPECT_EQ(fullest, 1);
  EXPECT_LT(in, 0.9 * out);
}

TEST(breath, lifts_the_shoulders_so_often_by_a_millimetre_or_two) {
  ClipSpec clip;
  clip.length_s = 60;
  clip.drift.breaths_per_minute = 14;
  const Performance performance = build_performance(clip);
  int breaths = 0;
  double before = sample_performance(performance, 0).turn.breath_mm, most = 0;
  bool is_up = true;
  for (int frame = 1; frame < 24 * 60; ++frame) {
    const TurnKey turn = sample_performance(performance, frame / 24.0).turn;
    if (turn.breath_mm > before && !is_up) ++breaths;
    if (turn.breath_mm != before) is_up = turn.breath_mm > before;
    EXPECT_LT(std::abs(turn.breath_mm - before), 0.15) << "mm a frame";
    EXPECT_LE(turn.nod_deg, 0) << "the chin comes up with it";
    before = turn.breath_mm;
    most = std::max(most, before);
  }
  EXPECT_NEAR(breaths, 14, 1);
  EXPECT_GT(most, 1.5);
  EXPECT_LE(most, kBreath_mm);
}

TEST(breath, is_none_unless_it_is_asked_for_and_holds_on_twos) {
  ClipSpec clip;
  clip.length_s = 2;
  clip.drift = {1, 3};
  EXPECT_EQ(sample_performance(build_performance(clip), 1.3).turn.breath_mm, 0);
  clip.drift.breaths_per_minute = 20;
  clip.draw = 2;
  const std::vector<int> drawings = compute_drawings(build_performance(clip));
  for (std::size_t frame = 0; frame < drawings.size(); ++frame)
    EXPECT_EQ(drawings[frame], static_cast<int>(frame - frame % 2));
}

TEST(drift, rests_on_the_drawings_of_a_hold) {
  ClipSpec clip;
  clip.length_s = 2;
  clip.draw = 2;
  clip.drift = {1, 1};
  const Performance performance = build_performance(clip);
  for (int frame = 0; frame < 48; frame += 2)
    EXPECT_EQ(sample_performance(performance, compute_drawing_time_s(clip, frame)).turn.turn_deg,
              sample_performance(performance, compute_drawing_time_s(clip, frame + 1)).turn.turn_deg);
}

TEST(asymmetry, is_off_by_default) {
  ClipSpec clip;
  clip.keys = {build_key(0, 0), build_key(1, 0.8)};
  clip.length_s = 1;
  const Pose pose = sample_performance(build_performance(clip), 0.4).pose;
  EXPECT_EQ(value_of(pose, "brow", Side::left, "up"), value_of(pose, "brow", Side::right, "up"));
}

TEST(asymmetry, keeps_the_times_of_keys_and_lets_one_side_lead) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    ClipSpec clip;
    clip.keys = {build_key(0, 0), build_key(1, 0.8), build_key(2, 0.8), build_key(3, 0)};
    clip.length_s = 3;
    clip.asymmetry = {0.06, seed};
    const Performance performance = build_performance(clip);
    for (const AreaLean& lean : performance.idle.asymmetry.areas) {
      const double share = lean.area == "lid" ? 0.5 : 1;
      if (share == 1) {
        EXPECT_GE(lean.delay_s, 0.02);
        EXPECT_LE(lean.delay_s, 0.06);
      } else {
        EXPECT_EQ(lean.delay_s, 0) << "lids open together";
      }
      EXPECT_GE(lean.weakness, 0.045 * share);
      EXPECT_LE(lean.weakness, 0.06 * share);
    }
    // At a key and all through the hold after it: the key's values, the weak side's less by its share.
    for (const double time_s : {1.0, 1.5, 2.0}) {
      const Pose pose = sample_performance(performance, time_s).pose;
      const double left = value_of(pose, "brow", Side::left, "up"),
                   right = value_of(pose, "brow", Side::right, "up");
      EXPECT_EQ(std::max(left, right), 0.8);
      EXPECT_LE(std::min(left, right), 0.8 * 0.955 + 1e-12);
      EXPECT_GE(std::min(left, right), 0.8 * 0.94 - 1e-12);
      EXPECT_EQ(value_of(pose, "lips", Side::none, "upper"), 0.8);
      EXPECT_EQ(value_of(pose, "eye", Side::left, "side"), value_of(pose, "eye", Side::right, "side"));
    }
    EXPECT_EQ(sample_performance(performance, 3).pose, Pose{});
    // Half way up the early side is ahead by the delay's worth of the way.
    const AreaLean& brow = performance.idle.asymmetry.areas.front();
    const double early_s = compute_side_time_s({0, 1}, 0.5, brow.delay_s, false);
    const double late_s = compute_side_time_s({0, 1}, 0.5, brow.delay_s, true);
    EXPECT_NEAR(early_s - late_s, brow.delay_s / (1 - brow.delay_s), 1e-12);
  }
}

// Under 0.15 nobody sees it, over 0.2 it is a smirk; and the weak side is the same all through the clip.
TEST(asymmetry, is_seen_by_itself_and_stays_on_its_side) {
  for (int seed = 1; seed <= 30; ++seed)
    for (const char* feeling : {"smile", "sadness", "fear"}) {
      const ClipSpec clip =
          load_text(
              fmt::format(
                  "mien: 1\nclip: {{asymmetry: {{seed: {}}}, keys: [{{at: 0s, express: {}}}, {{at: 2s}}, "
                  "{{at: 4s, express: {}, strength: 0.6}}]}}\n",
                  seed, feeling, feeling))
              .clip;
      const Performance performance = build_performance(clip);
      const auto lean = [&](double time_s, std::string_view area) {
        const Pose pose = sample_performance(performance, time_s).pose;
        return value_of(pose, area, Side::left, "up") / value_of(pose, area, Side::right, "up");
      };
      for (const char* area : {"corner", "brow"}) {
        const double first = lean(0, area), again = lean(4, area);
        const double weak = std::min(first, 1 / first);
        EXPECT_LE(weak, 0.85) << feeling << " " << seed;
        EXPECT_GE(weak, 0.8) << feeling << " " << seed;
        EXPECT_NEAR(again, first, 1e-12) << "the same side, by as much";
      }
    }
}

TEST(asymmetry, makes_the_side_weaker_that_it_says_and_the_right_one_more_often) {
  constexpr int kSeeds = 2000;
  int on_the_right = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const Asymmetry asymmetry = build_asymmetry({0.2, static_cast<std::uint64_t>(seed)}, {0});
    Pose even;
    for (const Side side : {Side::left, Side::right}) even.values[*find_move(Area::corner, side, "up")] = 0.8;
    const Pose leaning = sample_leaning(asymmetry, 0, [&](double, const auto&) { return even; });
    const auto corner = std::ranges::find(asymmetry.areas, "corner", &AreaLean::area);
    ASSERT_NE(corner, asymmetry.areas.end());
    const Side strong = corner->weak == Side::left ? Side::right : Side::left;
    EXPECT_DOUBLE_EQ(value_of(leaning, "corner", corner->weak, "up"), 0.8 * (1 - corner->weakness));
    EXPECT_EQ(value_of(leaning, "corner", strong, "up"), 0.8);
    if (corner->weak == Side::right) ++on_the_right;
  }
  EXPECT_NEAR(static_cast<double>(on_the_right) / kSeeds, 0.59, 0.04);
}

// On a way that is gone at an even pace from 0 to 1.
TEST(asymmetry, lets_the_late_side_wait_and_the_early_one_arrive) {
  const Asymmetry asymmetry = build_asymmetry({0.2, 3}, {0, 1});
  const auto sample = [](double time_s, const auto&) {
    Pose pose;
    for (const Side side : {Side::left, Side::right})
      pose.values[*find_move(Area::brow, side, "up")] = time_s;
    return pose;
  };
  const auto brow = std::ranges::find(asymmetry.areas, "brow", &AreaLean::area);
  ASSERT_NE(brow, asymmetry.areas.end());
  ASSERT_GT(brow->delay_s, 0);
  const auto gone = [&](double time_s, Side side) {
    const double weakness = side == brow->weak ? brow->weakness : 0;
    return value_of(sample_leaning(asymmetry, time_s, sample), "brow", side, "up") / (1 - weakness);
  };
  const Side early = brow->late == Side::left ? Side::right : Side::left;
  EXPECT_EQ(gone(brow->delay_s / 2, brow->late), 0);
  EXPECT_GT(gone(brow->delay_s / 2, early), brow->delay_s / 2);
  EXPECT_LT(gone(0.5, brow->late), 0.5);
  EXPECT_GT(gone(0.5, early), 0.5);
  EXPECT_DOUBLE_EQ(gone(1 - brow->delay_s / 2, early), 1);
}

TEST(asymmetry, leaves_a_shut_lid_shut) {
  ClipSpec clip;
  clip.keys = {build_key(0, -1)};
  clip.asymmetry = {0.3, 2};
  const Pose pose = sample_performance(build_performance(clip), 0).pose;
  for (const Side side : {Side::left, Side::right}) EXPECT_EQ(value_of(pose, "lid", side, "upper"), -1);
}

ClipSpec build_natural(double length_s, std::uint64_t seed) {
  ClipSpec clip;
  clip.length_s = length_s;
  clip.blink = kNaturalBlink;
  clip.blink.seed = seed;
  return clip;
}

// face-facts 3.5: 15 to 20 a minute, about half of them partial.
TEST(natural_blinks, keep_the_tables_rate_and_shares) {
  const auto blinks = place_blinks(build_natural(3600, 3));
  EXPECT_NEAR(static_cast<double>(blinks.size()) / 60, 15, 1.5);
  double partial = 0, doubles = 0;
  for (std::size_t i = 0; i < blinks.size(); ++i) {
    partial += blinks[i].depth < 1;
    EXPECT_GE(blinks[i].depth, 0.5);
    EXPECT_LE(blinks[i].depth, 1);
    if (i > 0) {
      const double way_s = blinks[i].at_s - blinks[i - 1].at_s;
      EXPECT_GE(way_s, kDoubleGap_s - 1e-9);
      doubles += way_s < kBlinkGap_s - 1e-9;
    }
  }
  const auto count = static_cast<double>(blinks.size());
  EXPECT_NEAR(partial / count, 0.5, 0.06);
  EXPECT_NEAR(doubles / (count - doubles), 0.1, 0.04);
}

TEST(natural_blinks, go_with_great_shifts_and_not_with_small_ones) {
  int with_great = 0, with_small = 0, with_turn = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    ClipSpec clip = build_natural(6, seed);
    clip.blink.per_minute = 0;
    clip.gaze.keys = {
        {0, LookAt::direction, -20, 0}, {2, LookAt::direction, 20, 0}, {4, LookAt::direction, 12, 0}};
    clip.turn = {{0, {}, 0, 0, 0}, {4.8, {}, 0, 0, 0}, {5.2, {}, 35, 0, 0}};
    for (const Blink& blink : place_blinks(clip)) {
      with_great += std::abs(blink.at_s - 1.95) < 0.06;
      with_small += std::abs(blink.at_s - 3.98) < 0.06;
      with_turn += std::abs(blink.at_s - 5) < 0.06;
      EXPECT_EQ(blink.depth, 1);
    }
  }
  EXPECT_EQ(with_great, 60);
  EXPECT_EQ(with_small, 0);
  EXPECT_EQ(with_turn, 60);
}

TEST(natural_blinks, shut_as_far_as_their_depth_in_a_drawing) {
  for (const int draw : {1, 2, 3}) {
    ClipSpec clip = build_natural(60, 5);
    clip.draw = draw;
    const Performance performance = build_performance(clip);
    for (const Blink& blink : performance.idle.blinks) {
      const int frame = static_cast<int>(std::lround(blink.at_s * clip.fps));
      EXPECT_EQ(frame % draw, 0);
      EXPECT_EQ(value_of(sample_performance(performance, compute_drawing_time_s(clip, frame)).pose, "lid",
                         Side::left, "upper"),
                -blink.depth);
    }
  }
}

// Two frames down at 24 a second, three to five up, measured on the drawn poses.
TEST(natural_blinks, last_as_long_as_the_tables_say) {
  ClipSpec clip = build_natural(120, 11);
  clip.blink.doubles = clip.blink.partial = 0;
  const Performance performance = build_performance(clip);
  std::vector<double> lids;
  for (int frame = 0; frame < count_frames(clip); ++frame)
    lids.push_back(value_of(sample_performance(performance, frame / 24.0).pose, "lid", Side::left, "upper"));
  for (std::size_t i = 8; i + 8 < lids.size(); ++i) {
    if (lids[i] != -1) continue;
    int down = 1, up = 0;
    while (lids[i - static_cast<std::size_t>(down)] < 0) ++down;
    while (lids[i + static_cast<std::size_t>(up) + 1] < 0) ++up;
    EXPECT_EQ(down, 2);
    EXPECT_GE(up, 3);
    EXPECT_LE(up, 5);
  }
}

TEST(idle, all_together_is_finite_within_limits_and_the_same_for_the_same_seeds) {
  std::mt19937_64 random(17);
  for (int i = 0; i < 60; ++i) {
    ClipSpec clip;
    clip.length_s = 8;
    for (int k = 0; k < 6; ++k) clip.keys.push_back(build_key(k * 1.5, sample_uniform(random, -1, 1)));
    clip.turn = {{0, {}, sample_uniform(random, -60, 60), 0, 0},
                 {5, {}, sample_uniform(random, -60, 60), 40, -30}};
    clip.blink = kNaturalBlink;
    clip.blink.seed = random() % 1000;
    clip.gaze = {{{1, LookAt::camera}, {2, LookAt::direction, 60, -50}}, 1, random() % 1000};
    clip.drift = {1, random() % 1000};
    clip.asymmetry = {0.3, random() % 1000};
    const Performance performance = build_performance(clip), again = build_performance(clip);
    for (int frame = 0; frame < count_frames(clip); ++frame) {
      const Moment moment = sample_performance(performance, frame / 24.0);
      EXPECT_EQ(moment.pose, sample_performance(again, frame / 24.0).pose);
      for (std::size_t k = 0; k < kMoveCount; ++k) {
        EXPECT_TRUE(std::isfinite(moment.pose.values[k]));
        EXPECT_GE(moment.pose.values[k], kMoves[k].low);
        EXPECT_LE(moment.pose.values[k], kMoves[k].high);
      }
      EXPECT_LE(std::abs(moment.turn.turn_deg), kMaxTurn_deg);
      EXPECT_LE(std::abs(moment.turn.nod_deg), kMaxNod_deg);
    }
  }
}

}  // namespace
}  // namespace mien

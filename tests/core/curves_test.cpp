#include "core/curves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "timeline/track.hpp"

namespace mien {
namespace {

// The thesis's example of section 2.3.1: times, and the three coordinates of each position.
const std::vector<double> kTimes{0, 1, 2, 5, 8};
const std::vector<std::vector<double>> kPlaces{
    {-3000, 0, 2000}, {-2000, -2000, 3000}, {0, -3000, 2000}, {2000, 1400, -2200}, {3000, 3000, -3000}};

KeyTrack build_thesis_track(Between between) {
  std::vector<TrackKey> keys;
  for (std::size_t i = 0; i < kTimes.size(); ++i) keys.push_back({kTimes[i], {}, between, kPlaces[i]});
  return build_track(std::move(keys), 3);
}

std::array<double, 3> sample(const KeyTrack& track, double time_s) {
  std::array<double, 3> into;
  sample_track(track, compute_ticks(time_s), into);
  return into;
}

// a + b t + c t^2 + d t^3 on each span, from the sixteen conditions of a natural spline through five points,
// solved by elimination with pivots.
std::vector<double> solve_natural_spline(const std::vector<double>& t, const std::vector<double>& y) {
  const std::size_t spans = t.size() - 1, n = 4 * spans;
  std::vector<std::vector<double>> rows;
  const auto add = [&](std::vector<std::pair<std::size_t, double>> terms, double right) {
    std::vector<double> row(n + 1, 0);
    for (const auto& [column, factor] : terms) row[column] += factor;
    row[n] = right;
    rows.push_back(std::move(row));
  };
  for (std::size_t i = 0; i < spans; ++i) {
    const std::size_t k = 4 * i;
    for (const std::size_t end : {i, i + 1})
      add({{k, 1}, {k + 1, t[end]}, {k + 2, t[end] * t[end]}, {k + 3, t[end] * t[end] * t[end]}}, y[end]);
    const double x = t[i + 1];
    if (i + 1 == spans) continue;
    add({{k + 1, 1}, {k + 2, 2 * x}, {k + 3, 3 * x * x}, {k + 5, -1}, {k + 6, -2 * x}, {k + 7, -3 * x * x}},
        0);
    add({{k + 2, 2}, {k + 3, 6 * x}, {k + 6, -2}, {k + 7, -6 * x}}, 0);
  }
  add({{2, 2}, {3, 6 * t.front()}}, 0);
  add({{n - 2, 2}, {n - 1, 6 * t.back()}}, 0);
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t best = c;
    for (std::size_t r = c; r < n; ++r)
      if (std::abs(rows[r][c]) > std::abs(rows[best][c])) best = r;
    std::swap(rows[c], rows[best]);
    for (std::size_t r = 0; r < n; ++r) {
      const double factor = r == c ? 0 : rows[r][c] / rows[c][c];
      for (std::size_t k = c; k <= n; ++k) rows[r][k] -= factor * rows[c][k];
    }
  }
  std::vector<double> solved;
  for (std::size_t c = 0; c < n; ++c) solved.push_back(rows[c][n] / rows[c][c]);
  return solved;
}

TEST(curves, pass_the_thesis_positions_exactly) {
  for (const Between between : {Between::ease, Between::linear, Between::smooth, Between::spline}) {
    const KeyTrack track = build_thesis_track(between);
    for (std::size_t i = 0; i < kTimes.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_EQ(sample(track, kTimes[i])[axis], kPlaces[i][axis]);
  }
}

TEST(curves, the_spline_agrees_with_a_solve_of_all_its_conditions) {
  const KeyTrack track = build_thesis_track(Between::spline);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> y;
    for (const auto& place : kPlaces) y.push_back(place[axis]);
    const std::vector<double> solved = solve_natural_spline(kTimes, y);
    for (const double t : {0.1, 0.25, 0.7, 1.3, 1.9, 2.4, 3.5, 4.8, 6.1, 7.7}) {
      std::size_t i = 0;
      while (t > kTimes[i + 1]) ++i;
      const double expected =
          solved[4 * i] + t * (solved[4 * i + 1] + t * (solved[4 * i + 2] + t * solved[4 * i + 3]));
      EXPECT_NEAR(sample(track, t)[axis] / 1000, expected / 1000, 1e-9) << t;
    }
  }
}

TEST(curves, straight_ways_equal_hand_values) {
  const KeyTrack track = build_thesis_track(Between::linear);
  EXPECT_NEAR(sample(track, 0.5)[0], -2500, 1e-9);
  EXPECT_NEAR(sample(track, 1.25)[1], -2250, 1e-9);
  EXPECT_NEAR(sample(track, 3.5)[2], -100, 1e-9);
  EXPECT_NEAR(sample(track, 6)[0], 2000 + 1000 / 3.0, 1e-9);
}

TEST(curves, smooth_never_passes_its_keys_and_has_no_corner) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> value(-1, 1), step(0.1, 2);
  for (int round = 0; round < 200; ++round) {
    std::vector<TrackKey> keys;
    double at_s = 0;
    for (int i = 0; i < 6; ++i, at_s += step(random))
      keys.push_back({at_s, {}, Between::smooth, {value(random)}});
    const KeyTrack track = build_track(keys, 1);
    const auto at = [&](double time_s) {
      double into = 0;
      sample_track(track, compute_ticks(time_s), std::span(&into, 1));
      return into;
    };
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
      const auto [low, high] = std::minmax(keys[i].values[0], keys[i + 1].values[0]);
      for (double u = 0; u <= 1; u += 0.02) {
        const double here = at(std::lerp(keys[i].at_s, keys[i + 1].at_s, u));
        ASSERT_GE(here, low - 1e-12);
        ASSERT_LE(here, high + 1e-12);
      }
      if (i == 0) continue;
      const double h = 1e-5, key_s = keys[i].at_s;
      EXPECT_NEAR((at(key_s) - at(key_s - h)) / h, (at(key_s + h) - at(key_s)) / h, 2e-2);
    }
  }
}

TEST(curves, smooth_ends_with_the_slopes_of_a_parabola) {
  using Slopes = std::vector<double>;
  // t^2 at 1, 2, 4 has the slopes 2 t.
  EXPECT_EQ(compute_smooth_slopes(std::array{1.0, 2.0, 4.0}, std::array{1.0, 4.0, 16.0}), (Slopes{2, 4, 8}));
  // Never against the way, and never more than twice as steep.
  EXPECT_EQ(compute_smooth_slopes(std::array{0.0, 1.0, 2.0}, std::array{0.0, 1.0, 10.0}), (Slopes{0, 2, 13}));
  EXPECT_EQ(compute_smooth_slopes(std::array{0.0, 1.0, 2.0}, std::array{0.0, 1.0, -4.0}), (Slopes{2, 0, -8}));
}

TEST(curves, a_key_with_an_ease_ends_the_curve) {
  std::vector<TrackKey> keys{{0, {}, Between::spline, {0}},
                             {1, {}, Between::spline, {1}},
                             {2, Easing::hold, Between::ease, {0}},
                             {3, {}, Between::spline, {1}}};
  const KeyTrack track = build_track(keys, 1);
  double into = 0;
  sample_track(track, compute_ticks(0.5), std::span(&into, 1));
  EXPECT_NEAR(into, 0.5, 1e-12);  // of two keys a straight line
  sample_track(track, compute_ticks(1.99), std::span(&into, 1));
  EXPECT_EQ(into, 1);
}

TEST(track, led_ways_begin_in_order_and_all_arrive) {
  std::vector<TrackKey> keys{{0, {}, Between::ease, {0, 0, 0}}, {1, {}, Between::ease, {1, 1, 1}}};
  Lead lead;
  for (const double after_s : {0.0, 0.1, 0.2}) lead.after.push_back(compute_ticks(after_s));
  lead.widest = lead.after.back();
  const KeyTrack track = build_track(keys, 3, lead);
  EXPECT_EQ(sample(track, 1), (std::array{1.0, 1.0, 1.0}));
  const auto early = sample(track, 0.15), late = sample(track, 0.85);
  EXPECT_GT(early[0], early[1]);
  EXPECT_GT(early[1], 0);
  EXPECT_EQ(early[2], 0);
  EXPECT_EQ(late[0], 1);
  EXPECT_GT(late[1], late[2]);
  // A short way is led by less: a quarter of it.
  EXPECT_EQ(compute_led_fraction(0, 100, 40, 40, 25), 0);
  EXPECT_GT(compute_led_fraction(0, 100, 40, 40, 26), 0);
  EXPECT_EQ(compute_led_fraction(0, 100, 0, 40, 75), 1);
}

}  // namespace
}  // namespace mien

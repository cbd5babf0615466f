#include "timeline/easing.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mien {
namespace {

constexpr Easing kAll[]{Easing::linear, Easing::in, Easing::out, Easing::in_out, Easing::hold};

TEST(easing, begins_at_nothing_and_ends_at_all_exactly) {
  for (const Easing easing : kAll) {
    EXPECT_EQ(ease(easing, 0), 0);
    EXPECT_EQ(ease(easing, 1), 1);
  }
}

TEST(easing, never_turns_back_and_never_leaves_its_range) {
  for (const Easing easing : kAll) {
    double before = 0;
    for (int i = -100; i <= 1100; ++i) {
      const double share = ease(easing, i / 1000.0);
      EXPECT_GE(share, before);
      EXPECT_LE(share, 1);
      before = share;
    }
  }
}

TEST(easing, of_back_bounce_and_curves_begin_and_end_exactly) {
  Ease curve(Easing::bezier);
  curve.handles = {0.3, 0, 0.2, 1};
  for (const Ease& each : {Ease(Easing::back), Ease(Easing::bounce), curve}) {
    EXPECT_EQ(ease(each, 0), 0);
    EXPECT_EQ(ease(each, 1), 1);
    for (int i = 0; i < 1000; ++i)
      EXPECT_LT(std::abs(ease(each, (i + 1) / 1000.0) - ease(each, i / 1000.0)), 0.01);
  }
}

TEST(easing, back_passes_the_key_by_a_tenth_and_bounce_never_does) {
  double most = 0;
  for (int i = 0; i <= 1000; ++i) {
    most = std::max(most, ease(Easing::back, i / 1000.0));
    EXPECT_LE(ease(Easing::bounce, i / 1000.0), 1);
  }
  EXPECT_NEAR(most, 1.1, 0.001);
}

TEST(easing, a_curve_is_that_of_css) {
  Ease curve(Easing::bezier);
  curve.handles = {0.25, 0.1, 0.25, 1};  // "ease"
  EXPECT_NEAR(ease(curve, 0.5), 0.8024034, 1e-7);
  curve.handles = {0.2, 0.2, 0.7, 0.7};
  EXPECT_NEAR(ease(curve, 0.3), 0.3, 1e-12);
}

TEST(easing, is_slow_where_its_name_says) {
  EXPECT_DOUBLE_EQ(ease(Easing::linear, 0.25), 0.25);
  EXPECT_LT(ease(Easing::in, 0.25), 0.25);
  EXPECT_GT(ease(Easing::out, 0.75), 0.75);
  EXPECT_LT(ease(Easing::in_out, 0.25), 0.25);
  EXPECT_GT(ease(Easing::in_out, 0.75), 0.75);
  EXPECT_DOUBLE_EQ(ease(Easing::in_out, 0.5), 0.5);
  EXPECT_EQ(ease(Easing::hold, 0.999), 0);
}

}  // namespace
}  // namespace mien

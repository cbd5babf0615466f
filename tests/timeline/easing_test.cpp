#include "timeline/easing.hpp"

#include <gtest/gtest.h>

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

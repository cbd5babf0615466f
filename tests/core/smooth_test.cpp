#include "core/smooth.hpp"

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(smooth, begins_and_ends_flat_and_rises_between) {
  EXPECT_EQ(smooth_step(2, 4, 1.0), 0);
  EXPECT_EQ(smooth_step(2, 4, 2.0), 0);
  EXPECT_EQ(smooth_step(2, 4, 3.0), 0.5);
  EXPECT_EQ(smooth_step(2, 4, 4.0), 1);
  EXPECT_EQ(smooth_step(2, 4, 9.0), 1);
  EXPECT_LT(smooth_step(0, 1, 1e-4), 1e-7);
  EXPECT_GT(smooth_step(0, 1, 1 - 1e-4), 1 - 1e-7);
  for (double t = 0; t < 1; t += 0.01) EXPECT_LT(smooth_share(t), smooth_share(t + 0.01));
}

}  // namespace
}  // namespace mien

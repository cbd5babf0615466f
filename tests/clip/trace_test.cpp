// The order in which drawings are traced.
#include "clip/trace.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace mien {
namespace {

FramePlan plan_of(int count, int step) {
  FramePlan plan;
  for (int i = 0; i < count; ++i) plan.drawings.push_back(1 + i * step);
  return plan;
}

TEST(trace, begins_with_the_poster_and_every_eighth_drawing) {
  const CoarseOrder coarse = order_coarsely(plan_of(20, 2), 11);
  EXPECT_EQ(coarse.order,
            (std::vector<std::size_t>{5, 0, 8, 16, 4, 12, 2, 6, 10, 14, 18, 1, 3, 7, 9, 11, 13, 15, 17, 19}));
  EXPECT_EQ(coarse.ends, (std::vector<std::size_t>{4, 6, 11, 20}));
}

TEST(trace, takes_every_drawing_once_whatever_their_number) {
  for (int count = 0; count < 40; ++count) {
    for (const int poster : {-5, 1, 7, 500}) {
      const CoarseOrder coarse = order_coarsely(plan_of(count, 1), poster);
      std::vector<std::size_t> sorted = coarse.order, all(static_cast<std::size_t>(count));
      std::iota(all.begin(), all.end(), 0u);
      std::sort(sorted.begin(), sorted.end());
      EXPECT_EQ(sorted, all);
      ASSERT_EQ(coarse.ends.size(), 4u);
      EXPECT_TRUE(std::is_sorted(coarse.ends.begin(), coarse.ends.end()));
      EXPECT_EQ(coarse.ends.back(), all.size());
    }
  }
}

}  // namespace
}  // namespace mien

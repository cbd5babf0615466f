#include "core/shared_cache.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "core/pool.hpp"

namespace mien {
namespace {

TEST(shared_cache, makes_each_thing_once_for_all_threads) {
  constexpr int kJobs = 8;
  constexpr std::size_t kTakers = 20;
  std::array<std::atomic<int>, 30> made{};
  SharedCache<int> cache(made.size());  // room for all: a thread that sleeps long finds its thing still there
  for_each_index(made.size() * kTakers, kJobs, [&](std::size_t i, int) {
    const std::size_t index = i / kTakers;
    const auto thing = share_thing<int>(cache, index, [&] {
      ++made[index];
      return static_cast<int>(index) + 100;
    });
    EXPECT_EQ(*thing, static_cast<int>(index) + 100);
  });
  for (const std::atomic<int>& count : made) EXPECT_EQ(count, 1);
}

TEST(shared_cache, keeps_few_and_lets_the_lowest_go) {
  SharedCache<std::size_t> cache(3);
  for (std::size_t index = 0; index < 20; ++index) {
    EXPECT_EQ(*share_thing<std::size_t>(cache, index, [&] { return index; }), index);
    EXPECT_LE(cache.things.size(), 3u);
  }
  EXPECT_EQ(cache.things.begin()->first, 17u);
}

TEST(shared_cache, tells_everybody_what_went_wrong) {
  SharedCache<int> cache(2);
  const std::function<int()> fail = []() -> int { throw std::runtime_error("no"); };
  EXPECT_THROW(share_thing(cache, 0, fail), std::runtime_error);
  EXPECT_THROW(share_thing<int>(cache, 0, [] { return 1; }), std::runtime_error);
}

}  // namespace
}  // namespace mien

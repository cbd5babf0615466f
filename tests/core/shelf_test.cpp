#include "core/shelf.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "core/pool.hpp"

namespace mien {
namespace {

TEST(shelf, makes_each_thing_once_for_all_threads) {
  constexpr int kJobs = 8;
  constexpr std::size_t kTakers = 20;
  set_job_count(kJobs);
  std::array<std::atomic<int>, 30> made{};
  Shelf<int> shelf(made.size());  // room for all: a thread that sleeps long finds its thing still there
  for_each_index(made.size() * kTakers, kJobs, [&](std::size_t i, int) {
    const std::size_t index = i / kTakers;
    const auto thing = take_thing<int>(shelf, index, [&] {
      ++made[index];
      return static_cast<int>(index) + 100;
    });
    EXPECT_EQ(*thing, static_cast<int>(index) + 100);
  });
  for (const std::atomic<int>& count : made) EXPECT_EQ(count, 1);
  set_job_count(0);
}

TEST(shelf, keeps_few_and_lets_the_lowest_go) {
  Shelf<std::size_t> shelf(3);
  for (std::size_t index = 0; index < 20; ++index) {
    EXPECT_EQ(*take_thing<std::size_t>(shelf, index, [&] { return index; }), index);
    EXPECT_LE(shelf.things.size(), 3u);
  }
  EXPECT_EQ(shelf.things.begin()->first, 17u);
}

TEST(shelf, tells_everybody_what_went_wrong) {
  Shelf<int> shelf(2);
  const std::function<int()> fail = []() -> int { throw std::runtime_error("no"); };
  EXPECT_THROW(take_thing(shelf, 0, fail), std::runtime_error);
  EXPECT_THROW(take_thing<int>(shelf, 0, [] { return 1; }), std::runtime_error);
}

}  // namespace
}  // namespace mien

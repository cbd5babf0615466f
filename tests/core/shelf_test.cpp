#include "core/shelf.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "core/parallel.hpp"

namespace mien {
namespace {

TEST(shelf, makes_each_thing_once_and_keeps_few) {
  constexpr int kJobs = 8;
  constexpr std::size_t kTakers = 20;
  Shelf<int> shelf(kJobs + 1);
  std::array<std::atomic<int>, 30> made{};
  for_each_index(made.size() * kTakers, kJobs, [&](std::size_t i, int) {
    const std::size_t index = i / kTakers;
    const auto thing = take_thing<int>(shelf, index, [&] {
      ++made[index];
      return static_cast<int>(index) + 100;
    });
    EXPECT_EQ(*thing, static_cast<int>(index) + 100);
    const std::lock_guard lock(shelf.mutex);
    EXPECT_LE(shelf.things.size(), shelf.room);
  });
  for (const std::atomic<int>& count : made) EXPECT_EQ(count, 1);
}

TEST(shelf, tells_everybody_what_went_wrong) {
  Shelf<int> shelf(2);
  const std::function<int()> fail = []() -> int { throw std::runtime_error("no"); };
  EXPECT_THROW(take_thing(shelf, 0, fail), std::runtime_error);
  EXPECT_THROW(take_thing<int>(shelf, 0, [] { return 1; }), std::runtime_error);
}

}  // namespace
}  // namespace mien

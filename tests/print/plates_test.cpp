// Plates: nothing overlaps, nothing hangs over the border.
#include "print/plates.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/error.hpp"

namespace mien {
namespace {

TEST(plates, nothing_overlaps_or_hangs_over) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> size(10, 70);
  for (int round = 0; round < 20; ++round) {
    std::vector<glm::dvec2> prints;
    for (int i = 0; i < 30; ++i) prints.emplace_back(size(random), size(random));
    const auto places = arrange_plates(prints, {220, 200}, 5);
    for (std::size_t i = 0; i < prints.size(); ++i) {
      EXPECT_GE(places[i].low.x, 5);
      EXPECT_GE(places[i].low.y, 5);
      EXPECT_LE(places[i].low.x + prints[i].x, 215);
      EXPECT_LE(places[i].low.y + prints[i].y, 195);
      for (std::size_t j = 0; j < i; ++j) {
        if (places[i].plate != places[j].plate) continue;
        const bool is_apart = places[i].low.x >= places[j].low.x + prints[j].x + 5 - 1e-9 ||
                              places[j].low.x >= places[i].low.x + prints[i].x + 5 - 1e-9 ||
                              places[i].low.y >= places[j].low.y + prints[j].y + 5 - 1e-9 ||
                              places[j].low.y >= places[i].low.y + prints[i].y + 5 - 1e-9;
        EXPECT_TRUE(is_apart) << i << " " << j;
      }
    }
  }
}

TEST(plates, equal_prints_fill_plates_in_their_order) {
  const auto places = arrange_plates(std::vector<glm::dvec2>(10, {40, 40}), {100, 140}, 5);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(places[i].plate, i / 6);
  EXPECT_EQ(places[1].low, glm::dvec2(50, 5));
  EXPECT_EQ(places[2].low, glm::dvec2(5, 50));
  EXPECT_TRUE(arrange_plates({}, {100, 100}, 5).empty());
}

TEST(plates, too_large_is_told) {
  try {
    arrange_plates({{20, 20}, {120, 90}}, {100, 100}, 5);
    ADD_FAILURE();
  } catch (const RunError& e) {
    EXPECT_STREQ(e.what(), "print 2 of 120 x 90 mm does not fit a plate of 100 x 100 mm");
  }
}

}  // namespace
}  // namespace mien

// Units as moves.
#include "takes/mapping.hpp"

#include <gtest/gtest.h>

#include <array>

namespace mien {
namespace {

// Two moves; a jaw, what shuts the lips of an open one, a smile, and both of the last together.
Mapping build_small_mapping() {
  Mapping mapping{"small", "a test"};
  mapping.units.push_back({"jaw", {{0, 1}}, 4, 0.25});
  mapping.units.push_back({"close", {{1, -1}}, 1, 0.5, 0});
  mapping.units.push_back({"smile", {{1, 0.5}}, 2, 0});
  mapping.blends.push_back({{0, 2}, {{0, 0.25}}});
  return mapping;
}

std::array<double, 2> map_weights(std::array<double, 3> weights) {
  std::array<double, 2> moves{};
  add_mapped_moves(build_small_mapping(), weights, moves);
  return moves;
}

// What each counts for by itself.
std::array<double, 3> weigh(std::array<double, 3> weights) {
  std::array<double, 2> moves{};
  add_mapped_moves(build_small_mapping(), weights, moves);
  return weights;
}

TEST(takes_mapping, units_add_up) {
  EXPECT_EQ(map_weights({0.5, 0, 0}), (std::array{0.5, 0.0}));
  EXPECT_EQ(map_weights({0, 0, 0.5}), (std::array{0.0, 0.25}));
}

TEST(takes_mapping, a_corrective_does_its_share_of_what_it_corrects) {
  EXPECT_EQ(map_weights({0, 1, 0}), (std::array{0.0, 0.0}));
  EXPECT_EQ(map_weights({0.25, 1, 0}), (std::array{0.25, -1.0}));
  EXPECT_EQ(map_weights({0.5, 0.25, 0}), (std::array{0.5, -0.5}));
  // Where both are next to nothing their share is noise.
  EXPECT_NEAR(map_weights({0.01, 0.01, 0})[1], -0.2, 1e-9);
}

TEST(takes_mapping, a_corrective_counts_with_what_it_corrects) {
  EXPECT_EQ(weigh({0.5, 0.25, 0}), (std::array{0.25, 0.25, 0.0}));
  EXPECT_EQ(weigh({0.5, 1, 0.75}), (std::array{0.0, 0.5, 0.75}));
  EXPECT_EQ(weigh({0, 1, 0}), (std::array{0.0, 0.0, 0.0}));
}

TEST(takes_mapping, a_combination_takes_the_least_of_its_units) {
  // All of both is the combination alone; of what one has more, the rest is its own.
  EXPECT_EQ(map_weights({1, 0, 1}), (std::array{0.25, 0.0}));
  EXPECT_EQ(map_weights({1, 0, 0.5}), (std::array{0.5 + 0.125, 0.0}));
}

TEST(takes_mapping, units_are_found_by_name) {
  EXPECT_EQ(find_unit(build_small_mapping(), "smile"), 2u);
  EXPECT_EQ(find_unit(build_small_mapping(), "Smile"), std::nullopt);
}

}  // namespace
}  // namespace mien

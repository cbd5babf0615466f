#include "core/sums.hpp"

#include <gtest/gtest.h>

#include <random>

namespace mien {
namespace {

std::vector<glm::dvec3> build_field(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<double> number(-3, 3);
  std::vector<glm::dvec3> field(count);
  for (glm::dvec3& v : field) v = {number(random), number(random), number(random)};
  return field;
}

TEST(sums, are_those_of_one_number_after_the_other_to_the_last_bit) {
  std::mt19937 random(4);
  for (const std::size_t count : {0, 1, 2, 3, 5, 8, 1700}) {
    const std::vector<glm::dvec3> one = build_field(random, count), other = build_field(random, count),
                                  start = build_field(random, count);
    std::vector<glm::dvec3> sum = start, both = start;
    add_products(0.3, one, sum);
    add_products(0.3, one, -1.7, other, both);
    for (std::size_t i = 0; i < count; ++i)
      for (int k = 0; k < 3; ++k) {
        ASSERT_EQ(sum[i][k], start[i][k] + 0.3 * one[i][k]);
        ASSERT_EQ(both[i][k], start[i][k] + (0.3 * one[i][k] + -1.7 * other[i][k]));
      }
  }
}

}  // namespace
}  // namespace mien

// Keys out of rows.
#include "takes/thin_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace mien {
namespace {

std::vector<double> list_row_times(std::size_t rows) {
  std::vector<double> at_s;
  for (std::size_t i = 0; i < rows; ++i) at_s.push_back(static_cast<double>(i));
  return at_s;
}

TEST(takes_thin, a_straight_way_is_its_ends) {
  const std::vector<float> values{0, 1, 2, 3, 4};
  EXPECT_EQ(thin_rows(list_row_times(5), values, 1, {{0, 1}}, 0.01), (std::vector<std::size_t>{0, 4}));
}

TEST(takes_thin, a_corner_is_kept) {
  const std::vector<float> values{0, 1, 2, 1, 0};
  EXPECT_EQ(thin_rows(list_row_times(5), values, 1, {{0, 1}}, 0.01), (std::vector<std::size_t>{0, 2, 4}));
}

TEST(takes_thin, a_way_is_how_far_a_column_takes_the_skin) {
  const std::vector<float> values{0, 0.1F, 0};
  EXPECT_EQ(thin_rows(list_row_times(3), values, 1, {{0, 1}}, 0.5).size(), 2u);   // 0.1 mm
  EXPECT_EQ(thin_rows(list_row_times(3), values, 1, {{0, 10}}, 0.5).size(), 3u);  // 1 mm
}

TEST(takes_thin, other_columns_are_not_looked_at) {
  const std::vector<float> values{0, 5, 0, -5, 0, 5};
  EXPECT_EQ(thin_rows(list_row_times(3), values, 2, {{0, 1}}, 0.5).size(), 2u);
}

TEST(takes_thin, no_row_is_further_than_the_tolerance) {
  std::mt19937 random(3);
  std::normal_distribution<float> step(0, 0.05F);
  const std::size_t rows = 5000;
  std::vector<float> values(2 * rows);
  for (std::size_t i = 2; i < values.size(); ++i) values[i] = values[i - 2] + step(random);
  const std::vector<double> at_s = list_row_times(rows);
  const auto kept = thin_rows(at_s, values, 2, {{0, 2}, {1, 3}}, 0.5);
  EXPECT_LT(kept.size(), rows / 2);
  for (std::size_t i = 1; i < kept.size(); ++i)
    for (std::size_t row = kept[i - 1]; row <= kept[i]; ++row)
      for (std::size_t column = 0; column < 2; ++column) {
        const double share = (at_s[row] - at_s[kept[i - 1]]) / (at_s[kept[i]] - at_s[kept[i - 1]]);
        const double from = values[2 * kept[i - 1] + column], to = values[2 * kept[i] + column];
        EXPECT_LE((column == 0 ? 2 : 3) * std::abs(values[2 * row + column] - (from + share * (to - from))),
                  0.5001);
      }
}

TEST(takes_thin, few_rows_are_kept_as_they_are) {
  EXPECT_TRUE(thin_rows({}, {}, 1, {{0, 1}}, 0.5).empty());
  const std::vector<float> one{1};
  EXPECT_EQ(thin_rows({0}, one, 1, {{0, 1}}, 0.5), std::vector<std::size_t>{0});
}

}  // namespace
}  // namespace mien

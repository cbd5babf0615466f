// Noise goes, onsets stay.
#include "takes/smooth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace mien {
namespace {

std::vector<double> list_times(std::size_t rows) {
  std::vector<double> at_s;
  for (std::size_t i = 0; i < rows; ++i) at_s.push_back(static_cast<double>(i) / 60);
  return at_s;
}

std::vector<float> smooth(std::vector<float> values, const SmoothSpec& spec = {}) {
  smooth_rows(list_times(values.size()), 1, spec, values);
  return values;
}

// When the rows pass a half, s.
double find_half_s(const std::vector<float>& values) {
  for (std::size_t i = 1; i < values.size(); ++i)
    if (values[i] >= 0.5F)
      return (static_cast<double>(i) - 1 + (0.5 - values[i - 1]) / (values[i] - values[i - 1])) / 60;
  return 0;
}

TEST(takes_smooth, noise_at_rest_is_a_third_at_most) {
  std::mt19937 random(1);
  std::normal_distribution<float> noise(0, 0.01F);
  std::vector<float> values(3000);
  for (float& value : values) value = noise(random);
  const auto size = [](const std::vector<float>& rows) {
    double sum = 0;
    for (const float value : rows) sum += static_cast<double>(value) * value;
    return std::sqrt(sum / static_cast<double>(rows.size()));
  };
  EXPECT_LT(size(smooth(values)), 0.33 * size(values));
}

TEST(takes_smooth, an_onset_keeps_its_time_and_passes_nothing) {
  std::vector<float> values(120, 0);
  for (std::size_t i = 60; i < 120; ++i) values[i] = i == 60 ? 0.33F : i == 61 ? 0.66F : 1;
  const std::vector<float> smoothed = smooth(values);
  EXPECT_NEAR(find_half_s(smoothed), find_half_s(values), 0.002);  // a tenth of a frame of 60
  EXPECT_LE(std::ranges::max(smoothed), 1 + 1e-6F);
  EXPECT_GE(std::ranges::min(smoothed), -1e-6F);
  EXPECT_LT(smoothed[56], 0.02F);
  EXPECT_GT(smoothed[65], 0.98F);
}

TEST(takes_smooth, a_blink_keeps_its_depth) {
  std::vector<float> values(60, 0);
  values.insert(values.end(), {0.25F, 0.6F, 0.95F, 1, 1, 0.9F, 0.7F, 0.5F, 0.3F, 0.15F, 0.05F});
  values.resize(140, 0);
  EXPECT_GT(std::ranges::max(smooth(values)), 0.96F);
}

TEST(takes_smooth, none_is_asked_for_with_0) {
  const std::vector<float> values{0, 1, 0, 1, 0};
  EXPECT_EQ(smooth(values, {0, 3, 4}), values);
}

TEST(takes_smooth, what_is_straight_or_still_stays) {
  const std::vector<float> still(50, 0.25F);
  EXPECT_EQ(smooth(still), still);
}

}  // namespace
}  // namespace mien

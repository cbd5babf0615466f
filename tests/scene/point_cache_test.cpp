#include "scene/point_cache.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>

#include "core/error.hpp"

namespace mien {
namespace {

std::uint32_t read_word(const std::string& bytes, std::size_t at, bool is_big) {
  std::uint32_t word = 0;
  for (int i = 0; i < 4; ++i)
    word |= std::uint32_t(static_cast<unsigned char>(bytes.at(at + i))) << 8 * (is_big ? 3 - i : i);
  return word;
}

float read_real(const std::string& bytes, std::size_t at, bool is_big) {
  return std::bit_cast<float>(read_word(bytes, at, is_big));
}

PointCache build_cache() {
  return {25, 3, {{{1, 2, 3}, {-4, 5.5f, 6}}, {{7, 8, 9}, {10, 11, -12}}, {{0, 0, 0}, {1, 1, 1}}}};
}

TEST(point_cache, pc2_reads_back) {
  const std::string bytes = build_pc2(build_cache());
  ASSERT_EQ(bytes.size(), 32u + 3 * 2 * 12);
  EXPECT_EQ(bytes.substr(0, 12), std::string("POINTCACHE2\0", 12));
  EXPECT_EQ(read_word(bytes, 12, false), 1u);
  EXPECT_EQ(read_word(bytes, 16, false), 2u) << "points";
  EXPECT_EQ(read_real(bytes, 20, false), 3) << "first frame";
  EXPECT_EQ(read_real(bytes, 24, false), 1) << "step";
  EXPECT_EQ(read_word(bytes, 28, false), 3u) << "frames";
  EXPECT_EQ(read_real(bytes, 32 + 12 + 4, false), 5.5f);
  EXPECT_EQ(read_real(bytes, 32 + 24 + 20, false), -12);
}

TEST(point_cache, mdd_reads_back) {
  const std::string bytes = build_mdd(build_cache());
  ASSERT_EQ(bytes.size(), 8u + 3 * 4 + 3 * 2 * 12);
  EXPECT_EQ(read_word(bytes, 0, true), 3u) << "frames";
  EXPECT_EQ(read_word(bytes, 4, true), 2u) << "points";
  EXPECT_EQ(read_real(bytes, 8, true), 0) << "seconds";
  EXPECT_EQ(read_real(bytes, 16, true), 0.08f);
  EXPECT_EQ(read_real(bytes, 20, true), 1);
  EXPECT_EQ(read_real(bytes, 20 + 12 + 4, true), 5.5f);
}

TEST(point_cache, refuses_numbers_that_are_not_finite) {
  PointCache cache = build_cache();
  cache.frames[1][0].y = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(build_pc2(cache), RunError);
  EXPECT_THROW(build_mdd(cache), RunError);
}

}  // namespace
}  // namespace mien

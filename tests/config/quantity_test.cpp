#include "config/quantity.hpp"

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(quantity, reads_numbers_as_a_whole_or_not_at_all) {
  EXPECT_EQ(parse_number("1.5"), 1.5);
  EXPECT_EQ(parse_number("+.5"), 0.5);
  EXPECT_EQ(parse_number("-2e1"), -20);
  for (const char* text : {"", "+", "-", "+-1", "-+1", "1.5s", "0x10", "1_000", " 1", "1 ", "inf", "-inf",
                           "nan", ".nan", ".inf", "1e999", "--1", "one"})
    EXPECT_FALSE(parse_number(text)) << text;
}

TEST(quantity, reads_units) {
  const Measure time = build_time_measure(24);
  EXPECT_EQ(parse_quantity("1.5s", time), 1.5);
  EXPECT_EQ(parse_quantity("36f", time), 1.5);
  EXPECT_EQ(parse_quantity("500ms", time), 0.5);
  EXPECT_EQ(parse_quantity("2", time), 2);
  EXPECT_EQ(parse_quantity("8cm", build_length_measure()), 80);
  EXPECT_EQ(parse_quantity("80mm", build_length_measure()), 80);
  EXPECT_EQ(parse_quantity("-20deg", build_angle_measure()), -20);
  for (const char* text : {"s", "1.5 s", "1.5S", "1.5sec", "1,5s", "1m", "", "infs", "1e308cm"})
    EXPECT_FALSE(parse_quantity(text, time)) << text;
  EXPECT_FALSE(parse_quantity("1e308cm", build_length_measure()));
}

TEST(quantity, reads_colours_and_sizes) {
  EXPECT_EQ(parse_colour("#ff0000"), glm::vec3(1, 0, 0));
  for (const char* text :
       {"", "#fff", "ff0000", "#ff00zz", "#-10000", "#+10000", "#ff00000", "red", "# f0000"})
    EXPECT_FALSE(parse_colour(text)) << text;
  EXPECT_EQ(parse_size("480x600"), std::pair(480, 600));
  for (const char* text : {"", "x", "480", "480x", "x600", "480X600", "-1x600", "480x600x3", "4e2x600",
                           "480 x 600", "99999999999x1"})
    EXPECT_FALSE(parse_size(text)) << text;
}

TEST(quantity, is_shown_in_its_base_unit) {
  EXPECT_EQ(format_quantity(1.5, build_time_measure(24)), "1.5s");
  EXPECT_EQ(format_quantity(400, build_length_measure()), "400mm");
  EXPECT_EQ(format_quantity(-30, build_angle_measure()), "-30deg");
}

}  // namespace
}  // namespace mien

#include "scene/title.hpp"

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(title, is_one_line_without_what_is_unsafe) {
  EXPECT_EQ(clean_title("A slow\nsmile\\\x7f{é}"), "A slow smile  {é}");
  EXPECT_EQ(clean_title("a*/b{c}\\", "*/\\{}"), "a  b c  ");
}

TEST(title, is_cut_between_characters) {
  EXPECT_EQ(clean_title("abé", "", 4), "abé");
  EXPECT_EQ(clean_title("abéd", "", 3), "ab");
  EXPECT_EQ(clean_title("日本", "", 5), "日");
  EXPECT_EQ(clean_title("日本", "", 1), "");
}

}  // namespace
}  // namespace mien

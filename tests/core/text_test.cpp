#include "core/text.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/error.hpp"

namespace mien {
namespace {

TEST(text, writes_numbers_one_way) {
  EXPECT_EQ(format_number(1.5, 4), "1.5");
  EXPECT_EQ(format_number(-0.00001, 4), "0");
  EXPECT_EQ(format_number(-0.25, 2), "-0.25");
  EXPECT_EQ(format_number(0.007, 3), "0.007");
  EXPECT_EQ(format_number(1200, 0), "1200");
  EXPECT_EQ(format_number(123456.789, 3), "123456.789");
  EXPECT_THROW(format_number(std::numeric_limits<double>::quiet_NaN(), 3), RunError);
  EXPECT_THROW(format_number(std::numeric_limits<double>::infinity(), 3), RunError);
}

TEST(text, fills_each_placeholder_or_says_which) {
  EXPECT_EQ(fill_template("a {{x}} b {{x}}", {{"x", "1"}}, "t"), "a 1 b 1");
  try {
    fill_template("{{y}}", {}, "t.inc");
    FAIL();
  } catch (const RunError& e) {
    EXPECT_STREQ(e.what(), "t.inc: unknown placeholder 'y'");
  }
  try {
    fill_template("", {{"z", ""}}, "t.inc");
    FAIL();
  } catch (const RunError& e) {
    EXPECT_STREQ(e.what(), "t.inc: placeholder 'z' is missing");
  }
}

TEST(text, suggests_the_nearest_word_only_if_near) {
  const std::vector<std::string> names{"smile", "surprise", "anger"};
  EXPECT_EQ(find_nearest("smlie", names), "smile");
  EXPECT_EQ(find_nearest("suprise", names), "surprise");
  EXPECT_EQ(find_nearest("xylophone", names), "");
}

TEST(text, writes_a_file_whole_or_not_at_all) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "mien_text_test";
  std::filesystem::remove_all(folder);
  write_file(folder / "a/b.txt", "hello");
  EXPECT_EQ(read_file(folder / "a/b.txt"), "hello");
  try {
    write_file("/dev/full/x", "hello");
    FAIL();
  } catch (const RunError& e) {
    EXPECT_STREQ(e.what(), "cannot write /dev/full/x: Not a directory");
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder / "a"))
    EXPECT_EQ(entry.path().filename(), "b.txt");
}

}  // namespace
}  // namespace mien

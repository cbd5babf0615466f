#include "core/text.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <limits>
#include <random>

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

// The same digit by digit: what is written, said slowly.
std::string spell_number(double value, int decimals) {
  double power = 1;
  for (int i = 0; i < decimals; ++i) power *= 10;
  const auto rest = static_cast<std::uint64_t>(std::abs(value) * power + 0.5);
  std::array<char, 24> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), rest).ptr;
  std::string text(digits.data(), end);
  if (rest == 0) return "0";
  const auto places = static_cast<std::size_t>(decimals);
  if (text.size() <= places) text.insert(0, places + 1 - text.size(), '0');
  text.insert(text.size() - places, ".");
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return (value < 0 ? "-" : "") + text;
}

TEST(text, writes_a_million_numbers_as_they_are_spelt) {
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> exponent(-7, 6), sign(-1, 1);
  for (int i = 0; i < 1'000'000; ++i) {
    const int decimals = i % 3 == 0 ? static_cast<int>(random() % 8) : 3;
    double value = std::copysign(std::pow(10.0, exponent(random)), sign(random));
    if (i % 2 == 0) value = static_cast<float>(value);             // as meshes have them
    if (i % 7 == 0) value = std::round(value * 2000) / 2000;       // near a tie or on it
    if (i % 11 == 0) value = std::round(value * 16) / 16;          // ties to the last bit: 0.0625
    if (i % 13 == 0) value = std::nextafter(value, sign(random));  // one bit beside
    ASSERT_EQ(format_number(value, decimals), spell_number(value, decimals)) << i << ": " << value;
  }
}

TEST(text, writes_the_borders_of_quick_numbers_like_all_others) {
  for (const int decimals : {0, 2, 3, 4, 7})
    for (const double value :
         {0.0,       -0.0,   0.0005,  0.0004999999, -0.0004,  -0.0005,  0.0625,
          -0.1875,   0.9995, 0.99949, 999.0,        999.9994, 999.9995, 999.9994999999999,
          -999.9995, 1000.0, 1000.5,  0.001,        0.01,     0.1,      0.011,
          0.101,     10.0,   100.0,   100.1,        1e-300,   -1e-300,  999999.0})
      EXPECT_EQ(format_number(value, decimals), spell_number(value, decimals)) << value << " " << decimals;
  EXPECT_EQ(format_number(-0.0, 3), "0");
  EXPECT_EQ(format_number(-0.0004, 3), "0");
  EXPECT_EQ(format_number(0.0625, 3), "0.063");
  EXPECT_EQ(format_number(-999.9995, 3), "-1000");
}

TEST(text, refuses_what_is_no_number_at_any_length) {
  using Limits = std::numeric_limits<double>;
  for (int decimals = 0; decimals < 10; ++decimals)
    for (const double value : {Limits::quiet_NaN(), -Limits::quiet_NaN(), Limits::infinity(),
                               -Limits::infinity(), 1e9, -1e9, Limits::max()})
      EXPECT_THROW(format_number(value, decimals), RunError) << value << " " << decimals;
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
  const auto expect_alone = [&] {
    for (const auto& entry : std::filesystem::directory_iterator(folder / "a"))
      EXPECT_EQ(entry.path().filename(), "b.txt");
  };
  expect_alone();

  // Never in place: who has the old file open reads it to its end.
  std::ifstream reader(folder / "a/b.txt");
  write_file(folder / "a/b.txt", "good-bye");
  std::string old;
  reader >> old;
  EXPECT_EQ(old, "hello");
  EXPECT_EQ(read_file(folder / "a/b.txt"), "good-bye");
  expect_alone();

  // A disk that takes only a part of it: the old file stays, and nothing beside it.
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit narrow{1000, before.rlim_max};
  const auto on_full = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &narrow), 0);
  std::string message;
  try {
    write_file(folder / "a/b.txt", std::string(2000, 'x'));
  } catch (const RunError& e) {
    message = e.what();
  }
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, on_full);
  EXPECT_EQ(message, "cannot write " + (folder / "a/b.txt").string() + ": File too large");
  EXPECT_EQ(read_file(folder / "a/b.txt"), "good-bye");
  expect_alone();
}

TEST(text, leaves_a_file_alone_that_holds_the_same_already) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "mien_text_same";
  std::filesystem::remove_all(folder);
  write_file(folder / "a.txt", "hello");
  const auto long_ago = std::filesystem::last_write_time(folder / "a.txt") - std::chrono::hours(1);
  std::filesystem::last_write_time(folder / "a.txt", long_ago);
  write_file(folder / "a.txt", "hello");
  EXPECT_EQ(std::filesystem::last_write_time(folder / "a.txt"), long_ago);
  write_file(folder / "a.txt", "jello");
  EXPECT_EQ(read_file(folder / "a.txt"), "jello");
  EXPECT_NE(std::filesystem::last_write_time(folder / "a.txt"), long_ago);
}

}  // namespace
}  // namespace mien

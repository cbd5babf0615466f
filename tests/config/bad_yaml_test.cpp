// Each broken file of tests/bad_yaml has its exact messages beside it.
#include "config/config_fixture.hpp"

namespace mien {
namespace {

TEST(bad_yaml, says_exactly_what_is_wrong_and_where) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kData / "tests/bad_yaml")) {
    if (entry.path().extension() != ".yaml") continue;
    ++count;
    EXPECT_EQ(find_mistakes(entry.path()),
              read_file(std::filesystem::path(entry.path()).replace_extension(".expected")))
        << entry.path();
  }
  EXPECT_GE(count, 140);
}

TEST(bad_yaml, tells_a_file_that_cannot_be_read) {
  const auto folder = make_test_folder();
  EXPECT_EQ(find_mistakes(folder / "none.yaml"), "none.yaml: error: cannot read: No such file or directory");
  EXPECT_EQ(find_mistakes(folder), folder.filename().string() + ": error: cannot read: Is a directory");
  EXPECT_EQ(find_mistakes("/dev/zero"), "zero: error: larger than 1048576 bytes; expected a note, not data");
}

TEST(bad_yaml, refuses_a_file_above_the_limit_only) {
  const std::string start = "mien: 1\n";
  EXPECT_EQ(find_text_mistakes(start + std::string(kMaxFileBytes - start.size(), '#')), "");
  EXPECT_EQ(find_text_mistakes(start + std::string(kMaxFileBytes - start.size() + 1, '#')),
            "test.yaml: error: larger than 1048576 bytes; expected a note, not data");
}

TEST(bad_yaml, stops_telling_after_a_thousand_mistakes) {
  std::string text = "mien: 1\n";
  for (int i = 0; i < 1500; ++i) text.append("k").append(std::to_string(i)).append(": 1\n");
  try {
    load_text(text);
    FAIL();
  } catch (const InputError& error) {
    ASSERT_EQ(error.diagnostics.size(), 1001u);
    EXPECT_EQ(error.diagnostics.back().message, "500 more mistakes are not shown");
  }
}

// What yaml-cpp or a reader could choke on: it must be told, quickly and in little memory.
TEST(bad_yaml, survives_floods) {
  for (const std::string unit :
       {"[",  "{", "- ",     "? ",    ": ",  "&a ", "!a ",        "[{",  "[\n", "{a: \n", "[,",   "x",
        "\"", "'", "%a b\n", "---\n", "|\n", "-\n", "&a a: *a\n", "[a,", "*a ", "a:",     "a:\n", "- ? "}) {
    std::string text;
    while (text.size() + unit.size() <= 200000) text += unit;
    EXPECT_NE(find_text_mistakes(text), "") << unit;
  }
}

}  // namespace
}  // namespace mien

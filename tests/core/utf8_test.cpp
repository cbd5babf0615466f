#include "core/utf8.hpp"

#include <gtest/gtest.h>

#include <string>

namespace mien {
namespace {

TEST(utf8, finds_characters_of_every_length) {
  const std::string text = "aé日😀";
  EXPECT_EQ(find_character(text, 0).code, U'a');
  EXPECT_EQ(find_character(text, 1).code, U'é');
  EXPECT_EQ(find_character(text, 3).code, U'日');
  EXPECT_EQ(find_character(text, 6).code, U'😀');
  EXPECT_EQ(find_character(text, 6).length, 4u);
  EXPECT_EQ(count_characters(text), 4u);
}

TEST(utf8, takes_nothing_that_is_malformed) {
  for (const char* text :
       {"\x80", "\xC0\xAF", "\xC1\x81", "\xE0\x80\xAF", "\xED\xA0\x80", "\xF0\x80\x80\xAF",
        "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF", "\xC3", "\xE6\x97", "\xC3(", "\xF0\x9F\x98"})
    EXPECT_EQ(find_character(text, 0).length, 0u) << testing::PrintToString(std::string(text));
  for (const char* text : {"\xC2\x80", "\xED\x9F\xBF", "\xEE\x80\x80", "\xEF\xBF\xBF", "\xF4\x8F\xBF\xBF"})
    EXPECT_EQ(find_character(text, 0).length, std::string(text).size());
}

TEST(utf8, every_code_point_comes_back) {
  for (char32_t code = 1; code <= 0x10FFFF; code += code < 0x3000 ? 1 : 97) {
    if (code >= 0xD800 && code <= 0xDFFF) continue;
    std::string text;
    if (code < 0x80) {
      text += static_cast<char>(code);
    } else {
      const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
      text += static_cast<char>((0xFF00 >> (more + 1) & 0xFF) | code >> 6 * more);
      for (int i = more - 1; i >= 0; --i) text += static_cast<char>(0x80 | (code >> 6 * i & 0x3F));
    }
    const Character found = find_character(text, 0);
    ASSERT_EQ(found.code, code);
    ASSERT_EQ(found.length, text.size());
  }
}

}  // namespace
}  // namespace mien

#include "scene/plate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "shipped.hpp"

namespace mien {
namespace {

using testing::HasSubstr;

TEST(plate, letters_become_those_that_can_be_drawn) {
  EXPECT_EQ(simplify_letters("A slow smile, 1.5 s"), "A slow smile, 1.5 s");
  EXPECT_EQ(simplify_letters("Émile – “naïve” Øre…"), "Emile - \"naive\" Ore...");
  EXPECT_EQ(simplify_letters("日本"), "");
  EXPECT_EQ(simplify_letters("a\xff\xc3"), "ayA");  // bytes that are no UTF-8 are Latin-1 at most
  EXPECT_EQ(simplify_letters("tab\tbell\a"), "tab bell");
}

TEST(plate, words_stay_inside_their_quotes) {
  EXPECT_EQ(quote_povray("plain"), "\"plain\"");
  EXPECT_EQ(quote_povray("\" 1, 0 } #include \"x\\"), "\"\\\" 1, 0 } #include \\\"x\\\\\"");
  EXPECT_EQ(quote_povray("two\nlines"), "\"two lines\"");
}

// Whatever the bytes: inside the quotes every quote and every backslash has a backslash before it.
TEST(plate, no_bytes_end_their_quotes) {
  std::mt19937 random(7);
  for (int round = 0; round < 500; ++round) {
    std::string words;
    for (int i = 0; i < 40; ++i)
      words += static_cast<char>(random() % 4 == 0 ? "\"\\\n{"[random() % 4] : random());
    const std::string quoted = quote_povray(words);
    ASSERT_GE(quoted.size(), 2u);
    std::size_t i = 1;
    for (; i + 1 < quoted.size(); ++i) {
      ASSERT_TRUE(quoted[i] >= ' ' && quoted[i] < 127);
      ASSERT_NE(quoted[i], '"');
      if (quoted[i] == '\\') ++i;
    }
    ASSERT_EQ(i, quoted.size() - 1);
    ASSERT_EQ(quoted.back(), '"');
  }
}

TEST(plate, is_a_scene_of_its_words_and_rules) {
  Plate plate;
  plate.width_px = 320;
  plate.height_px = 200;
  plate.words = {{"{{width}} \"A\"", 10, 20.5, 12, 0.5, 100, 0.5, false}, {"日", 0, 0}};
  plate.rules = {{1, 2, 300, 1.25, 1}};
  plate.lines = {{1, 2, 3, 4.5, 2, 0.5}, {5, 6, 7, 8, 1, 1, true}};
  const std::string scene = build_plate_scene(plate, shipped_stock().templates);
  EXPECT_THAT(scene, HasSubstr("#declare Page_width = 320;\n#declare Page_height = 200;"));
  EXPECT_THAT(scene, HasSubstr("plate_words(2, \"{{width}} \\\"A\\\"\", 10, 20.5, 12, 0.5, 100, 0.5)\n"));
  EXPECT_THAT(scene, HasSubstr("plate_rule(1, 2, 300, 1.25, 1)\n"));
  EXPECT_THAT(scene, HasSubstr("plate_line(1, 2, 3, 4.5, 2, 0.5)\nplate_arrow(5, 6, 7, 8, 1, 1)\n"));
  EXPECT_EQ(scene.find("plate_words(1"), std::string::npos);  // words without a letter are left out
}

}  // namespace
}  // namespace mien

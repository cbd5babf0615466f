#include "scene/strip.hpp"

#include <gtest/gtest.h>

#include <regex>

namespace mien {
namespace {

StripPage build_page() {
  StripPage page;
  page.title = "A smile";
  page.note = "48 frames";
  page.frame_count = 48;
  page.pictures = {
      {"PNG1", "rest", 0, 1, true}, {"PNG2", "", 0.5, 13, false}, {"PNG3", "smile", 1, 25, true}};
  page.keys = {{0, "rest"}, {1, "smile"}};
  page.blinks_s = {0.25};
  page.rows = {
      {"brows", {"up", "out", "turn"}, std::vector<std::vector<double>>(3, std::vector<double>(48, 0.5))},
      {"chin", {"down", "up"}, std::vector<std::vector<double>>(2, std::vector<double>(48, -1))}};
  return page;
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++found;
  return found;
}

// Every '<' begins a tag of ours, tags are closed in order, attributes stand in quotes.
void expect_well_formed(const std::string& svg) {
  static const std::regex kTag(R"re(<(/?)([a-z]+)((?: [a-zA-Z0-9-]+="[^"<>]*")*)(/?)>)re");
  std::vector<std::string> open;
  std::size_t tags = 0;
  const std::string body = svg.substr(svg.find("?>") + 2);
  for (std::sregex_iterator found(body.begin(), body.end(), kTag), end; found != end; ++found, ++tags) {
    const std::string name = (*found)[2];
    if ((*found)[1].length() > 0) {
      ASSERT_FALSE(open.empty());
      EXPECT_EQ(open.back(), name);
      open.pop_back();
    } else if ((*found)[4].length() == 0) {
      open.push_back(name);
    }
  }
  EXPECT_TRUE(open.empty());
  EXPECT_EQ(tags, count(body, "<"));
  EXPECT_EQ(tags, count(body, ">"));
}

TEST(strip, has_every_picture_and_a_curve_for_each_move) {
  const std::string svg = build_strip_svg(build_page());
  expect_well_formed(svg);
  EXPECT_EQ(count(svg, "<image"), 3u);
  EXPECT_EQ(count(svg, "<polyline"), 5u);
  EXPECT_NE(svg.find("data:image/png;base64," + encode_base64("PNG2")), std::string::npos);
  EXPECT_NE(svg.find(">smile</text>"), std::string::npos);
  EXPECT_EQ(svg, build_strip_svg(build_page()));
}

TEST(strip, keeps_words_words_whatever_they_hold) {
  const std::string wicked = "</text><script>alert(1)</script>\"'&amp; ]]> <!-- \x01 \xC3\xA9";
  StripPage page = build_page();
  page.title = page.note = wicked;
  page.pictures[0].caption = page.keys[0].label = page.rows[0].name = page.rows[0].moves[0] = wicked;
  const std::string svg = build_strip_svg(page);
  expect_well_formed(svg);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  EXPECT_EQ(svg.find('\x01'), std::string::npos);
  EXPECT_NE(svg.find("&lt;script&gt;alert(1)&lt;/script&gt;&quot;&#39;&amp;amp; ]]&gt; &lt;!--  \xC3\xA9"),
            std::string::npos);
}

TEST(strip, keeps_its_size_for_an_hour_of_frames) {
  StripPage page = build_page();
  page.frame_count = 86400;
  page.rows[0].values.assign(3, std::vector<double>(86400, 0.25));
  EXPECT_LT(build_strip_svg(page).size(), 200'000u);
}

TEST(strip, draws_what_is_past_a_limit_at_the_rows_edge) {
  StripPage page = build_page();
  page.rows[1].values[0].assign(48, 900.0);
  const std::string past = build_strip_svg(page);
  page.rows[1].values[0].assign(48, 1.15);
  EXPECT_EQ(past, build_strip_svg(page));
}

TEST(base64, agrees_with_rfc_4648) {
  const char* words[] = {"", "f", "fo", "foo", "foob", "fooba", "foobar"};
  const char* texts[] = {"", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"};
  for (int i = 0; i < 7; ++i) EXPECT_EQ(encode_base64(words[i]), texts[i]);
  EXPECT_EQ(encode_base64("\xFF\xFE\xFD"), "//79");
}

}  // namespace
}  // namespace mien

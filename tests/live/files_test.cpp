#include "live/files.hpp"

#include <gtest/gtest.h>

#include <regex>

#include "core/data.hpp"
#include "core/text.hpp"

namespace mien {
namespace {

TEST(live_files, all_that_the_page_asks_for_is_served) {
  const LiveFiles files = list_live_files(find_data_folder());
  const std::string page = answer_file(files, "").body;
  static const std::regex kAsked(R"re((?:src|href)="([^"]+)")re"),
      kImported(R"re((?:from|import\() ?"\./([^"]+)")re");
  int count = 0;
  for (std::sregex_iterator found(page.begin(), page.end(), kAsked), end; found != end; ++found, ++count)
    EXPECT_EQ(answer_file(files, (*found)[1]).status, 200) << (*found)[1];
  for (const auto& [name, path] : files) {
    if (!name.ends_with(".js") || name.starts_with("lib/")) continue;
    const std::string text = read_file(path);
    for (std::sregex_iterator found(text.begin(), text.end(), kImported), end; found != end; ++found, ++count)
      EXPECT_TRUE(files.contains((*found)[1])) << name << " " << (*found)[1];
  }
  EXPECT_GT(count, 60);
}

TEST(live_files, nothing_of_the_page_asks_for_what_its_policy_forbids) {
  for (const auto& [name, path] : list_live_files(find_data_folder())) {
    if (!name.ends_with(".html")) continue;
    const std::string text = read_file(path);
    EXPECT_FALSE(
        std::regex_search(text, std::regex(R"re(<script(?![^>]*\bsrc=)|\bstyle="|\bon[a-z]+="|https?://)re")))
        << name;
  }
}

TEST(live_files, others_are_not_there) {
  const LiveFiles files = list_live_files(find_data_folder());
  for (const char* name :
       {"../mien.schema.json", "lib/", "lib/../lib/codemirror.js", "/etc/passwd", "INDEX.HTML", "."})
    EXPECT_EQ(answer_file(files, name).status, 404) << name;
}

TEST(live_files, types_follow_from_endings) {
  EXPECT_EQ(find_type("a.js"), "text/javascript; charset=utf-8");
  EXPECT_EQ(find_type("hello.mp4"), "video/mp4");
  EXPECT_EQ(find_type("noending"), "application/octet-stream");
}

TEST(live_files, names_in_addresses_are_escaped) {
  EXPECT_EQ(encode_name("a b/ü\".mp4"), "a%20b%2F%C3%BC%22.mp4");
  EXPECT_EQ(encode_name("bust_smile-1.stl"), "bust_smile-1.stl");
}

}  // namespace
}  // namespace mien

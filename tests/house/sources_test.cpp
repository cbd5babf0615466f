// How each file is written: begun with its purpose, silent, and in one format.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>
#include <set>

#include "house/sources.hpp"
#include "places.hpp"

namespace mien {
namespace {

TEST(house, headers_begin_with_their_purpose_and_are_read_once) {
  for (const SourceFile& source : load_sources("src")) {
    if (!source.path.ends_with(".hpp")) continue;
    ASSERT_FALSE(source.lines.empty()) << source.path;
    EXPECT_TRUE(source.lines.front().starts_with("// ")) << source.path << ":1: the purpose is missing";
    EXPECT_EQ(std::count(source.lines.begin(), source.lines.end(), "#pragma once"), 1) << source.path;
  }
}

TEST(house, only_main_ends_the_program_and_few_print) {
  static const std::regex kEnds(R"re((^|[^\w.>:])(std::|::)?(exit|_exit|quick_exit|abort|terminate)\s*\()re");
  static const std::regex kPrints(
      R"re(std::c(out|err|log)\b|(^|[^\w.>])(std::|fmt::|::)?(f?printf|f?puts|putchar|print|println)\s*\()re");
  const std::set<std::string> printers{"src/main.cpp", "src/render/progress.cpp"};  // and the commands
  for (const SourceFile& source : load_sources("src"))
    for (std::size_t i = 0; i < source.lines.size(); ++i) {
      const std::string code = source.lines[i].substr(0, source.lines[i].find("//"));
      // Only there may a child end: one that was forked and cannot become its program.
      const bool may_end =
          source.path == "src/render/process.cpp" && code.find("::_exit(127)") != std::string::npos;
      EXPECT_FALSE(!may_end && std::regex_search(code, kEnds)) << source.path << ":" << i + 1 << ": " << code;
      if (!printers.contains(source.path) && !source.path.starts_with("src/commands/")) {
        EXPECT_FALSE(std::regex_search(code, kPrints)) << source.path << ":" << i + 1 << ": " << code;
      }
    }
}

TEST(house, sources_have_one_format) {
  if (std::system("command -v clang-format >/dev/null") != 0) GTEST_SKIP() << "clang-format is not installed";
  std::string command = fmt::format("cd '{}' && clang-format --dry-run -Werror", source_folder());
  for (const char* folder : {"src", "tests", "bench"})
    for (const SourceFile& source : load_sources(folder)) command += " " + source.path;
  EXPECT_EQ(std::system(command.c_str()), 0) << "./run format mends it";
}

TEST(house, scripts_are_clean) {
  if (std::system("command -v shellcheck >/dev/null") != 0) GTEST_SKIP() << "shellcheck is not installed";
  const std::string command =
      fmt::format("cd '{}' && shellcheck run .ci/run bench/busts docs/make_pictures", source_folder());
  EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST(house, the_workbench_says_what_it_can_do) {
  const std::string run = fmt::format("'{}/run'", source_folder());
  EXPECT_EQ(std::system((run + " | grep -q '^  demo '").c_str()), 0);
  EXPECT_NE(std::system((run + " demonstrate >/dev/null 2>&1").c_str()), 0);
}

}  // namespace
}  // namespace mien

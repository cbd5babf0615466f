// How each file is written: begun with its purpose, silent, and in one format.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <numeric>
#include <regex>
#include <set>
#include <sstream>

#include "core/text.hpp"
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

// The linker takes one of two types with one name for both, without a word, and what runs is wrong.
TEST(house, a_type_s_name_is_one_type_s) {
  static const std::regex kType(R"re(^(struct|class|enum class|enum) (\w+)( final)?( : [\w:, ]+)? \{)re");
  std::map<std::string, std::string> places;
  for (const SourceFile& source : load_sources("src")) {
    if (!source.path.ends_with(".hpp")) continue;
    for (std::size_t i = 0; i < source.lines.size(); ++i) {
      std::smatch match;
      if (!std::regex_search(source.lines[i], match, kType)) continue;
      const std::string place = fmt::format("{}:{}", source.path, i + 1);
      const auto [entry, is_new] = places.emplace(match[2].str(), place);
      EXPECT_TRUE(is_new) << place << ": " << match[2] << " is at " << entry->second << " too";
    }
  }
  EXPECT_GT(places.size(), 200u);
}

TEST(house, only_main_ends_the_program_and_few_print) {
  static const std::regex kEnds(R"re((^|[^\w.>:])(std::|::)?(exit|_exit|quick_exit|abort|terminate)\s*\()re");
  static const std::regex kPrints(
      R"re(std::c(out|err|log)\b|(^|[^\w.>])(std::|fmt::|::)?(f?printf|f?puts|putchar|print|println)\s*\()re");
  const std::set<std::string> printers{"src/main.cpp", "src/mien_pages.cpp", "src/mien_speak.cpp",
                                       "src/render/progress.cpp"};  // and the commands
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
  const std::string command = fmt::format(
      "cd '{}' && shellcheck run .ci/run bench/busts bench/torture docs/make_pictures", source_folder());
  EXPECT_EQ(std::system(command.c_str()), 0);
}

// What `./run mutants` says of its lists, with nothing built; empty: all is well.
std::string find_mutant_faults(const std::string& options) {
  const std::filesystem::path said = std::filesystem::path(testing::TempDir()) / "mien_mutants.txt";
  const std::string command = fmt::format("'{}/tests/mutants/mutants.py' --check {} >'{}' 2>&1",
                                          source_folder(), options, said.string());
  const int status = std::system(command.c_str());
  return status == 0 ? "" : read_file(said);
}

TEST(house, every_mutant_has_its_place_and_every_room_a_mutant) {
  if (std::system("command -v python3 >/dev/null") != 0) GTEST_SKIP() << "python3 is not installed";
  EXPECT_EQ(find_mutant_faults(""), "");
}

TEST(house, a_mutant_without_a_place_is_found) {
  if (std::system("command -v python3 >/dev/null") != 0) GTEST_SKIP() << "python3 is not installed";
  const std::filesystem::path lists = std::filesystem::path(testing::TempDir()) / "mien_mutant_lists";
  std::filesystem::remove_all(lists);
  write_file(lists / "core.txt",
             "gone mesh.* core/mesh.cpp\nNo such words.\n- no_such_words\n+ words\n\n"
             "often mesh.* core/mesh.cpp\nNot one place.\n- std::\n+ ::\n\n"
             "same mesh.* core/mesh.cpp\nNo change.\n- return six_volumes / 6;\n+ return six_volumes / 6;\n\n"
             "half mesh.* core/mesh.cpp\nNo whole.\n- return six_volumes\n+ return 6\n\n"
             "elsewhere mesh.* head/eyes.cpp\nAnother room.\n- return parts;\n+ return {};\n\n"
             "short mesh.* core/mesh.cpp\n- return {};\n");
  const std::string said = find_mutant_faults("--lists '" + lists.string() + "'");
  for (const char* fault :
       {"core.gone: core/mesh.cpp has 'no_such_words' 0 times", "core.often: core/mesh.cpp has 'std::' ",
        "core.same changes nothing", "core.half: 'return six_volumes' is neither",
        "core.elsewhere: head/eyes.cpp is of another room",
        "core.txt: 'short mesh.* core/mesh.cpp': expected", "no fault in the room head",
        "there are 5 faults, fewer than 120"})
    EXPECT_NE(said.find(fault), said.npos) << fault << " is not in\n" << said;
}

// A checkout with one commit after the first, and the sources that `./run tidy --changed` would read of it.
std::string list_changed(const std::string& change) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "mien_changed";
  const std::string command = fmt::format(
      "rm -rf '{0}' && mkdir -p '{0}/src' && cp '{1}/run' '{0}' && cd '{0}' && exec >log 2>&1 && "
      "export GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a GIT_COMMITTER_NAME=a GIT_COMMITTER_EMAIL=a && "
      "touch .clang-tidy src/a.cpp src/a.hpp src/b.cpp src/c.hpp src/d.hpp && "
      "echo '#include \"c.hpp\"' >src/e.cpp && git init -q -b main . && git add . && git commit -qm first && "
      "{{ {2}\n}} && ./run changed >changed",
      folder.string(), source_folder(), change);
  EXPECT_EQ(std::system(command.c_str()), 0) << read_file(folder / "log");
  return read_file(folder / "changed");
}

TEST(house, changed_sources_are_those_since_the_branch_began) {
  if (std::system("command -v git >/dev/null") != 0) GTEST_SKIP() << "git is not installed";
  const std::string all = "src/a.cpp\nsrc/b.cpp\nsrc/e.cpp\n";
  const auto sort_lines = [](const std::string& text) {
    std::istringstream in(text);
    std::set<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.insert(line + "\n");
    return std::accumulate(lines.begin(), lines.end(), std::string());
  };
  const std::string commit = " && git add . && git commit -qm next";
  // Nothing to compare with.
  EXPECT_EQ(sort_lines(list_changed("true")), all);
  // The last commit, where no origin/main is.
  EXPECT_EQ(list_changed("echo x >>src/b.cpp" + commit), "src/b.cpp\n");
  // A header stands for its source, or for one that includes it; nobody includes d.hpp.
  EXPECT_EQ(list_changed("echo x | tee -a src/a.hpp src/d.hpp >src/c.hpp" + commit),
            "src/a.cpp\nsrc/e.cpp\n");
  // All that the branch did, and what is not committed or not yet added.
  EXPECT_EQ(list_changed("git update-ref refs/remotes/origin/main HEAD; echo x >>src/a.cpp" + commit +
                         "; rm src/b.cpp" + commit + "; echo x >>src/e.cpp; touch src/f.cpp"),
            "src/a.cpp\nsrc/e.cpp\nsrc/f.cpp\n");
  // Other rules judge everything.
  EXPECT_EQ(sort_lines(list_changed("echo x >.clang-tidy" + commit)), all);
}

TEST(house, the_workbench_says_what_it_can_do) {
  const std::string run = fmt::format("'{}/run'", source_folder());
  EXPECT_EQ(std::system((run + " | grep -q '^  demo '").c_str()), 0);
  EXPECT_NE(std::system((run + " demonstrate >/dev/null 2>&1").c_str()), 0);
}

}  // namespace
}  // namespace mien

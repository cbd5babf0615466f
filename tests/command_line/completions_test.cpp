// The completions as the shells themselves take them.
#include "command_line/completions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "command_line/help.hpp"
#include "commands/table.hpp"
#include "config/words.hpp"
#include "core/text.hpp"

namespace mien {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const CompletionWords kWords{{{"list", {"ages", "areas", "skulls"}}, {"sheet", {"views", "people"}}},
                             {{"quality", kQualities}}};

// A folder with the three files, a folder, and two files of which one is mien's.
std::filesystem::path make_shells() {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "mien_completions";
  std::filesystem::remove_all(folder);
  write_file(folder / "mien.bash", build_bash_completion(kWords));
  write_file(folder / "_mien", build_zsh_completion(kWords));
  write_file(folder / "mien.fish", build_fish_completion(kWords));
  write_file(folder / "in/two words.yaml", "");
  write_file(folder / "in/face.png", "");
  std::filesystem::create_directories(folder / "in/out");
  return folder;
}

bool has_program(const std::string& name) {
  return std::system(("command -v " + name + " >/dev/null").c_str()) == 0;
}

// The lines that `script` prints in the folder in/ of the shells', sorted.
std::vector<std::string> run_lines(const std::string& script) {
  const std::filesystem::path folder = make_shells();
  write_file(folder / "script", script);
  const std::string command = fmt::format("cd '{0}/in' && {1} ../script >../lines 2>&1", folder.string(),
                                          script.starts_with("# fish") ? "fish" : "bash");
  EXPECT_EQ(std::system(command.c_str()), 0) << read_file(folder / "lines");
  std::istringstream in(read_file(folder / "lines"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  std::sort(lines.begin(), lines.end());
  return lines;
}

// What bash offers when Tab is pressed behind the last of `words`; bash itself splits at "=".
std::vector<std::string> complete_in_bash(const std::vector<std::string>& words) {
  return run_lines(
      fmt::format("source ../mien.bash\nCOMP_WORDS=('{}')\nCOMP_CWORD={}\n_mien mien\n"
                  "(( ${{#COMPREPLY[@]}} == 0 )) || printf '%s\\n' \"${{COMPREPLY[@]}}\"\n",
                  fmt::join(words, "' '"), words.size() - 1));
}

TEST(completions, hold_every_command_and_option) {
  for (const std::string& text :
       {build_bash_completion(kWords), build_zsh_completion(kWords), build_fish_completion(kWords)}) {
    for (const CommandInfo* command : kCommands)
      EXPECT_THAT(text, HasSubstr(std::string(command->name))) << command->name;
    const bool is_fish = text.find("complete -c mien") != text.npos;
    for (const OptionInfo& option : kOptions)
      EXPECT_THAT(text, HasSubstr(fmt::format("{}{}", is_fish ? "-l " : "--", option.name))) << option.name;
    for (const std::string& quality : kQualities) EXPECT_THAT(text, HasSubstr(quality));
  }
}

TEST(completions, are_read_by_their_shells) {
  const std::filesystem::path folder = make_shells();
  int read = 0;
  for (const auto& [shell, file] :
       {std::pair("bash", "mien.bash"), {"zsh", "_mien"}, {"fish", "mien.fish"}}) {
    if (!has_program(shell)) continue;
    ++read;
    EXPECT_EQ(std::system(fmt::format("{} -n '{}/{}'", shell, folder.string(), file).c_str()), 0) << shell;
  }
  EXPECT_GE(read, 1);
}

TEST(completions, of_zsh_hold_no_bare_colon) {
  EXPECT_THAT(build_zsh_completion(kWords), HasSubstr("[an expression instead of the clip'\\''s\\: smile"));
}

TEST(completions, of_bash_know_the_place) {
  EXPECT_THAT(complete_in_bash({"mien", "re"}), ElementsAre("render"));
  EXPECT_THAT(complete_in_bash({"mien", "s"}), ElementsAre("schema", "sheet", "still"));
  EXPECT_THAT(complete_in_bash({"mien", "--ver"}), ElementsAre("--version"));
  EXPECT_THAT(complete_in_bash({"mien", "list", "a"}), ElementsAre("ages", "areas"));
  EXPECT_THAT(complete_in_bash({"mien", "--quiet", "sheet", ""}), ElementsAre("people", "views"));
  EXPECT_THAT(complete_in_bash({"mien", "render", ""}), ElementsAre("out", "two words.yaml"));
  EXPECT_THAT(complete_in_bash({"mien", "sheet", "--size", "9x9", "views", "t"}),
              ElementsAre("two words.yaml"));
  EXPECT_THAT(complete_in_bash({"mien", "list", "ages", ""}), IsEmpty());
  EXPECT_THAT(complete_in_bash({"mien", "new", ""}), IsEmpty());
  EXPECT_THAT(complete_in_bash({"mien", "rendr", "--s"}), IsEmpty());
}

TEST(completions, of_bash_offer_what_each_command_takes) {
  for (const CommandInfo* each : kCommands) {
    const CommandInfo& command = *each;
    std::vector<std::string> options;
    for (const OptionInfo* option : list_options(command))
      options.push_back(fmt::format("--{}", option->name));
    std::sort(options.begin(), options.end());
    EXPECT_EQ(complete_in_bash({"mien", std::string(command.name), "-"}), options) << command.name;
  }
}

TEST(completions, of_bash_know_the_values_of_options) {
  EXPECT_THAT(complete_in_bash({"mien", "still", "a.yaml", "--quality", ""}),
              ElementsAre("best", "draft", "good", "sketch"));
  EXPECT_THAT(complete_in_bash({"mien", "still", "a.yaml", "--quality", "="}),
              ElementsAre("best", "draft", "good", "sketch"));
  EXPECT_THAT(complete_in_bash({"mien", "still", "--quality", "=", "dr"}), ElementsAre("draft"));
  EXPECT_THAT(complete_in_bash({"mien", "still", "--quality", "=", "draft", "two"}),
              ElementsAre("two words.yaml"));
  EXPECT_THAT(complete_in_bash({"mien", "mesh", "a.yaml", "-o", "f"}), ElementsAre("face.png"));
  EXPECT_THAT(complete_in_bash({"mien", "still", "a.yaml", "--at", ""}), IsEmpty());
}

TEST(completions, of_fish_know_the_place) {
  if (!has_program("fish")) GTEST_SKIP() << "fish is not installed";
  const auto complete = [](const std::string& line) {
    std::vector<std::string> words;
    for (const std::string& offered :
         run_lines(fmt::format("# fish\nsource ../mien.fish\ncomplete -C '{}'\n", line)))
      words.push_back(offered.substr(0, offered.find('\t')));
    return words;
  };
  EXPECT_THAT(complete("mien re"), ElementsAre("render"));
  EXPECT_THAT(complete("mien list a"), ElementsAre("ages", "areas"));
  EXPECT_THAT(complete("mien still --quality "), ElementsAre("best", "draft", "good", "sketch"));
  EXPECT_THAT(complete("mien bust --no"), ElementsAre("--no-stl"));
  EXPECT_THAT(complete("mien still --no"), IsEmpty());
  EXPECT_THAT(complete("mien render --no"), ElementsAre("--no-wait"));
}

}  // namespace
}  // namespace mien

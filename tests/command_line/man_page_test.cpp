// The manual page as man shows it.
#include "command_line/man_page.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "command_line/help.hpp"
#include "commands/table.hpp"
#include "core/text.hpp"

namespace mien {
namespace {

using testing::HasSubstr;

bool has_groff() { return std::system("command -v groff >/dev/null") == 0; }

// The page as plain text of very long lines, one blank between words, and roff's complaints.
struct Shown {
  std::string text, complaints;
};

Shown show_page() {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "mien_man_page";
  write_file(folder / "mien.1", build_man_page());
  const std::string command = fmt::format(
      "cd '{}' && groff -man -ww -Tascii -P-cbou -rLL=2000n mien.1 2>complaints | tr -s ' ' >shown",
      folder.string());
  EXPECT_EQ(std::system(command.c_str()), 0);
  return {read_file(folder / "shown"), read_file(folder / "complaints")};
}

TEST(man_page, is_read_without_a_complaint) {
  if (!has_groff()) GTEST_SKIP() << "groff is not installed";
  EXPECT_EQ(show_page().complaints, "");
}

TEST(man_page, tells_every_command_and_option_letter_for_letter) {
  if (!has_groff()) GTEST_SKIP() << "groff is not installed";
  const std::string text = show_page().text;
  for (const CommandInfo* each : kCommands) {
    const CommandInfo& command = *each;
    EXPECT_THAT(text, HasSubstr(fmt::format("mien {}", command.name)));
    EXPECT_THAT(text, HasSubstr(fmt::format(" {}.\n", command.summary)));
    std::string details(command.details);
    std::replace(details.begin(), details.end(), '\n', ' ');
    EXPECT_THAT(text, HasSubstr(" " + details + "\n"));
    EXPECT_THAT(text,
                HasSubstr(fmt::format(" {}\n", command.examples.substr(0, command.examples.find('\n')))));
  }
  for (const OptionInfo& option : kOptions) {
    EXPECT_THAT(
        text, HasSubstr(fmt::format("--{}{}{}", option.name, option.takes_word() ? " " : "", option.value)));
    EXPECT_THAT(text, HasSubstr(std::string(option.meaning)));
  }
  EXPECT_THAT(text, HasSubstr("-V, --version"));
}

TEST(man_page, says_the_version_and_no_date) {
  EXPECT_THAT(build_man_page(), HasSubstr("\n.TH MIEN 1 \"\" \"mien " MIEN_VERSION "\" "));
}

}  // namespace
}  // namespace mien

// What a command itself says of its options, before it reads anything.
#include <gtest/gtest.h>

#include "command_line/arguments.hpp"
#include "commands/table.hpp"
#include "core/error.hpp"

namespace mien {
namespace {

std::string run_mistaken(std::vector<const char*> words) {
  words.insert(words.begin(), "mien");
  try {
    const Request request = read_arguments(static_cast<int>(words.size()), words.data());
    request.command->run(request.options);
  } catch (const InputError& e) {
    return e.what();
  }
  return "none";
}

TEST(options, of_sheets_belong_to_their_kinds) {
  EXPECT_EQ(
      run_mistaken({"sheet", "ages", "a.yaml", "--express", "sly"}),
      "--express says nothing to 'mien sheet ages'; expected it with 'mien sheet heads', 'views' or 'wire'");
  EXPECT_EQ(run_mistaken({"sheet", "compare", "a", "b", "--express", "sly"}),
            "--express says nothing to 'mien sheet compare'; expected it with 'mien sheet heads', 'views' or "
            "'wire'");
  EXPECT_EQ(run_mistaken({"sheet", "heads", "a.yaml", "--at", "1s"}),
            "--at says nothing to 'mien sheet heads'; expected it with 'mien sheet views' or 'wire'");
  EXPECT_EQ(run_mistaken({"sheet", "views", "a.yaml", "--seed", "3"}),
            "--seed says nothing to 'mien sheet views'; expected it with 'mien sheet people'");
}

TEST(options, of_line_drawings_belong_to_them) {
  EXPECT_EQ(run_mistaken({"sheet", "views", "a.yaml", "--guides"}),
            "--guides says nothing to 'mien sheet views'; expected it with 'mien sheet wire'");
  EXPECT_EQ(run_mistaken({"still", "a.yaml", "--cage"}),
            "--cage is of a line drawing; expected it with --wire");
}

}  // namespace
}  // namespace mien

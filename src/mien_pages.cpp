// Writes what is installed beside the program and told by its tables: the manual page and the completions.
//   mien_pages FOLDER      FOLDER/mien.1 mien.bash _mien mien.fish
#include <cstdio>
#include <exception>
#include <filesystem>

#include "command_line/completions.hpp"
#include "command_line/man_page.hpp"
#include "commands/table.hpp"
#include "config/words.hpp"
#include "core/text.hpp"

int main(int argc, char** argv) {
  using namespace mien;
  if (argc != 2) {
    std::fputs("Usage: mien_pages FOLDER\n", stderr);
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[1];
    CompletionWords words{{}, {{"quality", kQualities}, {"engine", {"local", "slurm"}}}};
    for (const CommandInfo* command : kCommands)
      if (command->list_kinds) words.kinds[command->name] = command->list_kinds();
    write_file(folder / "mien.1", build_man_page());
    write_file(folder / "mien.bash", build_bash_completion(words));
    write_file(folder / "_mien", build_zsh_completion(words));
    write_file(folder / "mien.fish", build_fish_completion(words));
  } catch (const std::exception& e) {
    std::fprintf(stderr, "mien_pages: %s\n", e.what());
    return 1;
  }
}

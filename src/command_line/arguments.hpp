// The command line as values: which command, with which Options, or which text to show.
#pragma once

#include <string>

#include "commands/command.hpp"
#include "options.hpp"

namespace mien {

struct Request {
  const CommandInfo* command = nullptr;  // null: only `text` is to be shown
  Options options;
  std::string text;       // help, or the version
  bool is_usage = false;  // `text` is what mien says where no command was named: a mistake
};

// `argv` as main() has it. Throws InputError with every mistake: an unknown command or option (with the
// nearest known one), a missing or a wrong value.
Request read_arguments(int argc, const char* const* argv);

}  // namespace mien

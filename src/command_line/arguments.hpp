// The command line as values: which command, with which Options, or which text to show.
#pragma once

#include <string>

#include "command_line/commands.hpp"
#include "pipeline.hpp"

namespace mien {

struct Request {
  Command command = Command::usage;
  Options options;
  std::string kind;  // of Command::list and Command::sheet: "ages", "skulls", ...
  std::string text;  // of Command::usage and Command::text
};

// `argv` as main() has it. Throws InputError with every mistake: an unknown command or option (with the
// nearest known one), a missing or a wrong value.
Request read_arguments(int argc, const char* const* argv);

}  // namespace mien

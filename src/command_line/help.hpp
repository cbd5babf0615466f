// What the command line says of itself: usage and help, from the tables of commands and options.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "command_line/option_table.hpp"
#include "commands/command.hpp"

namespace mien {

// The table's entry of an option or of a command; nullptr if there is none such.
const OptionInfo* find_option(std::string_view name);
const CommandInfo* find_command(std::string_view name);

// The options a command takes, in the order its help tells them.
std::vector<const OptionInfo*> list_options(const CommandInfo& command);

// "Usage: mien COMMAND ..." in a few lines; all that mien can do; what one command can do.
std::string build_usage();
std::string build_help();
std::string build_command_help(const CommandInfo& command);

}  // namespace mien

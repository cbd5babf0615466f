#include "command_line/help.hpp"

#include <fmt/format.h>

#include <sstream>

#include "commands/table.hpp"

namespace mien {
namespace {

// Wide enough for "-o, --output PATH" and "  frames FILE"; the meanings begin in one column.
constexpr int kColumn = 20;

std::string format_option(const OptionInfo& option) {
  const std::string dashes = option.letter ? fmt::format("-{}, --{}", option.letter, option.name)
                                           : fmt::format("    --{}", option.name);
  const std::string usage = fmt::format("{}{}{}", dashes, option.takes_word() ? " " : "", option.value);
  return fmt::format("  {:<{}}  {}\n", usage, kColumn, option.meaning);
}

std::string format_command(const CommandInfo& command) {
  return fmt::format("  {:<{}}  {}\n", fmt::format("{} {}", command.name, command.argument), kColumn,
                     command.summary);
}

// Each line of `lines` two columns in.
std::string indent(std::string_view lines) {
  std::istringstream in{std::string(lines)};
  std::string text;
  for (std::string line; std::getline(in, line);) text += "  " + line + "\n";
  return text;
}

void append_options(std::vector<const OptionInfo*>& options, std::string_view names) {
  std::istringstream in{std::string(names)};
  for (std::string name; in >> name;) options.push_back(find_option(name));
}

}  // namespace

const OptionInfo* find_option(std::string_view name) {
  for (const OptionInfo& option : kOptions)
    if (option.name == name) return &option;
  return nullptr;
}

const CommandInfo* find_command(std::string_view name) {
  for (const CommandInfo* command : kCommands)
    if (command->name == name) return command;
  return nullptr;
}

std::vector<const OptionInfo*> list_options(const CommandInfo& command) {
  std::vector<const OptionInfo*> options;
  append_options(options, command.options);
  if (command.argument.ends_with("FILE")) append_options(options, kFileOptions);
  append_options(options, kAllOptions);
  return options;
}

std::string build_usage() {
  std::string names;
  for (const CommandInfo* command : kCommands) names += fmt::format(" {}", command->name);
  return fmt::format(
      "Usage: mien COMMAND FILE [options]\nCommands:{}\n`mien --help` tells more; `mien new my_face` makes a "
      "file to "
      "begin with.\n",
      names);
}

std::string build_help() {
  std::string text = "mien " MIEN_VERSION
                     ": a head and its performance as one text file, from guide lines to clip and print.\n\n"
                     "Usage: mien COMMAND FILE [options]\n";
  std::string_view group;
  for (const CommandInfo* command : kCommands) {
    if (command->group != group) text += fmt::format("\n{}\n", command->group);
    group = command->group;
    text += format_command(*command);
  }
  text += "\nOptions of every command with a FILE\n";
  std::vector<const OptionInfo*> options;
  append_options(options, kFileOptions);
  append_options(options, kAllOptions);
  for (const OptionInfo* option : options) text += format_option(*option);
  text += format_option({"version", 'V', "", "which mien this is"});
  text += "\nExamples\n";
  for (const char* name : {"new", "render", "still"}) text += indent(find_command(name)->examples);
  text +=
      "\n`mien COMMAND --help` tells a command's own options.\n"
      "Exit status: 0 done, 1 something failed, 2 the input is wrong, 130 interrupted.\n";
  return text;
}

std::string build_command_help(const CommandInfo& command) {
  const std::string argument = command.argument.empty() ? "" : fmt::format(" {}", command.argument);
  std::string text = fmt::format("mien {}: {}\n\nUsage: mien {}{} [options]\n\n{}\n\nOptions\n", command.name,
                                 command.summary, command.name, argument, command.details);
  for (const OptionInfo* option : list_options(command)) text += format_option(*option);
  return text + "\nExamples\n" + indent(command.examples);
}

}  // namespace mien

#include "command_line/completions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

#include "command_line/help.hpp"
#include "commands/table.hpp"

namespace mien {
namespace {

using Words = std::vector<std::string>;

constexpr const char* kOrigin =
    "# Completion of mien, written by mien_pages from the tables of commands and options.\n";
constexpr OptionInfo kVersion{"version", 'V', "", "which mien this is"};

// From what a word of the command line is completed.
enum class Source { nothing, words, yaml_file, any_file };
struct Slot {
  Source source = Source::nothing;
  Words words;  // of Source::words
};

Slot find_slot(const OptionInfo& option, const CompletionWords& words) {
  if (const auto values = words.values.find(option.name); values != words.values.end())
    return {Source::words, values->second};
  return {option.value == "PATH" ? Source::any_file : Source::nothing, {}};
}

// Of the command's arguments, in their order: "KIND FILE" has two.
std::vector<Slot> list_slots(const CommandInfo& command, const CompletionWords& words) {
  std::vector<Slot> slots;
  std::istringstream in{std::string(command.argument)};
  for (std::string argument; in >> argument;) {
    const auto kinds = words.kinds.find(command.name);
    if (argument == "FILE" || argument == "[FILE]")
      slots.push_back({Source::yaml_file, {}});
    else if (argument == "KIND" && kinds != words.kinds.end())
      slots.push_back({Source::words, kinds->second});
    else
      slots.push_back({});
  }
  return slots;
}

// What may stand before a command's name.
std::vector<const OptionInfo*> list_first_options() {
  std::vector<const OptionInfo*> options{&kVersion};
  std::istringstream in{std::string(kAllOptions)};
  for (std::string name; in >> name;) options.push_back(find_option(name));
  return options;
}

// "-o|--output": the option's forms as a shell's pattern.
std::string format_pattern(const OptionInfo& option) {
  return option.letter ? fmt::format("-{}|--{}", option.letter, option.name)
                       : fmt::format("--{}", option.name);
}

std::string join_long(const std::vector<const OptionInfo*>& options) {
  std::string names;
  for (const OptionInfo* option : options)
    names += fmt::format("{}--{}", names.empty() ? "" : " ", option->name);
  return names;
}

// `text` between single quotes, `quote` being how the shell writes one within.
std::string quote(std::string_view text, std::string_view quote) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string(quote) : std::string(1, c);
  return quoted + "'";
}

// ---- bash

std::string format_bash_action(const Slot& slot) {
  switch (slot.source) {
    case Source::words:
      return fmt::format("_mien_words '{}'", fmt::join(slot.words, " "));
    case Source::yaml_file:
      return "_mien_yaml";
    case Source::any_file:
      return "_mien_files";
    case Source::nothing:
      break;
  }
  return ":";
}

// The functions that see the word begun as `cur`.
constexpr const char* kBashHelpers = R"(
_mien_words() { mapfile -t COMPREPLY < <(compgen -W "$1" -- "$cur"); }
_mien_files() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -f -- "$cur")
}
_mien_yaml() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$cur"; compgen -f -X '!*.yaml' -- "$cur")
}
_mien() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} command='' place=0 i
  COMPREPLY=()
  # bash takes --quality=dr for three words.
  if [[ $cur == '=' ]]; then
    cur=''
  elif [[ $prev == '=' ]]; then
    prev=${COMP_WORDS[COMP_CWORD - 2]}
  fi
)";

// ---- zsh

// What may not stand bare in the brackets and between the colons of _arguments.
std::string escape_zsh(std::string_view text) {
  std::string escaped;
  for (const char c : text)
    escaped += c == ']' || c == '[' || c == ':' ? fmt::format("\\{}", c) : std::string(1, c);
  return escaped;
}

std::string format_zsh_action(const Slot& slot) {
  switch (slot.source) {
    case Source::words:
      return fmt::format("({})", fmt::join(slot.words, " "));
    case Source::yaml_file:
      return "_files -g \"*.yaml\"";
    case Source::any_file:
      return "_files";
    case Source::nothing:
      break;
  }
  return " ";
}

std::string format_zsh_option(const OptionInfo& option, const CompletionWords& words) {
  const std::string value =
      !option.takes_word() ? ""
                           : fmt::format(":{}:{}", option.value, format_zsh_action(find_slot(option, words)));
  const std::string rest = quote(fmt::format("[{}]{}", escape_zsh(option.meaning), value), "'\\''");
  const char* equals = option.takes_word() ? "=" : "";
  if (!option.letter) return fmt::format("--{}{}{}", option.name, equals, rest);
  return fmt::format("'(-{0} --{1})'{{-{0}{2},--{1}{3}}}{4}", option.letter, option.name,
                     option.takes_word() ? "+" : "", equals, rest);
}

// The arguments of one call of _arguments, one a line.
std::string format_zsh_options(const std::vector<const OptionInfo*>& options, const CompletionWords& words,
                               std::string_view indent) {
  std::string text;
  for (const OptionInfo* option : options)
    text += fmt::format(" \\\n{}{}", indent, format_zsh_option(*option, words));
  return text;
}

// ---- fish

std::string format_fish_action(const Slot& slot) {
  switch (slot.source) {
    case Source::words:
      return fmt::format(" -a '{}'", fmt::join(slot.words, " "));
    case Source::yaml_file:
      return " -k -a '(__fish_complete_suffix .yaml)'";
    case Source::any_file:
      return " -F";
    case Source::nothing:
      break;
  }
  return "";
}

// One line: the option after `condition`, a command of fish.
std::string format_fish_option(const OptionInfo& option, const std::string& condition,
                               const CompletionWords& words) {
  std::string text = fmt::format("complete -c mien -n '{}' -l {}", condition, option.name);
  if (option.letter) text += fmt::format(" -s {}", option.letter);
  const Slot slot = find_slot(option, words);
  if (option.takes_word())
    text += (slot.source == Source::any_file ? " -r" : " -x") + format_fish_action(slot);
  return text + fmt::format(" -d {}\n", quote(option.meaning, "\\'"));
}

}  // namespace

std::string build_bash_completion(const CompletionWords& words) {
  std::string with_value, values, options, places, names;
  for (const OptionInfo& option : kOptions) {
    if (!option.takes_word()) continue;
    with_value += (with_value.empty() ? "" : "|") + format_pattern(option);
    values += fmt::format("    {}) {}; return ;;\n", format_pattern(option),
                          format_bash_action(find_slot(option, words)));
  }
  for (const CommandInfo* each : kCommands) {
    const CommandInfo& command = *each;
    names += fmt::format("{}{}", names.empty() ? "" : " ", command.name);
    options += fmt::format("      {}) _mien_words '{}' ;;\n", command.name, join_long(list_options(command)));
    const std::vector<Slot> slots = list_slots(command, words);
    for (std::size_t i = 0; i < slots.size(); ++i)
      if (slots[i].source != Source::nothing)
        places += fmt::format("    {}:{}) {} ;;\n", command.name, i, format_bash_action(slots[i]));
  }
  return std::string(kOrigin) + kBashHelpers + "  for ((i = 1; i < COMP_CWORD; i++)); do\n" +
         "    case ${COMP_WORDS[i]} in\n      " + with_value +
         ")\n        [[ ${COMP_WORDS[i + 1]} == '=' ]] && ((i++))\n        ((i++))\n        ;;\n"
         "      -* | '=') ;;\n"
         "      *) if [[ -z $command ]]; then command=${COMP_WORDS[i]}; else ((place++)); fi ;;\n"
         "    esac\n  done\n  case $prev in\n" +
         values + "  esac\n  if [[ $cur == -* ]]; then\n    case $command in\n      '') _mien_words '" +
         join_long(list_first_options()) + "' ;;\n" + options + "    esac\n    return\n  fi\n" +
         "  case $command:$place in\n    :0) _mien_words '" + names + "' ;;\n" + places +
         "  esac\n}\ncomplete -F _mien mien\n";
}

std::string build_zsh_completion(const CompletionWords& words) {
  std::string commands, cases;
  for (const CommandInfo* each : kCommands) {
    const CommandInfo& command = *each;
    commands += fmt::format("    {}\n", quote(fmt::format("{}:{}", command.name, command.summary), "'\\''"));
    std::string arguments = format_zsh_options(list_options(command), words, "            ");
    const std::vector<Slot> slots = list_slots(command, words);
    for (std::size_t i = 0; i < slots.size(); ++i)
      arguments +=
          fmt::format(" \\\n            '{}:{}:{}'", i + 1,
                      slots[i].source == Source::words ? "kind" : "file", format_zsh_action(slots[i]));
    cases += fmt::format("        {})\n          _arguments{}\n          ;;\n", command.name, arguments);
  }
  return std::string("#compdef mien\n") + kOrigin +
         "_mien() {\n  local context state state_descr line\n  typeset -A opt_args\n  local -a commands\n"
         "  commands=(\n" +
         commands + "  )\n  _arguments -C" + format_zsh_options(list_first_options(), words, "    ") +
         " \\\n    '1:command:->command' \\\n    '*::argument:->argument'\n"
         "  case $state in\n    command) _describe -t commands 'command of mien' commands ;;\n"
         "    argument)\n      case $words[1] in\n" +
         cases + "      esac\n      ;;\n  esac\n}\n_mien \"$@\"\n";
}

std::string build_fish_completion(const CompletionWords& words) {
  std::string text = std::string(kOrigin) + "complete -c mien -f\n";
  for (const OptionInfo* option : list_first_options())
    text += format_fish_option(*option, "__fish_use_subcommand", words);
  for (const CommandInfo* each : kCommands) {
    const CommandInfo& command = *each;
    text += fmt::format("complete -c mien -n __fish_use_subcommand -a {} -d {}\n", command.name,
                        quote(command.summary, "\\'"));
    const std::string condition = fmt::format("__fish_seen_subcommand_from {}", command.name);
    for (const OptionInfo* option : list_options(command))
      text += format_fish_option(*option, condition, words);
    for (const Slot& slot : list_slots(command, words))
      if (slot.source != Source::nothing)
        text += fmt::format("complete -c mien -n '{}'{}\n", condition, format_fish_action(slot));
  }
  return text;
}

}  // namespace mien

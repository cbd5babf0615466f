#include "command_line/arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>
#include <vector>

#include "command_line/help.hpp"
#include "command_line/values.hpp"
#include "commands/table.hpp"
#include "core/error.hpp"

namespace mien {
namespace {

// What was typed, before its values are understood.
struct Typed {
  const CommandInfo* command = nullptr;  // null: none was named
  std::vector<std::string> words;        // neither options nor their values; the command's argument first
  std::vector<std::string> unknown;      // what looks like an option and is none
  TypedValues values;
  TypedValues flags;  // of those flags that may be given a value; empty: not typed
};

constexpr const char* kNoValue = "true";  // what CLI11 makes of such a flag alone

// A command that takes only what every command takes: for what stands before the command's name.
constexpr CommandInfo kNoCommand{"", "", "", "", "", "", "", nullptr};

void add_options(CLI::App& app, const CommandInfo& command, Typed& typed) {
  TypedValues& values = typed.values;
  app.set_help_flag("");
  app.allow_extras();  // and judged by read_arguments, since CLI11's own messages suggest nothing
  for (const OptionInfo* option : list_options(command)) {
    const std::string name(option->name);
    const std::string flags = option->letter ? fmt::format("-{},--{}", option->letter, name) : "--" + name;
    const auto keep = [&values, name](const std::string& value) { values[name] = value; };
    const auto gather = [&values, name](const std::vector<std::string>& all) {
      values[name] = all.back();
      values[std::string(kAllOutputs)] = fmt::format("{}", fmt::join(all, std::string(1, kBetweenOutputs)));
    };
    if (option->value.empty())
      app.add_flag_callback(flags, [keep] { keep({}); });
    else if (!option->takes_word())
      app.add_flag(flags, typed.flags[name])->take_last();
    else if (name == "output")
      app.add_option_function<std::vector<std::string>>(flags, gather)->take_all()->allow_extra_args(false);
    else
      app.add_option_function<std::string>(flags, keep)->take_last()->type_name(std::string(option->value));
  }
}

Typed read_typed(int argc, const char* const* argv) {
  std::vector<const char*> words(argv, argv + argc);
  if (argc > 1 && std::string_view("help") == words[1]) words[1] = "--help";
  Typed typed;
  CLI::App app;
  add_options(app, kNoCommand, typed);
  app.add_flag_callback("-V,--version", [&typed] { typed.values["version"]; });
  app.require_subcommand(0, 1);  // a second command's name is a word like any other
  for (const CommandInfo* command : kCommands) {
    CLI::App* sub = app.add_subcommand(std::string(command->name));
    add_options(*sub, *command, typed);
    sub->callback([&typed, command] { typed.command = command; });
  }
  try {
    app.parse(argc, words.data());
  } catch (const CLI::ParseError& e) {
    throw InputError(e.what());
  }
  for (const auto& [name, value] : typed.flags)
    if (!value.empty()) typed.values[name] = value == kNoValue ? "" : value;
  for (const std::string& word : app.remaining(true))
    (word.size() > 1 && word.front() == '-' ? typed.unknown : typed.words).push_back(word);
  return typed;
}

std::string describe_unknown_command(const std::string& word) {
  std::vector<std::string> names;
  for (const CommandInfo* command : kCommands) names.emplace_back(command->name);
  return fmt::format("unknown command '{}'{}", word, suggest(word, names));
}

std::string describe_unknown_option(const CommandInfo& command, const std::string& word) {
  const std::string option = word.substr(0, word.find('='));
  std::vector<std::string> names{"--version"};
  for (const OptionInfo* known : list_options(command)) names.push_back(fmt::format("--{}", known->name));
  if (std::find(names.begin(), names.end(), option) != names.end())
    return fmt::format("option '{}' belongs after the command's name", option);
  return fmt::format("unknown option '{}'{}{}", option,
                     command.name.empty() ? "" : fmt::format(" of 'mien {}'", command.name),
                     suggest(option, names));
}

std::string describe_missing_argument(const CommandInfo& command) {
  const std::string_view example = command.examples.substr(0, command.examples.find_first_of("\n&"));
  std::string needed(command.argument);
  if (const std::size_t blank = needed.find(' '); blank != needed.npos) needed.replace(blank, 1, " and a ");
  return fmt::format("'mien {}' needs a {}, as in: {}", command.name, needed, example);
}

// What is wrong with the words themselves, before any value is looked at.
void find_wrong_words(const Typed& typed, std::vector<Diagnostic>& mistakes) {
  const auto add = [&](std::string message) { add_mistake(mistakes, std::move(message)); };
  if (!typed.command && !typed.words.empty()) return add(describe_unknown_command(typed.words.front()));
  for (const std::string& word : typed.unknown)
    add(describe_unknown_option(typed.command ? *typed.command : kNoCommand, word));
  // What follows an unknown option may be its value: more words are no mistake of their own then.
  if (!typed.command || !typed.unknown.empty()) return;
  const std::string_view argument = typed.command->argument;
  const std::string_view of_two = typed.command->kind_of_two;
  const bool needs_two = !of_two.empty() && !typed.words.empty() && typed.words.front() == of_two;
  if (needs_two && typed.words.size() < 3)
    return add(fmt::format("'mien {0} {1}' needs two FILEs, as in: mien {0} {1} anna.yaml@smile otto.yaml",
                           typed.command->name, of_two));
  const std::size_t most =
      argument.empty() ? 0 : 1 + std::count(argument.begin(), argument.end(), ' ') + (needs_two ? 1 : 0);
  const std::size_t wanted = argument.starts_with('[') ? 0 : most;
  const std::string alone = fmt::format(" {} ", typed.command->kinds_without_file);
  const bool needs_no_file =
      !typed.words.empty() && alone.find(fmt::format(" {} ", typed.words.front())) != alone.npos;
  if (typed.words.size() + (needs_no_file ? 1 : 0) < wanted) add(describe_missing_argument(*typed.command));
  for (std::size_t i = most; i < typed.words.size(); ++i)
    add(fmt::format("'{}' is one word too many for 'mien {}'", typed.words[i], typed.command->name));
}

}  // namespace

Request read_arguments(int argc, const char* const* argv) {
  const Typed typed = read_typed(argc, argv);
  Request request;
  request.command = typed.command;
  if (typed.values.contains("version") || typed.values.contains("help")) {
    request.command = nullptr;
    request.text = typed.values.contains("version") ? "mien " MIEN_VERSION "\n"
                   : typed.command                  ? build_command_help(*typed.command)
                                                    : build_help();
    return request;
  }
  std::vector<Diagnostic> mistakes;
  find_wrong_words(typed, mistakes);
  request.options = build_options(typed.values, mistakes);
  if (!mistakes.empty()) throw InputError(std::move(mistakes));
  if (!typed.command) {
    request.text = build_usage();
    request.is_usage = true;
    return request;
  }
  std::vector<std::string> words = typed.words;
  if (typed.command->argument.starts_with("KIND")) {
    request.options.kind = words.front();
    words.erase(words.begin());
  }
  if (!words.empty()) request.options.file = words.front();
  if (words.size() > 1) request.options.other = words[1];
  return request;
}

}  // namespace mien

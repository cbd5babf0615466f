#include "command_line/man_page.hpp"

#include <fmt/format.h>

#include <sstream>

#include "command_line/help.hpp"
#include "commands/table.hpp"

namespace mien {
namespace {

// `text` as roff prints it letter for letter: dashes that can be copied, plain quotes, no line taken for a
// request.
std::string escape(std::string_view text) {
  std::string escaped;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins_line = i == 0 || text[i - 1] == '\n';
    switch (text[i]) {
      case '\\':
        escaped += "\\e";
        break;
      case '-':
        escaped += "\\-";
        break;
      case '\'':
        escaped += "\\(aq";
        break;
      case '`':
        escaped += "\\(ga";
        break;
      case '.':
        escaped += begins_line ? "\\&." : ".";
        break;
      default:
        escaped += text[i];
    }
  }
  return escaped;
}

std::string format_option(const OptionInfo& option) {
  std::string text = ".TP\n";
  if (option.letter) text += fmt::format("\\fB\\-{}\\fR, ", option.letter);
  text += fmt::format("\\fB\\-\\-{}\\fR", escape(option.name));
  if (!option.value.empty())
    text += fmt::format("{}\\fI{}\\fR", option.takes_word() ? " " : "", escape(option.value));
  return fmt::format("{}\n{}\n", text, escape(option.meaning));
}

// Those of `options` that are named in `names`, words with spaces between.
std::string format_options(std::string_view names) {
  std::string text;
  std::istringstream in{std::string(names)};
  for (std::string name; in >> name;) text += format_option(*find_option(name));
  return text;
}

std::string format_examples(std::string_view lines) {
  return fmt::format(".PP\n.RS\n.nf\n{}\n.fi\n.RE\n", escape(lines));
}

// "\fBmien render\fR \fIFILE\fR"
std::string format_call(const CommandInfo& command) {
  const std::string call = fmt::format("\\fBmien {}\\fR", escape(command.name));
  return command.argument.empty() ? call : fmt::format("{} \\fI{}\\fR", call, escape(command.argument));
}

std::string format_command(const CommandInfo& command) {
  return fmt::format(".SS {}\n{}.\n.PP\n{}\n{}{}", format_call(command), escape(command.summary),
                     escape(command.details), format_options(command.options),
                     format_examples(command.examples));
}

}  // namespace

std::string build_man_page() {
  std::string text =
      ".\\\" Written by mien_pages from the tables of commands and options.\n"
      ".TH MIEN 1 \"\" \"mien " MIEN_VERSION
      "\" \"User Commands\"\n"
      ".SH NAME\nmien \\- a head and its performance as one text file, from guide lines to clip and print\n"
      ".SH SYNOPSIS\n.nf\n";
  for (const CommandInfo* command : kCommands)
    text += fmt::format("{} [\\fIoptions\\fR]\n", format_call(*command));
  text +=
      ".fi\n.SH DESCRIPTION\n"
      "One YAML file describes a head and a performance. \\fBmien\\fR draws the head for every frame of it, "
      "has\nPOV\\-Ray render the pictures and ffmpeg join them, and writes busts for OpenSCAD and the "
      "slicer.\n"
      ".SH COMMANDS\n";
  for (const CommandInfo* command : kCommands) text += format_command(*command);
  text += ".SH OPTIONS OF EVERY COMMAND WITH A FILE\n" + format_options(kFileOptions);
  text += ".SH OPTIONS OF EVERY COMMAND\n" + format_options(kAllOptions);
  text += format_option({"version", 'V', "", "which mien this is"});
  text +=
      ".SH EXIT STATUS\n"
      ".TP\n0\ndone\n"
      ".TP\n1\nsomething failed, or a bust is not printable\n"
      ".TP\n2\nthe input is wrong: the words of the command line or the file\n"
      ".TP\n130\ninterrupted\n"
      ".PP\nWhere standard output or standard error is closed or full, the status is 1 if something was to "
      "be said there.\n"
      ".SH ENVIRONMENT\n"
      ".TP\nMIEN_STALL_LIMIT\nafter how many seconds a tool that says nothing and hardly works is ended "
      "(600; 0: never)\n"
      ".TP\nNO_COLOR\nif it is set, the progress bar has no colours\n"
      ".SH FILES\n"
      ".TP\n\\&.mien.lock\nin a folder that is being written: who does; gone when that run ends\n"
      ".SH SEE ALSO\n.BR povray (1),\n.BR ffmpeg (1),\n.BR openscad (1)\n";
  return text;
}

}  // namespace mien

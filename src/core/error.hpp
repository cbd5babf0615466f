// How a failure travels: thrown by whoever meets it, printed by main.cpp alone.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace mien {

// A place in an input file. Line and column count from 1; 0 means "the file as a whole", or the whole line.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

// One mistake: "configs/a.yaml:12:7: error: unknown expression 'smlie'; did you mean 'smile'?"
struct Diagnostic {
  Place place;
  std::string message;      // what was found; what was expected
  std::string source_line;  // the text of the line, shown under the message; empty: not shown
  bool is_warning = false;
};

// The input is wrong: exit status 2. Carries every mistake that was found, in the order of the file.
struct InputError : std::runtime_error {
  explicit InputError(std::vector<Diagnostic> found);
  explicit InputError(const std::string& message);  // a mistake with no place, such as a wrong option
  std::vector<Diagnostic> diagnostics;
};

// Something failed that is not the input's fault: a program, a disk. Exit status 1.
struct RunError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Ctrl-C or a termination signal came; what was finished stays. Exit status 130.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted; what was finished is kept, run again to go on") {}
  explicit Interrupted(const std::string& what_goes_on) : std::runtime_error(what_goes_on) {}
};

// "file:line:col: error: message", then the source line and a caret when they are known.
std::string format_diagnostic(const Diagnostic& diagnostic);

}  // namespace mien

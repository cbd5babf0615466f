// What a command is: its words for the help, the options it takes, and what it does.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "options.hpp"

namespace mien {

struct CommandInfo {
  std::string_view name;
  std::string_view group;  // under which the help lists it: "Pictures"
  std::string_view
      argument;  // the words it needs: "FILE", "KIND FILE"; "[FILE]": may be left out; empty: none
  std::string_view summary;
  std::string_view details;   // the first paragraph of its own help
  std::string_view options;   // long names with spaces between, beyond the common ones
  std::string_view examples;  // lines; without the indent
  // Does it. What a user should read (paths, lists, findings) goes to standard output; progress goes to
  // standard error. Throws InputError (exit 2) before anything is written, RunError (exit 1) or Interrupted
  // (exit 130).
  void (*run)(const Options& options);
  std::vector<std::string> (*list_kinds)() = nullptr;  // what KIND may be
  std::string_view kinds_without_file = {};            // each KIND that needs no FILE, with spaces between
  std::string_view kind_of_two = {};                   // the KIND that needs two FILEs
};

}  // namespace mien

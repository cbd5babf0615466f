// What a shell completes after `mien`, from the tables of commands and options.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

// What the tables do not hold: the words that a KIND or an option's value may be. What is not in here
// completes by its name: FILE to folders and *.yaml, PATH to any file, everything else to nothing.
struct CompletionWords {
  std::map<std::string_view, std::vector<std::string>> kinds;   // by command: "list"
  std::map<std::string_view, std::vector<std::string>> values;  // by option's long name: "quality"
};

// Each is one file, for bash 4, zsh and fish 3; it runs nothing but the shell's own completion.
std::string build_bash_completion(const CompletionWords& words);
std::string build_zsh_completion(const CompletionWords& words);
std::string build_fish_completion(const CompletionWords& words);

}  // namespace mien

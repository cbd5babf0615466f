// The mistakes of one run, gathered while files are read and thrown together.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace mien {

// A file with more mistakes is not a note with slips but another kind of file; the rest is only counted.
inline constexpr std::size_t kMaxMistakes = 1000;

struct Findings {
  std::vector<Diagnostic> mistakes;
  std::size_t untold = 0;                    // how many came after kMaxMistakes
  std::vector<std::filesystem::path> files;  // that were read, or are named to be read
  std::uintmax_t named_bytes = 0;            // of the texts among them that a file names
  std::size_t constants = 0;                 // formulas that were read in place of plain numbers
  bool keeps_to_nine = false;  // `head: {areas: nine}`: moves beyond Tezuka's areas are mistakes
};

// True when a further mistake would only be counted, so that no work need go into its words.
bool is_full(const Findings& findings);

// Adds the mistake; `source_line` is the text of its line (left out where it is too long to be read).
void add_mistake(Findings& findings, Place place, std::string message, std::string_view source_line);

// Throws InputError with all mistakes in the order of the file, each told once; does nothing if there are
// none.
void throw_mistakes(Findings findings);

// An author's word as a message shows it: cut where it is long, control characters as "\x1b".
std::string show_word(std::string_view word);

// "a, b, c", cut after 40 names.
std::string join_names(const std::vector<std::string>& names);

// The one of `names` that people call so (common_words.hpp), else the nearest, upper-case letters and '-' for
// '_' forgiven; empty if none is near. Costs little even when an author invents thousands of names.
std::string suggest_name(std::string_view word, const std::vector<std::string>& names);

// "did you mean 'adult'?", with the common word's note if it has one; empty if none is near.
std::string describe_suggestion(std::string_view word, const std::vector<std::string>& names);

// "unknown age 'adlut'; did you mean 'adult'?", or the known ones when none is near.
std::string describe_unknown(std::string_view kind, std::string_view word,
                             const std::vector<std::string>& names);

}  // namespace mien

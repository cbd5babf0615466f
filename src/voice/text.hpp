// A text as an author writes it for speech: "I *did* see you. You, too?"
#pragma once

#include <string>
#include <vector>

namespace mien {

// Letters of the plain text, from `from` up to `to`.
struct TextSpan {
  int from = 0, to = 0;
};

struct SaidText {
  std::string plain;                // without the stars
  std::vector<TextSpan> stressed;   // what stood between two of them
  std::vector<TextSpan> questions;  // each up to its question mark
};

SaidText read_said_text(const std::string& text);

// How many letters a text has, and some of them: bytes of UTF-8.
int count_letters(const std::string& text);
std::string take_letters(const std::string& text, const TextSpan& span);

}  // namespace mien

#include "voice/text.hpp"

#include <algorithm>
#include <string_view>

namespace mien {

namespace {

bool is_letter_begin(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }

}  // namespace

SaidText read_said_text(const std::string& text) {
  SaidText said;
  const bool is_paired = std::ranges::count(text, '*') % 2 == 0;
  int at = 0, star = -1, sentence = 0;
  for (const char c : text) {
    if (c == '*' && is_paired) {
      if (star >= 0) said.stressed.push_back({star, at});
      star = star >= 0 ? -1 : at;
      continue;
    }
    if (c == '?') said.questions.push_back({sentence, at});
    said.plain += c;
    if (is_letter_begin(c)) ++at;
    if (std::string_view(".!?;").find(c) != std::string_view::npos) sentence = at;
  }
  return said;
}

int count_letters(const std::string& text) {
  return static_cast<int>(std::ranges::count_if(text, is_letter_begin));
}

std::string take_letters(const std::string& text, const TextSpan& span) {
  std::string taken;
  int at = -1;
  for (const char c : text) {
    if (is_letter_begin(c)) ++at;
    if (at >= span.from && at < span.to) taken += c;
  }
  return taken;
}

}  // namespace mien

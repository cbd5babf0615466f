#include "sketch/sdl_tokens.hpp"

#include <fmt/format.h>

#include <charconv>

#include "core/error.hpp"

namespace mien {

namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

struct SdlText {
  std::string_view text, name;
  std::size_t at = 0;
  int line = 1;

  char look(std::size_t further = 0) const { return at + further < text.size() ? text[at + further] : '\0'; }
};

[[noreturn]] void fail_text(const SdlText& text, const std::string& what) {
  throw RunError(fmt::format("{}:{}: {}", text.name, text.line, what));
}

void skip_comment(SdlText& text) {
  if (text.look(1) == '/') {
    while (text.at < text.text.size() && text.look() != '\n') ++text.at;
    return;
  }
  const std::size_t end = text.text.find("*/", text.at + 2);
  if (end == std::string_view::npos) fail_text(text, "a comment without its end");
  for (; text.at < end + 2; ++text.at) text.line += text.look() == '\n';
}

std::string take_word(SdlText& text) {
  const std::size_t first = text.at;
  while (is_letter(text.look()) || is_digit(text.look())) ++text.at;
  return std::string(text.text.substr(first, text.at - first));
}

double take_number(SdlText& text) {
  double number = 0;
  const char* const first = text.text.data() + text.at;
  const auto [end, error] = std::from_chars(first, text.text.data() + text.text.size(), number);
  if (error != std::errc()) fail_text(text, "a number that cannot be read");
  text.at += static_cast<std::size_t>(end - first);
  return number;
}

SdlToken take_token(SdlText& text) {
  const char c = text.look();
  SdlToken token{SdlKind::sign, 0, std::string(1, c), text.line};
  if (is_digit(c) || (c == '.' && is_digit(text.look(1)))) {
    token.kind = SdlKind::number;
    token.number = take_number(text);
  } else if (is_letter(c)) {
    token.kind = SdlKind::word;
    token.word = take_word(text);
  } else if (c == '#') {
    ++text.at;
    token.kind = SdlKind::directive;
    token.word = take_word(text);
  } else if (c == '"') {
    const std::size_t end = text.text.find('"', text.at + 1);
    if (end == std::string_view::npos) fail_text(text, "a text without its end");
    token.kind = SdlKind::text;
    token.word = text.text.substr(text.at + 1, end - text.at - 1);
    text.at = end + 1;
  } else {
    ++text.at;
    if ((c == '!' || c == '<' || c == '>') && text.look() == '=') {
      token.word += '=';
      ++text.at;
    } else if (std::string_view("<>{}[]()+-*/,;=!&|.?:").find(c) == std::string_view::npos) {
      fail_text(text, fmt::format("unexpected '{}'", c));
    }
  }
  return token;
}

}  // namespace

std::vector<SdlToken> list_sdl_tokens(std::string_view whole, std::string_view name) {
  SdlText text{whole, name};
  std::vector<SdlToken> tokens;
  while (text.at < whole.size()) {
    const char c = text.look();
    if (c == '/' && (text.look(1) == '/' || text.look(1) == '*')) {
      skip_comment(text);
    } else if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
      text.line += c == '\n';
      ++text.at;
    } else {
      tokens.push_back(take_token(text));
    }
  }
  return tokens;
}

}  // namespace mien

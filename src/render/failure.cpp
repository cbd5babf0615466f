#include "render/failure.hpp"

#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <cctype>
#include <cstring>

#include "core/utf8.hpp"

namespace mien {

namespace {

constexpr std::size_t kLastLines = 12;      // of output in a message: an error and what led to it
constexpr std::size_t kLongestLine = 1000;  // bytes of each: a path and what is wrong with it

bool is_safe_in_shell(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) || std::strchr("_-+=./,:@%", letter) != nullptr;
}

// A line as a message shows it: of a very long one its beginning.
std::string shorten_line(const std::string& line) {
  if (line.size() <= kLongestLine) return line;
  std::size_t end = kLongestLine;
  while (end > 0 && !is_first_of_character(line[end])) --end;
  return fmt::format("{}... ({} bytes more left out)", line.substr(0, end), line.size() - end);
}

}  // namespace

std::string quote_command(const std::vector<std::string>& command) {
  std::string line;
  for (const std::string& word : command) {
    if (!line.empty()) line += ' ';
    if (!word.empty() && std::ranges::all_of(word, is_safe_in_shell)) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char letter : word) line += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    line += '\'';
  }
  return line;
}

std::string describe_end(const std::string& program, int exit_code) {
  if (exit_code > 128 && exit_code < 128 + NSIG)
    return fmt::format("{} was ended by signal {} ({})", program, exit_code - 128,
                       ::strsignal(exit_code - 128));
  return fmt::format("{} failed (exit status {})", program, exit_code);
}

std::string format_failure(const std::string& what, const std::string& command, const std::string& output) {
  std::vector<std::string> lines{""};
  for (const char letter : output) {
    if (letter == '\n' || letter == '\r') {
      if (!lines.back().empty()) lines.emplace_back();
    } else if (static_cast<unsigned char>(letter) >= ' ' || letter == '\t') {
      lines.back() += letter;
    }
  }
  if (lines.back().empty()) lines.pop_back();
  std::string text = fmt::format("{}\n  command: {}", what, command);
  const std::size_t first = lines.size() > kLastLines ? lines.size() - kLastLines : 0;
  if (first > 0) text += fmt::format("\n  ({} line{} before these left out)", first, first == 1 ? "" : "s");
  for (std::size_t i = first; i < lines.size(); ++i) text += "\n  " + shorten_line(lines[i]);
  return text;
}

}  // namespace mien

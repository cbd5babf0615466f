#include "render/failure.hpp"

#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <cctype>
#include <cstring>

namespace mien {

namespace {

constexpr int kLastLines = 12;  // lines of output in a message: an error and what led to it

bool is_safe_in_shell(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) || std::strchr("_-+=./,:@%", letter) != nullptr;
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
  for (std::size_t i = first; i < lines.size(); ++i) text += "\n  " + lines[i];
  return text;
}

}  // namespace mien

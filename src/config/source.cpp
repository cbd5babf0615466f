// The form of UTF-8: RFC 3629, section 4.
#include "config/source.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstring>

#include "config/load_spec.hpp"
#include "core/signals.hpp"
#include "core/utf8.hpp"

namespace mien {

namespace {

struct Closer {
  int descriptor;
  ~Closer() { ::close(descriptor); }
};

constexpr int kPoll_ms = 50;  // how late a signal to another thread is noticed

// Reads at most kMaxFileBytes + 1 bytes, so that an endless device ends too; returns 0 or the error number. A
// pipe is waited for until somebody has written it and closed it, or a signal comes; then throws Interrupted.
int read_bounded(const std::filesystem::path& file, std::string& bytes) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return errno;
  const Closer closer{descriptor};
  bytes.resize(kMaxFileBytes + 1);
  std::size_t size = 0;
  int error = 0;
  while (size < bytes.size()) {
    throw_if_interrupted();
    pollfd waited{descriptor, POLLIN, 0};
    if (::poll(&waited, 1, kPoll_ms) <= 0) continue;
    const ssize_t count = ::read(descriptor, bytes.data() + size, bytes.size() - size);
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (count < 0) error = errno;
    if (count <= 0) break;
    size += static_cast<std::size_t>(count);
  }
  bytes.resize(size);
  return error;
}

bool is_control(std::uint32_t code) {
  if (code == '\n' || code == '\t' || code == 0x85) return false;
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0xFFFE || code == 0xFFFF;
}

// "\r\n" and "\r" become "\n".
std::string unify_line_ends(const std::string& bytes) {
  std::string text;
  text.reserve(bytes.size());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (bytes[i] != '\r')
      text += bytes[i];
    else if (i + 1 == bytes.size() || bytes[i + 1] != '\n')
      text += '\n';
  }
  return text;
}

// The first character that no text holds, as a mistake; false if there is one.
bool is_clean_text(const SourceText& source, Findings& findings) {
  int line = 1, column = 1;
  for (std::size_t at = 0; at < source.text.size();) {
    const Character character = find_character(source.text, at);
    if (character.length == 0 || is_control(character.code)) {
      const unsigned byte = static_cast<unsigned char>(source.text[at]);
      const std::string found =
          character.length == 0
              ? fmt::format("byte 0x{:02X} is not UTF-8; expected a file saved as UTF-8", byte)
              : fmt::format("control character U+{:04X}; expected plain text", character.code);
      // The line itself is not shown: it is no text that a terminal should be given.
      add_mistake(findings, {source.file, line, column}, found, {});
      return false;
    }
    at += character.length;
    ++column;
    if (character.code == '\n') ++line, column = 1;
  }
  return true;
}

bool is_indented_by_spaces(const SourceText& source, Findings& findings) {
  bool is_right = true;
  for (int line = 1; line <= static_cast<int>(source.line_starts.size()); ++line) {
    const std::string_view text = find_line(source, line);
    const std::size_t content = text.find_first_not_of(" \t");
    const std::size_t tab = text.find('\t');
    if (content == std::string_view::npos || text[content] == '#' || tab > content) continue;
    add_mistake(findings, source, {line, static_cast<int>(tab)}, "tab in the indentation; expected spaces");
    is_right = false;
  }
  return is_right;
}

}  // namespace

std::optional<SourceText> load_source(const std::filesystem::path& file, Findings& findings) {
  std::string bytes;
  findings.files.push_back(file);
  if (const int error = read_bounded(file, bytes)) {
    add_mistake(findings, {file.string(), 0, 0}, fmt::format("cannot read: {}", std::strerror(error)), {});
    return std::nullopt;
  }
  return build_source(file.string(), std::move(bytes), findings);
}

std::optional<SourceText> build_source(std::string file, std::string bytes, Findings& findings) {
  if (bytes.size() > kMaxFileBytes) {
    add_mistake(findings, {file, 0, 0},
                fmt::format("larger than {} bytes; expected a note, not data", kMaxFileBytes), {});
    return std::nullopt;
  }
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
    add_mistake(findings, {file, 1, 1}, "the file is UTF-16; expected a file saved as UTF-8", {});
    return std::nullopt;
  }
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);

  SourceText source{std::move(file), unify_line_ends(bytes), {0}};
  for (std::size_t at = source.text.find('\n'); at != std::string::npos; at = source.text.find('\n', at + 1))
    source.line_starts.push_back(at + 1);
  if (!is_clean_text(source, findings) || !is_indented_by_spaces(source, findings)) return std::nullopt;
  return source;
}

std::string_view find_line(const SourceText& source, int line) {
  const auto& starts = source.line_starts;
  if (line < 1 || line > static_cast<int>(starts.size())) return {};
  const std::size_t start = starts[line - 1];
  const std::size_t end = line < static_cast<int>(starts.size()) ? starts[line] - 1 : source.text.size();
  return std::string_view(source.text).substr(start, end - start);
}

Place find_place(const SourceText& source, Spot spot) {
  const std::string_view line = find_line(source, spot.line);
  const std::string_view before = line.substr(0, static_cast<std::size_t>(std::max(0, spot.byte)));
  return {source.file, spot.line, 1 + static_cast<int>(count_characters(before))};
}

void add_mistake(Findings& findings, const SourceText& source, Spot spot, std::string message) {
  if (is_full(findings))
    ++findings.untold;  // counting the column of each would take long on a long line
  else
    add_mistake(findings, find_place(source, spot), std::move(message), find_line(source, spot.line));
}

}  // namespace mien

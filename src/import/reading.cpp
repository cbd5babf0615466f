#include "import/reading.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"

namespace mien {

bool read_line(LineReader& reader) {
  if (reader.rest.empty()) return false;
  const std::size_t end = reader.rest.find('\n');
  reader.line = reader.rest.substr(0, end);
  // What is left has its place in the file even when it is empty: binary data begin there.
  reader.rest.remove_prefix(std::min(end, reader.rest.size() - 1) + 1);
  if (reader.line.ends_with('\r')) reader.line.remove_suffix(1);
  ++reader.number;
  return true;
}

void split_words(std::string_view line, std::vector<std::string_view>& words) {
  words.clear();
  while (true) {
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return;
    line.remove_prefix(begin);
    const std::size_t length = std::min(line.find_first_of(" \t"), line.size());
    words.push_back(line.substr(0, length));
    line.remove_prefix(length);
  }
}

std::optional<double> parse_coordinate(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  // Numbers too small for a double are as good as 0.
  if (error == std::errc::result_out_of_range && word.find("e-") != word.npos) return 0.0;
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<long long> parse_index(std::string_view word) {
  long long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

std::uint32_t parse_point_number(const std::string& file, int line, std::string_view word, std::size_t count,
                                 const char* user) {
  const auto index = parse_index(word.substr(0, word.find('/')));
  if (!index)
    fail_line(
        file, line,
        fmt::format("'{}' names no point; expected a number from 1, as in f 1 2 3 4", show_found(word)));
  const auto known = static_cast<long long>(count);
  if (*index == 0) fail_line(file, line, fmt::format("a {} names point 0; expected numbers from 1", user));
  const long long at = *index > 0 ? *index - 1 : known + *index;
  if (at < 0 || at >= static_cast<long long>(kMaxGeometryPoints))
    fail_line(file, line,
              fmt::format("a {} names point {}; expected numbers from 1 to {}", user, *index, count));
  return static_cast<std::uint32_t>(at);
}

std::string show_found(std::string_view word) {
  constexpr std::size_t kMaxShown = 24;  // letters; more are no word
  std::string shown;
  for (const char c : word.substr(0, kMaxShown)) shown += c >= ' ' && c < 127 ? c : '?';
  return word.size() > kMaxShown ? shown + "..." : shown;
}

std::string count_bytes(std::size_t count) { return fmt::format("{} byte{}", count, count == 1 ? "" : "s"); }

void fail_file(const std::string& file, const std::string& message) { fail_line(file, 0, message); }

void fail_line(const std::string& file, int line, const std::string& message) {
  throw InputError(std::vector<Diagnostic>{{{file, line, 0}, message, "", false}});
}

std::string read_plain_file(const std::filesystem::path& path, const std::string& file,
                            const std::string& expected, std::uintmax_t most) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) fail_file(file, "there is no such file; expected " + expected);
  if (fs::is_directory(status)) fail_file(file, "is a folder; expected " + expected);
  if (!fs::is_regular_file(status)) fail_file(file, "is no plain file; expected " + expected);
  const std::uintmax_t size = fs::file_size(path, error);
  if (!error && size > most) fail_file(file, fmt::format("has {} bytes; expected {} at most", size, most));
  try {
    return read_file(path);
  } catch (const RunError&) {
    fail_file(file, "cannot be read; expected a file that you may read");
  }
}

glm::dvec3 parse_position(const std::string& file, int line, std::string_view x, std::string_view y,
                          std::string_view z) {
  glm::dvec3 position{0};
  int axis = 0;
  for (const std::string_view word : {x, y, z}) {
    const auto value = parse_coordinate(word);
    if (!value || std::abs(*value) > kMaxCoordinate)
      fail_line(
          file, line,
          fmt::format("'{}' is no coordinate; expected a number from -1000000 to 1000000", show_found(word)));
    position[axis++] = *value;
  }
  return position;
}

void check_position(const std::string& file, std::size_t offset, const glm::dvec3& position) {
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(position[axis]) || std::abs(position[axis]) > kMaxCoordinate)
      fail_file(file,
                fmt::format("the point at byte {} has the {} {:.7g}; expected a number from -1000000 to "
                            "1000000",
                            offset, "xyz"[axis], position[axis]));
}

void check_point_count(const std::string& file, int line, std::size_t count) {
  if (count > kMaxGeometryPoints)
    fail_line(file, line, fmt::format("more than {} points; expected fewer", kMaxGeometryPoints));
}

}  // namespace mien

#include "core/text.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>
#include <vector>

#include "core/error.hpp"
#include "core/thousandths.hpp"

namespace mien {

namespace {

constexpr std::array<double, 10> kPowersOfTen{1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

constexpr std::array<std::uint32_t, 10> kWholePowersOfTen{1,      10,      100,      1000,      10000,
                                                          100000, 1000000, 10000000, 100000000, 1000000000};

// "00" to "99" in a row.
constexpr std::array<char, 200> build_pairs() {
  std::array<char, 200> pairs{};
  for (std::size_t i = 0; i < 100; ++i) {
    pairs[2 * i] = static_cast<char>('0' + i / 10);
    pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
  }
  return pairs;
}
constexpr std::array<char, 200> kPairs = build_pairs();

// The digits of `value`, at least one, so that they end before `end`; returns where they begin.
char* write_digits(std::uint32_t value, char* end) {
  while (value >= 100) {
    end -= 2;
    std::memcpy(end, &kPairs[std::size_t{2} * (value % 100)], 2);
    value /= 100;
  }
  if (value < 10) {
    *--end = static_cast<char>('0' + value);
    return end;
  }
  end -= 2;
  std::memcpy(end, &kPairs[std::size_t{2} * value], 2);
  return end;
}

[[noreturn]] void fail_write(const std::filesystem::path& path, int error) {
  throw RunError(fmt::format("cannot write {}: {}", path.string(), std::strerror(error)));
}

bool has_content(const std::filesystem::path& path, std::string_view content) {
  std::error_code ignored;
  if (std::filesystem::file_size(path, ignored) != content.size() || ignored) return false;
  return read_file(path) == content;
}

// How often a half-made file may vanish under us before that is an error: whoever clears a folder of what
// dead runs left may take ours for one of theirs between two of our calls.
constexpr int kMostTries = 3;

// Writes all of `content` to a new file and flushes it; returns 0 or the error number. While it is written it
// is locked, so that others see that somebody lives who writes it.
int write_flushed(const std::string& path, std::string_view content) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return errno;
  ::flock(file, LOCK_SH | LOCK_NB);
  int error = 0;
  while (!content.empty() && error == 0) {
    const ssize_t written = ::write(file, content.data(), content.size());
    if (written >= 0)
      content.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      error = errno;
  }
  if (::close(file) != 0 && error == 0) error = errno;
  return error;
}

}  // namespace

char* write_number(char* text, double value, int decimals) {
  if (decimals == 3)
    if (char* const end = write_thousandths(text, value)) return end;
  if (!std::isfinite(value) || std::abs(value) >= 1e9)
    throw RunError(fmt::format("internal: {} is not a number that can be written", value));
  const bool is_negative = value < 0;
  // Half away from zero, as std::llround; the cast is several times quicker, and scenes hold millions of
  // numbers.
  const auto rest = static_cast<std::uint64_t>(std::abs(value) * kPowersOfTen[decimals] + 0.5);
  if (rest == 0) {
    *text = '0';
    return text + 1;
  }
  // Written from the back, two digits at a time: fraction digits without zeros at their end, point, then the
  // whole digits, at least one.
  const std::uint32_t power = kWholePowersOfTen[decimals];
  const bool is_short = rest <= std::numeric_limits<std::uint32_t>::max();  // divided in a third of the time
  const auto whole =
      static_cast<std::uint32_t>(is_short ? static_cast<std::uint32_t>(rest) / power : rest / power);
  auto fraction = static_cast<std::uint32_t>(rest - std::uint64_t{whole} * power);
  std::array<char, std::size_t{2} * kLongestNumber>
      digits;  // the rest is there to be copied along, at a fixed size
  char* const end = digits.data() + kLongestNumber;
  char* begin = end;
  if (fraction != 0) {
    int count = decimals;
    for (; fraction % 10 == 0; --count) fraction /= 10;
    char* const point = end - count;
    begin = write_digits(fraction, end);
    while (begin > point) *--begin = '0';
    *--begin = '.';
  }
  begin = write_digits(whole, begin);
  if (is_negative) *--begin = '-';
  std::memcpy(text, begin, kLongestNumber);
  return text + (end - begin);
}

void append_number(std::string& text, double value, int decimals) {
  std::array<char, kLongestNumber> number;
  text.append(number.data(),
              static_cast<std::size_t>(write_number(number.data(), value, decimals) - number.data()));
}

std::string format_number(double value, int decimals) {
  std::string text;
  append_number(text, value, decimals);
  return text;
}

std::string read_file(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    throw RunError(fmt::format("cannot read {}: it is a folder", path.string()));
  std::ifstream file(path, std::ios::binary);
  if (!file) throw RunError(fmt::format("cannot read {}: {}", path.string(), std::strerror(errno)));
  std::ostringstream content;
  content << file.rdbuf();
  return std::move(content).str();
}

void write_file(const std::filesystem::path& path, std::string_view content) {
  if (has_content(path, content)) return;
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  if (error) fail_write(path, error.value());

  const std::string beside = fmt::format("{}.{}.part", path.string(), ::getpid());
  int number = ENOENT;
  for (int i = 0; i < kMostTries && number == ENOENT; ++i) {
    number = write_flushed(beside, content);
    if (number == 0 && ::rename(beside.c_str(), path.c_str()) != 0) number = errno;
  }
  if (number == 0) return;
  ::unlink(beside.c_str());
  fail_write(path, number);
}

std::string fill_template(std::string_view text, const std::map<std::string, std::string>& values,
                          std::string_view origin) {
  std::string filled;
  std::set<std::string> used;
  while (true) {
    const std::size_t open = text.find("{{");
    if (open == std::string_view::npos) break;
    const std::size_t close = text.find("}}", open);
    if (close == std::string_view::npos)
      throw RunError(fmt::format("{}: a placeholder is opened with '{{{{' and never closed", origin));
    const std::string name(text.substr(open + 2, close - open - 2));
    const auto value = values.find(name);
    if (value == values.end()) throw RunError(fmt::format("{}: unknown placeholder '{}'", origin, name));
    filled += text.substr(0, open);
    filled += value->second;
    used.insert(name);
    text.remove_prefix(close + 2);
  }
  for (const auto& [name, value] : values)
    if (!used.contains(name)) throw RunError(fmt::format("{}: placeholder '{}' is missing", origin, name));
  return filled += text;
}

std::string find_nearest(std::string_view word, const std::vector<std::string>& names) {
  std::string nearest;
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& name : names) {
    // Optimal string alignment: insert, delete, replace, swap neighbours; three rows are enough.
    std::vector<std::size_t> before(name.size() + 1), above(name.size() + 1), row(name.size() + 1);
    for (std::size_t j = 0; j <= name.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= word.size(); ++i) {
      before = above;
      above = row;
      row[0] = i;
      for (std::size_t j = 1; j <= name.size(); ++j) {
        row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (word[i - 1] != name[j - 1])});
        if (i > 1 && j > 1 && word[i - 1] == name[j - 2] && word[i - 2] == name[j - 1])
          row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    if (row[name.size()] < least) {
      least = row[name.size()];
      nearest = name;
    }
  }
  return nearest;
}

std::string find_ending(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

std::string hash_hex(std::string_view content) {
  return fmt::format("{:016x}", XXH64(content.data(), content.size(), 0));
}

}  // namespace mien

#include "import/mouth_reading.hpp"

#include <fmt/format.h>
#include <utf8cpp/utf8.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/utf8.hpp"
#include "import/reading.hpp"

namespace mien {

namespace {

constexpr std::string_view kBlanksInLine = " \t";

// Praat writes what is no ASCII so, with the mark in front.
std::string convert_sixteen(const std::string& file, std::string_view bytes, bool is_big) {
  if (bytes.size() % 2 != 0)
    fail_file(file, fmt::format("is UTF-16 and has {} bytes; expected two a letter", bytes.size()));
  std::vector<std::uint16_t> units;
  units.reserve(bytes.size() / 2);
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    const auto first = static_cast<unsigned char>(bytes[i]),
               second = static_cast<unsigned char>(bytes[i + 1]);
    units.push_back(static_cast<std::uint16_t>(is_big ? first << 8 | second : second << 8 | first));
  }
  std::string text;
  try {
    utf8::utf16to8(units.begin() + 1, units.end(), std::back_inserter(text));
  } catch (const utf8::exception&) {
    fail_file(file, "is no UTF-16, as its first bytes say; expected UTF-8, or UTF-16 with its mark");
  }
  return text;
}

// Line ends of Windows and of old Macs become those of all others, in place.
void make_line_ends_one(std::string& text) {
  std::size_t to = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
    text[to++] = text[i] == '\r' ? '\n' : text[i];
  }
  text.resize(to);
}

std::string_view find_text_line(const MouthText& text, int line) {
  const std::size_t begin = text.line_starts[static_cast<std::size_t>(line - 1)];
  const std::string_view rest = std::string_view(text.text).substr(begin);
  return rest.substr(0, rest.find('\n'));
}

}  // namespace

MouthText build_mouth_text(std::string file, std::string bytes) {
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
    bytes = convert_sixteen(file, bytes, bytes.front() == '\xFE');
  else if (bytes.starts_with("\xEF\xBB\xBF"))
    bytes.erase(0, 3);
  make_line_ends_one(bytes);
  MouthText text{std::move(file), std::move(bytes), {0}};
  for (std::size_t i = 0; i < text.text.size(); ++i)
    if (text.text[i] == '\n') text.line_starts.push_back(i + 1);
  const auto wrong = utf8::find_invalid(text.text.begin(), text.text.end());
  if (wrong != text.text.end())
    fail_at(text, static_cast<std::size_t>(wrong - text.text.begin()),
            fmt::format("the byte {:02X} is no UTF-8; expected a text in UTF-8, or in UTF-16 with its mark",
                        static_cast<unsigned char>(*wrong)));
  const auto control = std::ranges::find_if(
      text.text, [](unsigned char c) { return (c < 0x20 && c != '\t' && c != '\n') || c == 0x7F; });
  if (control != text.text.end())
    fail_at(
        text, static_cast<std::size_t>(control - text.text.begin()),
        fmt::format("the control character {:02X}; expected a text", static_cast<unsigned char>(*control)));
  return text;
}

void fail_at(const MouthText& text, std::size_t at, const std::string& message) {
  constexpr std::size_t kLongestShown = 200;  // bytes; more than a terminal's line helps nobody
  const int line = find_line_number(text, at);
  std::string_view shown = find_text_line(text, line);
  const std::string_view before = shown.substr(0, at - text.line_starts[static_cast<std::size_t>(line - 1)]);
  const int column = 1 + static_cast<int>(count_characters(before));
  const bool is_text = shown.size() <= kLongestShown && utf8::is_valid(shown.begin(), shown.end());
  throw InputError(std::vector<Diagnostic>{
      {{text.file, line, column}, message, is_text ? std::string(shown) : std::string(), false}});
}

void fail_at_end(const MouthText& text, const std::string& message) {
  const std::size_t last = text.text.find_last_not_of(" \t\n");
  fail_at(text, last == std::string::npos ? 0 : last + 1, message);
}

int find_line_number(const MouthText& text, std::size_t at) {
  return static_cast<int>(std::ranges::upper_bound(text.line_starts, at) - text.line_starts.begin());
}

std::string show_words(std::string_view words) {
  constexpr std::size_t kMostShown = 24;  // characters; more are no word
  std::size_t end = 0;
  for (std::size_t count = 0; end < words.size() && count < kMostShown; ++count) {
    const std::size_t length = find_character(words, end).length;
    if (length == 0) break;
    end += length;
  }
  std::string shown(words.substr(0, end));
  std::ranges::replace(shown, '\n', ' ');
  return end < words.size() ? shown + "..." : shown;
}

bool read_text_line(const MouthText& text, std::size_t& next, MouthWord& line) {
  if (next >= text.text.size()) return false;
  const std::size_t end = std::min(text.text.find('\n', next), text.text.size());
  line = {std::string_view(text.text).substr(next, end - next), next};
  next = end + 1;
  return true;
}

bool read_full_line(const MouthText& text, std::size_t& next, MouthWord& line) {
  while (read_text_line(text, next, line))
    if (line.word.find_first_not_of(kBlanksInLine) != std::string_view::npos) return true;
  return false;
}

MouthWord trim_word(MouthWord word) {
  constexpr std::string_view kBlanks = " \t\n";
  const std::size_t begin = std::min(word.word.find_first_not_of(kBlanks), word.word.size());
  word.word.remove_prefix(begin);
  word.word = word.word.substr(0, word.word.find_last_not_of(kBlanks) + 1);
  return {word.word, word.at + begin};
}

void split_line(MouthWord line, std::vector<MouthWord>& words) {
  words.clear();
  for (std::size_t at = line.word.find_first_not_of(kBlanksInLine); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.word.find_first_of(kBlanksInLine, at), line.word.size());
    words.push_back({line.word.substr(at, end - at), line.at + at});
    at = line.word.find_first_not_of(kBlanksInLine, end);
  }
}

double parse_seconds(const MouthText& text, MouthWord word) {
  const auto seconds = parse_coordinate(word.word);
  if (!seconds || *seconds < 0 || *seconds > kMaxMouthTime_s)
    fail_at(text, word.at,
            fmt::format("'{}' is no time; expected seconds from 0 to {}", show_words(word.word),
                        kMaxMouthTime_s));
  return *seconds;
}

void check_seconds(const MouthText& text, std::size_t at, double seconds) {
  if (!(seconds >= 0 && seconds <= kMaxMouthTime_s))
    fail_at(text, at,
            fmt::format("{:.7g} is no time; expected seconds from 0 to {}", seconds, kMaxMouthTime_s));
}

long long parse_frame(const MouthText& text, MouthWord word, long long least) {
  constexpr auto kMostFrames = static_cast<long long>(kMaxMouthTime_s * kMaxMouthRate);
  const auto frame = parse_index(word.word);
  if (!frame || *frame < least || *frame > kMostFrames)
    fail_at(text, word.at,
            fmt::format("'{}' is no frame; expected a whole number from {} to {}", show_words(word.word),
                        least, kMostFrames));
  return *frame;
}

long long parse_count(const MouthText& text, MouthWord word, const std::string& what, long long least,
                      long long most) {
  const auto count = parse_index(word.word);
  if (!count || *count < least || *count > most)
    fail_at(text, word.at,
            fmt::format("'{}' is no number of {}; expected one from {} to {}", show_words(word.word), what,
                        least, most));
  return *count;
}

double compute_frame_time(const MouthText& text, std::size_t at, long long frames, double fps) {
  const double seconds = static_cast<double>(frames) / fps;
  if (!(seconds <= kMaxMouthTime_s))
    fail_at(text, at,
            fmt::format("at {:.7g} frames a second this comes at {:.7g} s; expected {} s at most", fps,
                        seconds, kMaxMouthTime_s));
  return seconds;
}

double find_start(const MouthText& text, std::size_t at, double before_s, double from_s, double to_s) {
  constexpr double kOverlap_s = 0.001;  // programs that round an end and a beginning each for itself
  if (from_s < before_s - kOverlap_s)
    fail_at(text, at,
            fmt::format("this begins at {:.7g} s, and what is before it ends at {:.7g} s; expected rising "
                        "times",
                        from_s, before_s));
  from_s = std::max(from_s, before_s);
  if (to_s <= from_s)
    fail_at(text, at,
            fmt::format("this lasts from {:.7g} s to {:.7g} s; expected an end after its beginning", from_s,
                        to_s));
  return from_s;
}

void append_cue(const MouthText& text, std::vector<MouthCue>& cues, std::size_t at, double from_s,
                double to_s, std::string name) {
  if (cues.size() >= kMaxMouthCues)
    fail_at(text, at, fmt::format("more than {} cues; expected fewer", kMaxMouthCues));
  const double start_s = find_start(text, at, cues.empty() ? 0 : cues.back().to_s, from_s, to_s);
  cues.push_back({start_s, to_s, std::move(name), find_line_number(text, at)});
}

}  // namespace mien

// Rhubarb Lip Sync's JSON: an object with mouthCues, a list of {start, end, value}. Source:
// DanielSWolf/rhubarb-lip-sync README, "JSON format". Other keys are passed, as it asks for.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/utf8.hpp"
#include "import/mouth_reading.hpp"

namespace mien {

namespace {

constexpr std::size_t kDeepestJson = 64;  // lists and objects within each other; Rhubarb writes three

// Tells how far the parser has read, so that what it finds has a place.
struct CountedLetter {
  // NOLINTBEGIN(readability-identifier-naming): the names are the standard library's
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;
  // NOLINTEND(readability-identifier-naming)

  const char* letter = nullptr;
  const char** furthest = nullptr;

  reference operator*() const { return *letter; }
  CountedLetter& operator++() {
    *furthest = ++letter;
    return *this;
  }
  bool operator==(const CountedLetter& other) const { return letter == other.letter; }
};

struct JsonLevel {
  bool is_list = false;
  std::string key;
};

// What the parser calls, in the order of the file: its names are the library's.
struct JsonTrack {
  const MouthText& text;
  const char* furthest = nullptr;
  MouthTrack track;
  std::vector<JsonLevel> levels;
  bool has_cues = false;
  // The cue that is open, and which of its parts have been there.
  std::size_t cue_at = 0;
  double from_s = 0, to_s = 0;
  std::string shape;
  bool has_start = false, has_end = false, has_value = false;

  bool null();
  bool boolean(bool value);
  bool number_integer(std::int64_t value);
  bool number_unsigned(std::uint64_t value);
  bool number_float(double value, const std::string& written);
  bool string(std::string& value);
  bool binary(nlohmann::json::binary_t& value);
  bool start_object(std::size_t count);
  bool key(std::string& name);
  bool end_object();
  bool start_array(std::size_t count);
  bool end_array();
  bool parse_error(std::size_t position, const std::string& token, const nlohmann::json::exception& why);
};

// Where we are: "/mouthCues/[]/start".
std::string find_json_path(const JsonTrack& json) {
  std::string path;
  for (const JsonLevel& level : json.levels) path += level.is_list ? "/[]" : "/" + level.key;
  return path;
}

std::size_t find_read(const JsonTrack& json) {
  return static_cast<std::size_t>(json.furthest - json.text.text.data());
}

// Where the string begins whose closing quote was read last.
std::size_t find_json_string(const JsonTrack& json) {
  const std::string& text = json.text.text;
  for (std::size_t at = find_read(json) - 1; at > 0;) {
    --at;
    if (text[at] != '"') continue;
    std::size_t escapes = 0;
    while (escapes < at && text[at - 1 - escapes] == '\\') ++escapes;
    if (escapes % 2 == 0) return at;
  }
  return 0;
}

// Where the number, true, false or null begins that was read last, one letter further perhaps.
std::size_t find_json_word(const JsonTrack& json) {
  const auto is_of_word = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || c == '+' || c == '-' || c == '.' || c == 'E';
  };
  const std::string& text = json.text.text;
  std::size_t at = find_read(json);
  if (at > 0 && !is_of_word(text[at - 1])) --at;
  while (at > 0 && is_of_word(text[at - 1])) --at;
  return at;
}

[[noreturn]] void fail_json_kind(const JsonTrack& json, std::size_t at, const std::string& path) {
  if (path.empty()) fail_at(json.text, at, "no object stands here; expected {\"mouthCues\": [..]}");
  const std::string name = path.substr(path.rfind('/') + 1);
  if (name == "mouthCues") fail_at(json.text, at, "'mouthCues' is no list; expected one of cues");
  if (name == "[]")
    fail_at(json.text, at, "a cue is no object; expected {\"start\": 0.1, \"end\": 0.2, \"value\": \"A\"}");
  fail_at(json.text, at,
          fmt::format("'{}' is no {}; expected {}", name, name == "value" ? "text" : "number",
                      name == "value" ? "the letter of a shape" : "seconds"));
}

// Whether the path leads to something that this reads, and then of which kind it is.
enum class JsonKind { passed, object, list, number, word };
JsonKind find_json_kind(std::string_view path) {
  if (path.empty() || path == "/mouthCues/[]") return JsonKind::object;
  if (path == "/mouthCues") return JsonKind::list;
  if (path == "/mouthCues/[]/start" || path == "/mouthCues/[]/end" || path == "/metadata/duration")
    return JsonKind::number;
  return path == "/mouthCues/[]/value" ? JsonKind::word : JsonKind::passed;
}

// The path, if what stands there is read; fails if it is of another kind.
std::string take_json_path(const JsonTrack& json, std::size_t at, JsonKind kind) {
  std::string path = find_json_path(json);
  const JsonKind expected = find_json_kind(path);
  if (expected == JsonKind::passed) return "passed";
  if (expected != kind) fail_json_kind(json, at, path);
  return path;
}

bool take_json_number(JsonTrack& json, double value) {
  const std::size_t at = find_json_word(json);
  const std::string path = take_json_path(json, at, JsonKind::number);
  if (path == "passed") return true;
  check_seconds(json.text, at, value);
  if (path == "/metadata/duration") {
    json.track.end_s = value;
  } else if (path.ends_with("start")) {
    json.from_s = value;
    json.has_start = true;
  } else {
    json.to_s = value;
    json.has_end = true;
  }
  return true;
}

void open_json_level(JsonTrack& json, bool is_list) {
  if (json.levels.size() >= kDeepestJson)
    fail_at(json.text, find_read(json) - 1,
            fmt::format("more than {} lists and objects within each other; expected fewer", kDeepestJson));
  json.levels.push_back({is_list, {}});
}

void close_json_cue(JsonTrack& json) {
  for (const auto& [has, name] :
       {std::pair{json.has_start, "start"}, {json.has_end, "end"}, {json.has_value, "value"}})
    if (!has)
      fail_at(json.text, json.cue_at, fmt::format("a cue without '{}'; expected start, end and value", name));
  append_cue(json.text, json.track.cues, json.cue_at, json.from_s, json.to_s, std::move(json.shape));
}

bool JsonTrack::null() {
  take_json_path(*this, find_json_word(*this), JsonKind::passed);
  return true;
}

bool JsonTrack::boolean(bool) { return null(); }

bool JsonTrack::number_integer(std::int64_t value) {
  return take_json_number(*this, static_cast<double>(value));
}

bool JsonTrack::number_unsigned(std::uint64_t value) {
  return take_json_number(*this, static_cast<double>(value));
}

bool JsonTrack::number_float(double value, const std::string&) { return take_json_number(*this, value); }

bool JsonTrack::string(std::string& value) {
  const std::size_t at = find_json_string(*this);
  if (take_json_path(*this, at, JsonKind::word) == "passed") return true;
  check_mouth_name(text, MouthNames::rhubarb, {value, at + 1});
  shape = value;
  has_value = true;
  return true;
}

bool JsonTrack::binary(nlohmann::json::binary_t&) { return true; }  // JSON as text has none

bool JsonTrack::start_object(std::size_t) {
  const std::string path = take_json_path(*this, find_read(*this) - 1, JsonKind::object);
  if (path == "/mouthCues/[]") {
    cue_at = find_read(*this) - 1;
    has_start = has_end = has_value = false;
  }
  open_json_level(*this, false);
  return true;
}

bool JsonTrack::key(std::string& name) {
  // Those that are read are short words; a path of others would cost time, or be taken for one of theirs.
  constexpr std::size_t kLongestKey = 16;
  levels.back().key = name.size() <= kLongestKey && name.find('/') == name.npos ? name : "other";
  return true;
}

bool JsonTrack::end_object() {
  levels.pop_back();
  if (find_json_path(*this) == "/mouthCues/[]") close_json_cue(*this);
  return true;
}

bool JsonTrack::start_array(std::size_t) {
  if (take_json_path(*this, find_read(*this) - 1, JsonKind::list) == "/mouthCues") has_cues = true;
  open_json_level(*this, true);
  return true;
}

bool JsonTrack::end_array() {
  levels.pop_back();
  return true;
}

bool JsonTrack::parse_error(std::size_t, const std::string&, const nlohmann::json::exception& why) {
  constexpr int kTooLarge = 406;  // the library's number of it
  const std::size_t last = text.text.find_last_not_of(" \t\n"), read = find_read(*this);
  if (why.id == kTooLarge)
    fail_at(text, find_json_word(*this), "a number that is too large; expected seconds");
  if (read > last) fail_at_end(text, "the file ends within its JSON; expected the rest");
  // A string has been read up to its end, a number one letter further, all else up to the wrong letter.
  std::size_t at = read == 0 ? 0 : read - 1;
  while (at > 0 && (text.text[at] == ' ' || text.text[at] == '\n' || text.text[at] == '\t')) --at;
  while (at > 0 && !is_first_of_character(text.text[at])) --at;
  if (text.text[at] == '"') at = std::min(at, find_json_string(*this));
  const std::string_view rest = std::string_view(text.text).substr(at);
  fail_at(text, at,
          fmt::format("'{}' cannot stand here; expected JSON as Rhubarb writes it",
                      rest.substr(0, find_character(rest, 0).length)));
}

}  // namespace

MouthTrack read_rhubarb_json(const MouthText& text) {
  JsonTrack json{text, text.text.data(), {}, {}, false, 0, 0, 0, {}, false, false, false};
  const char* begin = text.text.data();
  nlohmann::json::sax_parse(CountedLetter{begin, &json.furthest},
                            CountedLetter{begin + text.text.size(), &json.furthest}, &json);
  if (!json.has_cues) fail_at(text, 0, "the object has no mouthCues; expected what Rhubarb writes");
  if (!json.track.cues.empty()) json.track.end_s = std::max(json.track.end_s, json.track.cues.back().to_s);
  return std::move(json.track);
}

}  // namespace mien

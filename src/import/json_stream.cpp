#include "import/json_stream.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/utf8.hpp"
#include "import/reading.hpp"

namespace mien {

namespace {

constexpr std::size_t kDeepestStream = 64;      // takes have six
constexpr std::size_t kLongestText = 16 << 10;  // bytes; names are short, notes are not much longer
constexpr std::size_t kLongestStreamKey = 64;   // longer ones are none that is read

// The file's letters, and the place of the token that was begun last.
struct JsonLetters {
  std::string file;
  std::streambuf* buffer = nullptr;
  JsonSpot now, token, last;  // of the letter that is next; of the token; of the letter that was read
  char letter = 0;            // that one
  bool is_in_text = false, is_escaped = false, is_between = true;
  std::size_t text_length = 0;

  void pass(char c);
};

void JsonLetters::pass(char c) {
  if (is_first_of_character(c)) last = now;
  letter = c;
  if (is_in_text) {
    if (++text_length > kLongestText)
      fail_json(file, token, fmt::format("a text of more than {} bytes; expected a word", kLongestText));
    if (is_escaped)
      is_escaped = false;
    else if (c == '\\')
      is_escaped = true;
    else if (c == '"')
      is_in_text = false;
  } else if (c == '"' || c == '{' || c == '[') {
    token = now;
    is_in_text = c == '"';
    is_between = true;
    text_length = 0;
  } else if (std::string_view(" \t\r\n,:]}").find(c) != std::string_view::npos) {
    is_between = true;
  } else {
    if (is_between) token = now;
    is_between = false;
  }
  if (c == '\n') {
    ++now.line;
    now.column = 1;
  } else if (is_first_of_character(c)) {
    ++now.column;
  }
}

struct JsonLetter {
  // NOLINTBEGIN(readability-identifier-naming): the names are the standard library's
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = char;
  // NOLINTEND(readability-identifier-naming)

  JsonLetters* letters = nullptr;  // null: the end

  bool is_end() const {
    return letters == nullptr || letters->buffer->sgetc() == std::char_traits<char>::eof();
  }
  char operator*() const { return static_cast<char>(letters->buffer->sgetc()); }
  JsonLetter& operator++() {
    letters->pass(static_cast<char>(letters->buffer->sbumpc()));
    return *this;
  }
  bool operator==(const JsonLetter& other) const { return is_end() == other.is_end(); }
  bool operator!=(const JsonLetter& other) const { return is_end() != other.is_end(); }
};

// What the parser calls: its names are the library's.
struct JsonCalls {
  JsonLetters& letters;
  const JsonUse& use;
  std::vector<JsonStep> steps = {};

  bool null() { return true; }
  bool boolean(bool) { return true; }
  bool number_integer(std::int64_t value) { return take(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) { return take(static_cast<double>(value)); }
  bool number_float(double value, const std::string&) { return take(value); }
  bool string(std::string& value) {
    if (use.text) use.text(steps, value, letters.token);
    return true;
  }
  bool binary(nlohmann::json::binary_t&) { return true; }  // JSON as text has none
  bool start_object(std::size_t) { return open(false); }
  bool key(std::string& name) {
    steps.back().key = name.size() <= kLongestStreamKey ? name : std::string("other");
    return true;
  }
  bool end_object() { return close(); }
  bool start_array(std::size_t) { return open(true); }
  bool end_array() { return close(); }
  bool parse_error(std::size_t position, const std::string& token, const nlohmann::json::exception& why);

  bool take(double value) {
    if (!std::isfinite(value))
      fail_json(letters.file, letters.token, "a number that is too large; expected one of a take");
    if (use.number) use.number(steps, value, letters.token);
    return true;
  }
  bool open(bool is_list) {
    if (steps.size() >= kDeepestStream)
      fail_json(
          letters.file, letters.token,
          fmt::format("more than {} lists and objects within each other; expected fewer", kDeepestStream));
    const int role = use.open(steps, is_list, letters.token);
    steps.push_back({is_list, {}, role, letters.token});
    return true;
  }
  bool close() {
    if (use.close) use.close(steps, steps.back().spot);
    steps.pop_back();
    return true;
  }
};

bool JsonCalls::parse_error(std::size_t, const std::string&, const nlohmann::json::exception& why) {
  constexpr int kTooLarge = 406;  // the library's number of it
  if (why.id == kTooLarge)
    fail_json(letters.file, letters.token, "a number that is too large; expected one of a take");
  if (std::string_view(why.what()).find("end of input") != std::string_view::npos)
    fail_json(letters.file, letters.now, "the file ends within its JSON; expected the rest");
  fail_json(letters.file, letters.last,
            fmt::format("'{}' cannot stand here; expected JSON", show_found({&letters.letter, 1})));
}

}  // namespace

void fail_json(const std::string& file, JsonSpot spot, const std::string& message) {
  throw InputError(std::vector<Diagnostic>{{{file, spot.line, spot.column}, message, "", false}});
}

void read_json_stream(const std::filesystem::path& path, const std::string& expected, const JsonUse& use) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail_file(path.string(), "cannot be read; expected " + expected);
  JsonLetters letters;
  letters.file = path.string();
  letters.buffer = stream.rdbuf();
  for (const char mark : {'\xEF', '\xBB', '\xBF'})
    if (letters.buffer->sgetc() == static_cast<unsigned char>(mark)) letters.buffer->sbumpc();
  if (letters.buffer->sgetc() == std::char_traits<char>::eof())
    fail_file(letters.file, "is empty; expected " + expected);
  JsonCalls calls{letters, use};
  nlohmann::json::sax_parse(JsonLetter{&letters}, JsonLetter{}, &calls);
}

}  // namespace mien

// The reasons are those of yaml-cpp 0.7, exceptions.h; one that is not known here is passed on as it is.
#include "config/syntax_error.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <optional>
#include <vector>

namespace mien {

namespace {

struct Explanation {
  Spot spot;
  std::string message;
};

// Brackets and a quote that are open at a place of the text.
struct OpenMarks {
  std::vector<Spot> brackets;
  std::optional<Spot> quote;
};

char find_letter(const SourceText& source, Spot spot) {
  const std::string_view line = find_line(source, spot.line);
  return spot.byte < static_cast<int>(line.size()) ? line[spot.byte] : '\0';
}

bool is_blank(char letter) { return letter == ' ' || letter == '\t'; }

// Opens and closes what one line does. A quote or a bracket opens something only where a value may begin; a
// bracket within brackets always does.
void read_marks(std::string_view text, int line, char& quote, OpenMarks& open) {
  char before = '\0';  // the last letter that is no blank
  for (int i = 0; i < static_cast<int>(text.size()); ++i) {
    const char letter = text[i];
    if (quote != '\0') {
      const bool is_doubled = quote == '\'' && text.substr(i, 2) == "''";
      if (is_doubled || (quote == '"' && letter == '\\'))
        ++i;
      else if (letter == quote)
        quote = '\0', open.quote.reset();
      before = letter;
      continue;
    }
    if (is_blank(letter)) continue;
    if (letter == '#' && (i == 0 || is_blank(text[i - 1]))) break;
    const bool is_value_start =
        before == '\0' || std::string_view(":,[{-?").find(before) != std::string_view::npos;
    if ((letter == '&' || letter == '!') && is_value_start) {
      while (i + 1 < static_cast<int>(text.size()) && !is_blank(text[i + 1]))
        ++i;  // the value is still to come
      continue;
    }
    if ((letter == '"' || letter == '\'') && is_value_start) {
      quote = letter;
      open.quote = Spot{line, i};
    } else if ((letter == '[' || letter == '{') && (is_value_start || !open.brackets.empty())) {
      open.brackets.push_back({line, i});
    } else if ((letter == ']' || letter == '}') && !open.brackets.empty()) {
      open.brackets.pop_back();
    }
    before = letter;
  }
}

// What is open just before `end`.
OpenMarks find_open_marks(const SourceText& source, Spot end) {
  OpenMarks open;
  char quote = '\0';
  const int last = std::min(end.line, static_cast<int>(source.line_starts.size()));
  for (int line = 1; line <= last; ++line) {
    const std::string_view text = find_line(source, line);
    read_marks(line == end.line ? text.substr(0, static_cast<std::size_t>(end.byte)) : text, line, quote,
               open);
  }
  return open;
}

// An unquoted "#rrggbb" between the two spots: it is a comment and swallows what closes the bracket.
std::optional<Spot> find_swallowing_colour(const SourceText& source, Spot from, Spot to) {
  for (int line = from.line; line <= to.line; ++line) {
    const std::string_view text = find_line(source, line);
    const std::size_t hash = text.find(" #");
    if (hash == std::string_view::npos || (line == from.line && static_cast<int>(hash) < from.byte)) continue;
    const std::string_view word = text.substr(hash + 2, 6);
    if (word.size() == 6 && word.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos)
      return Spot{line, static_cast<int>(hash) + 1};
  }
  return std::nullopt;
}

Spot find_end(const SourceText& source) {
  const int last = static_cast<int>(source.line_starts.size());
  return {last, static_cast<int>(find_line(source, last).size())};
}

// True if nothing but blanks stands from the spot on. yaml-cpp gives 1:1 for some of its ends.
bool is_at_end(const SourceText& source, Spot spot) {
  const std::size_t offset = source.line_starts[spot.line - 1] + static_cast<std::size_t>(spot.byte);
  return offset == 0 || source.text.find_first_not_of(" \t\n", offset) == std::string::npos;
}

Explanation explain_quote(const SourceText& source, Spot quote) {
  return {quote, fmt::format("this quote is never closed; expected {}", find_letter(source, quote))};
}

// A list or a mapping in brackets that goes on where it should not.
Explanation explain_flow(const SourceText& source, Spot spot, bool is_mapping) {
  const bool is_last = is_at_end(source, spot);
  if (const auto quote = find_open_quote(source); is_last && quote) return explain_quote(source, *quote);
  const Spot end = is_last ? find_end(source) : spot;
  const std::vector<Spot> brackets = find_open_marks(source, end).brackets;
  const char closer = is_mapping ? '}' : ']';
  const Spot opener = brackets.empty() ? spot : brackets.back();
  if (const auto colour = find_swallowing_colour(source, opener, end))
    return {*colour, "'#' begins a comment here; expected a colour in quotes, such as \"#dcae8f\""};
  if (is_last || brackets.empty())
    return {opener, fmt::format("'{}' is never closed; expected '{}'", is_mapping ? '{' : '[', closer)};
  // A ':' further down is the next key's.
  if (find_letter(source, spot) == ':' && spot.line > opener.line)
    return {opener, fmt::format("'{}' is not closed; expected ',' or '{}' before line {}",
                                find_letter(source, opener), closer, spot.line)};
  return {spot, fmt::format("unexpected text; expected ',' or '{}' for the '{}' of line {}", closer,
                            find_letter(source, opener), opener.line)};
}

Explanation explain_flow_end(const SourceText& source, Spot spot) {
  const std::vector<Spot> brackets = find_open_marks(source, spot).brackets;
  const char found = find_letter(source, spot);
  if (brackets.empty()) return {spot, fmt::format("'{}' closes nothing", found)};
  const char opener = find_letter(source, brackets.back());
  return {spot, fmt::format("'{}' does not close the '{}' of line {}; expected '{}'", found, opener,
                            brackets.back().line, opener == '{' ? '}' : ']')};
}

bool has_key(std::string_view line) {
  return line.find(": ") != std::string_view::npos || line.ends_with(':');
}

// A ':' where no key can end: two on a line, a line above without one, or a line indented by accident.
Explanation explain_map_value(const SourceText& source, Spot spot) {
  const std::string_view line = find_line(source, spot.line);
  if (line.substr(0, static_cast<std::size_t>(spot.byte)).find(": ") != std::string_view::npos)
    return {spot, "a second ':' on the line; expected quotes around a text that holds ': '"};
  int above = spot.line - 1;
  std::size_t content = std::string_view::npos;
  for (; above >= 1; --above) {
    content = find_line(source, above).find_first_not_of(' ');
    if (content != std::string_view::npos && find_line(source, above)[content] != '#') break;
  }
  if (above < 1) return {spot, "unexpected ':'; expected 'key: value'"};
  if (!has_key(find_line(source, above)))
    return {{above, static_cast<int>(content)}, "this line has no ': '; expected 'key: value'"};
  const std::size_t indent = line.find_first_not_of(' ');
  if (indent > content && indent != std::string_view::npos)
    return {{spot.line, static_cast<int>(indent)},
            "this line is indented deeper than the one above, which has its value; expected the same "
            "indentation"};
  return {spot, "unexpected ':'; expected 'key: value'"};
}

Explanation explain_block(const SourceText& source, Spot spot) {
  const std::string_view line = find_line(source, spot.line);
  const std::string_view before = line.substr(0, static_cast<std::size_t>(spot.byte));
  if (before.find_first_not_of(' ') == std::string_view::npos) {
    if (find_letter(source, spot) == '-') return {spot, "a list item stands where a key is expected"};
    return {spot, "this line's indentation fits none of the lines above"};
  }
  if (before.ends_with('"') || before.ends_with('\'') || before.ends_with("\" ") || before.ends_with("' "))
    return {spot, "text after a closing quote; expected the end of the value"};
  return {spot, "unexpected text; expected the end of the value"};
}

std::string find_word(const SourceText& source, Spot spot) {
  const std::string_view rest = find_line(source, spot.line).substr(static_cast<std::size_t>(spot.byte));
  return show_word(rest.substr(0, rest.find_first_of(" \t,]}")));
}

Explanation explain(const SourceText& source, Spot spot, const std::string& reason) {
  if (reason == "end of map flow not found") return explain_flow(source, spot, true);
  if (reason == "end of sequence flow not found") return explain_flow(source, spot, false);
  if (reason == "illegal flow end") return explain_flow_end(source, spot);
  if (reason == "illegal map value") return explain_map_value(source, spot);
  if (reason == "end of map not found" || reason == "end of sequence not found")
    return explain_block(source, spot);
  if (reason == "illegal block entry")
    return {spot, "a list item begins here; expected it on a line of its own"};
  if (reason == "illegal EOF in scalar" || reason == "illegal document indicator in scalar") {
    const auto quote = find_open_quote(source);
    return quote ? explain_quote(source, *quote) : Explanation{spot, "a text in quotes is not closed here"};
  }
  if (reason == "unknown token")
    return {spot, fmt::format("unexpected '{}'; expected a word, a number or a text in quotes",
                              show_word(std::string(1, find_letter(source, spot))))};
  if (reason.starts_with("unknown escape character"))
    return {spot, "unknown escape; expected '\\\\' for a backslash between double quotes"};
  if (reason == "the referenced anchor is not defined") {
    const std::string word = find_word(source, spot);
    return {spot, fmt::format("unknown alias '{}'; expected an anchor '&{}' above", word,
                              word.empty() ? word : word.substr(1))};
  }
  return {spot, "this is no YAML: " + reason};
}

}  // namespace

std::optional<Spot> find_open_quote(const SourceText& source) {
  return find_open_marks(source, find_end(source)).quote;
}

void add_syntax_error(Findings& findings, const SourceText& source, Spot spot, const std::string& reason) {
  // At the end of the text yaml-cpp may stand on a line that is none.
  if (spot.line > static_cast<int>(source.line_starts.size())) spot = find_end(source);
  spot.byte = std::min(spot.byte, static_cast<int>(find_line(source, spot.line).size()));
  Explanation explanation = explain(source, spot, reason);
  add_mistake(findings, source, explanation.spot, std::move(explanation.message));
}

}  // namespace mien

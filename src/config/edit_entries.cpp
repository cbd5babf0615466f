#include "config/edit_entries.hpp"

#include <algorithm>

namespace mien {

namespace {

const std::string& words_of(const EditText& text) { return text.document.source.text; }

std::string take_range(const EditText& text, Range range) {
  return words_of(text).substr(range.begin, range.end - range.begin);
}

bool is_list_node(const EditText& text, std::uint32_t node) {
  return text.document.nodes[node].kind == NodeKind::list;
}

// The lines of an entry, each but the first begun at its column.
std::string build_block(const EntryWords& entry, int column, bool is_item) {
  const std::vector<std::string> lines = entry.block.empty() ? std::vector{entry.flow} : entry.block;
  std::string words;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i > 0) words += "\n" + std::string(static_cast<std::size_t>(column), ' ');
    if (is_item) words += i == 0 ? "- " : "  ";
    words += lines[i];
  }
  return words;
}

bool is_blank_line(const EditText& text, std::size_t begin) {
  return begin <= words_of(text).size() &&
         words_of(text).find_first_not_of(" \t", begin) >= find_line_end(text, begin);
}

// Whether a section of the file that begins there has a blank line above it, and above its comments.
bool is_set_apart(const EditText& text, std::size_t at) {
  for (std::size_t begin = find_line_begin(text, at); begin > 0;) {
    begin = find_line_begin(text, begin - 1);
    if (is_blank_line(text, begin)) return true;
    if (words_of(text)[words_of(text).find_first_not_of(' ', begin)] != '#') return false;
  }
  return false;
}

// Where an entry's last line ends, comments behind it that are indented deeper than the entry with it.
std::size_t find_entry_end(const EditText& text, std::uint32_t owner, std::size_t entry) {
  const std::size_t column = static_cast<std::size_t>(text.document.nodes[owner].spot.byte);
  std::size_t end = find_line_end(text, find_entry(text, owner, entry).end);
  while (end < words_of(text).size()) {
    const std::size_t first = words_of(text).find_first_not_of(' ', end + 1);
    if (first == std::string::npos || words_of(text)[first] != '#' || first - end - 1 <= column) break;
    end = find_line_end(text, first);
  }
  return end;
}

// A section of the file between others that have blank lines between them has one too.
bool needs_blank_line(const EditText& text, std::uint32_t owner, std::size_t entry, const EntryWords& words) {
  const bool is_section = !words.block.empty() || words.flow.ends_with('}') || words.flow.ends_with(']');
  if (owner != text.document.root || !is_section) return false;
  if (entry == count_entries(text, owner))
    return is_set_apart(text, find_entry(text, owner, entry - 1).begin);
  const std::size_t end = find_entry_end(text, owner, entry - 1);
  return is_blank_line(text, end + 1);
}

Splice insert_block(const EditText& text, std::uint32_t owner, std::size_t entry, const EntryWords& words) {
  const int column = text.document.nodes[owner].spot.byte;
  const bool is_list = is_list_node(text, owner);
  const std::string indent(static_cast<std::size_t>(column), ' '),
      block = build_block(words, column, is_list);
  if (entry > 0) {
    const std::size_t at = find_entry_end(text, owner, entry - 1);
    return {{at, at}, (needs_blank_line(text, owner, entry, words) ? "\n\n" : "\n") + indent + block};
  }
  const std::size_t at = is_list ? find_item_dash(text, owner, 0) : find_entry(text, owner, 0).begin;
  return {{at, at}, block + "\n" + indent};
}

Splice insert_flow(const EditText& text, std::uint32_t owner, std::size_t entry, const std::string& words) {
  const std::size_t count = count_entries(text, owner);
  if (count == 0) {
    const std::size_t at = text.ranges[owner].begin + 1;
    return {{at, at}, words};
  }
  const Range next = find_entry(text, owner, std::min(entry, count - 1));
  const bool is_own_line = is_first_of_line(text, next.begin);
  const std::string line = "\n" + std::string(static_cast<std::size_t>(find_column(text, next.begin)), ' ');
  if (entry < count) return {{next.begin, next.begin}, words + (is_own_line ? "," + line : ", ")};
  if (!is_own_line) return {{next.end, next.end}, ", " + words};
  const std::size_t comma = skip_blanks(text, next.end);
  const bool has_comma =
      words_of(text)[comma] == ',' && find_line_end(text, comma) == find_line_end(text, next.end);
  const std::size_t end = has_comma ? comma + 1 : next.end;
  if (!is_rest_comment(text, end)) return {{next.end, next.end}, "," + line + words};
  const std::size_t line_end = find_line_end(text, end);
  if (has_comma) return {{line_end, line_end}, line + words + ","};
  return {{end, line_end}, "," + take_range(text, {end, line_end}) + line + words};
}

// Behind the ':' of an entry's key, or the '-' of an item.
std::size_t find_value_begin(const EditText& text, std::uint32_t owner, std::size_t entry) {
  if (is_list_node(text, owner)) return find_item_dash(text, owner, entry) + 1;
  const std::uint32_t key = text.document.nodes[owner].children[2 * entry];
  const std::size_t colon = words_of(text).find(':', text.ranges[key].end);
  return colon == std::string::npos ? text.ranges[key].end : colon + 1;
}

// Where the words of a line end before its comment.
std::size_t find_words_end(const EditText& text, std::size_t from) {
  const std::size_t line_end = find_line_end(text, from);
  std::size_t end = from;
  for (std::size_t at = from; at < line_end; ++at) {
    const char letter = words_of(text)[at];
    if (letter == '#' && (words_of(text)[at - 1] == ' ' || words_of(text)[at - 1] == '\t')) break;
    if (letter != ' ' && letter != '\t') end = at + 1;
  }
  return end;
}

// All lines of an entry that has them for itself, with the end of the last.
Range find_entry_lines(const EditText& text, std::uint32_t owner, std::size_t entry) {
  const std::size_t begin =
      is_list_node(text, owner) ? find_item_dash(text, owner, entry) : find_entry(text, owner, entry).begin;
  const std::size_t end = find_line_end(text, find_entry(text, owner, entry).end);
  return {find_line_begin(text, begin), std::min(end + 1, words_of(text).size())};
}

// At the end of a text without a last line end the one before goes.
Range shift_to_end(const EditText& text, Range lines) {
  const bool is_cut = lines.end == words_of(text).size() && lines.begin > 0 && words_of(text).back() != '\n';
  return is_cut ? Range{lines.begin - 1, lines.end} : lines;
}

Splice remove_lines(const EditText& text, std::uint32_t owner, std::size_t entry) {
  Range lines = find_entry_lines(text, owner, entry);
  const bool is_section = owner == text.document.root && !is_list_node(text, owner);
  const bool is_last = lines.end == words_of(text).size();
  if (is_section && lines.begin > 0 && is_blank_line(text, find_line_begin(text, lines.begin - 1)) &&
      (is_last || is_blank_line(text, lines.end)))
    lines.begin = find_line_begin(text, lines.begin - 1);
  return {shift_to_end(text, lines), ""};
}

Splice remove_flow(const EditText& text, std::uint32_t owner, std::size_t entry) {
  const Range range = find_entry(text, owner, entry);
  if (entry + 1 < count_entries(text, owner))
    return {{range.begin, find_entry(text, owner, entry + 1).begin}, ""};
  const std::size_t before = find_entry(text, owner, entry - 1).end;
  const std::size_t comma = skip_blanks(text, before);
  // What is said behind the entry before stays.
  const std::string between = take_range(text, {comma + 1, range.begin});
  const std::size_t kept = between.find_last_not_of(" \t\n");
  std::string words = take_range(text, {before, comma});
  if (kept != between.npos) {
    words += between.substr(0, kept + 1);
    if (!is_rest_comment(text, range.end))
      words += "\n" + std::string(static_cast<std::size_t>(find_column(text, range.begin)), ' ');
  }
  return {{before, range.end}, words};
}

}  // namespace

int find_indent_step(const EditText& text) {
  constexpr int kUsual = 2;
  if (text.is_empty || is_in_brackets(text, text.document.root)) return kUsual;
  for (std::size_t i = 0; i < count_entries(text, text.document.root); ++i) {
    const std::uint32_t value = find_entry_value(text, text.document.root, i);
    const YamlNode& node = text.document.nodes[value];
    if (node.kind == NodeKind::mapping && !is_in_brackets(text, value) && node.spot.byte > 0)
      return node.spot.byte;
  }
  return kUsual;
}

Splice insert_entry(const EditText& text, std::uint32_t owner, std::size_t entry, const EntryWords& words) {
  return is_in_brackets(text, owner) ? insert_flow(text, owner, entry, words.flow)
                                     : insert_block(text, owner, entry, words);
}

Splice fill_absent(const EditText& text, std::uint32_t owner, std::size_t entry, const EntryWords& words,
                   bool is_list) {
  const Range range = find_entry(text, owner, entry);
  if (is_in_brackets(text, owner) || is_list_node(text, owner)) {
    const std::string flow = is_list ? "[" + words.flow + "]" : "{" + words.flow + "}";
    return replace_value(text, owner, entry, flow);
  }
  const int column = find_column(text, range.begin) + find_indent_step(text);
  const std::size_t at = find_line_end(text, range.end);
  return {{at, at},
          "\n" + std::string(static_cast<std::size_t>(column), ' ') + build_block(words, column, is_list)};
}

Splice replace_value(const EditText& text, std::uint32_t owner, std::size_t entry, const std::string& value) {
  const std::uint32_t node = find_entry_value(text, owner, entry);
  const Range range = text.ranges[node];
  if (is_absent(text, node)) {
    const bool has_colon =
        is_list_node(text, owner) || (range.begin > 0 && words_of(text)[range.begin - 1] == ':');
    return {range, (has_colon ? " " : ": ") + value};
  }
  const NodeKind kind = text.document.nodes[node].kind;
  const bool is_block = (kind == NodeKind::list || kind == NodeKind::mapping) && !is_in_brackets(text, node);
  if (!is_block || !is_first_of_line(text, range.begin)) return {range, value};
  // Lines of its own: the value goes up to the key, before what is said there.
  const std::size_t at = find_words_end(text, find_value_begin(text, owner, entry));
  return {{at, find_line_end(text, range.end)},
          " " + value + take_range(text, {at, find_line_end(text, at)})};
}

Splice remove_entry(const EditText& text, std::uint32_t owner, std::size_t entry) {
  if (is_in_brackets(text, owner)) return remove_flow(text, owner, entry);
  const Range range = find_entry(text, owner, entry);
  const std::size_t begin = is_list_node(text, owner) ? find_item_dash(text, owner, entry) : range.begin;
  if (is_first_of_line(text, begin)) return remove_lines(text, owner, entry);
  // It stands behind a '-': the next one goes there.
  const Range next = find_entry(text, owner, entry + 1);
  return {{begin, is_list_node(text, owner) ? find_item_dash(text, owner, entry + 1) : next.begin}, ""};
}

Splice move_item(const EditText& text, std::uint32_t list, std::size_t from, std::size_t before) {
  // Items from `first` to `last` change places; of them the moved one is the first or the last.
  const std::size_t first = std::min(from, before), last = from < before ? before - 1 : from;
  std::vector<Range> ranges;
  for (std::size_t i = first; i <= last; ++i)
    ranges.push_back(is_in_brackets(text, list) ? find_entry(text, list, i)
                                                : find_entry_lines(text, list, i));
  const Range all{ranges.front().begin, ranges.back().end};
  if (is_in_brackets(text, list)) {
    // Commas and comments stay where they are.
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < ranges.size(); ++i) order.push_back(i);
    if (from == first)
      std::rotate(order.begin(), order.begin() + 1, order.end());
    else
      std::rotate(order.begin(), order.end() - 1, order.end());
    std::string words;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      if (i > 0) words += take_range(text, {ranges[i - 1].end, ranges[i].begin});
      words += take_range(text, ranges[order[i]]);
    }
    return {all, words};
  }
  const Range item = from == first ? ranges.front() : ranges.back();
  std::string moved = take_range(text, item);
  std::string others =
      from == first ? take_range(text, {item.end, all.end}) : take_range(text, {all.begin, item.begin});
  for (std::string* lines : {&moved, &others})
    if (!lines->ends_with('\n')) *lines += '\n';
  std::string words = from == first ? others + moved : moved + others;
  if (words_of(text)[all.end - 1] != '\n') words.pop_back();
  return {all, words};
}

std::string quote_key(const std::string& key) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '.' || c == '/' || c == '-';
  };
  const bool is_word = !key.empty() && key.front() != '-' && key != "null" && key != "Null" &&
                       key != "NULL" && std::ranges::all_of(key, is_plain);
  if (is_word) return key;
  std::string quoted = "\"";
  for (const char letter : key) {
    if (letter == '"' || letter == '\\') quoted += '\\';
    quoted += letter;
  }
  return quoted + "\"";
}

}  // namespace mien

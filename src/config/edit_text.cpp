#include "config/edit_text.hpp"

#include <fmt/format.h>
#include <algorithm>

namespace mien {

namespace {

constexpr std::string_view kBlanks = " \t", kGaps = " \t\n";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool is_one_of(char letter, std::string_view letters) { return letters.find(letter) != letters.npos; }

std::size_t find_offset(const SourceText& source, Spot spot) {
  return source.line_starts[static_cast<std::size_t>(spot.line - 1)] + static_cast<std::size_t>(spot.byte);
}

// Measures the nodes one after another. A value's end is where its own words end in the text.
class Ruler {
 public:
  explicit Ruler(EditText& text) : text_(text), document_(text.document), words_(document_.source.text) {}

  // `indent`: of the lines that a text over several lines must be deeper than; -1 at the top.
  std::size_t measure(std::uint32_t index, int indent) {
    const YamlNode& node = document_.nodes[index];
    const std::size_t begin = find_offset(document_.source, node.spot);
    std::size_t end = begin;
    if (node.kind == NodeKind::text)
      end = find_text_end(node, begin, indent);
    else if (node.kind == NodeKind::list || node.kind == NodeKind::mapping)
      end = find_collection_end(node, begin);
    else
      end = std::min(words_.find_first_of(" \t\n,]}", begin), words_.size());
    text_.ranges[index] = {begin, end};
    return end;
  }

 private:
  std::size_t find_quote_end(std::size_t at) const {
    const char quote = words_[at];
    for (++at; at < words_.size(); ++at) {
      const bool is_escape = quote == '"' && words_[at] == '\\';
      const bool is_twice = quote == '\'' && words_.compare(at, 2, "''") == 0;
      if (is_escape || is_twice)
        ++at;
      else if (words_[at] == quote)
        return at + 1;
    }
    return words_.size();
  }

  // Of a text behind '|' or '>': the last line that is indented deeper.
  std::size_t find_block_end(std::size_t at, int indent) const {
    std::size_t end = std::min(words_.find('\n', at), words_.size());
    for (std::size_t line = end; line < words_.size();) {
      const std::size_t begin = line + 1, next = std::min(words_.find('\n', begin), words_.size());
      const std::size_t first = words_.find_first_not_of(' ', begin);
      line = next;
      if (first >= next) continue;  // a blank line
      if (static_cast<int>(first - begin) <= indent) break;
      end = next;
    }
    return end;
  }

  // A plain text may run over lines, which are one blank in `node.text` then.
  std::size_t find_plain_end(const YamlNode& node, std::size_t at) const {
    for (std::size_t i = 0; i < node.text.size() && at < words_.size();) {
      if (is_one_of(node.text[i], kGaps)) {
        while (i < node.text.size() && is_one_of(node.text[i], kGaps)) ++i;
        while (at < words_.size() && is_one_of(words_[at], kGaps)) ++at;
      } else {
        if (node.text[i] != words_[at]) break;
        ++i, ++at;
      }
    }
    return at;
  }

  std::size_t find_text_end(const YamlNode& node, std::size_t at, int indent) const {
    if (!node.is_quoted || at >= words_.size()) return find_plain_end(node, at);
    if (words_[at] == '|' || words_[at] == '>') return find_block_end(at, indent);
    return find_quote_end(at);
  }

  // Behind the ':' of a key that ends at a byte; there if it has none.
  std::size_t skip_colon(std::size_t at) const {
    const std::size_t colon = words_.find_first_not_of(kGaps, at);
    return colon != words_.npos && words_[colon] == ':' ? colon + 1 : at;
  }

  std::size_t find_collection_end(const YamlNode& node, std::size_t begin) {
    const bool is_list = node.kind == NodeKind::list;
    const bool is_flow = words_[begin] == (is_list ? '[' : '{');
    std::size_t end = is_flow ? begin + 1 : begin;
    const std::vector<std::uint32_t> children = node.children;
    const int indent = node.spot.byte;
    for (std::size_t i = 0; i < children.size(); ++i) {
      const bool is_value = is_list || i % 2 == 1;
      if (is_value && is_absent(text_, children[i])) {
        const std::size_t at = find_offset(document_.source, document_.nodes[children[i]].spot);
        end = is_list ? at + (words_[at] == '-' ? 1 : 0) : skip_colon(end);
        text_.ranges[children[i]] = {end, end};
      } else {
        end = measure(children[i], indent);
      }
    }
    if (!is_flow) return end;
    for (end = skip_blanks(text_, end); end < words_.size() && words_[end] == ',';)
      end = skip_blanks(text_, end + 1);
    return std::min(end + 1, words_.size());
  }

  EditText& text_;
  const YamlDocument& document_;
  const std::string& words_;
};

bool has_words(const SourceText& source) {
  for (int line = 1; line <= static_cast<int>(source.line_starts.size()); ++line) {
    const std::string_view words = find_line(source, line);
    const std::size_t first = words.find_first_not_of(kBlanks);
    if (first != words.npos && words[first] != '#') return true;
  }
  return false;
}

void refuse_unread(const Findings& findings) {
  if (findings.mistakes.empty()) return;
  const Diagnostic& mistake = findings.mistakes.front();
  throw InputError(
      fmt::format("the text cannot be read for changes: line {}: {}", mistake.place.line, mistake.message));
}

// Where each line of the bytes begins, as the document counts lines.
std::vector<std::size_t> list_line_begins(const std::string& bytes) {
  std::vector<std::size_t> begins{bytes.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const bool is_pair = bytes[i] == '\r' && i + 1 < bytes.size() && bytes[i + 1] == '\n';
    if ((bytes[i] == '\n' || bytes[i] == '\r') && !is_pair) begins.push_back(i + 1);
  }
  return begins;
}

// How the text ends its lines: as the first.
std::string find_line_ending(const std::string& bytes) {
  const std::size_t first = bytes.find_first_of("\r\n");
  if (first == bytes.npos || bytes[first] == '\n') return "\n";
  return first + 1 < bytes.size() && bytes[first + 1] == '\n' ? "\r\n" : "\r";
}

const YamlNode& node_of(const EditText& text, std::uint32_t node) { return text.document.nodes[node]; }

}  // namespace

EditText open_text(const std::string& bytes) {
  EditText text;
  text.bytes = bytes;
  Findings findings;
  std::optional<SourceText> source = build_source("", bytes, findings);
  refuse_unread(findings);
  if (!has_words(*source)) {
    text.is_empty = true;
    text.document.source = std::move(*source);
    return text;
  }
  std::optional<YamlDocument> document = scan_document(std::move(*source), findings);
  refuse_unread(findings);
  text.document = std::move(*document);
  text.ranges.resize(text.document.nodes.size());
  Ruler(text).measure(text.document.root, -1);
  for (const YamlNode& node : text.document.nodes)
    if (node.kind == NodeKind::alias) text.repeated.insert(node.target);
  return text;
}

bool is_in_brackets(const EditText& text, std::uint32_t node) {
  const char first = text.document.source.text[text.ranges[node].begin];
  return first == (node_of(text, node).kind == NodeKind::list ? '[' : '{');
}

bool is_absent(const EditText& text, std::uint32_t node) {
  if (node_of(text, node).kind != NodeKind::nothing) return false;
  const std::string& words = text.document.source.text;
  const std::size_t at = find_offset(text.document.source, node_of(text, node).spot);
  const std::string_view word = std::string_view(words)
                                    .substr(std::min(at, words.size()))
                                    .substr(0, words.find_first_of(" \t\n,]}", at) - at);
  // Where it is absent this is its key, or the '-' of its item.
  return word != "~" && word != "null" && word != "Null" && word != "NULL";
}

std::size_t count_entries(const EditText& text, std::uint32_t node) {
  const YamlNode& owner = node_of(text, node);
  return owner.kind == NodeKind::list ? owner.children.size() : owner.children.size() / 2;
}

Range find_entry(const EditText& text, std::uint32_t node, std::size_t entry) {
  const YamlNode& owner = node_of(text, node);
  if (owner.kind == NodeKind::list) return text.ranges[owner.children[entry]];
  return {text.ranges[owner.children[2 * entry]].begin, text.ranges[owner.children[2 * entry + 1]].end};
}

std::uint32_t find_entry_value(const EditText& text, std::uint32_t node, std::size_t entry) {
  const YamlNode& owner = node_of(text, node);
  return owner.children[owner.kind == NodeKind::list ? entry : 2 * entry + 1];
}

std::size_t find_item_dash(const EditText& text, std::uint32_t list, std::size_t entry) {
  const std::size_t column = static_cast<std::size_t>(node_of(text, list).spot.byte);
  std::size_t begin = find_line_begin(text, find_entry(text, list, entry).begin);
  const std::string& words = text.document.source.text;
  const auto has_dash = [&](std::size_t line) {
    return line + column < words.size() && line + column < find_line_end(text, line) &&
           words[line + column] == '-';
  };
  while (!has_dash(begin) && begin > text.ranges[list].begin) begin = find_line_begin(text, begin - 1);
  return begin + column;
}

Trail find_trail(const EditText& text, const YamlPath& path) {
  Trail trail;
  trail.nodes.push_back(text.document.root);
  for (std::size_t step = 0;; ++step) {
    const std::uint32_t index = trail.nodes.back();
    const YamlNode& node = node_of(text, index);
    if (node.kind == NodeKind::alias)
      throw InputError(
          fmt::format("{} is an alias; expected a value of its own to change", describe_path(path, step)));
    if (text.repeated.contains(index))
      check_unrepeated(text, text.ranges[index], {path.begin(), path.begin() + step});
    if (step == path.size()) return trail;
    const bool is_collection = node.kind == NodeKind::list || node.kind == NodeKind::mapping;
    if (!is_collection) return trail;
    if (is_in_brackets(text, index)) trail.is_in_brackets = true;
    std::optional<std::size_t> entry;
    for (std::size_t i = 0; i < count_entries(text, index) && !entry; ++i) {
      const std::string* key = std::get_if<std::string>(&path[step]);
      const std::size_t* number = std::get_if<std::size_t>(&path[step]);
      if (node.kind == NodeKind::mapping && key != nullptr &&
          node_of(text, node.children[2 * i]).text == *key)
        entry = i;
      if (node.kind == NodeKind::list && number != nullptr && *number == i) entry = i;
    }
    if (!entry) return trail;
    trail.entries.push_back(*entry);
    trail.nodes.push_back(find_entry_value(text, index, *entry));
  }
}

void check_unrepeated(const EditText& text, Range range, const YamlPath& path) {
  for (std::size_t i = 0; i < text.document.nodes.size(); ++i) {
    const YamlNode& node = text.document.nodes[i];
    if (node.kind != NodeKind::alias) continue;
    const std::size_t target = text.ranges[node.target].begin, alias = text.ranges[i].begin;
    const bool is_alias_in = alias >= range.begin && alias < range.end;
    const bool is_target_in = target == range.begin || (target > range.begin && target < range.end);
    if (is_alias_in || !is_target_in) continue;
    throw InputError(
        fmt::format("an alias on line {} repeats {}, or a part of it; expected a value that stands once",
                    node.spot.line, path.empty() ? "the file" : describe_path(path)));
  }
}

std::size_t find_line_begin(const EditText& text, std::size_t at) {
  const std::string& words = text.document.source.text;
  const std::size_t before = at == 0 ? words.npos : words.rfind('\n', at - 1);
  return before == words.npos ? 0 : before + 1;
}

std::size_t find_line_end(const EditText& text, std::size_t at) {
  return std::min(text.document.source.text.find('\n', at), text.document.source.text.size());
}

bool is_first_of_line(const EditText& text, std::size_t at) {
  const std::size_t begin = find_line_begin(text, at);
  return text.document.source.text.find_first_not_of(' ', begin) >= at;
}

int find_column(const EditText& text, std::size_t at) {
  return static_cast<int>(at - find_line_begin(text, at));
}

bool is_rest_comment(const EditText& text, std::size_t at) {
  const std::string& words = text.document.source.text;
  const std::size_t first = words.find_first_not_of(kBlanks, at);
  return first == words.npos || words[first] == '\n' || words[first] == '#';
}

std::size_t skip_blanks(const EditText& text, std::size_t at) {
  const std::string& words = text.document.source.text;
  for (;;) {
    at = std::min(words.find_first_not_of(kGaps, at), words.size());
    if (at == words.size() || words[at] != '#') return at;
    at = find_line_end(text, at);
  }
}

std::string replace_range(const EditText& text, Range range, const std::string& words) {
  const std::vector<std::size_t> begins = list_line_begins(text.bytes);
  const std::vector<std::size_t>& starts = text.document.source.line_starts;
  const auto find_byte = [&](std::size_t at) {
    const auto line = std::ranges::upper_bound(starts, at) - starts.begin() - 1;
    return begins[static_cast<std::size_t>(line)] + at - starts[static_cast<std::size_t>(line)];
  };
  const std::string ending = find_line_ending(text.bytes);
  std::string bytes = text.bytes.substr(0, find_byte(range.begin));
  for (const char letter : words)
    if (letter == '\n')
      bytes += ending;
    else
      bytes += letter;
  return bytes + text.bytes.substr(find_byte(range.end));
}

std::string describe_path(const YamlPath& path, std::size_t steps) {
  if (steps == 0) return "the file";
  std::string words;
  for (std::size_t i = 0; i < steps; ++i)
    if (const auto* number = std::get_if<std::size_t>(&path[i]))
      words += fmt::format("[{}]", *number);
    else
      words += (words.empty() ? "" : ".") + show_word(std::get<std::string>(path[i]));
  return "'" + words + "'";
}

std::string describe_path(const YamlPath& path) { return describe_path(path, path.size()); }

}  // namespace mien

#include "config/scan.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <fmt/format.h>
#include <algorithm>
#include <sstream>
#include <unordered_map>

#include "config/load_spec.hpp"
#include "config/syntax_error.hpp"

namespace mien {

namespace {

// Ends a scan whose mistake is told.
struct ScanEnd {};

// Opening brackets that are still open: yaml-cpp looks far ahead and would keep a token for each.
constexpr int kMaxOpenBrackets = 1000;

Spot find_spot(const YAML::Mark& mark) { return {std::max(0, mark.line) + 1, std::max(0, mark.column)}; }

// Where the value itself begins, after an anchor or a tag on its line.
Spot skip_properties(const SourceText& source, Spot spot) {
  const std::string_view line = find_line(source, spot.line);
  std::size_t at = static_cast<std::size_t>(spot.byte);
  while (at < line.size() && (line[at] == '&' || line[at] == '!')) {
    const std::size_t blank = line.find_first_of(" \t", at);
    const std::size_t next = line.find_first_not_of(" \t", blank);
    if (blank == std::string_view::npos || next == std::string_view::npos || line[next] == '#') return spot;
    at = next;
  }
  return {spot.line, static_cast<int>(at)};
}

// True if a null is written out at the spot; the mark of an absent one is wherever the parser stood.
bool is_written_null(const SourceText& source, Spot spot) {
  const std::string_view line = find_line(source, spot.line);
  if (spot.byte >= static_cast<int>(line.size())) return false;
  const std::string_view rest = line.substr(static_cast<std::size_t>(spot.byte));
  const std::string_view word = rest.substr(0, rest.find_first_of(" \t,]}:"));
  return word == "~" || word == "null" || word == "Null" || word == "NULL";
}

// An absent item of a list has no place of its own; its '-' is the one an author looks at.
Spot find_dash(const SourceText& source, Spot spot) {
  std::string_view line = find_line(source, spot.line);
  const bool is_in_brackets =
      spot.byte < static_cast<int>(line.size()) && (line[spot.byte] == ',' || line[spot.byte] == ']');
  if (is_in_brackets) return spot;
  line = line.substr(0, static_cast<std::size_t>(spot.byte));
  for (int above = spot.line; above >= 1; line = find_line(source, --above)) {
    const std::string_view text = line.substr(0, line.find(" #"));
    const std::size_t last = text.find_last_not_of(" \t");
    if (last == std::string_view::npos || text[text.find_first_not_of(" \t")] == '#') continue;
    return text[last] == '-' ? Spot{above, static_cast<int>(last)} : spot;
  }
  return spot;
}

class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(YamlDocument& document, Findings& findings) : document_(document), findings_(findings) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ == 1) return;
    const Spot spot = find_spot(mark);
    const bool is_marked = find_line(document_.source, spot.line).starts_with("---");
    end_scan(spot, is_marked ? "a second document begins; expected one document a file"
                             : "this does not belong to what stands above it; check the indentation");
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    append_node(NodeKind::nothing, mark, "", anchor);
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    YamlNode& node = document_.nodes[append_node(NodeKind::text, mark, tag, anchor)];
    node.text = value;
    node.is_quoted = tag == "!";
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const Spot spot = find_spot(mark);
    if (++aliases_ > kMaxAliases) end_scan(spot, fmt::format("more than {} aliases", kMaxAliases));
    const std::uint32_t target = anchors_.at(anchor);
    const bool is_open = std::find(open_.begin(), open_.end(), target) != open_.end();
    if (is_open) report(spot, "this alias stands inside of what it repeats");
    YamlNode& node = document_.nodes[append_node(is_open ? NodeKind::broken : NodeKind::alias, mark, "", 0)];
    node.target = target;
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open_node(append_node(NodeKind::list, mark, tag, anchor));
  }
  void OnSequenceEnd() override { open_.pop_back(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open_node(append_node(NodeKind::mapping, mark, tag, anchor));
  }
  void OnMapEnd() override {
    keep_right_keys(document_.nodes[open_.back()]);
    open_.pop_back();
  }

 private:
  void report(Spot spot, std::string message) {
    add_mistake(findings_, document_.source, spot, std::move(message));
  }
  [[noreturn]] void end_scan(Spot spot, std::string message) {
    report(spot, std::move(message));
    throw ScanEnd{};
  }

  void report_tag(Spot spot) {
    std::string_view rest =
        find_line(document_.source, spot.line).substr(static_cast<std::size_t>(spot.byte));
    rest.remove_prefix(std::min(rest.find('!'), rest.size()));  // an anchor may stand before it
    const std::string word = show_word(rest.substr(0, rest.find_first_of(" \t,]}")));
    report(spot, fmt::format("tag '{}'; expected a value without a tag", word));
  }

  std::uint32_t append_node(NodeKind kind, const YAML::Mark& mark, const std::string& tag,
                            YAML::anchor_t anchor) {
    const Spot spot = find_spot(mark);
    // yaml-cpp itself tags plain values "?" and quoted ones "!".
    if (!tag.empty() && tag != "?" && tag != "!") report_tag(spot);
    const std::uint32_t index = static_cast<std::uint32_t>(document_.nodes.size());
    YamlNode node;
    node.kind = kind;
    node.spot = skip_properties(document_.source, spot);
    if (!open_.empty()) {
      YamlNode& parent = document_.nodes[open_.back()];
      if (kind == NodeKind::nothing && !is_written_null(document_.source, node.spot))
        node.spot = find_absent_spot(parent, node.spot);
      parent.children.push_back(index);
    }
    document_.nodes.push_back(std::move(node));
    if (anchor != 0) anchors_[anchor] = index;
    return index;
  }

  // An absent value has no place of its own; its key's is the one an author looks at.
  Spot find_absent_spot(const YamlNode& parent, Spot spot) const {
    if (parent.kind == NodeKind::list) return find_dash(document_.source, spot);
    return parent.children.size() % 2 == 1 ? document_.nodes[parent.children.back()].spot : spot;
  }

  void open_node(std::uint32_t node) {
    if (open_.size() >= static_cast<std::size_t>(kMaxDepth))
      end_scan(document_.nodes[node].spot, fmt::format("nested deeper than {} levels", kMaxDepth));
    open_.push_back(node);
  }

  void keep_right_keys(YamlNode& mapping) {
    std::unordered_map<std::string, int> first_lines;
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i + 1 < mapping.children.size(); i += 2) {
      const YamlNode& key = document_.nodes[mapping.children[i]];
      if (key.kind == NodeKind::nothing) {
        report(key.spot, "a key is missing; expected a word before ':'");
      } else if (key.kind != NodeKind::text) {
        report(key.spot, "a key is no word; expected a plain word before ':'");
      } else if (const auto [first, is_new] = first_lines.emplace(key.text, key.spot.line); !is_new) {
        report(key.spot, fmt::format("duplicate key '{}'; it stands on line {} already", show_word(key.text),
                                     first->second));
      } else {
        kept.insert(kept.end(), {mapping.children[i], mapping.children[i + 1]});
      }
    }
    mapping.children = std::move(kept);
  }

  YamlDocument& document_;
  Findings& findings_;
  std::vector<std::uint32_t> open_;
  std::unordered_map<YAML::anchor_t, std::uint32_t> anchors_;
  int documents_ = 0;
  int aliases_ = 0;
};

// Refuses a flood of opening brackets before yaml-cpp sees it.
bool is_nested_sanely(const SourceText& source, Findings& findings) {
  int open = 0, line = 1;
  std::optional<Spot> too_deep;
  for (std::size_t at = 0; at < source.text.size() && open <= kMaxOpenBrackets; ++at) {
    const char letter = source.text[at];
    if (letter == '\n') ++line;
    if (letter == '[' || letter == '{') ++open;
    if ((letter == ']' || letter == '}') && open > 0) --open;
    if (open <= kMaxDepth) too_deep.reset();
    if (open > kMaxDepth && !too_deep) too_deep = {line, static_cast<int>(at - source.line_starts[line - 1])};
  }
  if (open <= kMaxOpenBrackets) return true;
  add_mistake(findings, source, *too_deep, fmt::format("nested deeper than {} levels", kMaxDepth));
  return false;
}

// yaml-cpp takes a quote that runs to the end of the text for a whole one.
bool is_quote_closed(const YamlDocument& document, Findings& findings) {
  const auto quote = find_open_quote(document.source);
  if (!quote) return true;
  const auto is_opened_there = [&](const YamlNode& node) {
    return node.is_quoted && node.spot.line == quote->line && node.spot.byte == quote->byte;
  };
  if (std::none_of(document.nodes.begin(), document.nodes.end(), is_opened_there)) return true;
  add_syntax_error(findings, document.source, *quote, "illegal EOF in scalar");
  return false;
}

}  // namespace

std::optional<YamlDocument> scan_document(SourceText source, Findings& findings) {
  if (!is_nested_sanely(source, findings)) return std::nullopt;
  YamlDocument document;
  document.source = std::move(source);
  TreeBuilder builder(document, findings);
  try {
    std::istringstream stream(document.source.text);
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const ScanEnd&) {
    return std::nullopt;
  } catch (const YAML::Exception& e) {
    add_syntax_error(findings, document.source, find_spot(e.mark), e.msg);
    return std::nullopt;
  }
  if (!is_quote_closed(document, findings)) return std::nullopt;
  if (document.nodes.empty() || document.nodes[document.root].kind == NodeKind::nothing) {
    add_mistake(findings, document.source, {1, 0}, "the file is empty; expected at least 'mien: 1'");
    return std::nullopt;
  }
  return document;
}

}  // namespace mien

#include "config/yaml_reader.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace mien {

namespace {

YamlValue build_value(const YamlValue& owner, std::uint32_t index, std::string path, bool is_item) {
  const YamlNode& node = owner.document->nodes[index];
  const std::uint32_t content = node.kind == NodeKind::alias ? node.target : index;
  return {owner.document, owner.findings, content, node.spot, std::move(path), is_item};
}

std::string describe_found(const YamlNode& node) {
  switch (node.kind) {
    case NodeKind::list:
      return "is a list";
    case NodeKind::mapping:
      return "is a mapping";
    case NodeKind::text:
      break;
    default:
      return "has no value";
  }
  const std::string word = show_word(node.text);
  return node.is_quoted ? fmt::format("is the text '{}'", word) : fmt::format("is '{}'", word);
}

bool is_kind(const YamlValue& value, NodeKind kind, std::string_view expected) {
  const YamlNode& node = find_node(value);
  if (node.kind == kind) return true;
  add_unexpected(value, expected);
  return false;
}

std::string format_plain(double value) { return fmt::format("{:.7g}", value); }

std::string format_unit(std::string_view unit) { return unit.empty() ? "" : fmt::format(" {}", unit); }

// What helps most: the section that has the key, a key nearly the same, a slip of the colon, or all keys.
std::string describe_unknown_key(const YamlValue& owner, const std::string& key, const Names& keys,
                                 std::string_view noun) {
  const std::string where = owner.path.empty() ? "" : fmt::format(" in '{}'", owner.path);
  const std::string start = fmt::format("unknown {} '{}'{}; ", noun, show_word(key), where);
  if (key == "<<") return start + "there are no merge keys here";
  // "turn" is a brow's move, too.
  const bool is_of_face = noun != "key" || owner.path.starts_with("expressions");
  for (const Section& section : kSections)
    if (!is_of_face && section.name != owner.path &&
        std::ranges::find(section.keys, key) != section.keys.end())
      return start + (section.name.empty() ? std::string("it belongs at the top of the file")
                                           : fmt::format("it belongs in '{}'", section.name));
  const std::string nearest = suggest_name(key, keys);
  if (!nearest.empty()) return start + fmt::format("did you mean '{}'?", nearest);
  const std::size_t colon = key.find(':');
  if (colon != std::string::npos && std::ranges::find(keys, key.substr(0, colon)) != keys.end())
    return start + "expected a space after ':'";
  return start + (keys.empty() ? "none is known here" : "known: " + join_names(keys));
}

}  // namespace

YamlValue find_root(const YamlDocument& document, Findings& findings) {
  return {&document, &findings, document.root, document.nodes[document.root].spot, "", false};
}

const YamlNode& find_node(const YamlValue& value) { return value.document->nodes[value.node]; }

std::string describe_subject(const YamlValue& value) {
  if (value.path.empty()) return "the file";
  return fmt::format("{}'{}'", value.is_item ? "an item of " : "", value.path);
}

void add_mistake(const YamlValue& value, std::string message) {
  if (find_node(value).kind == NodeKind::broken) return;
  add_mistake(*value.findings, value.document->source, value.spot, std::move(message));
}

void add_unexpected(const YamlValue& value, std::string_view expected) {
  add_mistake(value, fmt::format("{} {}; expected {}", describe_subject(value),
                                 describe_found(find_node(value)), expected));
}

YamlMapping load_free_mapping(const YamlValue& value, std::string_view expected) {
  if (!is_kind(value, NodeKind::mapping, expected)) return {};
  YamlMapping mapping;
  const auto& children = find_node(value).children;
  for (std::size_t i = 0; i < children.size(); i += 2) {
    const YamlNode& key = value.document->nodes[children[i]];
    const std::string word = show_word(key.text);
    std::string path = value.path.empty() ? word : value.path + "." + word;
    mapping.push_back({key.text, key.spot, build_value(value, children[i + 1], std::move(path), false)});
  }
  return mapping;
}

YamlMapping load_mapping(const YamlValue& value, const Names& keys, std::string_view expected,
                         std::string_view noun) {
  YamlMapping mapping = load_free_mapping(value, expected);
  std::erase_if(mapping, [&](const YamlEntry& entry) {
    if (std::ranges::find(keys, entry.key) != keys.end()) return false;
    add_mistake(*value.findings, value.document->source, entry.spot,
                is_full(*value.findings) ? "" : describe_unknown_key(value, entry.key, keys, noun));
    return true;
  });
  return mapping;
}

std::vector<YamlValue> load_list(const YamlValue& value, std::string_view expected) {
  if (!is_kind(value, NodeKind::list, expected)) return {};
  std::vector<YamlValue> items;
  for (const std::uint32_t child : find_node(value).children)
    items.push_back(build_value(value, child, value.path, true));
  return items;
}

const YamlValue* find_value(const YamlMapping& mapping, std::string_view key) {
  for (const YamlEntry& entry : mapping)
    if (entry.key == key) return &entry.value;
  return nullptr;
}

const YamlValue* find_required(const YamlMapping& mapping, std::string_view key, const YamlValue& owner,
                               std::string_view expected) {
  const YamlValue* value = find_value(mapping, key);
  if (value == nullptr && find_node(owner).kind == NodeKind::mapping)
    add_mistake(owner, fmt::format("{} has no '{}'; expected {}", describe_subject(owner), key, expected));
  return value;
}

bool load_number(const YamlValue& value, double low, double high, double& into, std::string_view unit) {
  const YamlNode& node = find_node(value);
  const auto number = node.kind == NodeKind::text && !node.is_quoted ? parse_number(node.text) : std::nullopt;
  const bool is_right = number && *number >= low && *number <= high;
  if (is_right)
    into = *number;
  else
    add_unexpected(value, fmt::format("a number from {} to {}{}", format_plain(low), format_plain(high),
                                      format_unit(unit)));
  return is_right;
}

bool load_whole(const YamlValue& value, int low, int high, int& into, std::string_view unit) {
  const YamlNode& node = find_node(value);
  const auto number = node.kind == NodeKind::text && !node.is_quoted ? parse_number(node.text) : std::nullopt;
  const bool is_right = number && *number >= low && *number <= high && *number == std::floor(*number);
  if (is_right)
    into = static_cast<int>(*number);
  else
    add_unexpected(value, fmt::format("a whole number from {} to {}{}", low, high, format_unit(unit)));
  return is_right;
}

bool load_quantity(const YamlValue& value, const Measure& measure, double low, double high, double& into) {
  const YamlNode& node = find_node(value);
  auto number = node.kind == NodeKind::text ? parse_quantity(node.text, measure) : std::nullopt;
  if (number && node.is_quoted && parse_number(node.text)) number.reset();  // "80" in quotes is a text
  const bool is_right = number && *number >= low && *number <= high;
  if (is_right)
    into = *number;
  else if (!number)
    add_unexpected(value, fmt::format("{} such as {}", measure.noun, measure.example));
  else
    add_unexpected(value, fmt::format("{} from {} to {}{}", measure.noun, format_quantity(low, measure),
                                      format_quantity(high, measure), measure.note));
  return is_right;
}

bool load_lengths(const YamlValue& value, double most_mm, glm::dvec3& into) {
  constexpr const char* kExpected = "three lengths, x y z, such as [0, -2mm, 3mm]";
  const std::vector<YamlValue> items = load_list(value, kExpected);
  if (find_node(value).kind != NodeKind::list) return false;
  if (items.size() != 3) {
    add_mistake(value, fmt::format("{} has {} item{}; expected {}", describe_subject(value), items.size(),
                                   items.size() == 1 ? "" : "s", kExpected));
    return false;
  }
  bool is_right = true;
  for (int axis = 0; axis < 3; ++axis)
    is_right &= load_quantity(items[static_cast<std::size_t>(axis)], build_length_measure(), -most_mm,
                              most_mm, into[axis]);
  return is_right;
}

bool load_colour(const YamlValue& value, glm::vec3& into) {
  const YamlNode& node = find_node(value);
  if (node.kind == NodeKind::text)
    if (const auto colour = parse_colour(node.text)) {
      into = *colour;
      return true;
    }
  // An unquoted colour is a comment to YAML and leaves nothing.
  add_unexpected(value, node.kind == NodeKind::nothing
                            ? "a colour in quotes, such as \"#dcae8f\", as '#' begins a comment"
                            : "a colour such as \"#dcae8f\"");
  return false;
}

bool load_text(const YamlValue& value, std::string_view expected, std::string& into) {
  if (!is_kind(value, NodeKind::text, expected)) return false;
  into = find_node(value).text;
  return true;
}

bool load_name(const YamlValue& value, std::string_view kind, const Names& names, std::string& into) {
  std::string word;
  if (!load_text(value, "one of: " + join_names(names), word)) return false;
  if (std::ranges::find(names, word) == names.end()) {
    add_mistake(value, describe_unknown(kind, word, names));
    return false;
  }
  into = word;
  return true;
}

}  // namespace mien

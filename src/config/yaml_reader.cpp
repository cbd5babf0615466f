#include "config/yaml_reader.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "config/constants.hpp"

namespace mien {

namespace {

// What the language lets stand under a key of the value, or as an item of it; nullptr if it says nothing.
const Forms* find_entry_forms(const YamlValue& owner, const std::string& key) {
  if (owner.forms == nullptr) return nullptr;
  if (const Form* form = find_form(*owner.forms, FormKind::section)) {
    const Key* known = find_key(*form->section, key);
    return known == nullptr ? nullptr : &known->forms;
  }
  const Form* form = find_form(*owner.forms, FormKind::map);
  return form == nullptr ? nullptr : &form->items;
}

const Forms* find_item_forms(const YamlValue& owner) {
  const Form* form = owner.forms == nullptr ? nullptr : find_form(*owner.forms, FormKind::list);
  return form == nullptr ? nullptr : &form->items;
}

YamlValue build_value(const YamlValue& owner, std::uint32_t index, std::string path, bool is_item,
                      const Forms* forms) {
  const YamlNode& node = owner.document->nodes[index];
  const std::uint32_t content = node.kind == NodeKind::alias ? node.target : index;
  return {owner.document,  owner.findings, content, node.spot,
          std::move(path), is_item,        forms,   owner.constants};
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

// What stands in place of a number.
struct FoundNumber {
  std::optional<double> number = {};
  bool is_formula = false;  // whose mistake was told if it has no number
};

FoundNumber find_number(const YamlValue& value, bool may_decide) {
  if (is_constant(value)) return {load_constant(value, may_decide), true};
  const YamlNode& node = find_node(value);
  if (node.kind != NodeKind::text || node.is_quoted) return {};
  return {parse_number(node.text), false};
}

FoundNumber find_quantity(const YamlValue& value, const Measure& measure) {
  if (is_constant(value, measure)) return {load_constant(value, measure.units.front().name == "s"), true};
  const YamlNode& node = find_node(value);
  auto number = node.kind == NodeKind::text ? parse_quantity(node.text, measure) : std::nullopt;
  if (number && node.is_quoted && parse_number(node.text)) number.reset();  // "80" in quotes is a text
  return {number, false};
}

bool is_within(const FoundNumber& found, double low, double high) {
  return found.number && *found.number >= low && *found.number <= high;
}

// Tells a number that is out of its range or of another type; of a formula that has none, all is told.
void add_unexpected_number(const YamlValue& value, const FoundNumber& found, std::string_view unit,
                           std::string_view expected) {
  if (!found.is_formula) return add_unexpected(value, expected);
  if (found.number)
    add_mistake(value, fmt::format("{} is the formula '{}', which comes to {:.7g}{}; expected {}",
                                   describe_subject(value), show_word(find_node(value).text), *found.number,
                                   unit, expected));
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
  const Sections& all = find_sections();
  for (const auto& [path, section] : std::array<std::pair<std::string_view, const Section*>, 4>{
           {{"", &all.file}, {"head", &all.head}, {"clip", &all.clip}, {"render", &all.render}}})
    if (!is_of_face && path != owner.path && find_key(*section, key) != nullptr)
      return start + (path.empty() ? std::string("it belongs at the top of the file")
                                   : fmt::format("it belongs in '{}'", path));
  const std::string suggestion = describe_suggestion(key, keys);
  if (!suggestion.empty()) return start + suggestion;
  const std::size_t colon = key.find(':');
  if (colon != std::string::npos && std::ranges::find(keys, key.substr(0, colon)) != keys.end())
    return start + "expected a space after ':'";
  return start + (keys.empty() ? "none is known here" : "known: " + join_names(keys));
}

}  // namespace

YamlValue find_root(const YamlDocument& document, Findings& findings) {
  return {&document, &findings, document.root, document.nodes[document.root].spot, "", false, nullptr, {}};
}

const Form& find_form(const YamlValue& value, FormKind kind) {
  const Form* form = value.forms == nullptr ? nullptr : find_form(*value.forms, kind);
  if (form == nullptr)
    throw std::logic_error(
        fmt::format("the language has no form {} for {}", static_cast<int>(kind), describe_subject(value)));
  return *form;
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
    mapping.push_back(
        {key.text, key.spot,
         build_value(value, children[i + 1], std::move(path), false, find_entry_forms(value, key.text))});
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

YamlMapping load_section(const YamlValue& value) {
  return load_section(value, *find_form(value, FormKind::section).section);
}

YamlMapping load_section(const YamlValue& value, const Section& section) {
  YamlMapping mapping = load_mapping(value, list_keys(section), section.expected, section.noun);
  for (YamlEntry& entry : mapping) entry.value.forms = &find_key(section, entry.key)->forms;
  return mapping;
}

std::vector<YamlValue> load_list(const YamlValue& value, std::string_view expected) {
  if (!is_kind(value, NodeKind::list, expected)) return {};
  std::vector<YamlValue> items;
  for (const std::uint32_t child : find_node(value).children)
    items.push_back(build_value(value, child, value.path, true, find_item_forms(value)));
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
  const FoundNumber found = find_number(value, false);
  const bool is_right = is_within(found, low, high);
  if (is_right)
    into = *found.number;
  else
    add_unexpected_number(
        value, found, "",
        fmt::format("a number from {} to {}{}", format_plain(low), format_plain(high), format_unit(unit)));
  return is_right;
}

bool load_whole(const YamlValue& value, int low, int high, int& into, std::string_view unit) {
  constexpr double kRoundOff = 1e-9;  // of a formula: (0.1 + 0.2)*10 is 3
  FoundNumber found = find_number(value, true);
  if (found.is_formula && found.number && std::abs(*found.number - std::round(*found.number)) < kRoundOff)
    found.number = std::round(*found.number);
  const bool is_right = is_within(found, low, high) && *found.number == std::floor(*found.number);
  if (is_right)
    into = static_cast<int>(*found.number);
  else
    add_unexpected_number(value, found, "",
                          fmt::format("a whole number from {} to {}{}", low, high, format_unit(unit)));
  return is_right;
}

bool load_quantity(const YamlValue& value, const Measure& measure, double low, double high, double& into) {
  const FoundNumber found = find_quantity(value, measure);
  const bool is_right = is_within(found, low, high);
  if (is_right)
    into = *found.number;
  else if (!found.number)
    add_unexpected_number(value, found, "", fmt::format("{} such as {}", measure.noun, measure.example));
  else
    add_unexpected_number(value, found, measure.units.front().name,
                          fmt::format("{} from {} to {}{}", measure.noun, format_quantity(low, measure),
                                      format_quantity(high, measure), measure.note));
  return is_right;
}

bool load_number(const YamlValue& value, double& into) {
  const Form& form = find_form(value, FormKind::number);
  return load_number(value, form.low, form.high, into, form.noun);
}

bool load_whole(const YamlValue& value, int& into) {
  const Form& form = find_form(value, FormKind::whole);
  return load_whole(value, static_cast<int>(form.low), static_cast<int>(form.high), into, form.noun);
}

bool load_seconds(const YamlValue& value, double& into_s) {
  const Form& form = find_form(value, FormKind::seconds);
  return load_quantity(value, build_seconds_measure(), form.low, form.high, into_s);
}

bool load_length(const YamlValue& value, double& into_mm) {
  const Form& form = find_form(value, FormKind::length);
  return load_quantity(value, build_length_measure(), form.low, form.high, into_mm);
}

bool load_angle(const YamlValue& value, double& into_deg) {
  const Form& form = find_form(value, FormKind::angle);
  return load_quantity(value, build_angle_measure(), form.low, form.high, into_deg);
}

bool load_lengths(const YamlValue& value, glm::dvec3& into_mm) {
  constexpr const char* kExpected = "three lengths, x y z, such as [0, -2mm, 3mm]";
  const Form& form = find_form(value, FormKind::lengths);
  const std::vector<YamlValue> items = load_list(value, kExpected);
  if (find_node(value).kind != NodeKind::list) return false;
  if (items.size() != 3) {
    add_mistake(value, fmt::format("{} has {} item{}; expected {}", describe_subject(value), items.size(),
                                   items.size() == 1 ? "" : "s", kExpected));
    return false;
  }
  bool is_right = true;
  for (int axis = 0; axis < 3; ++axis)
    is_right &= load_quantity(items[static_cast<std::size_t>(axis)], build_length_measure(), form.low,
                              form.high, into_mm[axis]);
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

bool load_name(const YamlValue& value, std::string& into) {
  const Form& form = find_form(value, FormKind::word);
  return load_name(value, form.noun, list_names(form.words), into);
}

bool load_yes_no(const YamlValue& value, bool& into) {
  const Form& form = find_form(value, FormKind::yes_no);
  std::string answer;
  if (!load_name(value, form.noun, list_names(form.words), answer)) return false;
  into = answer == form.words.front().name;
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

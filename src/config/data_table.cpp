#include "config/data_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

std::optional<double> find_number(const YamlNode& node) {
  if (node.kind != NodeKind::text || node.is_quoted) return std::nullopt;
  return parse_number(node.text);
}

template <typename Vector>
bool load_vector(const YamlValue& value, Vector& into) {
  const std::vector<YamlValue> items = load_row(value, static_cast<std::size_t>(Vector::length()));
  bool is_right = !items.empty();
  for (std::size_t i = 0; i < items.size(); ++i)
    if (!load_datum(items[i], into[static_cast<int>(i)])) is_right = false;
  return is_right;
}

}  // namespace

bool load_datum(const YamlValue& value, double& into) {
  const auto number = find_number(find_node(value));
  if (number)
    into = *number;
  else
    add_unexpected(value, "a number");
  return number.has_value();
}

bool load_datum(const YamlValue& value, int& into) {
  const auto number = find_number(find_node(value));
  const bool is_right = number && *number == std::floor(*number) && std::abs(*number) < 1e9;
  if (is_right)
    into = static_cast<int>(*number);
  else
    add_unexpected(value, "a whole number");
  return is_right;
}

bool load_datum(const YamlValue& value, bool& into) {
  const YamlNode& node = find_node(value);
  const bool is_right =
      node.kind == NodeKind::text && !node.is_quoted && (node.text == "true" || node.text == "false");
  if (is_right)
    into = node.text == "true";
  else
    add_unexpected(value, "true or false");
  return is_right;
}

bool load_datum(const YamlValue& value, std::string& into) { return load_text(value, "a word", into); }

bool load_datum(const YamlValue& value, glm::dvec2& into) { return load_vector(value, into); }

bool load_datum(const YamlValue& value, glm::dvec3& into) { return load_vector(value, into); }

std::vector<YamlValue> load_row(const YamlValue& value, std::size_t count) {
  const std::string expected = fmt::format("a list of {}", count);
  std::vector<YamlValue> items = load_list(value, expected);
  if (items.size() == count) return items;
  if (find_node(value).kind == NodeKind::list)
    add_mistake(value,
                fmt::format("{} has {} items; expected {}", describe_subject(value), items.size(), count));
  return {};
}

DataTable::DataTable(const YamlValue* value) {
  if (value == nullptr) return;
  value_ = *value;
  entries_ = load_free_mapping(*value, "a mapping");
}

DataTable::~DataTable() {
  for (const YamlEntry& entry : entries_) check_name(entry, "key", asked_);
}

const YamlValue* DataTable::require(const std::string& key) const {
  asked_.push_back(key);
  return value_ ? find_required(entries_, key, *value_, "a value") : nullptr;
}

const YamlValue* DataTable::find(const std::string& key) const {
  asked_.push_back(key);
  return find_value(entries_, key);
}

DataTable DataTable::at(const std::string& key) const { return DataTable(require(key)); }

YamlMapping DataTable::list(const std::string& key) const {
  const YamlValue* value = require(key);
  return value ? load_free_mapping(*value, "a mapping") : YamlMapping{};
}

void DataTable::fail(std::string message) const {
  if (value_) add_mistake(*value_, std::move(message));
}

bool check_name(const YamlEntry& entry, std::string_view kind, const Names& names) {
  if (std::ranges::find(names, entry.key) != names.end()) return true;
  const YamlValue& value = entry.value;
  add_mistake(*value.findings, value.document->source, entry.spot, describe_unknown(kind, entry.key, names));
  return false;
}

bool check_name(const YamlValue& value, const std::string& word, std::string_view kind, const Names& names) {
  if (std::ranges::find(names, word) != names.end()) return true;
  add_mistake(value, describe_unknown(kind, word, names));
  return false;
}

std::optional<YamlDocument> load_document(const std::filesystem::path& file, Findings& findings) {
  auto source = load_source(file, findings);
  return source ? scan_document(std::move(*source), findings) : std::nullopt;
}

}  // namespace mien

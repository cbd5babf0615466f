// A mapping of one of mien's own data files, read value by value. What is missing, of another kind or never
// asked for (an unknown key) becomes a finding at its place; what was to be filled keeps its default.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "config/yaml_reader.hpp"

namespace mien {

// One value each, false with a mistake told if it is of another kind.
bool load_datum(const YamlValue& value, double& into);
bool load_datum(const YamlValue& value, int& into);
bool load_datum(const YamlValue& value, bool& into);  // true or false
bool load_datum(const YamlValue& value, std::string& into);
bool load_datum(const YamlValue& value, glm::dvec2& into);  // [x, y]
bool load_datum(const YamlValue& value, glm::dvec3& into);  // [x, y, z]

// The items of a list of exactly `count`; none, with a mistake told, if it is another one.
std::vector<YamlValue> load_row(const YamlValue& value, std::size_t count);

template <typename T>
bool load_datum(const YamlValue& value, std::vector<T>& into) {
  std::vector<T> items;
  bool is_right = find_node(value).kind == NodeKind::list;
  for (const YamlValue& item : load_list(value, "a list"))
    if (!load_datum(item, items.emplace_back())) is_right = false;
  if (is_right) into = std::move(items);
  return is_right;
}

template <typename T, std::size_t N>
bool load_datum(const YamlValue& value, std::array<T, N>& into) {
  const std::vector<YamlValue> items = load_row(value, N);
  bool is_right = !items.empty();
  for (std::size_t i = 0; i < items.size(); ++i)
    if (!load_datum(items[i], into[i])) is_right = false;
  return is_right;
}

template <typename T>
bool load_datum(const YamlValue& value, std::map<std::string, T>& into) {
  bool is_right = find_node(value).kind == NodeKind::mapping;
  for (const YamlEntry& entry : load_free_mapping(value, "a mapping"))
    if (!load_datum(entry.value, into[entry.key])) is_right = false;
  return is_right;
}

// Lives while a mapping is read; the keys that nobody asked for are told as it goes.
class DataTable {
 public:
  explicit DataTable(const YamlValue& value) : DataTable(&value) {}
  explicit DataTable(
      const YamlValue* value);  // null: a mapping that is missing, of which nothing more is told
  DataTable(const DataTable&) = delete;
  DataTable& operator=(const DataTable&) = delete;
  ~DataTable();

  // The value of a key that must be there; null, with a mistake told, if it is not.
  const YamlValue* require(const std::string& key) const;
  // The value of a key that may be there.
  const YamlValue* find(const std::string& key) const;
  // A mapping that must be there.
  DataTable at(const std::string& key) const;
  // The entries of a mapping that must be there, in the file's order.
  YamlMapping list(const std::string& key) const;

  // False if it is missing or of another kind.
  template <typename T>
  bool read(const std::string& key, T& into) const {
    const YamlValue* value = require(key);
    return value != nullptr && load_datum(*value, into);
  }
  template <typename T>
  void read_if(const std::string& key, T& into) const {
    if (const YamlValue* value = find(key)) load_datum(*value, into);
  }

  // Adds a mistake about the mapping as a whole.
  void fail(std::string message) const;

 private:
  std::optional<YamlValue> value_;
  YamlMapping entries_;
  mutable std::vector<std::string> asked_;
};

// Adds a mistake at the entry's key unless `names` has it: "unknown point 'E1_44'; did you mean 'E1_4'?".
bool check_name(const YamlEntry& entry, std::string_view kind, const Names& names);
// The same of a value.
bool check_name(const YamlValue& value, const std::string& word, std::string_view kind, const Names& names);

// The file as a tree; empty, with mistakes added, if it cannot be read or is no YAML.
std::optional<YamlDocument> load_document(const std::filesystem::path& file, Findings& findings);

}  // namespace mien

// A typed view of a YAML tree that knows each value's place and the path of keys to it. Whatever does not fit
// is added to the findings at its place, and the target keeps the default it had; nothing here throws.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/language.hpp"
#include "config/quantity.hpp"
#include "config/scan.hpp"
#include "config/words.hpp"

namespace mien {

struct Constants;  // constants.hpp
using ConstantsPointer = std::shared_ptr<const Constants>;

// One value of the tree. `node` is never an alias: it is what the alias stands for, at the alias's own place.
struct YamlValue {
  const YamlDocument* document = nullptr;
  Findings* findings = nullptr;
  std::uint32_t node = 0;
  Spot spot;
  std::string path;                 // "clip.keys.at"; empty for the file as a whole
  bool is_item = false;             // an item of the list `path`
  const Forms* forms = nullptr;     // what the language lets stand here; none: of a file of another kind
  ConstantsPointer constants = {};  // what a formula in place of a number may use; none: no formula may
};

struct YamlEntry {
  std::string key;
  Spot spot;  // of the key
  YamlValue value;
};

using YamlMapping = std::vector<YamlEntry>;  // in the order of the file; each key once

YamlValue find_root(const YamlDocument& document, Findings& findings);
const YamlNode& find_node(const YamlValue& value);

// The value's name in a message: "'clip.fps'", "an item of 'clip.keys'", "the file".
std::string describe_subject(const YamlValue& value);

void add_mistake(const YamlValue& value, std::string message);
// "'clip.fps' is 'fast'; expected a whole number from 1 to 120".
void add_unexpected(const YamlValue& value, std::string_view expected);

// The form of a kind that the language has for a value: its range, its words. A loader that asks for one that
// the table lacks is wrong itself: std::logic_error.
const Form& find_form(const YamlValue& value, FormKind kind);

// The entries of a mapping that the language has for the value, or `section`'s. Other keys are mistakes
// and left out.
YamlMapping load_section(const YamlValue& value);
YamlMapping load_section(const YamlValue& value, const Section& section);

// The entries of a mapping with keys that are data. Keys other than `keys` are mistakes and left out; `noun`
// is what they are called.
YamlMapping load_mapping(const YamlValue& value, const Names& keys, std::string_view expected,
                         std::string_view noun = "key");
// The entries of a mapping whose keys are names that the author chooses.
YamlMapping load_free_mapping(const YamlValue& value, std::string_view expected);
std::vector<YamlValue> load_list(const YamlValue& value, std::string_view expected);

const YamlValue* find_value(const YamlMapping& mapping, std::string_view key);
const YamlValue* find_value(YamlMapping&& mapping, std::string_view key) = delete;  // it would be gone
// As find_value, but an absent one is a mistake at `owner`.
const YamlValue* find_required(const YamlMapping& mapping, std::string_view key, const YamlValue& owner,
                               std::string_view expected);

// One value each. False, with a mistake told, if it is of another type or out of its range. A formula in
// quotes may stand in place of any number (constants.hpp). These take the range and the words from the
// value's form.
bool load_number(const YamlValue& value, double& into);
bool load_whole(const YamlValue& value, int& into);
bool load_seconds(const YamlValue& value, double& into_s);  // of what has no frames
bool load_length(const YamlValue& value, double& into_mm);
bool load_angle(const YamlValue& value, double& into_deg);
bool load_lengths(const YamlValue& value, glm::dvec3& into_mm);
bool load_name(const YamlValue& value, std::string& into);
bool load_yes_no(const YamlValue& value, bool& into);

// The same for ranges and words that are data; `unit` is what messages count ("frames a second").
bool load_number(const YamlValue& value, double low, double high, double& into, std::string_view unit = "");
bool load_whole(const YamlValue& value, int low, int high, int& into, std::string_view unit = "");
bool load_quantity(const YamlValue& value, const Measure& measure, double low, double high, double& into);
bool load_colour(const YamlValue& value, glm::vec3& into);
bool load_text(const YamlValue& value, std::string_view expected, std::string& into);
// One of `names`; `kind` is what they are called ("age").
bool load_name(const YamlValue& value, std::string_view kind, const Names& names, std::string& into);

}  // namespace mien

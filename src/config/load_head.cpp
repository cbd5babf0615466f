#include <fmt/format.h>
#include <cmath>
#include <limits>

#include "config/sections.hpp"

namespace mien {

namespace {

constexpr double kLowestGuide = 0.05, kHighestGuide = 0.95;  // further out a line would leave the face
constexpr double kMaxWeight = 1000;                          // of a mix; only its proportions count

// `adult`, or `{child: 0.4, adult: 0.6}`.
void load_mix(const YamlValue& value, std::string_view kind, const Names& names, Mix& into) {
  std::string name;
  if (find_node(value).kind != NodeKind::mapping) {
    if (load_name(value, kind, names, name)) into = {{name, 1.0}};
    return;
  }
  const YamlMapping entries = load_mapping(value, names, "", kind);
  if (find_node(value).children.empty())
    add_mistake(value, fmt::format("{} names no {}; expected one at least", describe_subject(value), kind));
  Mix mix;
  double sum = 0;
  for (const YamlEntry& entry : entries) {
    double weight = 0;
    if (!load_number(entry.value, 0, kMaxWeight, weight)) continue;
    if (weight == 0) {
      add_mistake(entry.value,
                  describe_subject(entry.value) + " is 0; expected a weight above 0, or no such key");
      continue;
    }
    mix[entry.key] = weight;
    sum += weight;
  }
  if (mix.empty()) return;
  for (auto& [key, weight] : mix) weight /= sum;
  into = mix;
}

void load_character(const YamlValue& value, double& into) {
  const YamlNode& node = find_node(value);
  if (node.kind == NodeKind::text && node.text == "female") {
    into = -1;
  } else if (node.kind == NodeKind::text && node.text == "male") {
    into = 1;
  } else if (node.kind == NodeKind::text && !parse_number(node.text)) {
    std::string name;
    load_name(value, "character", {"female", "male", "a number from -1 to 1"}, name);
  } else {
    load_number(value, -1, 1, into);
  }
}

void load_guides(const YamlValue& value, std::map<std::string, double>& into) {
  const YamlMapping entries =
      load_mapping(value, kGuides, "guide lines such as {eye_line: 0.49}", "guide line");
  std::string below;
  for (const std::string& guide : kGuides) {
    const YamlValue* line = find_value(entries, guide);
    double height = 0;
    if (line == nullptr || !load_number(*line, kLowestGuide, kHighestGuide, height, "of the head's height"))
      continue;
    if (!below.empty() && height <= into[below])
      add_mistake(
          *line,
          fmt::format("{} is {:.7g}, not above {} at {:.7g}; expected mouth_line < nose_base < eye_line "
                      "< brow_line < hairline",
                      describe_subject(*line), height, below, into[below]));
    into[guide] = height;
    below = guide;
  }
}

void load_features(const YamlValue& value, const Names& features, std::map<std::string, double>& into) {
  for (const YamlEntry& entry :
       load_mapping(value, features, "features such as {nose_length: 0.3}", "feature")) {
    double amount = 0;
    if (load_number(entry.value, -1, 1, amount)) into[entry.key] = amount;
  }
}

void load_look(const YamlValue& value, Look& look) {
  const YamlMapping entries = load_mapping(value, kLookKeys, "colours such as {skin: \"#dcae8f\"}");
  if (const YamlValue* skin = find_value(entries, "skin")) load_colour(*skin, look.skin);
  if (const YamlValue* iris = find_value(entries, "iris")) load_colour(*iris, look.iris);
  if (const YamlValue* brow = find_value(entries, "brow")) load_colour(*brow, look.brow);
  glm::vec3 colour{0};
  if (const YamlValue* lips = find_value(entries, "lips"); lips != nullptr && load_colour(*lips, colour))
    look.lips = colour;
}

}  // namespace

HeadSpec load_head(const YamlValue& value, const Names& features) {
  HeadSpec head;
  const YamlMapping entries = load_mapping(value, kHeadKeys, "a mapping such as {age: adult}");
  if (const YamlValue* age = find_value(entries, "age")) load_mix(*age, "age", kAges, head.age);
  if (const YamlValue* skull = find_value(entries, "skull")) load_mix(*skull, "skull", kSkulls, head.skull);
  if (const YamlValue* character = find_value(entries, "character"))
    load_character(*character, head.character);
  if (const YamlValue* guides = find_value(entries, "guides")) load_guides(*guides, head.guides);
  if (const YamlValue* names = find_value(entries, "features"))
    load_features(*names, features, head.features);
  if (const YamlValue* look = find_value(entries, "look")) load_look(*look, head.look);
  return head;
}

}  // namespace mien

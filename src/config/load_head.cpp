#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "config/conformation.hpp"
#include "config/constants.hpp"
#include "config/limits.hpp"
#include "config/named_file.hpp"
#include "config/sections.hpp"
#include "core/seeded.hpp"

namespace mien {

namespace {

// `adult`, or `{child: 0.4, adult: 0.6}`, of the language's own words or of `names`.
void load_mix(const YamlValue& value, Mix& into, const Names& names = {}) {
  std::string name;
  if (find_node(value).kind != NodeKind::mapping) {
    const bool is_read = names.empty() ? load_name(value, name)
                                       : load_name(value, find_form(value, FormKind::word).noun, names, name);
    if (is_read) into = {{name, 1.0}};
    return;
  }
  const Form& form = find_form(value, FormKind::map);
  const std::string& kind = form.noun;
  const YamlMapping entries = load_mapping(value, names.empty() ? list_names(form.words) : names, "", kind);
  if (find_node(value).children.empty())
    add_mistake(value, fmt::format("{} names no {}; expected one at least", describe_subject(value), kind));
  Mix mix;
  double sum = 0;
  for (const YamlEntry& entry : entries) {
    double weight = 0;
    if (!load_number(entry.value, weight)) continue;
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
  } else if (is_word(value)) {
    const Form &word = find_form(value, FormKind::word), &number = find_form(value, FormKind::number);
    Names names = list_names(word.words);
    names.push_back(fmt::format("a number from {:g} to {:g}", number.low, number.high));
    std::string name;
    load_name(value, word.noun, names, name);
  } else {
    load_number(value, into);
  }
}

void load_guides(const YamlValue& value, std::map<std::string, double>& into) {
  const YamlMapping entries = load_section(value);
  std::string below;
  for (const std::string& guide : kGuides) {
    const YamlValue* line = find_value(entries, guide);
    double height = 0;
    if (line == nullptr || !load_number(*line, height)) continue;
    if (!below.empty() && height <= into[below])
      add_mistake(
          *line,
          fmt::format("{} is {:.7g}, not above {} at {:.7g}; expected mouth_line < nose_base < eye_line "
                      "< brow_line < hairline",
                      describe_subject(*line), height, below, into[below]));
    into[guide] = height;
    below = guide;
  }
  for (const std::string& guide : kEarGuides)
    if (const YamlValue* line = find_value(entries, guide)) load_number(*line, into[guide]);
}

// The sums of what the parameters shape; `features` beside them stand above.
void load_conformation(const YamlValue& value, std::map<std::string, double>& into) {
  std::map<std::string, double> sums;
  for (const YamlEntry& entry : load_section(value)) {
    const auto row = std::ranges::find(kConformationRows, entry.key, &ConformationRow::name);
    double number = 0;
    if (row == kConformationRows.end() || !load_number(entry.value, number)) continue;
    for (const FeatureShare& share : row->shares)
      if (!share.feature.empty()) sums[std::string(share.feature)] += number * share.value;
  }
  for (const auto& [feature, sum] : sums) into[feature] = std::clamp(sum, -1.0, 1.0);
}

void load_features(const YamlValue& value, const Names& features, std::map<std::string, double>& into) {
  for (const YamlEntry& entry :
       load_mapping(value, features, "features such as {nose_length: 0.3}", "feature")) {
    double amount = 0;
    if (load_number(entry.value, amount)) into[entry.key] = amount;
  }
}

// Takes an entry out that names one of `looks` instead of a colour, and returns it; nullptr for a colour, or
// none.
const Look* take_named_look(YamlMapping& entries, std::string_view key,
                            const std::vector<std::pair<std::string, Look>>& looks) {
  const auto entry = std::ranges::find(entries, key, &YamlEntry::key);
  if (entry == entries.end() || find_node(entry->value).kind != NodeKind::text ||
      find_node(entry->value).text.starts_with("#"))
    return nullptr;
  const auto found =
      std::ranges::find(looks, find_node(entry->value).text, [](const auto& named) { return named.first; });
  if (found == looks.end()) {
    Names names;
    for (const auto& [name, colours] : looks) names.push_back(name);
    const std::string& word = find_node(entry->value).text;
    const std::string suggestion = describe_suggestion(word, names);
    if (suggestion.empty())
      add_unexpected(entry->value, "a colour such as \"#dcae8f\", or one of: " + join_names(names));
    else
      add_mistake(entry->value,
                  fmt::format("{} is '{}'; {}", describe_subject(entry->value), show_word(word), suggestion));
  }
  entries.erase(entry);
  return found == looks.end() ? nullptr : &found->second;
}

// A skin by name brings all colours that go with it, a hair by name its brows; whatever else is said stands
// above them.
void load_look(const YamlValue& value, const HeadWords& words, Look& look) {
  YamlMapping entries = load_section(value);
  const bool says_hair = find_value(entries, "hair") != nullptr;
  const bool says_brow = find_value(entries, "brow") != nullptr;
  if (const Look* skin = take_named_look(entries, "skin", words.looks)) {
    const std::string beard = look.beard;
    look = *skin;
    look.beard = beard;
  }
  if (const Look* hair = take_named_look(entries, "hair", words.hair_colours)) {
    look.hair = hair->hair;
    look.brow = hair->brow;
    look.is_brow_given = true;
  }
  look.is_hair_given = look.is_hair_given || says_hair;
  look.is_brow_given = look.is_brow_given || says_brow;
  if (const Look* brow = take_named_look(entries, "brow", words.hair_colours)) look.brow = brow->brow;
  if (const YamlValue* beard = find_value(entries, "beard")) load_name(*beard, look.beard);
  if (const YamlValue* texture = find_value(entries, "texture")) load_file(*texture, look.texture);
  load_look_words(entries, look);
}

// "12mm", "1.2cm" or "0.3 eye_nose"; empty if the text is no such length.
std::optional<LimitLength> parse_limit_length(std::string_view text) {
  const auto take = [&](std::string_view unit) -> std::optional<double> {
    if (!text.ends_with(unit)) return std::nullopt;
    std::string_view number = text.substr(0, text.size() - unit.size());
    while (number.ends_with(' ')) number.remove_suffix(1);
    return parse_number(number);
  };
  for (const std::string_view unit : kFaceUnits)
    if (const auto value = take(unit)) return LimitLength{*value, std::string(unit)};
  if (const auto value = take("mm")) return LimitLength{*value, "mm"};
  if (const auto value = take("cm")) return LimitLength{*value * 10, "mm"};
  return std::nullopt;
}

// A share or a length of this limit, which stands above what was said of it before.
void load_limit(const YamlValue& value, const std::vector<std::string>& names, bool is_shared,
                HeadSpec& head) {
  const YamlNode& node = find_node(value);
  const Form& range = find_form(value, FormKind::number);
  const auto length = node.kind == NodeKind::text ? parse_limit_length(node.text) : std::nullopt;
  auto share = node.kind == NodeKind::text ? parse_number(node.text) : std::nullopt;
  if (!length && is_constant(value)) {
    double number = 0;
    if (!load_number(value, number)) return;
    share = number;
  }
  if (length ? length->value < 0 || (length->unit == "mm" && length->value > kMaxLimit_mm)
             : !share || *share < range.low || *share > range.high)
    return add_unexpected(
        value, fmt::format("a number from {:g} to {:g} {}, or a length such as 12mm or 0.3eye_nose",
                           range.low, range.high, range.noun));
  for (const std::string& name : names) {
    head.limits.erase(name);
    head.limit_lengths.erase(name);
    if (length)
      head.limit_lengths[name] = {length->value, length->unit, find_place(value.document->source, value.spot),
                                  is_shared};
    else
      head.limits[name] = *share;
  }
}

// "-1mm" as a height; false if it is no length.
bool load_match_level(const YamlValue& value, HeadSpec& head) {
  const YamlNode& node = find_node(value);
  const auto level = node.kind == NodeKind::text ? parse_limit_length(node.text) : std::nullopt;
  if (!level) return false;
  const double most = level->unit == "mm" ? kMaxMatchLevel_mm : 1;
  if (std::abs(level->value) > most)
    add_unexpected(value,
                   fmt::format("a height from {0:g}mm to {1:g}mm, or from -1 to 1 of a unit of the face",
                               -kMaxMatchLevel_mm, kMaxMatchLevel_mm));
  else
    head.match_level = {level->value, level->unit, find_place(value.document->source, value.spot)};
  return true;
}

// `brow.left.up: 0.8`, or `brows.up` for both sides, which a sided name overrides; both override the
// thesis's.
void load_limits(const YamlValue& value, HeadSpec& head) {
  const YamlMapping entries = load_section(value);
  for (const auto name_of : {&LimitName::thesis, &LimitName::plural, &LimitName::name})
    for (const YamlEntry& entry : entries) {
      std::vector<std::string> names;
      for (const LimitName& limit : list_limits())
        if (entry.key == limit.*name_of) names.push_back(limit.name);
      if (entry.key == kMatchLevel && name_of == &LimitName::thesis && load_match_level(entry.value, head))
        continue;
      if (!names.empty())
        load_limit(entry.value, names, name_of == &LimitName::thesis && names.size() > 1, head);
    }
}

// What the head starts from, if not from the shipped adult: one of mesh, scan and mix.
void load_start(const YamlMapping& entries, const HeadSource& source, HeadSpec& head) {
  const YamlEntry* start = nullptr;
  for (const YamlEntry& entry : entries) {
    if (entry.key != "mesh" && entry.key != "scan" && entry.key != "mix") continue;
    if (start != nullptr)
      add_mistake(
          *entry.value.findings, entry.value.document->source, entry.spot,
          fmt::format("'{}' stands beside '{}'; expected one of mesh, scan and mix", entry.key, start->key));
    start = &entry;
    if (entry.key == "mesh") load_mesh(entry.value, source, head.mesh);
    if (entry.key == "scan") load_scan(entry.value, source, head.scan);
    if (entry.key == "mix") load_head_mix(entry.value, source, head);
  }
}

// What of a head is said, which `random` leaves alone. A skin by its name says all colours that go with it.
std::set<std::string> find_said(const YamlMapping& entries) {
  std::set<std::string> said;
  for (const YamlEntry& entry : entries) {
    said.insert(entry.key);
    if (entry.key == kConformationKey && find_node(entry.value).kind == NodeKind::mapping)
      for (const YamlEntry& parameter : load_free_mapping(entry.value, "a mapping"))
        if (const auto row = std::ranges::find(kConformationRows, parameter.key, &ConformationRow::name);
            row != kConformationRows.end())
          for (const FeatureShare& share : row->shares)
            said.insert(fmt::format("features.{}", share.feature));
    if ((entry.key != "features" && entry.key != "look") || find_node(entry.value).kind != NodeKind::mapping)
      continue;
    for (const YamlEntry& part : load_free_mapping(entry.value, "a mapping")) {
      said.insert(entry.key + "." + part.key);
      if (part.key == "skin" && !find_node(part.value).text.starts_with('#'))
        for (const Key& colour : find_sections().look.keys) said.insert("look." + colour.name);
    }
  }
  return said;
}

// A number from which all is drawn that the file says nothing of.
void load_random(const YamlValue& value, const People& people, HeadSpec& head) {
  int seed = 0;
  if (!load_whole(value, seed)) return;
  head.random = seed;
  draw_person(people, static_cast<std::uint64_t>(seed), head);
}

}  // namespace

HeadSpec load_head(const YamlValue& value, const HeadSource& source) {
  HeadSpec head;
  const YamlMapping entries = load_section(value);
  load_start(entries, source, head);
  load_growth(entries, *source.words, head);
  if (const YamlValue* hair = find_value(entries, "hair")) load_name(*hair, head.hair);
  std::string areas;  // understood before all else: load_spec.cpp
  if (const YamlValue* choice = find_value(entries, "areas")) load_name(*choice, areas);
  std::string rules;
  if (const YamlValue* choice = find_value(entries, "rules"); choice != nullptr && load_name(*choice, rules))
    head.follows_thesis = rules == kAreaRuleWords[1].name;
  if (const YamlValue* limits = find_value(entries, "limits")) load_limits(*limits, head);
  if (const YamlValue* sculpt = find_value(entries, "sculpt")) load_sculpt(*sculpt, source, head.sculpt);
  head.said = find_said(entries);
  if (const YamlValue* random = find_value(entries, "random"))
    load_random(*random, source.words->people, head);
  set_greying(source.words->greying, head.look);
  return head;
}

void load_growth(const YamlMapping& entries, const HeadWords& words, HeadSpec& head) {
  if (const YamlValue* age = find_value(entries, "age")) load_mix(*age, head.age);
  if (const YamlValue* skull = find_value(entries, "skull")) load_mix(*skull, head.skull);
  if (const YamlValue* design = find_value(entries, "design")) {
    Names names;
    for (const LookWord& word : words.designs) names.push_back(word.name);
    load_mix(*design, head.design, names);
  }
  if (const YamlValue* character = find_value(entries, "character"))
    load_character(*character, head.character);
  if (const YamlValue* guides = find_value(entries, "guides")) load_guides(*guides, head.guides);
  if (const YamlValue* conformation = find_value(entries, kConformationKey))
    load_conformation(*conformation, head.features);
  if (const YamlValue* names = find_value(entries, "features"))
    load_features(*names, words.features, head.features);
  if (const YamlValue* look = find_value(entries, "look")) load_look(*look, words, head.look);
  set_greying(words.greying, head.look);
}

}  // namespace mien

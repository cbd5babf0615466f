#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "config/limits.hpp"
#include "config/sections.hpp"
#include "core/seeded.hpp"

namespace mien {

namespace {

constexpr double kLowestGuide = 0.05, kHighestGuide = 0.95;  // further out a line would leave the face
constexpr double kMaxLimit = 2;                              // of the head's own; further the skin folds over
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
  Names lines = kGuides;
  lines.insert(lines.end(), kEarGuides.begin(), kEarGuides.end());
  const YamlMapping entries =
      load_mapping(value, lines, "guide lines such as {eye_line: 0.49}", "guide line");
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
  for (const std::string& guide : kEarGuides)
    if (const YamlValue* line = find_value(entries, guide))
      load_number(*line, kLowestGuide, kHighestGuide, into[guide], "of the head's height");
}

void load_features(const YamlValue& value, const Names& features, std::map<std::string, double>& into) {
  for (const YamlEntry& entry :
       load_mapping(value, features, "features such as {nose_length: 0.3}", "feature")) {
    double amount = 0;
    if (load_number(entry.value, -1, 1, amount)) into[entry.key] = amount;
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
    add_unexpected(entry->value, "a colour such as \"#dcae8f\", or one of: " + join_names(names));
  }
  entries.erase(entry);
  return found == looks.end() ? nullptr : &found->second;
}

// A skin by name brings all colours that go with it, a hair by name its brows; whatever else is said stands
// above them.
void load_look(const YamlValue& value, const HeadWords& words, Look& look) {
  YamlMapping entries = load_mapping(value, kLookKeys, "colours such as {skin: \"#dcae8f\"}");
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
  if (const YamlValue* beard = find_value(entries, "beard")) load_name(*beard, "beard", kBeards, look.beard);
  load_look_words(entries, look);
}

// `brow.left.up: 0.8`, or `brows.up` for both sides, which a sided name overrides.
void load_limits(const YamlValue& value, std::map<std::string, double>& into) {
  Names names;
  for (const LimitName& limit : list_limits())
    if (const std::string& name = limit.plural.empty() ? limit.name : limit.plural;
        std::ranges::find(names, name) == names.end())
      names.push_back(name);
  for (const LimitName& limit : list_limits())
    if (!limit.plural.empty()) names.push_back(limit.name);
  const YamlMapping entries = load_mapping(value, names, "limits such as {brow.left.up: 0.8}", "limit");
  for (const bool is_plural_pass : {true, false})
    for (const YamlEntry& entry : entries) {
      double share = 1;
      bool is_read = false;
      for (const LimitName& limit : list_limits()) {
        if (entry.key != (is_plural_pass ? limit.plural : limit.name)) continue;
        if (!is_read && !load_number(entry.value, 0, kMaxLimit, share, "times the head's own")) break;
        is_read = true;
        into[limit.name] = share;
      }
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
    if (entry.key == "mesh") load_mesh(entry.value, head.mesh);
    if (entry.key == "scan") load_scan(entry.value, head.scan);
    if (entry.key == "mix") load_head_mix(entry.value, source, head);
  }
}

// What of a head is said, which `random` leaves alone. A skin by its name says all colours that go with it.
std::set<std::string> find_said(const YamlMapping& entries) {
  std::set<std::string> said;
  for (const YamlEntry& entry : entries) {
    said.insert(entry.key);
    if ((entry.key != "features" && entry.key != "look") || find_node(entry.value).kind != NodeKind::mapping)
      continue;
    for (const YamlEntry& part : load_free_mapping(entry.value, "a mapping")) {
      said.insert(entry.key + "." + part.key);
      if (part.key == "skin" && !find_node(part.value).text.starts_with('#'))
        for (const std::string& colour : kLookKeys) said.insert("look." + colour);
    }
  }
  return said;
}

// A number from which all is drawn that the file says nothing of.
void load_random(const YamlValue& value, const People& people, HeadSpec& head) {
  int seed = 0;
  if (!load_whole(value, 0, kMaxSeed, seed)) return;
  head.random = seed;
  draw_person(people, static_cast<std::uint64_t>(seed), head);
}

}  // namespace

HeadSpec load_head(const YamlValue& value, const HeadSource& source) {
  HeadSpec head;
  const YamlMapping entries = load_mapping(value, kHeadKeys, "a mapping such as {age: adult}");
  load_start(entries, source, head);
  load_growth(entries, *source.words, head);
  if (const YamlValue* hair = find_value(entries, "hair")) load_name(*hair, "cut of hair", kHairs, head.hair);
  if (const YamlValue* limits = find_value(entries, "limits")) load_limits(*limits, head.limits);
  if (const YamlValue* sculpt = find_value(entries, "sculpt"))
    load_sculpt(*sculpt, *source.words, head.sculpt);
  head.said = find_said(entries);
  if (const YamlValue* random = find_value(entries, "random"))
    load_random(*random, source.words->people, head);
  set_greying(source.words->greying, head.look);
  return head;
}

void load_growth(const YamlMapping& entries, const HeadWords& words, HeadSpec& head) {
  if (const YamlValue* age = find_value(entries, "age")) load_mix(*age, "age", kAges, head.age);
  if (const YamlValue* skull = find_value(entries, "skull")) load_mix(*skull, "skull", kSkulls, head.skull);
  if (const YamlValue* character = find_value(entries, "character"))
    load_character(*character, head.character);
  if (const YamlValue* guides = find_value(entries, "guides")) load_guides(*guides, head.guides);
  if (const YamlValue* names = find_value(entries, "features"))
    load_features(*names, words.features, head.features);
  if (const YamlValue* look = find_value(entries, "look")) load_look(*look, words, head.look);
  set_greying(words.greying, head.look);
}

}  // namespace mien

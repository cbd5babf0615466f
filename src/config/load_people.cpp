#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "config/head_words.hpp"
#include "config/people.hpp"
#include "config/yaml_reader.hpp"

namespace mien {

namespace {

const Names kPeopleKeys{"most",     "character",  "skull",  "most_skull",   "features",
                        "together", "skins",      "shade",  "hair_colours", "irises",
                        "cuts",     "other_cuts", "beards", "freckles"};
constexpr double kMostDeviations = 6;  // sample_normal goes no further
constexpr double kMostShare = 1000;    // only proportions count
constexpr double kLeastPivot = 1e-9;   // of a correlation matrix that is positive definite

void load_part(const YamlMapping& entries, const char* key, const YamlValue& owner, double low, double high,
               double& into) {
  if (const YamlValue* value = find_required(entries, key, owner, "a number"))
    load_number(*value, low, high, into);
}

void load_skulls(const YamlValue& value, People& people) {
  for (const YamlEntry& entry :
       load_free_mapping(value, "ways such as {width: {more: wide, less: narrow}}")) {
    const YamlMapping entries =
        load_mapping(entry.value, {"more", "less", "spread"}, "two skulls and a spread");
    SkullWay way{entry.key, {}, {}, 0};
    for (const auto& [key, into] : {std::pair{"more", &way.more}, std::pair{"less", &way.less}})
      if (const YamlValue* skull = find_required(entries, key, entry.value, "a skull"))
        load_name(*skull, "skull", kSkulls, *into);
    load_part(entries, "spread", entry.value, 0, 1, way.spread);
    people.skulls.push_back(way);
  }
}

void load_features(const YamlValue& value, const Names& features, People& people) {
  for (const YamlEntry& entry :
       load_mapping(value, features, "features such as {nose_length: 0.4}", "feature")) {
    double spread = 0;
    if (load_number(entry.value, 0, 1, spread)) people.features.emplace_back(entry.key, spread);
  }
}

std::map<std::string, double> load_shares(const YamlValue& value, const Names& names, std::string_view noun) {
  std::map<std::string, double> shares;
  double sum = 0;
  for (const YamlEntry& entry : load_mapping(value, names, "names and their shares", noun))
    if (load_number(entry.value, 0, kMostShare, shares[entry.key])) sum += shares[entry.key];
  if (sum == 0) add_mistake(value, describe_subject(value) + " has no share above 0; expected one at least");
  return shares;
}

void load_colour_names(const YamlMapping& entries, const YamlValue& root, People& people) {
  if (const YamlValue* hairs = find_required(entries, "hair_colours", root, "names of colours"))
    for (const YamlEntry& entry : load_free_mapping(*hairs, "names of colours")) {
      const YamlMapping colours = load_mapping(entry.value, {"hair", "brow"}, "colours of hair and brow");
      HairColour& colour = people.hair_colours[entry.key];
      for (const auto& [key, into] : {std::pair{"hair", &colour.hair}, std::pair{"brow", &colour.brow}})
        if (const YamlValue* value = find_required(colours, key, entry.value, "a colour"))
          load_colour(*value, *into);
    }
  if (const YamlValue* irises = find_required(entries, "irises", root, "names of colours"))
    for (const YamlEntry& entry : load_free_mapping(*irises, "names of colours"))
      load_colour(entry.value, people.irises[entry.key]);
}

template <typename Map>
Names list_keys(const Map& map) {
  Names names;
  for (const auto& [name, value] : map) names.push_back(name);
  return names;
}

// In the order of looks.yaml, from light to dark.
void load_skins(const YamlValue& value, const std::vector<std::pair<std::string, Look>>& looks,
                People& people) {
  const YamlMapping entries = load_mapping(value, list_keys(looks), "skins of looks.yaml", "look");
  for (const auto& [name, look] : looks) {
    const YamlValue* skin = find_value(entries, name);
    if (skin == nullptr) continue;
    const YamlMapping parts =
        load_mapping(*skin, {"share", "hair", "iris", "freckled"}, "a share, hair and iris");
    PeoplesSkin read{look, 0, {}, {}, 0};
    if (find_value(parts, "freckled") != nullptr) load_part(parts, "freckled", *skin, 0, 1, read.freckled);
    load_part(parts, "share", *skin, 0, kMostShare, read.share);
    if (const YamlValue* hair = find_required(parts, "hair", *skin, "colours and their shares"))
      read.hairs = load_shares(*hair, list_keys(people.hair_colours), "colour of hair");
    if (const YamlValue* iris = find_required(parts, "iris", *skin, "colours and their shares"))
      read.irises = load_shares(*iris, list_keys(people.irises), "iris");
    people.skins.push_back(read);
  }
  double sum = 0;
  for (const PeoplesSkin& skin : people.skins) sum += skin.share;
  if (sum == 0) add_mistake(value, describe_subject(value) + " has no share above 0; expected one at least");
}

CutShares load_cut(const YamlValue& value) {
  CutShares shares;
  const YamlMapping entries = load_mapping(value, {"women", "men"}, "shares such as {women: 1, men: 2}");
  load_part(entries, "women", value, 0, kMostShare, shares.women);
  load_part(entries, "men", value, 0, kMostShare, shares.men);
  return shares;
}

void load_together(const YamlValue& value, People& people) {
  const std::size_t count = people.dials.size();
  people.together.assign(count, std::vector<double>(count, 0));
  for (std::size_t i = 0; i < count; ++i) people.together[i][i] = 1;
  const auto find_dial = [&](const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(people.dials, name) - people.dials.begin());
  };
  constexpr const char* kExpected = "correlations such as {nose_length: {ear_size: 0.2}}";
  for (const YamlEntry& entry : load_mapping(value, people.dials, kExpected, "dial"))
    for (const YamlEntry& other : load_mapping(entry.value, people.dials, kExpected, "dial")) {
      const std::size_t i = find_dial(entry.key), j = find_dial(other.key);
      if (i == j || people.together[i][j] != 0)
        add_mistake(*other.value.findings, other.value.document->source, other.spot,
                    fmt::format("'{}' and '{}' are told {}; expected each two of them once", entry.key,
                                other.key, i == j ? "to be one" : "twice"));
      double correlation = 0;
      load_number(other.value, -1, 1, correlation);
      people.together[i][j] = people.together[j][i] = i == j ? 1 : correlation;
    }
}

// False where the correlations are nobody's: then `dial` says at which one that shows.
bool build_root(People& people, std::size_t& dial) {
  const std::size_t count = people.dials.size();
  people.root.assign(count, std::vector<double>(count, 0));
  for (dial = 0; dial < count; ++dial)
    for (std::size_t j = 0; j <= dial; ++j) {
      double rest = people.together[dial][j];
      for (std::size_t k = 0; k < j; ++k) rest -= people.root[dial][k] * people.root[j][k];
      if (j == dial && rest < kLeastPivot) return false;
      people.root[dial][j] = j == dial ? std::sqrt(rest) : rest / people.root[j][j];
    }
  return true;
}

void load_dials(const YamlMapping& entries, const YamlValue& root, const PeopleWords& words, People& people) {
  people.dials = {"character", "tone"};
  if (const YamlValue* skull = find_required(entries, "skull", root, "ways in which skulls differ"))
    load_skulls(*skull, people);
  if (const YamlValue* features = find_required(entries, "features", root, "the spread of each feature"))
    load_features(*features, words.features, people);
  for (const SkullWay& way : people.skulls) people.dials.push_back(way.name);
  for (const auto& [name, spread] : people.features) people.dials.push_back(name);
  const YamlValue* together = find_required(entries, "together", root, "correlations");
  if (together == nullptr) return;
  load_together(*together, people);
  std::size_t dial = 0;
  if (build_root(people, dial)) return;
  add_mistake(*together,
              fmt::format("'together' contradicts itself: '{}' cannot go with those before it as it says; "
                          "expected weaker correlations",
                          people.dials[dial]));
}

}  // namespace

People load_people(const std::filesystem::path& file, const PeopleWords& words, Findings& findings) {
  People people;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return people;
  auto source = load_source(file, findings);
  const auto document = source ? scan_document(std::move(*source), findings) : std::nullopt;
  if (!document) return people;
  const YamlValue root = find_root(*document, findings);
  const YamlMapping entries = load_mapping(root, kPeopleKeys, "a mapping");
  load_part(entries, "most", root, 0, kMostDeviations, people.most);
  load_part(entries, "most_skull", root, 0, 1, people.most_skull);
  load_part(entries, "shade", root, 0, 1, people.shade);
  if (const YamlValue* character = find_required(entries, "character", root, "its middle and spread")) {
    const YamlMapping parts = load_mapping(*character, {"middle", "spread"}, "its middle and spread");
    load_part(parts, "middle", *character, 0.01, 1, people.character_middle);
    load_part(parts, "spread", *character, 0, 1, people.character_spread);
  }
  load_dials(entries, root, words, people);
  load_colour_names(entries, root, people);
  if (const YamlValue* skins = find_required(entries, "skins", root, "skins of looks.yaml"))
    load_skins(*skins, words.looks, people);
  if (const YamlValue* cuts = find_required(entries, "cuts", root, "cuts of hair and who wears them"))
    for (const YamlEntry& entry :
         load_mapping(*cuts, kHairs, "cuts of hair and who wears them", "cut of hair"))
      people.cuts[entry.key] = load_cut(entry.value);
  if (const YamlValue* beards = find_required(entries, "beards", root, "beards and how many men wear them"))
    people.beards = load_shares(*beards, kBeards, "beard");
  if (const YamlValue* freckles =
          find_required(entries, "freckles", root, "the least and the most of them")) {
    const YamlMapping parts = load_mapping(*freckles, {"least", "most"}, "the least and the most of them");
    load_part(parts, "least", *freckles, 0, 1, people.least_freckles);
    load_part(parts, "most", *freckles, 0, 1, people.most_freckles);
  }
  if (const YamlValue* others = find_required(entries, "other_cuts", root, "who wears the other cuts"))
    people.other_cuts = load_cut(*others);
  return people;
}

}  // namespace mien

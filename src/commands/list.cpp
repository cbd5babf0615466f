// `mien list KIND`: the words of the language, from the same tables that the reader uses.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "commands/table.hpp"
#include "config/conformation.hpp"
#include "config/findings.hpp"
#include "config/head_parts.hpp"
#include "config/language.hpp"
#include "config/parke.hpp"
#include "config/words.hpp"
#include "core/data.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "frames/figure.hpp"
#include "frames/resources.hpp"
#include "head/landmarks.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

using Rows = std::vector<std::pair<std::string, std::string>>;  // word, meaning

Rows list_names(const Names& names) {
  Rows rows;
  for (const std::string& name : names) rows.emplace_back(name, "");
  return rows;
}

// None, then the cuts of templates/head/hair.yaml, then its beards.
Rows list_hair(const fs::path& data) {
  const HairData hair = load_hair_alone(data);
  Rows rows{{std::string(kHairWords[0].name), std::string(kHairWords[0].meaning)}};
  for (const std::string& name : kHairs)
    if (const auto cut = hair.cuts.find(name); cut != hair.cuts.end())
      rows.emplace_back(name, cut->second.meaning);
  for (const std::string& name : kBeards)
    if (const auto beard = hair.beards.beards.find(name); beard != hair.beards.beards.end())
      rows.emplace_back("beard: " + name, beard->second.meaning);
  return rows;
}

// The skins by name, the colours of hair, then the dials.
Rows list_looks(const fs::path& data) {
  const LanguagePointer language = load_language(data);
  const HeadWords& words = language->words;
  Rows rows;
  for (const LookWord& look : words.look_words)
    rows.emplace_back(look.name, fmt::format("{}  {}", look.value, look.meaning));
  for (const LookWord& colour : words.hair_colour_words)
    rows.emplace_back("hair: " + colour.name, fmt::format("{}  {}", colour.value, colour.meaning));
  for (const LookWord& dial : words.dial_words)
    if (const Key* key = find_key(find_sections().look, dial.name))
      rows.emplace_back(key->name,
                        fmt::format("{} to {}   {}", key->forms[0].low, key->forms[0].high, dial.meaning));
  return rows;
}

Rows list_designs(const fs::path& data) {
  Rows rows;
  for (const LookWord& design : load_language(data)->words.designs)
    rows.emplace_back(design.name, design.meaning);
  return rows;
}

// Where each line lies in the charts of the ages.
Rows list_guides(const fs::path& data) {
  const ShapeData shapes = load_shapes_alone(data);
  Rows rows;
  for (const Names* names : {&kGuides, &kEarGuides})
    for (const std::string& line : *names) {
      std::string meaning;
      for (const std::string& age : kAges)
        meaning += fmt::format("{}{} {:.3f}", meaning.empty() ? "" : ", ", age,
                               shapes.heads.charts.at(age).lines.at(line));
      rows.emplace_back(line, meaning);
    }
  return rows;
}

Rows list_areas(const fs::path&) {
  Rows rows;
  for (const MoveInfo& move : kMoves) {
    rows.emplace_back(fmt::format("{}: {{{}: {}..{}}}", find_area_key(move), move.move, move.low, move.high),
                      move.meaning);
  }
  return rows;
}

// Muscles, units and parameters, by the keys that they stand under.
Rows list_doctrines(const fs::path&) {
  Rows rows;
  const auto add = [&](std::string_view key, const std::string& name, double low, double high,
                       std::string_view meaning) {
    rows.emplace_back(fmt::format("{}: {{{}: {}..{}}}", key, name, low, high), meaning);
  };
  const auto add_all = [&](std::string_view key, const auto& channels) {
    for (const ChannelRow& row : channels)
      add(key, row.alias.empty() ? std::string(row.name) : fmt::format("{} or {}", row.name, row.alias),
          row.low, row.high, row.meaning);
  };
  add_all(kMusclesKey, kMuscleRows);
  add_all(kCandideKey, kUnitRows);
  for (const ParkeRow& row : kParkeRows)
    add(kParkeKey, std::string(row.name), row.low, row.high, row.meaning);
  for (const ConformationRow& row : kConformationRows)
    add(kConformationKey, std::string(row.name), -1, 1, row.meaning);
  return rows;
}

Rows list_expressions(const fs::path& data) {
  const LanguagePointer language = load_language(data);
  Rows rows;
  for (const Expression& expression : language->libraries.expressions) {
    std::string areas;
    for (std::size_t i = 0; i < kChannelCount; ++i) {
      const std::string area(kChannels[i].area);
      if (expression.pose.values[i] != 0 && areas.find(area) == areas.npos)
        areas += (areas.empty() ? "" : ", ") + area;
    }
    rows.emplace_back(expression.library + "/" + expression.name, areas);
  }
  return rows;
}

Rows list_landmarks(const fs::path& folder) {
  const HeadStock stock = load_resources(folder).heads;
  const Figure figure = build_figure(stock, HeadSpec{});
  DeformBuffers buffers;
  Drawing drawing;
  deform_figure(figure, Pose{}, TurnKey{}, buffers, drawing);
  const auto landmarks = find_landmarks(figure.head);
  const LandmarkData& data = stock.data->landmarks;
  const std::vector<std::string>& needed = data.needed;
  Rows rows;
  for (const auto& [name, at] : measure_landmarks(figure.head, landmarks, figure.model, drawing)) {
    const bool is_sided = name.ends_with("_l") || name.ends_with("_r");
    const std::string bare = name.substr(0, name.size() - (is_sided ? 2 : 0));
    const bool is_needed = std::find(needed.begin(), needed.end(), bare) != needed.end();
    rows.emplace_back(name, fmt::format("{:7.1f} {:7.1f} {:7.1f} mm on the adult{}", at.x, at.y, at.z,
                                        is_needed ? "; a scan needs it" : ""));
  }
  for (const auto& [word, meaning] : data.everyday_middle)
    rows.emplace_back(word, fmt::format("for sculpting: {}", meaning));
  for (const auto& [word, meaning] : data.everyday_sided)
    rows.emplace_back(word, fmt::format("for sculpting: {}, both sides", meaning));
  return rows;
}

// Each limit by its thesis's name, in face units (the same on every head), and as millimetres on the adult.
Rows list_limits_of_adult(const fs::path& data) {
  const Figure figure = build_figure(load_resources(data).heads, HeadSpec{});
  Rows rows;
  for (const Limit& limit : measure_limits(figure.head, figure.face, figure.limits))
    rows.emplace_back(limit.name->name, fmt::format("{:<27} {:6.3g} {:<14} {:5.1f} mm on the adult",
                                                    limit.name->thesis.empty() ? "-" : limit.name->thesis,
                                                    limit.value, limit.unit, limit.mm));
  return rows;
}

Rows list_features(const fs::path& data) {
  Rows rows;
  const Form& range = find_key(find_sections().head, "features")->forms.front().items.front();
  for (const FeatureInfo& feature : load_shapes_alone(data).features)
    rows.emplace_back(feature.name, fmt::format("{}..{}  {}", range.low, range.high, feature.meaning));
  return rows;
}

// What `random` draws: each dial with its standard deviation and what it goes together with.
Rows list_people(const fs::path& data) {
  const LanguagePointer language = load_language(data);
  const People& people = language->words.people;
  std::map<std::string, std::string> meanings{
      {"character", fmt::format("{:.2f} +-{:.2f} from 0 on either side", people.character_middle,
                                people.character_spread)},
      {"tone", "of the skin, + darker"}};
  for (const SkullWay& way : people.skulls)
    meanings[way.name] = fmt::format("+-{:.2f}  of the skull, + {}, - {}", way.spread, way.more, way.less);
  for (const auto& [feature, spread] : people.features) meanings[feature] = fmt::format("+-{:.2f}", spread);
  Rows rows;
  for (std::size_t i = 0; i < people.dials.size(); ++i) {
    std::string others;
    for (std::size_t j = 0; j < people.dials.size(); ++j)
      if (i != j && people.together[i][j] != 0)
        others += fmt::format("{}{} {:+.2f}", others.empty() ? "; goes with " : ", ", people.dials[j],
                              people.together[i][j]);
    rows.emplace_back(people.dials[i], meanings[people.dials[i]] + others);
  }
  return rows;
}

// The sounds that share each mouth, then the letters and names that other programs give them.
Rows list_mouths(const fs::path& data) {
  const SpeechDataPointer speech = load_language(data)->speech;
  const auto find_names = [](const std::map<std::string, VisemeIndices>& all, std::size_t viseme) {
    std::string names;
    for (const auto& [name, visemes] : all)
      if (visemes == VisemeIndices{viseme}) names += (names.empty() ? "" : " ") + name;
    return names;
  };
  Rows rows;
  for (std::size_t i = 0; i < speech->visemes.size(); ++i) {
    const Viseme& viseme = speech->visemes[i];
    std::string meaning = fmt::format("{:<58}", viseme.meaning + ";");
    meaning += find_names(speech->phonemes, i);
    const std::string letters = find_names(speech->rhubarb, i), blair = find_names(speech->preston_blair, i);
    if (!letters.empty()) meaning += "; Rhubarb " + letters;
    if (!blair.empty()) meaning += "; Preston Blair " + blair;
    rows.emplace_back(viseme.name, meaning);
  }
  for (const auto& [letter, visemes] : speech->rhubarb)
    rows.emplace_back("mouths/" + letter,
                      fmt::format("Rhubarb's {}: {}", letter, speech->visemes[visemes.front()].meaning));
  return rows;
}

Rows list_qualities(const fs::path&) {
  Rows rows;
  for (const Word& word : kQualityWords) rows.emplace_back(word.name, word.meaning);
  return rows;
}

struct Kind {
  std::string_view name;
  Rows (*list)(const fs::path& data);  // which reads of the data folder what it tells, and no more
};

constexpr std::array kKinds{
    Kind{"ages", [](const fs::path&) { return list_names(kAges); }},
    Kind{"skulls", [](const fs::path&) { return list_names(kSkulls); }},
    Kind{"designs", list_designs},
    Kind{"guides", list_guides},
    Kind{"features", list_features},
    Kind{"people", list_people},
    Kind{"hair", list_hair},
    Kind{"looks", list_looks},
    Kind{"areas", list_areas},
    Kind{"doctrines", list_doctrines},
    Kind{"limits", list_limits_of_adult},
    Kind{"expressions", list_expressions},
    Kind{"landmarks", list_landmarks},
    Kind{"mouths", list_mouths},
    Kind{"qualities", list_qualities},
};

Names list_kinds() {
  Names names;
  for (const Kind& kind : kKinds) names.emplace_back(kind.name);
  return names;
}

Rows list_rows(const std::string& kind) {
  for (const Kind& known : kKinds)
    if (known.name == kind) return known.list(find_data_folder());
  const Names names = list_kinds();
  const std::string near = find_nearest(kind, names);
  throw InputError(near.empty()
                       ? fmt::format("unknown kind '{}'; expected one of: {}", kind, join_names(names))
                       : fmt::format("unknown kind '{}'; did you mean '{}'?", kind, near));
}

void run_list(const Options& options) {
  const Rows rows = list_rows(options.kind);
  if (options.is_json) {
    for (const auto& [word, meaning] : rows)
      fmt::print("{}\n", nlohmann::ordered_json{{"name", word}, {"meaning", meaning}}.dump());
    return;
  }
  std::size_t width = 0;
  for (const auto& [word, meaning] : rows) width = std::max(width, word.size());
  for (const auto& [word, meaning] : rows)
    fmt::print("{}\n", meaning.empty() ? word : fmt::format("{:<{}}  {}", word, width, meaning));
}

}  // namespace

const CommandInfo command_list{
    "list",
    "The file",
    "KIND",
    "the words of the language",
    "Lists one kind of word: ages, skulls, designs, guides, features, hair, looks, areas,\n"
    "doctrines, limits, expressions, landmarks or qualities; people tells how far random heads differ and "
    "what of them goes "
    "together.",
    "",
    "mien list expressions\nmien list areas --json",
    run_list,
    list_kinds};

}  // namespace mien

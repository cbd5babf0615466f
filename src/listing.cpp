// `mien list KIND`: the words of the language, from the same tables that the reader uses.
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "config/findings.hpp"
#include "config/head_words.hpp"
#include "config/load_spec.hpp"
#include "config/words.hpp"
#include "core/data.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "frames/figure.hpp"
#include "head/landmarks.hpp"
#include "head/shapes.hpp"
#include "pipeline.hpp"

namespace mien {

namespace {

using Rows = std::vector<std::pair<std::string, std::string>>;  // word, meaning

// The keys of one map of templates/head/heads.yaml, in its order: ages from young to old.
Rows list_heads(const std::filesystem::path& data, const char* map) {
  Rows rows;
  const YAML::Node heads = YAML::LoadFile((data / "templates/head/heads.yaml").string());
  for (const auto& entry : heads[map]) rows.emplace_back(entry.first.as<std::string>(), "");
  return rows;
}

// None, then the cuts of templates/head/hair.yaml in its order.
Rows list_hair(const std::filesystem::path& data) {
  Rows rows{{"none", "a bald head: the default"}};
  const YAML::Node hair = YAML::LoadFile((data / "templates/head/hair.yaml").string());
  for (const auto& cut : hair["cuts"])
    rows.emplace_back(cut.first.as<std::string>(), cut.second["meaning"].as<std::string>());
  for (const auto& beard : hair["beards"])
    rows.emplace_back("beard: " + beard.first.as<std::string>(), beard.second["meaning"].as<std::string>());
  return rows;
}

// The skins by name, then the dials.
Rows list_looks(const std::filesystem::path& data) {
  Rows rows;
  const YAML::Node looks = YAML::LoadFile((data / "templates/head/looks.yaml").string());
  for (const auto& look : looks["looks"])
    rows.emplace_back(look.first.as<std::string>(),
                      fmt::format("{}  {}", look.second["skin"].as<std::string>(),
                                  look.second["meaning"].as<std::string>()));
  for (const auto& colour : looks["hair_colours"])
    rows.emplace_back("hair: " + colour.first.as<std::string>(),
                      fmt::format("{}  {}", colour.second["hair"].as<std::string>(),
                                  colour.second["meaning"].as<std::string>()));
  for (const auto& dial : looks["dials"])
    rows.emplace_back(dial.first.as<std::string>(),
                      fmt::format("0 to 1   {}", dial.second.as<std::string>()));
  return rows;
}

// Where each line lies in the charts of the ages.
Rows list_guides(const std::filesystem::path& data) {
  Rows rows;
  const YAML::Node charts = YAML::LoadFile((data / "templates/head/heads.yaml").string())["charts"];
  for (const Names* names : {&kGuides, &kEarGuides})
    for (const std::string& line : *names) {
      std::string meaning;
      for (const auto& chart : charts)
        meaning += fmt::format("{}{} {:.3f}", meaning.empty() ? "" : ", ", chart.first.as<std::string>(),
                               chart.second[line].as<double>());
      rows.emplace_back(line, meaning);
    }
  return rows;
}

Rows list_areas(const std::filesystem::path&) {
  Rows rows;
  for (const MoveInfo& move : kMoves) {
    std::string key(move.area);
    if (move.side != Side::none) key += move.side == Side::left ? ".left" : ".right";
    rows.emplace_back(fmt::format("{}: {{{}: {}..{}}}", key, move.move, move.low, move.high), move.meaning);
  }
  return rows;
}

Rows list_expressions(const std::filesystem::path& data) {
  Rows rows;
  for (const Expression& expression : load_expression_libraries(data / "configs/expressions")) {
    std::string areas;
    for (std::size_t i = 0; i < kMoveCount; ++i) {
      const std::string area(kMoves[i].area);
      if (expression.pose.values[i] != 0 && areas.find(area) == areas.npos)
        areas += (areas.empty() ? "" : ", ") + area;
    }
    rows.emplace_back(expression.library + "/" + expression.name, areas);
  }
  return rows;
}

Rows list_landmarks(const std::filesystem::path& data) {
  const Figure figure = build_figure(HeadSpec{}, data);
  DeformBuffers buffers;
  Drawing drawing;
  deform_figure(figure, Pose{}, TurnKey{}, buffers, drawing);
  const auto landmarks = find_landmarks(figure.head, data / "templates/head/landmarks.yaml");
  const auto needed = find_needed_landmarks(data / "templates/head/landmarks.yaml");
  Rows rows;
  for (const auto& [name, at] : measure_landmarks(figure.head, landmarks, figure.model, drawing)) {
    const bool is_sided = name.ends_with("_l") || name.ends_with("_r");
    const std::string bare = name.substr(0, name.size() - (is_sided ? 2 : 0));
    const bool is_needed = std::find(needed.begin(), needed.end(), bare) != needed.end();
    rows.emplace_back(name, fmt::format("{:7.1f} {:7.1f} {:7.1f} mm on the adult{}", at.x, at.y, at.z,
                                        is_needed ? "; a scan needs it" : ""));
  }
  const YAML::Node words = YAML::LoadFile((data / "templates/head/landmarks.yaml").string());
  for (const char* table : {"everyday_middle", "everyday_sided"})
    for (const auto& word : words[table])
      rows.emplace_back(word.first.as<std::string>(),
                        fmt::format("for sculpting: {}{}", word.second.as<std::string>(),
                                    table == std::string_view("everyday_sided") ? ", both sides" : ""));
  return rows;
}

// Each limit by its thesis's name, in face units (the same on every head), and as millimetres on the adult.
Rows list_limits_of_adult(const std::filesystem::path& data) {
  const Figure figure = build_figure(HeadSpec{}, data);
  Rows rows;
  for (const Limit& limit :
       measure_limits(figure.head, figure.face, figure.limits, data / "templates/head/areas.yaml"))
    rows.emplace_back(limit.name->name, fmt::format("{:<27} {:6.3g} {:<14} {:5.1f} mm on the adult",
                                                    limit.name->thesis.empty() ? "-" : limit.name->thesis,
                                                    limit.value, limit.unit, limit.mm));
  return rows;
}

Rows list_features(const std::filesystem::path& data) {
  Rows rows;
  for (const FeatureInfo& feature : load_features(data / "templates/head"))
    rows.emplace_back(feature.name, "-1..1  " + feature.meaning);
  return rows;
}

// What `random` draws: each dial with its standard deviation and what it goes together with.
Rows list_people(const std::filesystem::path& data) {
  Findings findings;
  const People people = load_head_words(data, findings).people;
  throw_mistakes(std::move(findings));
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

Rows list_qualities(const std::filesystem::path&) {
  return {{"draft", "about 1 s a frame of 480x600 on one core: to see the timing"},
          {"good", "about 3 s: the default"},
          {"best", "about 10 s: for the last run"}};
}

struct Kind {
  std::string_view name;
  Rows (*list)(const std::filesystem::path& data);
};

constexpr std::array kKinds{
    Kind{"ages", [](const std::filesystem::path& data) { return list_heads(data, "ages"); }},
    Kind{"skulls", [](const std::filesystem::path& data) { return list_heads(data, "skulls"); }},
    Kind{"guides", list_guides},
    Kind{"features", list_features},
    Kind{"people", list_people},
    Kind{"hair", list_hair},
    Kind{"looks", list_looks},
    Kind{"areas", list_areas},
    Kind{"limits", list_limits_of_adult},
    Kind{"expressions", list_expressions},
    Kind{"landmarks", list_landmarks},
    Kind{"qualities", list_qualities},
};

Rows list_rows(const std::string& kind, const std::filesystem::path& data) {
  for (const Kind& known : kKinds)
    if (known.name == kind) return known.list(data);
  const Names names = list_word_kinds();
  const std::string near = find_nearest(kind, names);
  throw InputError(near.empty()
                       ? fmt::format("unknown kind '{}'; expected one of: {}", kind, join_names(names))
                       : fmt::format("unknown kind '{}'; did you mean '{}'?", kind, near));
}

}  // namespace

std::vector<std::string> list_word_kinds() {
  Names names;
  for (const Kind& kind : kKinds) names.emplace_back(kind.name);
  return names;
}

void list_kind(const std::string& kind, const Options& options) {
  const Rows rows = list_rows(kind, find_data_folder());
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

}  // namespace mien

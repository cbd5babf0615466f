#include "config/data_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "config/areas.hpp"
#include "config/head_parts.hpp"
#include "config/load_spec.hpp"

namespace mien {

namespace {

template <typename Things>
std::vector<DataWord> list_meanings(const Names& names, const Things& things) {
  std::vector<DataWord> words;
  for (const std::string& name : names)
    if (const auto found = things.find(name); found != things.end())
      words.push_back({name, found->second.meaning});
  return words;
}

std::vector<DataWord> list_looks(const std::vector<LookWord>& looks) {
  std::vector<DataWord> words;
  for (const LookWord& look : looks) words.push_back({look.name, look.meaning});
  return words;
}

std::string describe_expression(const Expression& expression) {
  std::string areas;
  std::set<std::string_view> told;
  for (std::size_t i = 0; i < kChannelCount; ++i)
    if (expression.pose.values[i] != 0 && told.insert(kChannels[i].area).second)
      areas += fmt::format("{}{}", areas.empty() ? "" : ", ", kChannels[i].area);
  return fmt::format("Of {}: {}; comes in {:.3g}s.", expression.library,
                     areas.empty() ? "all at rest" : "moves " + areas, expression.attack_s);
}

std::vector<DataWord> list_expressions(const std::vector<Expression>& expressions) {
  std::vector<DataWord> words;
  std::set<std::string> told;
  for (const std::string& library : kEverydayLibraries)
    for (const Expression& expression : expressions)
      if (expression.library == library && told.insert(expression.name).second)
        words.push_back({expression.name, describe_expression(expression)});
  for (const Expression& expression : expressions)
    words.push_back({expression.library + "/" + expression.name, describe_expression(expression)});
  return words;
}

}  // namespace

DataWords load_data_words(const std::filesystem::path& data_folder) {
  const LanguagePointer language = load_language(data_folder);
  const HairData hair = load_hair_alone(data_folder);
  DataWords words;
  for (const FeatureInfo& feature : load_shapes_alone(data_folder).features)
    words["features"].push_back({feature.name, feature.meaning});
  words["looks"] = list_looks(language->words.look_words);
  words["hair_colours"] = list_looks(language->words.hair_colour_words);
  words["designs"] = list_looks(language->words.designs);
  words["hair"] = list_meanings(kHairs, hair.cuts);
  words["beards"] = list_meanings(kBeards, hair.beards.beards);
  for (const std::string& place : list_places(language->words)) words["places"].push_back({place, {}});
  for (const auto& [library, source] : load_library_sources(data_folder / "configs/expressions"))
    words["libraries"].push_back({library, source});
  words["expressions"] = list_expressions(language->libraries.expressions);
  return words;
}

}  // namespace mien

#include "config/data_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "config/areas.hpp"
#include "config/head_words.hpp"
#include "config/load_spec.hpp"
#include "config/yaml_reader.hpp"

namespace mien {

namespace {

// The keys of one mapping of a data file, each with its `meaning`.
std::vector<DataWord> load_meanings(const std::filesystem::path& file, std::string_view mapping,
                                    Findings& findings) {
  std::vector<DataWord> words;
  auto source = load_source(file, findings);
  const auto document = source ? scan_document(std::move(*source), findings) : std::nullopt;
  if (!document) return words;
  const YamlMapping root = load_free_mapping(find_root(*document, findings), "a mapping");
  const YamlValue* entries = find_value(root, mapping);
  if (entries == nullptr) return words;
  for (const YamlEntry& entry : load_free_mapping(*entries, "a mapping")) {
    DataWord word{entry.key, {}};
    const YamlMapping parts = load_free_mapping(entry.value, "a mapping with a meaning");
    if (const YamlValue* meaning = find_value(parts, "meaning")) load_text(*meaning, "a text", word.meaning);
    words.push_back(word);
  }
  return words;
}

std::string describe_expression(const Expression& expression) {
  std::string areas;
  std::set<std::string_view> told;
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (expression.pose.values[i] != 0 && told.insert(kMoves[i].area).second)
      areas += fmt::format("{}{}", areas.empty() ? "" : ", ", kMoves[i].area);
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
  Findings findings;
  DataWords words;
  const std::filesystem::path head = data_folder / "templates/head";
  words["features"] = load_meanings(head / "features.yaml", "features", findings);
  words["looks"] = load_meanings(head / "looks.yaml", "looks", findings);
  words["hair_colours"] = load_meanings(head / "looks.yaml", "hair_colours", findings);
  words["hair"] = load_meanings(head / "hair.yaml", "cuts", findings);
  words["beards"] = load_meanings(head / "hair.yaml", "beards", findings);
  for (const std::string& place : list_places(load_head_words(data_folder, findings)))
    words["places"].push_back({place, {}});
  for (const auto& [library, source] : load_library_sources(data_folder / "configs/expressions"))
    words["libraries"].push_back({library, source});
  words["expressions"] = list_expressions(load_expression_libraries(data_folder / "configs/expressions"));
  throw_mistakes(std::move(findings));
  return words;
}

}  // namespace mien

// `mien schema` says what the table of the language and the data say, and a real validator takes it.
#include "config/schema.hpp"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "config/areas.hpp"
#include "config/config_fixture.hpp"
#include "config/language.hpp"
#include "config/validator.hpp"

namespace mien {
namespace {

using nlohmann::json;

const json& find_schema() {
  static const json schema = json::parse(build_schema(load_data_words(kData)));
  return schema;
}

Names list_properties(const json& object) {
  EXPECT_EQ(object.at("additionalProperties"), false);
  Names keys;
  for (const auto& [key, value] : object.at("properties").items()) keys.push_back(key);
  return keys;
}

Names sort(Names names) {
  std::sort(names.begin(), names.end());
  return names;
}

TEST(schema, has_every_mapping_with_its_keys_and_a_line_of_help_for_each) {
  for (const Section* section : list_sections()) {
    if (section->name == "library_file") continue;
    const json& object =
        section->name == "file" ? find_schema() : find_schema().at("$defs").at(section->name);
    Names keys = list_keys(*section);
    if (section->name == "file") keys.insert(keys.end(), {"source", "rules"});  // of a library
    EXPECT_EQ(list_properties(object), sort(keys)) << section->name;
    for (const auto& [key, value] : object.at("properties").items())
      EXPECT_GT(value.at("description").get<std::string>().size(), 2u) << section->name << "." << key;
  }
}

TEST(schema, has_the_range_of_every_move) {
  for (const MoveInfo& move : kMoves) {
    const json& number = find_schema()
                             .at("$defs")
                             .at(std::string(move.area))
                             .at("properties")
                             .at(std::string(move.move))
                             .at("anyOf")
                             .at(0);
    EXPECT_EQ(number.at("minimum"), kMaxExaggerate * move.low) << move.area << move.move;
    EXPECT_EQ(number.at("maximum"), kMaxExaggerate * move.high) << move.area << move.move;
  }
}

TEST(schema, knows_expressions_features_and_words_with_their_meanings) {
  const json& defs = find_schema().at("$defs");
  std::map<std::string, std::string> expressions;
  for (const json& word : defs.at("expressions").at("oneOf"))
    expressions[word.at("const")] = word.at("description");
  for (const Expression& expression : load_expression_libraries(kData / "configs/expressions"))
    EXPECT_TRUE(expressions.contains(expression.library + "/" + expression.name)) << expression.name;
  EXPECT_EQ(expressions.at("smile"), expressions.at("mien/smile"));
  EXPECT_NE(expressions.at("smile").find("corner"), std::string::npos);
  EXPECT_FALSE(expressions.contains("/smile"));
  const json& features = defs.at("head").at("properties").at("features").at("properties");
  EXPECT_EQ(features.at("nose_length").at("description"), "tip and base of the nose 3 mm lower");
  const json& qualities = defs.at("render").at("properties").at("quality").at("oneOf");
  EXPECT_EQ(qualities.size(), kQualities.size());
  EXPECT_EQ(qualities[0].at("const"), "sketch");
  EXPECT_NE(qualities[0].at("description"), "");
}

Names list_files(const std::filesystem::path& folder) {
  Names files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".yaml") files.push_back(entry.path().string());
  return sort(files);
}

TEST(schema, lets_a_validator_accept_every_example_and_library) {
  for (const char* folder : {"configs", "configs/expressions"}) {
    const auto said = judge(list_files(kData / folder));
    if (said.empty()) GTEST_SKIP() << "python3-jsonschema or python3-yaml is not installed";
    for (const auto& [name, judgement] : said) EXPECT_EQ(judgement, "accepted") << name;
  }
}

// What no schema can see stands in schema_accepts.txt, each group below its reason.
TEST(schema, lets_a_validator_refuse_every_wrong_file_but_those_listed) {
  const auto said = judge(list_files(kData / "tests/bad_yaml"));
  if (said.empty()) GTEST_SKIP() << "python3-jsonschema or python3-yaml is not installed";
  std::set<std::string> accepted, listed;
  for (const auto& [name, judgement] : said)
    if (judgement == "accepted") accepted.insert(std::filesystem::path(name).stem().string());
  std::istringstream lines(read_file(kData / "tests/config/schema_accepts.txt"));
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && line[0] != '#') listed.insert(line);
  EXPECT_EQ(accepted, listed);
}

}  // namespace
}  // namespace mien

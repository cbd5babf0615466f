// templates/mien.schema.json says what the code says: the same words, keys and moves.
#include <nlohmann/json.hpp>

#include "config/config_fixture.hpp"
#include "config/limits.hpp"
#include "config/words.hpp"

namespace mien {
namespace {

using nlohmann::json;

Names list_properties(const json& object) {
  EXPECT_EQ(object.at("additionalProperties"), false);
  Names keys;
  for (const auto& [key, value] : object.at("properties").items()) {
    keys.push_back(key);
    EXPECT_TRUE(value.contains("description") || value.contains("$ref")) << key;
  }
  return keys;
}

Names sort(Names names) {
  std::sort(names.begin(), names.end());
  return names;
}

TEST(schema, has_the_keys_and_names_of_the_language) {
  const json schema = json::parse(read_file(kData / "templates/mien.schema.json"));
  const json& file = schema.at("properties");
  const json& defs = schema.at("$defs");
  EXPECT_EQ(list_properties(schema), sort(kFileKeys));
  EXPECT_EQ(file.at("mien").at("const"), kLanguageVersion);

  const json& head = file.at("head");
  EXPECT_EQ(list_properties(head), sort(kHeadKeys));
  EXPECT_EQ(list_properties(head.at("properties").at("look")), sort(kLookKeys));
  Names limits;
  for (const LimitName& limit : list_limits()) {
    limits.push_back(limit.name);
    if (!limit.plural.empty()) limits.push_back(limit.plural);
  }
  limits = sort(limits);
  limits.erase(std::unique(limits.begin(), limits.end()), limits.end());
  EXPECT_EQ(list_properties(head.at("properties").at("limits")), limits);
  EXPECT_EQ(list_properties(head.at("properties").at("guides")), sort(kGuides));
  EXPECT_EQ(head.at("properties").at("age").at("anyOf")[0].at("enum").get<Names>(), kAges);
  EXPECT_EQ(list_properties(head.at("properties").at("age").at("anyOf")[1]), sort(kAges));
  EXPECT_EQ(head.at("properties").at("skull").at("anyOf")[0].at("enum").get<Names>(), kSkulls);
  EXPECT_EQ(head.at("properties").at("character").at("anyOf")[0].at("enum").get<Names>(), kCharacters);

  const json& clip = file.at("clip");
  EXPECT_EQ(list_properties(clip), sort(kClipKeys));
  const json& blink = clip.at("properties").at("blink").at("anyOf");
  EXPECT_EQ(blink[0].at("enum").get<Names>(), kBlinkStyles);
  EXPECT_EQ(list_properties(blink[1]), sort(kBlinkKeys));
  const json& gaze = clip.at("properties").at("gaze").at("anyOf");
  EXPECT_EQ(gaze[0].at("enum").get<Names>(), kGazeWords);
  EXPECT_EQ(list_properties(gaze[2]), sort(kGazeKeys));
  EXPECT_EQ(list_properties(defs.at("gaze_key")), sort(kGazeKeyKeys));
  const json& look = defs.at("look").at("anyOf");
  EXPECT_EQ(look[0].at("enum").get<Names>(), kLooks);
  EXPECT_EQ(list_properties(look[1]), sort(kDirectionKeys));
  EXPECT_EQ(list_properties(clip.at("properties").at("drift").at("anyOf")[1]), sort(kDriftKeys));
  EXPECT_EQ(list_properties(clip.at("properties").at("asymmetry").at("anyOf")[2]), sort(kAsymmetryKeys));
  EXPECT_EQ(clip.at("properties").at("asymmetry").at("anyOf")[0].at("enum").get<Names>(), kAsymmetryWords);
  EXPECT_EQ(clip.at("properties").at("draw").at("anyOf")[0].at("enum").get<Names>(), kDraws);
  EXPECT_EQ(list_properties(defs.at("pose_key")), sort(kPoseKeyKeys));
  EXPECT_EQ(list_properties(defs.at("pose_key").at("properties").at("release").at("anyOf")[2]),
            sort(kReleaseKeys));
  EXPECT_EQ(list_properties(defs.at("camera_key")), sort(kCameraKeys));
  EXPECT_EQ(list_properties(defs.at("turn_key")), sort(kTurnKeys));
  EXPECT_EQ(list_properties(defs.at("head_key")), sort(kHeadTrackKeys));
  EXPECT_EQ(list_properties(defs.at("light_key")), sort(kLightKeys));
  EXPECT_EQ(defs.at("light_key").at("properties").at("set").at("enum").get<Names>(), kLightSets);
  EXPECT_EQ(list_properties(defs.at("background_key")), sort(kBackgroundKeys));
  EXPECT_EQ(list_properties(defs.at("wait")), sort(kWaitKeys));
  EXPECT_EQ(list_properties(defs.at("actor")), sort(kActorKeys));
  EXPECT_EQ(list_properties(defs.at("actor").at("properties").at("place")), sort(kPlaceKeys));
  EXPECT_EQ(defs.at("ease").at("anyOf")[0].at("enum").get<Names>(), kEasings);
  EXPECT_EQ(defs.at("between").at("enum").get<Names>(), kBetweens);
  EXPECT_EQ(defs.at("rule").at("enum").get<Names>(), kRules);
  EXPECT_EQ(list_properties(defs.at("cue")), sort(kCueKeys));
  EXPECT_EQ(list_properties(defs.at("law")), sort(kLawKeys));
  EXPECT_EQ(list_properties(defs.at("script")), sort(kScriptKeys));
  const json& parts = clip.at("properties");
  EXPECT_EQ(parts.at("lead").at("anyOf")[0].at("enum").get<Names>(), kLeads);
  EXPECT_EQ(list_properties(parts.at("lead").at("anyOf")[1]), sort(kLeadKeys));
  EXPECT_EQ(list_properties(parts.at("draw").at("anyOf")[2].at("items")), sort(kDrawKeys));
  EXPECT_EQ(list_properties(parts.at("tracks").at("items")), sort(kTrackKeys));
  const json& include = parts.at("include").at("anyOf")[1];
  EXPECT_EQ(list_properties(include), sort(kIncludeKeys));
  EXPECT_EQ(include.at("properties").at("take").at("items").at("enum").get<Names>(), kTakes);

  EXPECT_EQ(list_properties(file.at("render")), sort(kRenderKeys));
  EXPECT_EQ(file.at("render").at("properties").at("quality").at("enum").get<Names>(), kQualities);
  EXPECT_EQ(file.at("render").at("properties").at("background").at("enum").get<Names>(), kBackgrounds);
  EXPECT_EQ(list_properties(file.at("busts").at("items")), sort(kBustKeys));
  EXPECT_EQ(list_properties(file.at("busts")), sort(kBustSetKeys));

  Names libraries;
  for (const auto& entry : std::filesystem::directory_iterator(kData / "configs/expressions"))
    libraries.push_back(entry.path().stem());
  EXPECT_EQ(file.at("library").at("enum").get<Names>(), sort(libraries));
}

TEST(schema, has_every_area_and_the_range_of_every_move) {
  const json defs = json::parse(read_file(kData / "templates/mien.schema.json")).at("$defs");
  Names area_keys, expression_keys = kExpressionKeys;
  for (const AreaKey& key : kAreaKeys) area_keys.emplace_back(key.key);
  expression_keys.insert(expression_keys.end(), area_keys.begin(), area_keys.end());
  EXPECT_EQ(list_properties(defs.at("areas")), sort(area_keys));
  EXPECT_EQ(list_properties(defs.at("expression")), sort(expression_keys));
  for (const AreaKey& key : kAreaKeys)
    EXPECT_EQ(defs.at("areas").at("properties").at(std::string(key.key)).at("$ref"),
              "#/$defs/" + std::string(key.area));
  for (const MoveInfo& move : kMoves) {
    const json& number = defs.at(std::string(move.area)).at("properties").at(std::string(move.move));
    EXPECT_EQ(number.at("minimum"), kMaxExaggerate * move.low) << move.area << move.move;
    EXPECT_EQ(number.at("maximum"), kMaxExaggerate * move.high) << move.area << move.move;
  }
}

}  // namespace
}  // namespace mien

#include "head/shapes.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/error.hpp"
#include "core/text.hpp"
#include "places.hpp"

namespace mien {
namespace {

TEST(shapes, guide_lines_stand_where_the_head_has_them) {
  HeadSpec spec;
  const auto adult = measure_guide_heights(build_neutral_head(spec, source_folder()));
  std::vector<std::string> names;
  for (const auto& [name, y] : adult) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"chin", "mouth_line", "nose_base", "eye_line", "brow_line",
                                             "hairline", "crown"}));
  EXPECT_NEAR(adult[3].second, 0, 1e-6);  // the origin is at the height of the pupils
  for (const char* age : {"infant", "child", "teenager"}) {
    spec.age = {{age, 1.0}};
    const NeutralHead head = build_neutral_head(spec, source_folder());
    const auto heights = measure_guide_heights(head);
    EXPECT_NEAR(heights[3].second, head.eye.centre.y, 1e-6) << age;
    EXPECT_NEAR(heights.back().second, find_bounds(head.skin.positions).high.y, 1e-4) << age;
    for (std::size_t i = 1; i < heights.size(); ++i)
      EXPECT_GT(heights[i].second, heights[i - 1].second + 5) << age << heights[i].first;
  }
}

TEST(shapes, moved_guide_lines_are_measured_where_they_were_moved) {
  HeadSpec spec;
  spec.guides = {{"eye_line", 0.46}, {"hairline", 0.8}, {"mouth_line", 0.22}};
  const auto heights = measure_guide_heights(build_neutral_head(spec, source_folder()));
  const double chin = heights.front().second, height = heights.back().second - chin;
  for (const auto& [name, y] : heights)
    if (spec.guides.contains(name)) {
      EXPECT_NEAR((y - chin) / height, spec.guides.at(name), 0.002) << name;
    }
}

TEST(shapes, character_is_a_feature_too) {
  HeadSpec key, feature;
  key.character = -0.75;
  feature.features = {{"character", -0.75}};
  EXPECT_EQ(build_neutral_head(key, source_folder()).cage.points,
            build_neutral_head(feature, source_folder()).cage.points);
}

// In a folder of its own with this text as features.yaml.
std::vector<FeatureInfo> load(const std::string& text) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "mien_features";
  write_file(folder / "features.yaml", text);
  return load_features(folder);
}

TEST(shapes, features_tell_their_meaning_and_view) {
  const auto features = load(
      "features:\n  b: {meaning: wide, handles: {p_tip: [0, 0, 1]}}\n"
      "  a: {meaning: long, view: side, around: [en_l, ex_l], handles: {M6_0: [1, 0, 0]}}\n");
  ASSERT_EQ(features.size(), 2u);
  EXPECT_EQ(features[0].name, "b");
  EXPECT_EQ(features[0].meaning, "wide");
  EXPECT_EQ(features[0].view, "three_quarter");
  EXPECT_EQ(features[1].view, "side");
  EXPECT_EQ(features[0].around, (std::vector<std::string>{"p_tip"}));
  EXPECT_EQ(features[1].around, (std::vector<std::string>{"en_l", "ex_l"}));
  EXPECT_TRUE(load_features("/nowhere").empty());
  try {
    load("features:\n  a: {meaning: long,\n    view: top}\n");
    FAIL();
  } catch (const RunError& e) {
    EXPECT_TRUE(std::string(e.what()).ends_with(
        "features.yaml:3: unknown view 'top'; expected front, three_quarter or side"))
        << e.what();
  }
}

}  // namespace
}  // namespace mien

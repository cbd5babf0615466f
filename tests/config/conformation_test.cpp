// Parke's conformation parameters: a head shaped by the names that he gave.
#include "config/conformation.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "config/config_fixture.hpp"

namespace mien {
namespace {

using Features = std::map<std::string, double>;

Features load_features_of(const std::string& head) {
  return load_text("mien: 1\nhead: " + head + "\n").head.features;
}

TEST(conformation, shapes_features_that_there_are_each_parameter_one_at_least) {
  for (const ConformationRow& row : kConformationRows) {
    const Features up = load_features_of(fmt::format("{{conformation: {{{}: 0.5}}}}", row.name));
    const Features down = load_features_of(fmt::format("{{conformation: {{{}: -0.5}}}}", row.name));
    EXPECT_FALSE(up.empty()) << row.name;
    ASSERT_EQ(up.size(), down.size()) << row.name;
    for (const auto& [feature, value] : up) {
      EXPECT_EQ(down.at(feature), -value) << row.name;
      EXPECT_EQ(load_features_of(fmt::format("{{features: {{{}: {}}}}}", feature, value)).at(feature), value)
          << row.name;
    }
  }
}

TEST(conformation, adds_up_and_ends_at_one) {
  EXPECT_EQ(load_features_of("{conformation: {jaw_width: 0.5}}"),
            (Features{{"jaw_width", 0.5}, {"jaw_angle", 0.2}}));
  const Features both = load_features_of("{conformation: {jaw_width: 0.5, head_aspect: 0.5}}");
  EXPECT_NEAR(both.at("jaw_width"), 0.85, 1e-12);
  EXPECT_NEAR(both.at("chin_height"), -0.3, 1e-12);
  EXPECT_EQ(load_features_of("{conformation: {jaw_width: 1, head_aspect: 1}}").at("jaw_width"), 1);
}

TEST(conformation, is_below_features_whichever_stands_first) {
  const Features features{{"jaw_width", -0.1}, {"jaw_angle", 0.2}};
  EXPECT_EQ(load_features_of("{conformation: {jaw_width: 0.5}, features: {jaw_width: -0.1}}"), features);
  EXPECT_EQ(load_features_of("{features: {jaw_width: -0.1}, conformation: {jaw_width: 0.5}}"), features);
}

TEST(conformation, holds_where_the_rest_of_a_head_is_drawn_at_random) {
  const Features drawn = load_features_of("{random: 7}"),
                 said = load_features_of("{random: 7, conformation: {nose_length: 0.75}}");
  EXPECT_EQ(said.at("nose_length"), 0.75);
  EXPECT_NE(drawn.at("nose_length"), 0.75);
  EXPECT_EQ(said.at("mouth_width"), drawn.at("mouth_width"));
}

TEST(conformation, changes_in_time) {
  const Spec spec = load_text(
      "mien: 1\nclip: {length: 2s, head: [{at: 0s}, {at: 1s, conformation: {eye_separation: 0.4}}]}\n");
  EXPECT_EQ(spec.clip.head[1].head.features, (Features{{"eye_spacing", 0.4}}));
}

}  // namespace
}  // namespace mien

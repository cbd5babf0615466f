#include "clip/ink_lamp.hpp"

#include <gtest/gtest.h>

#include "clip/view.hpp"
#include "config/words.hpp"

namespace mien {
namespace {

float brightness(const glm::vec3& colour) { return colour.r + colour.g + colour.b; }

TEST(ink_lamp, is_ink_s_own_unless_a_clip_says_lights) {
  CameraView view;
  view.angle_deg = 25;
  EXPECT_FALSE(find_ink_lamp({}, view));
  const InkLamp lamp = *find_ink_lamp({{"studio", 1, 0}}, view);
  const InkView own = compute_ink_view(view, {}), asked = compute_ink_view(view, {}, lamp);
  EXPECT_LT(glm::distance(own.to_light, asked.to_light), 1e-9);
  EXPECT_EQ(lamp.lit, glm::vec3(1));
  EXPECT_EQ(lamp.dark, glm::vec3(1));
  EXPECT_EQ(lamp.flat, glm::vec3(1));
}

TEST(ink_lamp, every_light_set_has_its_own) {
  const InkLamp studio = *find_ink_lamp({{"studio", 1, 0}}, {});
  for (const Word& set : kLightSetWords) {
    const InkLamp lamp = *find_ink_lamp({{std::string(set.name), 1, 0}}, {});
    EXPECT_NEAR(glm::length(lamp.to_light), 1, 1e-9) << set.name;
    if (set.name == "studio") continue;
    EXPECT_GT(glm::distance(lamp.to_light, studio.to_light), 0.2) << set.name;
    EXPECT_LT(brightness(lamp.dark), 0.8f * brightness(studio.dark)) << set.name;
  }
}

TEST(ink_lamp, stands_where_the_set_s_key_does) {
  const auto find_way = [](const char* set, double angle_deg) {
    return find_ink_lamp({{set, 1, angle_deg}}, {})->to_light;
  };
  EXPECT_LT(find_way("side", 0).x, -0.7) << "on the picture's left";
  EXPECT_GT(find_way("moon", 0).x, 0.5) << "on its right";
  EXPECT_LT(find_way("low", 0).y, -0.7) << "from below";
  EXPECT_LT(find_way("rim", 0).z, -0.5) << "from behind";
  EXPECT_GT(find_way("side", 90).x, find_way("side", 0).x)
      << "an author's angle goes to the character's left";
}

TEST(ink_lamp, goes_from_one_to_the_other_and_fades) {
  const CameraView view;
  const InkLamp from = *find_ink_lamp({{"side", 1, 0}}, view), to = *find_ink_lamp({{"moon", 1, 0}}, view),
                between = *find_ink_lamp({{"side", 0.5, 0}, {"moon", 0.5, 0}}, view),
                half = *find_ink_lamp({{"side", 0.5, 0}}, view);
  EXPECT_LT(from.to_light.x, between.to_light.x);
  EXPECT_LT(between.to_light.x, to.to_light.x);
  EXPECT_NEAR(between.lit.r, (from.lit.r + to.lit.r) / 2, 1e-6);
  EXPECT_NEAR(half.lit.r, from.lit.r / 2, 1e-6);
  EXPECT_LT(glm::distance(half.to_light, from.to_light), 1e-9);
}

TEST(ink_lamp, what_is_flat_is_as_bright_as_what_it_is_seen_beside) {
  const InkLamp behind = *find_ink_lamp({{"rim", 1, 0}}, {}), before = *find_ink_lamp({{"low", 1, 0}}, {});
  EXPECT_EQ(behind.flat, behind.dark);
  EXPECT_EQ(before.flat, before.lit);
}

}  // namespace
}  // namespace mien

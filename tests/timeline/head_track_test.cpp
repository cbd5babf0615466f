#include "timeline/head_track.hpp"

#include <gtest/gtest.h>

#include "timeline/drawings.hpp"

namespace mien {
namespace {

HeadSpec of_age(const char* age) {
  HeadSpec head;
  head.age = {{age, 1.0}};
  return head;
}

HeadKey key_at(double at_s, const HeadSpec& head) {
  HeadKey key;
  key.at_s = at_s;
  key.ease = Easing::linear;
  key.head = head;
  return key;
}

TEST(head_track, has_its_keys_heads_exactly) {
  HeadSpec grown = of_age("adult");
  grown.guides["eye_line"] = 0.5;
  grown.look.lips = glm::vec3(0.7f, 0.2f, 0.3f);
  const std::vector<HeadKey> keys{key_at(1, of_age("infant")), key_at(3, grown)};
  for (const double before : {0.0, 1.0})
    EXPECT_EQ(compute_head_key(sample_head(keys, before)), compute_head_key(of_age("infant")));
  for (const double after : {3.0, 9.0})
    EXPECT_EQ(compute_head_key(sample_head(keys, after)), compute_head_key(grown));
  EXPECT_TRUE(sample_head(keys, 3).guide_shares.empty());
}

TEST(head_track, mixes_the_forms_of_two_persons) {
  HeadSpec from = of_age("infant"), to = of_age("adult");
  to.sculpt = {{"chin", {0, -3, 0}, 25}};
  const std::vector<HeadKey> keys{key_at(0, from), key_at(2, to)};
  const HeadSpec between = sample_head(keys, 0.5);
  ASSERT_EQ(between.mix.size(), 2u);
  EXPECT_EQ(between.mix[0].weight, 0.75);
  EXPECT_EQ(between.mix[0].head.age, from.age);
  EXPECT_EQ(between.mix[1].head.sculpt, to.sculpt);
  EXPECT_TRUE(between.sculpt.empty()) << "it is in the form that is mixed";
  EXPECT_NE(compute_head_key(between), compute_head_key(sample_head(keys, 1)));
  EXPECT_EQ(compute_head_key(sample_head(keys, 2)), compute_head_key(to));
}

TEST(head_track, mixes_what_lies_between) {
  HeadSpec from = of_age("infant"), to = of_age("adult");
  from.features["nose_length"] = 0.4;
  to.character = 1;
  to.guides["eye_line"] = 0.5;
  to.look.skin = from.look.skin * 0.5f;
  to.look.lips = glm::vec3(0.5f);
  to.look.age_spots = 0.6;
  const HeadSpec half = sample_head({key_at(0, from), key_at(2, to)}, 1);
  EXPECT_EQ(half.age, (Mix{{"infant", 0.5}, {"adult", 0.5}}));
  EXPECT_EQ(half.skull, from.skull);
  EXPECT_DOUBLE_EQ(half.features.at("nose_length"), 0.2);
  EXPECT_DOUBLE_EQ(half.character, 0.5);
  EXPECT_DOUBLE_EQ(half.guides.at("eye_line"), 0.5) << "its place is known; it goes half the way there";
  EXPECT_DOUBLE_EQ(half.guide_shares.at("eye_line"), 0.5);
  EXPECT_NEAR(half.look.skin.x, from.look.skin.x * 0.75, 1e-6);
  EXPECT_EQ(half.look.lips, to.look.lips);
  EXPECT_DOUBLE_EQ(half.look.lips_share, 0.5);
  EXPECT_DOUBLE_EQ(half.look.age_spots, 0.3);
}

TEST(head_track, tells_heads_apart_by_each_thing_that_may_change) {
  const HeadSpec plain;
  std::vector<HeadSpec> heads(10);
  heads[1].age = {{"child", 1.0}};
  heads[2].skull = {{"round", 1.0}};
  heads[3].character = 0.1;
  heads[4].guides["eye_line"] = 0.5;
  heads[5].features["nose_length"] = 0.5;
  heads[6].look.iris = glm::vec3(0);
  heads[7].look.lips = glm::vec3(0);
  heads[8].look.freckles = 0.5;
  heads[9].look.age_spots = 0.5;
  for (std::size_t i = 0; i < heads.size(); ++i)
    for (std::size_t j = 0; j < heads.size(); ++j)
      EXPECT_EQ(compute_head_key(heads[i]) == compute_head_key(heads[j]), i == j) << i << " " << j;
  EXPECT_EQ(compute_head_key(plain), compute_head_key(heads[0]));
}

TEST(head_track, makes_drawings_differ_while_the_head_grows) {
  ClipSpec clip;
  clip.draw = 2;
  clip.length_s = 1;
  clip.keys = {PoseKey{}};
  clip.head = {key_at(0, of_age("infant")), key_at(0.5, of_age("child"))};
  const std::vector<int> first = compute_drawings(build_performance(clip));
  ASSERT_EQ(first.size(), 24u);
  for (int frame = 0; frame < 24; ++frame)
    EXPECT_EQ(first[static_cast<std::size_t>(frame)], std::min(frame - frame % 2, 12)) << frame;
}

}  // namespace
}  // namespace mien

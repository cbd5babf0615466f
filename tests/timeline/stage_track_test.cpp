#include "timeline/stage_track.hpp"

#include <gtest/gtest.h>

namespace mien {
namespace {

ClipSpec make_clip() {
  ClipSpec clip;
  clip.camera.resize(2);
  clip.camera[1].at_s = 2;
  clip.camera[1].ease = Easing::linear;
  clip.camera[1].lens_mm = 50;
  clip.camera[1].aim.kind = Aim::Kind::landmark;
  clip.camera[1].aim.landmark = "nose_tip";
  clip.light.resize(3);
  clip.light[1] = {1, Easing::linear, "moon", 0.5, 20};
  clip.light[2] = {2, Easing::linear, "moon", 1.5, -20};
  clip.background.resize(2);
  clip.background[1] = {2, Easing::linear, "studio", glm::vec3(0.1f, 0.2f, 0.3f)};
  return clip;
}

TEST(stage_track, says_nothing_of_lights_that_nobody_set) {
  ClipSpec clip;
  clip.camera.resize(1);
  const StageMoment moment = sample_stage(clip, 1);
  EXPECT_TRUE(moment.lights.empty());
  EXPECT_TRUE(moment.backgrounds.empty());
  EXPECT_EQ(moment.lens_mm, kPortraitLens_mm);
  ASSERT_EQ(moment.aims.size(), 1u);
  EXPECT_EQ(moment.aims[0].aim.kind, Aim::Kind::frame);
}

TEST(stage_track, is_exactly_a_key_at_its_time) {
  const StageMoment moment = sample_stage(make_clip(), 2);
  ASSERT_EQ(moment.lights.size(), 1u);
  EXPECT_EQ(moment.lights[0].set, "moon");
  EXPECT_EQ(moment.lights[0].bright, 1.5);
  EXPECT_EQ(moment.lights[0].angle_deg, -20);
  ASSERT_EQ(moment.backgrounds.size(), 1u);
  EXPECT_EQ(moment.backgrounds[0].colour, glm::vec3(0.1f, 0.2f, 0.3f));
  ASSERT_EQ(moment.aims.size(), 1u);
  EXPECT_EQ(moment.aims[0].aim.landmark, "nose_tip");
  EXPECT_EQ(moment.lens_mm, 50);
}

TEST(stage_track, fades_one_set_into_another_and_carries_a_set_that_stays) {
  const StageMoment fading = sample_stage(make_clip(), 0.25);
  ASSERT_EQ(fading.lights.size(), 2u);
  EXPECT_EQ(fading.lights[0].set, "studio");
  EXPECT_DOUBLE_EQ(fading.lights[0].bright, 0.75);
  EXPECT_EQ(fading.lights[1].set, "moon");
  EXPECT_DOUBLE_EQ(fading.lights[1].bright, 0.25 * 0.5);
  ASSERT_EQ(fading.backgrounds.size(), 2u);
  EXPECT_DOUBLE_EQ(fading.backgrounds[0].share + fading.backgrounds[1].share, 1);
  ASSERT_EQ(fading.aims.size(), 2u);
  EXPECT_DOUBLE_EQ(fading.aims[1].share, 0.125);

  const StageMoment turning = sample_stage(make_clip(), 1.5);
  ASSERT_EQ(turning.lights.size(), 1u);
  EXPECT_DOUBLE_EQ(turning.lights[0].bright, 1);
  EXPECT_DOUBLE_EQ(turning.lights[0].angle_deg, 0);
}

TEST(stage_track, tells_moments_apart) {
  const ClipSpec clip = make_clip();
  EXPECT_EQ(compute_stage_key(sample_stage(clip, 3)), compute_stage_key(sample_stage(clip, 4)));
  EXPECT_NE(compute_stage_key(sample_stage(clip, 0.5)), compute_stage_key(sample_stage(clip, 0.6)));
}

}  // namespace
}  // namespace mien

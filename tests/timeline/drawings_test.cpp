#include "timeline/drawings.hpp"

#include <gtest/gtest.h>

namespace mien {
namespace {

ClipSpec make_clip(int draw) {
  ClipSpec clip;
  clip.draw = draw;
  clip.length_s = 1;
  clip.keys = {PoseKey{}, PoseKey{}, PoseKey{}};
  clip.keys[1].at_s = 0.5;
  clip.keys[1].pose.values[0] = 1;
  clip.keys[2].at_s = 1;
  clip.camera = {CameraKey{}};
  clip.turn = {TurnKey{}};
  return clip;
}

TEST(drawings, held_frames_fall_together) {
  const std::vector<int> twos = compute_drawings(build_performance(make_clip(2)));
  ASSERT_EQ(twos.size(), 24u);
  for (std::size_t i = 0; i + 1 < twos.size(); i += 2) EXPECT_EQ(twos[i], twos[i + 1]);
}

TEST(drawings, a_frame_never_repeats_a_later_one) {
  const std::vector<int> ones = compute_drawings(build_performance(make_clip(1)));
  for (std::size_t i = 0; i < ones.size(); ++i) {
    EXPECT_LE(ones[i], static_cast<int>(i));
    EXPECT_EQ(ones[ones[i]], ones[i]);
  }
}

TEST(drawings, a_clip_at_rest_is_one_drawing) {
  ClipSpec clip = make_clip(1);
  clip.keys[1].pose = Pose{};
  for (const int first : compute_drawings(build_performance(clip))) EXPECT_EQ(first, 0);
}

TEST(drawings, other_light_is_another_drawing) {
  ClipSpec clip = make_clip(1);
  clip.keys[1].pose = Pose{};
  clip.light.resize(2);
  clip.light[1] = {0.5, Easing::linear, "studio", 0.5, 0};
  const std::vector<int> first = compute_drawings(build_performance(clip));
  EXPECT_EQ(first[11], 11);
  EXPECT_EQ(first[12], 12);
  EXPECT_EQ(first[23], 12) << "the light stays as it was";
}

TEST(drawings, of_equal_keys_the_poster_shows_the_first) {
  ClipSpec clip = make_clip(1);
  clip.keys[2].pose.values[1] = -1;
  EXPECT_EQ(find_poster_frame(clip), 12);
}

TEST(drawings, the_poster_shows_the_strongest_key) { EXPECT_EQ(find_poster_frame(make_clip(2)), 12); }

}  // namespace
}  // namespace mien

// What a clip's files show: which frames in which order, and what is written on them.
#include <gtest/gtest.h>

#include "clip/pictures.hpp"
#include "clip/slate.hpp"
#include "shipped.hpp"
#include "sketch/lettering.hpp"

namespace mien {
namespace {

using Shown = std::vector<std::size_t>;

Clip clip_of(int count) {
  Clip clip;
  for (int i = 1; i <= count; ++i) clip.plan.frames.push_back(i);
  clip.plan.drawn_as = clip.plan.drawings = clip.plan.frames;
  clip.frame_count = count;
  clip.files.name = "face";
  clip.files.folder = "out/face";
  return clip;
}

TEST(shown, frames_go_forth_and_back_without_an_end_twice) {
  Clip clip = clip_of(4);
  EXPECT_EQ(list_shown_frames(clip, "a.mp4"), (Shown{0, 1, 2, 3}));
  clip.video.is_boomerang = true;
  EXPECT_EQ(list_shown_frames(clip, "a.mp4"), (Shown{0, 1, 2, 3, 2, 1}));
  clip.video.rounds = 2;
  EXPECT_EQ(list_shown_frames(clip, "a.mov"), (Shown{0, 1, 2, 3, 2, 1, 0, 1, 2, 3, 2, 1}));
  EXPECT_EQ(list_shown_frames(clip, "a.gif"), (Shown{0, 1, 2, 3, 2, 1})) << "it says so itself";
  for (const int few : {1, 2}) {
    Clip still = clip_of(few);
    still.video.is_boomerang = true;
    EXPECT_EQ(list_shown_frames(still, "a.mp4").size(), static_cast<std::size_t>(few));
  }
}

TEST(shown, otherwise_than_plainly_a_clip_is_called_so) {
  Clip clip = clip_of(3);
  EXPECT_EQ(list_video_paths(clip).front(), "out/face/face.mp4");
  clip.video = {3, 0, true, true};
  EXPECT_EQ(list_video_paths(clip).front(), "out/face/face_boomerang_loop3_slate.mp4");
  clip.videos = {"a.gif"};
  EXPECT_EQ(list_video_paths(clip).front(), "a.gif");
}

TEST(slate, names_the_key_that_is_shown_and_the_one_to_come) {
  Clip clip = clip_of(24);
  clip.spec.clip.fps = 24;
  ClipSpec play;
  play.fps = 24;
  const auto add = [&](double at_s, const char* label) {
    PoseKey& key = play.keys.emplace_back();
    key.at_s = at_s;
    key.label = label;
  };
  add(0.125, "neutral");
  add(0.25, "smile 0.8");
  add(0.5, "smile 0.8");
  clip.actors.push_back({"", {}, {}, Performance{}});
  clip.actors[0].performance.clip = play;
  EXPECT_EQ(build_slate(clip, 1).keys, "to neutral");
  EXPECT_EQ(build_slate(clip, 4).keys, "neutral");
  EXPECT_EQ(build_slate(clip, 5).keys, "neutral to smile 0.8");
  EXPECT_EQ(build_slate(clip, 7).keys, "smile 0.8");
  EXPECT_EQ(build_slate(clip, 9).keys, "smile 0.8") << "it stays";
  EXPECT_EQ(build_slate(clip, 24).keys, "smile 0.8");
  EXPECT_EQ(build_slate(clip, 7).frame, "0007/0024");
  EXPECT_EQ(build_slate(clip, 7).time, "0.250 s");
  clip.actors.push_back(clip.actors[0]);
  clip.actors[0].name = "ann";
  clip.actors[1].name = "otto";
  EXPECT_EQ(build_slate(clip, 4).keys, "ann: neutral, otto: neutral");
}

TEST(slate, stays_on_its_strip) {
  const Letters letters = find_letters(shipped_stock().templates);
  for (const PictureSize size : {PictureSize{64, 80}, {480, 600}, {600, 120}}) {
    Pixels picture = make_pixels(size);
    std::fill(picture.rgb.begin(), picture.rgb.end(), std::uint8_t{128});
    const Pixels before = picture;
    draw_slate(picture, {"0001/0024", "0.000 s", std::string(200, 'W')}, letters);
    const std::size_t row = 3 * static_cast<std::size_t>(size.width_px);
    std::size_t first = 0;
    while (first < picture.rgb.size() && picture.rgb[first] == before.rgb[first]) ++first;
    const double changed = 1 - static_cast<double>(first / row) / size.height_px;
    EXPECT_GT(changed, 0.01) << size.width_px;
    EXPECT_LT(changed, 0.25) << size.width_px;
    EXPECT_GT(*std::max_element(picture.rgb.begin() + static_cast<std::ptrdiff_t>(first), picture.rgb.end()),
              240)
        << "its letters are white";
  }
}

TEST(lettering, is_left_out_where_there_is_no_picture) {
  const Letters letters = find_letters(shipped_stock().templates);
  Pixels picture = make_pixels({20, 10});
  WrittenLine line;
  line.words = "FACE";
  line.width_px = 100;
  for (const double left_px : {-30.0, 15.0, 300.0})
    for (const double base_px : {-20.0, 2.0, 14.0, 90.0}) {
      line.left_px = left_px;
      line.base_px = base_px;
      write_line(picture, line, letters);
      cover_box(picture, static_cast<int>(left_px), static_cast<int>(base_px), {30, 30}, {1, 1, 1}, 0.5);
    }
  EXPECT_EQ(picture.rgb.size(), 600u);
}

}  // namespace
}  // namespace mien

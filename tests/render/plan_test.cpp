#include "render/plan.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/text.hpp"

namespace mien {
namespace {

TEST(plan, draws_each_drawing_once) {
  const FramePlan plan = plan_frames({0, 0, 2, 2, 0, 5}, std::nullopt);
  EXPECT_EQ(plan.frames, (std::vector<int>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(plan.drawn_as, (std::vector<int>{1, 1, 3, 3, 1, 6}));
  EXPECT_EQ(plan.drawings, (std::vector<int>{1, 3, 6}));
}

TEST(plan, draws_a_held_frame_whose_drawing_was_not_asked_for) {
  const FramePlan plan = plan_frames({0, 0, 2, 2, 0, 5}, std::pair{4, 5});
  EXPECT_EQ(plan.frames, (std::vector<int>{4, 5}));
  EXPECT_EQ(plan.drawn_as, (std::vector<int>{4, 5}));
  EXPECT_EQ(plan.drawings, (std::vector<int>{4, 5}));
}

TEST(plan, refuses_frames_outside_the_clip) {
  for (const auto& [range, message] : std::vector<std::pair<std::pair<int, int>, std::string>>{
           {{0, 2}, "--frames 0-2: the clip has 3 frames; expected A-B within 1-3"},
           {{2, 1}, "--frames 2-1: the clip has 3 frames; expected A-B within 1-3"},
           {{1, 4}, "--frames 1-4: the clip has 3 frames; expected A-B within 1-3"}}) {
    try {
      plan_frames({0, 1, 2}, range);
      FAIL() << message;
    } catch (const InputError& e) {
      EXPECT_EQ(e.what(), message);
    }
  }
}

TEST(plan, names_frames_with_four_digits_and_more_when_needed) {
  EXPECT_EQ(name_frame(7), "f0007");
  EXPECT_EQ(name_frame(12345), "f12345");
}

TEST(plan, knows_its_own_files) {
  for (const char* name : {"f0001.pov", "f12345.png", "h0007.inc", "head.inc", "loop.pov", "hello.ini"})
    EXPECT_TRUE(is_clip_file(name)) << name;
  for (const char* name : {"photo.png", "f004x.png", "f0001.jpg", "heads.inc", ""})
    EXPECT_FALSE(is_clip_file(name)) << name;
}

TEST(plan, finds_only_its_own_stale_files) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "mien_plan_test";
  std::filesystem::remove_all(folder);
  const ClipFiles files{folder, "x"};
  for (const char* name : {"f0001.png", "f0004.png", "f004x.png", "photo.png", "f0005.pov"})
    write_file(folder / "frames" / name, "x");
  write_file(files.scene(9), "x");
  std::filesystem::create_directories(folder / "frames/f0008.png");  // somebody's own
  EXPECT_EQ(find_stale_files(files, 3),
            (std::vector<std::filesystem::path>{folder / "frames/f0004.png", folder / "frames/f0005.pov",
                                                folder / "scenes/f0009.pov"}));
  EXPECT_TRUE(find_stale_files({folder / "nowhere", "x"}, 3).empty());
}

}  // namespace
}  // namespace mien

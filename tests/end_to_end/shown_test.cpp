// Clips shown otherwise than plainly, transparent ones, and contact sheets.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "end_to_end/program.hpp"
#include "render/picture.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Eight frames that end as they begin, and nothing that moves by itself.
constexpr const char* kThereAndBack = R"(mien: 1
title: There
clip:
  fps: 8
  length: 1s
  keys:
    - {at: 0s, express: neutral}
    - {at: 0.25s, express: neutral}
    - {at: 0.5s, express: shout, ease: linear}
    - {at: 0.75s, express: neutral, ease: linear}
render: {size: 48x60, quality: draft}
)";

// Of each frame of a clip how its picture differs from the first one's.
std::vector<double> list_differences(const fs::path& folder, const std::string& clip) {
  run_shell(folder, "rm -f f*.png; ffmpeg -v error -i " + clip + " f%03d.png");
  std::vector<double> differences;
  Pixels first;
  for (int i = 1; fs::exists(folder / fmt::format("f{:03}.png", i)); ++i) {
    const Pixels picture = read_pixels(folder / fmt::format("f{:03}.png", i));
    if (i == 1) first = picture;
    double sum = 0;
    for (std::size_t k = 0; k < picture.rgb.size(); ++k) sum += std::abs(picture.rgb[k] - first.rgb[k]);
    differences.push_back(sum / static_cast<double>(picture.rgb.size()));
  }
  return differences;
}

TEST(shown_clips, come_back_to_drawings_that_were_before) {
  const auto folder = make_folder("shown_back");
  write_file(folder / "a.yaml", kThereAndBack);
  const ProgramRun run = run_shell(folder, "mien render a.yaml --quality sketch --quiet -o a.mov");
  ASSERT_EQ(run.status, 0) << run.err;
  const std::vector<double> apart = list_differences(folder, "a.mov");
  ASSERT_EQ(apart.size(), 8u);
  constexpr double kSame = 0.5, kOther = 2;
  for (const std::size_t rest : {0u, 1u, 2u, 6u, 7u}) EXPECT_LT(apart[rest], kSame) << rest;
  EXPECT_GT(apart[4], kOther) << "the shout";
  EXPECT_LT(apart[3], apart[4]);
  EXPECT_LT(apart[5], apart[4]);
}

TEST(shown_clips, go_forth_and_back_again_and_again) {
  const auto folder = make_folder("shown_rounds");
  write_file(folder / "a.yaml", kThereAndBack);
  for (const char* quality : {"sketch", "draft"}) {
    const std::string name = fmt::format("{}.mov", quality);
    const ProgramRun run =
        run_shell(folder, fmt::format("mien render a.yaml --frames 3-5 --boomerang --loop=2 --nice --quiet "
                                      "--size 24x30 --quality {} -o {} -o a.gif",
                                      quality, name));
    ASSERT_EQ(run.status, 0) << run.err;
    const std::vector<double> apart = list_differences(folder, name);
    ASSERT_EQ(apart.size(), 8u) << "3 4 5 4, twice";
    constexpr double kSame = 0.5;
    EXPECT_GT(apart[2], 2 * kSame);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(apart[i], apart[i + 4], kSame) << quality << " " << i;
    EXPECT_NEAR(apart[1], apart[3], kSame) << quality;
    EXPECT_EQ(list_differences(folder, "a.gif").size(), 4u) << quality;
  }
}

TEST(shown_clips, have_a_slate_and_leave_frames_and_poster_alone) {
  const auto folder = make_folder("shown_slate");
  write_file(folder / "a.yaml", kThereAndBack);
  ASSERT_EQ(run_shell(folder, "mien render a.yaml --frames 5-6 --quiet").status, 0);
  const std::string frame = read_file(folder / "out/a/frames/f0005.png"),
                    poster = read_file(folder / "out/a/poster.png"),
                    clip = read_file(folder / "out/a/a_5-6.mp4");
  const ProgramRun run = run_shell(folder, "mien render a.yaml --frames 5-6 --slate");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr(", 0 to trace\n"));
  EXPECT_TRUE(fs::exists(folder / "out/a/a_5-6_slate.mp4"));
  EXPECT_EQ(read_file(folder / "out/a/frames/f0005.png"), frame);
  EXPECT_EQ(read_file(folder / "out/a/poster.png"), poster);
  EXPECT_EQ(read_file(folder / "out/a/a_5-6.mp4"), clip);
}

TEST(transparent, pictures_are_so_where_nobody_is) {
  const auto folder = make_folder("transparent");
  std::string text = kThereAndBack;
  text.replace(text.find("draft}"), 6, "draft, background: none}");
  write_file(folder / "a.yaml", text);
  std::vector<Pixels> pictures;
  for (const char* quality : {"sketch", "draft"}) {
    const std::string still = fmt::format("{}.png", quality);
    ASSERT_EQ(
        run_shell(folder, fmt::format("mien still a.yaml --quality {} --quiet -o {}", quality, still)).status,
        0);
    const Pixels picture = read_pixels(folder / still);
    ASSERT_EQ(picture.alpha.size(), 48u * 60) << quality;
    EXPECT_EQ(picture.alpha[0], 0) << "a corner";
    EXPECT_EQ(picture.alpha[30 * 48 + 24], 255) << "the face";
    pictures.push_back(picture);
  }
  double apart = 0;
  for (std::size_t i = 0; i < pictures[0].alpha.size(); ++i)
    apart += std::abs(pictures[0].alpha[i] - pictures[1].alpha[i]);
  EXPECT_LT(apart / static_cast<double>(pictures[0].alpha.size()), 2) << "both draw the same outline";
  const ProgramRun run = run_shell(
      folder,
      "mien render a.yaml --frames 1-2 --quiet --beside real,comic -o a.mov -o a.webm -o a.webp -o a.apng");
  EXPECT_EQ(run.status, 0) << run.err;
}

TEST(contact_sheet, shows_drawings_and_traces_none_twice) {
  const auto folder = make_folder("contact");
  write_file(folder / "a.yaml", kThereAndBack);
  ASSERT_EQ(run_shell(folder, "mien sheet contact a.yaml --every 2 --size 24x30 -o one.png").status, 0);
  const ProgramRun again =
      run_shell(folder, "mien sheet contact a.yaml --every 2 --size 24x30 -o two.png --json");
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(read_file(folder / "one.png"), read_file(folder / "two.png"));
  EXPECT_THAT(again.err, HasSubstr("\"rendered\":0"));
  EXPECT_EQ(list_files(folder / "out/a/store").size(), 3u) << "two of three drawings, and drawings.txt";
  ASSERT_EQ(run_shell(folder, "mien sheet contact a.yaml --quality sketch --frames 2-8 --quiet").status, 0);
  EXPECT_TRUE(fs::exists(folder / "out/a/contact_sketch.png"));
  EXPECT_EQ(run_shell(folder, "mien sheet contact a.yaml -o c.jpg").err,
            "error: -o c.jpg: unknown kind of sheet '.jpg'; expected a name that ends in .png\n");
  EXPECT_EQ(run_shell(folder, "mien sheet contact a.yaml --actor ann").err,
            "error: --actor says nothing to 'mien sheet contact', which shows everybody\n");
  EXPECT_EQ(run_shell(folder, "mien sheet views a.yaml --every 2").err,
            "error: --every says nothing to 'mien sheet views'; expected it with 'mien sheet contact'\n");
}

}  // namespace
}  // namespace mien

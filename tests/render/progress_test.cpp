#include "render/progress.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "render/process.hpp"
#include "render/scratch.hpp"

namespace mien {
namespace {

using testing::MatchesRegex;

// What a Progress of four frames, one of them kept, writes to a file.
std::string write_progress(ProgressStyle style, bool is_finished = true) {
  std::FILE* file = std::tmpfile();
  {
    Progress progress(file, style, "frames", 4);
    progress.advance(true, 1);
    for (int number : {3, 2, 4}) progress.advance(false, number);
    if (is_finished) progress.finish();
  }
  std::string text(10000, '\0');
  std::rewind(file);
  text.resize(std::fread(text.data(), 1, text.size(), file));
  std::fclose(file);
  return text;
}

TEST(progress, fits_the_bar_to_the_width) {
  const ProgressState state{"frames", 18, 0, 48, 8.57};
  EXPECT_EQ(format_progress_bar(state, 90),
            "frames  [############--------------------]  18/48  2.1 frames/s  15 s left");
  EXPECT_EQ(format_progress_bar(state, 60), "frames  [###-------]  18/48  2.1 frames/s  15 s left");
  EXPECT_EQ(format_progress_bar(state, 45), "frames  [####---------]  18/48  2.1 frames/s");
  EXPECT_EQ(format_progress_bar(state, 30), "frames  [####---------]  18/48");
  EXPECT_EQ(format_progress_bar(state, 12), "frames 18/48");
  for (int width = 0; width < 120; ++width)
    EXPECT_LE(format_progress_bar(state, width).size(), static_cast<std::size_t>(width));
}

TEST(progress, counts_kept_frames_as_done_but_not_as_speed) {
  EXPECT_EQ(format_progress_bar({"frames", 10, 990, 1100, 20}, 80),
            "frames  [#######################---]  1000/1100  0.50 frames/s  3 min 20 s left");
  EXPECT_EQ(format_progress_bar({"frames", 0, 3, 4, 1}, 40), "frames  [#######---]  3/4");
}

TEST(progress, shows_a_full_and_an_empty_bar) {
  EXPECT_EQ(format_progress_bar({"scenes", 0, 0, 9, 0}, 30), "scenes  [---------------]  0/9");
  EXPECT_EQ(format_progress_bar({"scenes", 9, 0, 9, 1}, 30), "scenes  [###############]  9/9");
  EXPECT_EQ(format_progress_bar({"scenes", 0, 0, 0, 0}, 30), "scenes  [---------------]  0/0");
}

TEST(progress, tells_a_duration_in_words) {
  EXPECT_EQ(format_duration(0), "0 s");
  EXPECT_EQ(format_duration(59.4), "59 s");
  EXPECT_EQ(format_duration(59.6), "1 min 00 s");
  EXPECT_EQ(format_duration(125), "2 min 05 s");
  EXPECT_EQ(format_duration(4320), "1 h 12 min");
}

TEST(progress, is_plain_or_silent_or_json_as_asked) {
  EXPECT_THAT(write_progress(ProgressStyle::lines), MatchesRegex("frames: 3 done, 1 kept in 0.[0-9] s\n"));
  EXPECT_EQ(write_progress(ProgressStyle::quiet), "");
  std::istringstream lines(write_progress(ProgressStyle::json));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, R"({"event":"frame","stage":"frames","frame":1,"done":1,"total":4,"kept":1})");
  for (int i = 0; i < 4; ++i) std::getline(lines, line);
  const auto end = nlohmann::json::parse(line);
  EXPECT_EQ(end["event"], "stage");
  EXPECT_EQ(end["rendered"], 3);
  EXPECT_FALSE(std::getline(lines, line));
}

TEST(progress, erases_its_bar_before_the_last_word) {
  ::setenv("NO_COLOR", "1", 1);
  ::setenv("LC_ALL", "C", 1);
  const std::string erase = "\r\x1b[2K";
  EXPECT_EQ(write_progress(ProgressStyle::bar, false),
            erase + "frames  [--------------------------------]  0/4" + erase);
  const std::string finished = write_progress(ProgressStyle::bar);
  EXPECT_NE(finished.find(erase + "frames: 3 done, 1 kept in 0.0 s\n"), std::string::npos) << finished;
  ::setenv("LC_ALL", "C.UTF-8", 1);
  EXPECT_THAT(write_progress(ProgressStyle::bar), testing::HasSubstr("frames  ╌╌╌╌"));
  ::unsetenv("NO_COLOR");
  ::unsetenv("LC_ALL");
}

TEST(progress, takes_a_bar_for_terminals_only) {
  std::FILE* file = std::tmpfile();
  EXPECT_EQ(compute_progress_style(file, false, false), ProgressStyle::lines);
  EXPECT_EQ(compute_progress_style(file, false, true), ProgressStyle::json);
  EXPECT_EQ(compute_progress_style(file, true, true), ProgressStyle::quiet);
  std::fclose(file);
}

}  // namespace
}  // namespace mien

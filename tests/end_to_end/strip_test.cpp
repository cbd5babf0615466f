// A clip on paper, as a person makes it.
#include <gtest/gtest.h>

#include "end_to_end/program.hpp"

namespace mien {
namespace {

constexpr const char* kClip = R"(mien: 1
title: "</text><script>alert('&')</script>"
clip:
  draw: twos
  keys:
    - {at: 0s, express: neutral}
    - {at: 4f, express: smile}
  length: 6f
  gaze: camera
render: {size: 96x120, quality: draft}
)";

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++found;
  return found;
}

TEST(clip_sheet, strip_has_the_drawings_and_the_curves_and_its_words_stay_words) {
  const auto folder = make_folder("strip");
  write_file(folder / "a.yaml", kClip);
  ProgramRun run = run_shell(folder, "mien sheet strip a.yaml --size 32x40");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, "sheet   out/a/strip.svg\n");
  const std::string svg = read_file(folder / "out/a/strip.svg");
  EXPECT_EQ(count(svg, "<image"), 3u);
  EXPECT_EQ(count(svg, "<script"), 0u);
  EXPECT_NE(svg.find("&lt;script&gt;alert(&#39;&amp;&#39;)"), std::string::npos);
  EXPECT_NE(svg.find(">smile</text>"), std::string::npos);
  run = run_shell(folder, "mien sheet strip a.yaml --size 32x40 --jobs 2 --quiet -o again.svg");
  EXPECT_EQ(run.out + run.err, "");
  EXPECT_EQ(read_file(folder / "again.svg"), svg);
  EXPECT_EQ(list_files(folder), (std::vector<std::string>{"a.yaml", "again.svg", "out/a/strip.svg"}));
}

TEST(clip_sheet, exposure_has_a_line_for_each_frame) {
  const auto folder = make_folder("exposure");
  write_file(folder / "a.yaml", kClip);
  ProgramRun run = run_shell(folder, "mien sheet exposure a.yaml -o a.csv");
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string csv = read_file(folder / "a.csv");
  EXPECT_EQ(count(csv, "\n"), 7u);
  EXPECT_TRUE(
      csv.starts_with("frame,time_s,drawing,held,key,changed\n1,0,1,,neutral,\n2,0.041667,1,held,,\n"))
      << csv;
  EXPECT_NE(csv.find("\n5,0.166667,3,,smile,"), std::string::npos) << csv;
  run = run_shell(folder, "mien sheet exposure a.yaml -o a.xls");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err, "error: -o a.xls: unknown kind of sheet '.xls'; expected a name that ends in .csv\n");
  EXPECT_EQ(list_files(folder), (std::vector<std::string>{"a.csv", "a.yaml"}));
}

TEST(commands, check_warns_of_what_will_not_read_well_and_does_not_fail) {
  const auto folder = make_folder("advice");
  write_file(folder / "a.yaml",
             "mien: 1\nclip:\n  keys:\n    - {at: 0s, express: neutral}\n    - {at: 1s, express: neutral}\n"
             "    - {at: 25f, express: surprise}\n    - {at: 28f, express: surprise}\n"
             "    - {at: 2s, express: neutral}\n");
  ProgramRun run = run_shell(folder, "mien check a.yaml");
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_TRUE(run.out.starts_with("a.yaml:6:7: warning: on the way to 'surprise' the ")) << run.out;
  EXPECT_NE(run.out.find("a.yaml:7:7: warning: 'surprise' is held for 3 frames; a hold is read from 6 on"),
            std::string::npos)
      << run.out;
  // Both ways of a move count, each as far as it goes.
  write_file(folder / "b.yaml",
             "mien: 1\nclip:\n  keys:\n    - {at: 1s, areas: {corners: {up: 1, out: 1}}}\n"
             "    - {at: 25f, areas: {corners: {up: -1}}}\n    - {at: 2s, express: neutral}\n");
  run = run_shell(folder, "mien check b.yaml");
  const std::string_view moves = "the corner moves ";
  const std::size_t at = run.out.find(moves);
  ASSERT_NE(at, std::string::npos) << run.out;
  EXPECT_GT(std::stod(run.out.substr(at + moves.size())), 16) << run.out;
  run = run_shell(folder, "mien check a.yaml --json");
  EXPECT_TRUE(run.out.starts_with("{\"kind\":\"warning\",\"file\":\"a.yaml\",\"line\":6,\"column\":7,"))
      << run.out;
}

}  // namespace
}  // namespace mien

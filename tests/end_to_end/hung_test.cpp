// A tool that hangs is ended and told; one that works is waited for.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <thread>

#include "end_to_end/program.hpp"

namespace mien {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kHang = "echo working; sleep 300 & echo $! >>'{0}/ids'; echo $$ >>'{0}/ids'; wait\n";

// What is told of it, with a limit of two seconds.
std::string describe_hung(const std::string& program) {
  return program +
         " hung and was ended: for 2 s it said nothing and hardly worked; run again, or let MIEN_STALL_LIMIT "
         "be "
         "more seconds (0: no limit)\n  command: ";
}

bool are_gone(const std::filesystem::path& ids) {
  std::istringstream numbers(read_file(ids));
  int count = 0;
  for (pid_t id; numbers >> id; ++count)
    for (int i = 0; ::kill(id, 0) == 0; ++i) {
      std::error_code ignored;
      if (i == 200) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      const std::string stat = std::filesystem::exists(fmt::format("/proc/{}", id), ignored)
                                   ? read_file(fmt::format("/proc/{}/stat", id))
                                   : "";
      if (stat.find(") Z") != stat.npos) break;  // its parent is not ours
    }
  return count > 0;
}

TEST(hung, tools_are_ended_with_their_children_and_told) {
  const auto folder = make_folder("hung");
  write_file(folder / "a.yaml", std::string(kTinyClip) + "busts: [{express: laugh, triangles: 8000}]\n");
  struct Case {
    const char *program, *command, *start;
  };
  for (const auto& [program, command, start] :
       {Case{"povray", "still a.yaml -o a.png", "error: frame 1: "},
        Case{"povray", "render a.yaml -o X", "error: frame 1: "},
        Case{"openscad", "bust a.yaml --openscad --no-stl -o b", "error: b/bust_laugh.scad: "},
        Case{"ffmpeg", "render a.yaml -o X", "error: X/a.mp4: "},
        Case{"ffprobe", "render a.yaml -o X", "error: "}}) {
    std::filesystem::remove(folder / "ids");
    std::filesystem::remove_all(folder / "bin");
    const std::string path = make_program(folder, program, fmt::format(fmt::runtime(kHang), folder.string()));
    const ProgramRun run =
        run_shell(folder, fmt::format("{}MIEN_STALL_LIMIT=2 mien {} --quiet", path, command));
    EXPECT_EQ(run.status, 1) << command;
    EXPECT_THAT(run.err, StartsWith(start + describe_hung(program))) << command;
    EXPECT_THAT(run.err, testing::EndsWith("\n  working\n")) << command;
    EXPECT_TRUE(are_gone(folder / "ids")) << command;
  }
  for (const std::string& file : list_files(folder)) EXPECT_EQ(file.find(".mien"), file.npos) << file;
}

TEST(hung, a_real_povray_is_ended) {
  const auto folder = make_folder("hung_povray");
  write_file(folder / "a.yaml", kTinyClip);
  // It waits for somebody to write what it includes, and wakes a hundred times a second meanwhile.
  const std::string path = make_program(folder, "povray",
                                        "mkfifo head.inc.new && mv head.inc.new "
                                        "head.inc\nPATH=/usr/local/bin:/usr/bin:/bin exec povray \"$@\"\n");
  const ProgramRun run = run_shell(folder, path + "MIEN_STALL_LIMIT=4 mien still a.yaml -o a.png");
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, StartsWith("error: frame 1: povray hung and was ended: for 4 s it said nothing"));
}

TEST(hung, a_tool_that_computes_or_talks_is_not) {
  const auto folder = make_folder("not_hung");
  write_file(folder / "a.yaml", kTinyClip);
  // Four times the limit of silence, and then of idleness.
  const std::string path =
      make_program(folder, "povray",
                   "end=$(($(date +%s) + 4)); while [ $(date +%s) -lt $end ]; do :; done\n"
                   "for i in 1 2 3 4 5 6 7 8; do sleep 0.5; echo; done\nPATH=/usr/local/bin:/usr/bin:/bin "
                   "exec povray \"$@\"\n");
  const ProgramRun run = run_shell(folder, path + "MIEN_STALL_LIMIT=1 mien still a.yaml -o a.png");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(std::filesystem::exists(folder / "a.png"));
}

TEST(hung, a_wrong_limit_is_told_before_anything) {
  const auto folder = make_folder("hung_limit");
  write_file(folder / "a.yaml", kTinyClip);
  for (const char* limit : {"never", "-1", "10min", "inf", "nan"}) {
    const ProgramRun run = run_shell(folder, fmt::format("MIEN_STALL_LIMIT={} mien render a.yaml", limit));
    EXPECT_EQ(run.status, 2) << limit;
    EXPECT_EQ(run.err,
              fmt::format("error: MIEN_STALL_LIMIT: '{}' is not a number of seconds such as 600, or 0 for no "
                          "limit\n",
                          limit));
  }
  EXPECT_EQ(list_files(folder), std::vector<std::string>{"a.yaml"});
}

TEST(hung, a_flood_of_words_is_told_by_its_end) {
  const auto folder = make_folder("flood");
  write_file(folder / "a.yaml", kTinyClip);
  const std::string lines = make_program(folder, "povray",
                                         "i=0; while [ $i -lt 30000 ]; do echo \"warning $i of many that "
                                         "fill the screen\"; i=$((i+1)); done; exit 1\n");
  ProgramRun run = run_shell(folder, lines + "mien still a.yaml -o a.png");
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("\n  (29988 lines before these left out)\n  warning 29988 of many"));
  EXPECT_THAT(run.err, testing::EndsWith("\n  warning 29999 of many that fill the screen\n"));
  EXPECT_LT(run.err.size(), 2000u);
  const std::string line = make_program(folder, "povray", "head -c 1600000 /dev/zero | tr '\\0' x; exit 1\n");
  run = run_shell(folder, line + "mien still a.yaml -o a.png");
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, testing::EndsWith("xxx... (1599000 bytes more left out)\n"));
  EXPECT_LT(run.err.size(), 3000u);
}

}  // namespace
}  // namespace mien

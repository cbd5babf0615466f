// Streams that are closed, full or read by nobody; pipes as files; names that are no text.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "end_to_end/program.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

fs::path make_clip(const std::string& name) {
  const fs::path folder = make_folder(name);
  write_file(folder / "tiny.yaml", std::string(kTinyClip) + "busts: [{express: smile, triangles: 8000}]\n");
  write_file(folder / "bad.yaml", "mien: 1\nclip: {keys: [{at: 0s, express: smlie}]}\n");
  return folder;
}

struct Said {
  std::string command;
  bool has_out, has_err;  // whether it says something there
  int status = 0;         // where all that it says is heard
};

const std::vector<Said>& list_commands() {
  static const std::vector<Said> commands{{"render tiny.yaml", true, true},
                                          {"render tiny.yaml --json", true, true},
                                          {"render tiny.yaml --quiet", false, false},
                                          {"frames tiny.yaml", true, true},
                                          {"still tiny.yaml", true, false},
                                          {"sheet exposure tiny.yaml", true, false},
                                          {"sheet views tiny.yaml --size 24x30 --quality sketch", true, true},
                                          {"mesh tiny.yaml", true, false},
                                          {"bust tiny.yaml --no-stl --json", true, true},
                                          {"check tiny.yaml", true, false},
                                          {"explain tiny.yaml", true, false},
                                          {"list ages", true, false},
                                          {"schema", true, false},
                                          {"--help", true, false},
                                          {"--version", true, false},
                                          {"check bad.yaml", false, true, 2},
                                          {"render bad.yaml --json", false, true, 2},
                                          {"rendr tiny.yaml", false, true, 2},
                                          {"", false, true, 2}};
  return commands;
}

TEST(streams, an_error_stream_that_takes_nothing_is_a_failure_without_words) {
  const auto folder = make_clip("streams_err");
  for (const Said& said : list_commands())
    for (const char* closed : {"2>&-", "2>/dev/full"}) {
      fs::remove_all(folder / "out");
      const ProgramRun run = run_shell(folder, fmt::format("mien {} {}", said.command, closed));
      EXPECT_EQ(run.status, said.status != 0 ? said.status : said.has_err ? 1 : 0) << said.command << closed;
      EXPECT_EQ(run.err, "") << said.command << closed;
      EXPECT_EQ(!run.out.empty(), said.has_out) << said.command << closed;
      if (said.command == "render tiny.yaml") {  // all the same
        EXPECT_TRUE(fs::exists(folder / "out/tiny/tiny.mp4")) << closed;
        EXPECT_TRUE(fs::exists(folder / "out/tiny/poster.png")) << closed;
      }
    }
}

TEST(streams, an_output_that_takes_nothing_is_told_in_one_line) {
  const auto folder = make_clip("streams_out");
  for (const Said& said : list_commands())
    for (const auto& [closed, reason] :
         {std::pair{">&-", "Bad file descriptor"}, {">/dev/full", "No space left on device"}}) {
      const ProgramRun run = run_shell(folder, fmt::format("mien {} {}", said.command, closed));
      EXPECT_EQ(run.status, said.status != 0 ? said.status : said.has_out ? 1 : 0) << said.command << closed;
      const std::string line = fmt::format("cannot write standard output: {}", reason);
      EXPECT_EQ(run.err.find(line) != run.err.npos, said.has_out) << said.command << closed << run.err;
    }
  // Nobody to tell it to.
  for (const char* closed : {">&- 2>&-", ">/dev/full 2>&1", ">&- 2>/dev/full <&-"})
    EXPECT_EQ(run_shell(folder, std::string("mien list ages ") + closed).status, 1) << closed;
  const ProgramRun run = run_shell(folder, "{ mien schema; echo $? >status; } | head -c 1");
  EXPECT_EQ(run.err, "") << "nobody waits for what a pipe's reader left";
  EXPECT_EQ(read_file(folder / "status"), "1\n");
}

TEST(streams, that_are_closed_are_no_file_that_is_written) {
  const auto folder = make_clip("streams_closed");
  ASSERT_EQ(run_shell(folder, "mien render tiny.yaml -o whole --quiet").status, 0);
  EXPECT_EQ(run_shell(folder, "mien render tiny.yaml -o closed <&- >&- 2>&-").status, 1);
  EXPECT_EQ(run_shell(folder, "diff -r -x tiny.ini whole closed").out, "");
  const ProgramRun run = run_shell(folder,
                                   "mien new fresh && mien new closed <&- >&- 2>&-; echo $?; "
                                   "sed s/closed/fresh/g closed.yaml | cmp fresh.yaml -");
  EXPECT_EQ(run.out, "file    fresh.yaml\n1\n") << run.err;
}

TEST(streams, a_pipe_is_a_file_too) {
  const auto folder = make_clip("pipes");
  for (const char* command : {"cat tiny.yaml | mien check /dev/stdin", "mien check /dev/stdin <tiny.yaml",
                              "mkfifo pipe.yaml; cat tiny.yaml >pipe.yaml & mien check pipe.yaml"}) {
    const ProgramRun run = run_shell(folder, command);
    EXPECT_EQ(run.status, 0) << command << run.err;
    EXPECT_THAT(run.out, HasSubstr(": good; 3 frames at 24 a second")) << command;
    EXPECT_EQ(run.err, "") << command;
  }
  ProgramRun run =
      run_shell(folder, "cat tiny.yaml | mien mesh /dev/stdin -o piped.obj && mien mesh tiny.yaml -o a.obj");
  EXPECT_EQ(run.out, "mesh    piped.obj\nmesh    a.obj\n") << run.err;
  run = run_shell(folder, "cat bad.yaml | mien render /dev/stdin");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err.find("/dev/stdin:2:33: error: unknown expression 'smlie'; did you mean 'smile'?\n"), 0u)
      << run.err;
  run = run_shell(folder, "mien check /dev/stdin <&-");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err.find("/dev/stdin:"), 0u) << run.err;
}

TEST(streams, who_waits_for_a_pipe_can_be_interrupted) {
  const auto folder = make_clip("waiting");
  const ProgramRun run =
      run_shell(folder, std::string("mkfifo never.yaml; '") + program_path() +
                            "' render never.yaml & id=$!; sleep 1; kill -INT $id; wait $id");
  EXPECT_EQ(run.status, 130);
  EXPECT_EQ(run.err, "error: interrupted; what was finished is kept, run again to go on\n");
  EXPECT_TRUE(list_files(folder).empty() || !fs::exists(folder / "out"));
}

TEST(streams, names_that_are_no_text_are_told_in_json_too) {
  const auto folder = make_clip("names");
  ASSERT_EQ(run_shell(folder, "cp tiny.yaml \"$(printf 'f\\351e.yaml')\"").status, 0);
  for (const char* command :
       {"check \"$(printf 'f\\351e.yaml')\"", "mesh tiny.yaml -o \"$(printf 'f\\351e.obj')\"",
        "frames tiny.yaml --frames 1-1 -o \"$(printf 'f\\351e')\" 2>/dev/null",
        "explain \"$(printf 'f\\351e.yaml')\""}) {
    const ProgramRun run = run_shell(folder, fmt::format("mien {} --json", command));
    EXPECT_EQ(run.status, 0) << command << run.err;
    EXPECT_THAT(run.out, HasSubstr("f\xEF\xBF\xBD"
                                   "e"))
        << command;
    std::istringstream lines(run.out);
    for (std::string line; std::getline(lines, line);) EXPECT_TRUE(nlohmann::json::accept(line)) << line;
  }
}

}  // namespace
}  // namespace mien

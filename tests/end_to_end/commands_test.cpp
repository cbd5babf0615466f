// What the commands say and how they end, as told by product and help.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "end_to_end/program.hpp"

namespace mien {
namespace {

TEST(commands, tell_the_version_and_the_help) {
  const auto folder = make_folder("help");
  ProgramRun run = run_shell(folder, "mien --version");
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out, "mien 0.1.0\n");
  run = run_shell(folder, "mien --help");
  EXPECT_EQ(run.status, 0);
  for (const char* command :
       {"render", "frames", "still", "mesh", "bust", "check", "list", "new", "schema"}) {
    EXPECT_NE(run.out.find(std::string("\n  ") + command + " "), std::string::npos) << command;
    EXPECT_EQ(run_shell(folder, std::string("mien ") + command + " --help").status, 0);
  }
  EXPECT_EQ(run.err, "");
}

TEST(commands, end_with_2_if_the_words_are_wrong) {
  const auto folder = make_folder("words");
  ProgramRun run = run_shell(folder, "mien");
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(run.err.starts_with("Usage: mien COMMAND")) << run.err;
  run = run_shell(folder, "mien rendr a.yaml");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err, "error: unknown command 'rendr'; did you mean 'render'?\n");
  run = run_shell(folder, "mien render a.yaml --size 4x4 --jobs none");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err,
            "error: --jobs: 'none' is not a whole number within 1..1024\n"
            "error: --size: '4x4' has a side outside 16..8192 pixels\n2 errors\n");
  EXPECT_TRUE(list_files(folder).empty());
}

TEST(commands, tell_mistakes_as_json_lines) {
  const auto folder = make_folder("json_mistakes");
  write_file(folder / "bad.yaml", "mien: 1\nclip:\n  fsp: 24\nhaed: {}\n");
  const ProgramRun run = run_shell(folder, "mien check bad.yaml --json");
  EXPECT_EQ(run.status, 2);
  std::istringstream lines(run.err);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    const auto object = nlohmann::json::parse(line);
    EXPECT_EQ(object.at("kind"), "error");
    EXPECT_EQ(object.at("file"), "bad.yaml");
    EXPECT_EQ(object.at("line"), count == 0 ? 3 : 4);
    EXPECT_TRUE(object.at("message").is_string());
  }
  EXPECT_EQ(count, 2);
}

TEST(commands, write_nothing_if_the_file_is_wrong) {
  const auto folder = make_folder("wrong");
  write_file(folder / "bad.yaml", "mien: 1\nclip:\n  keys:\n    - {at: 0s, express: smlie}\n");
  for (const char* command : {"render", "frames", "still", "mesh", "bust", "check"}) {
    const ProgramRun run = run_shell(folder, std::string("mien ") + command + " bad.yaml");
    EXPECT_EQ(run.status, 2) << command;
    EXPECT_TRUE(
        run.err.starts_with("bad.yaml:4:25: error: unknown expression 'smlie'; did you mean 'smile'?\n"))
        << command << ": " << run.err;
    EXPECT_EQ(list_files(folder), std::vector<std::string>{"bad.yaml"}) << command;
  }
}

TEST(commands, check_a_right_file_in_one_line) {
  const auto folder = make_folder("check");
  write_file(folder / "tiny.yaml", kTinyClip);
  const ProgramRun run = run_shell(folder, "mien check tiny.yaml");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 1) << run.out;
  EXPECT_EQ(list_files(folder), std::vector<std::string>{"tiny.yaml"});
}

TEST(commands, end_with_2_if_the_file_is_not_there) {
  const auto folder = make_folder("absent");
  const ProgramRun run = run_shell(folder, "mien render absent.yaml");
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find("absent.yaml"), std::string::npos) << run.err;
  EXPECT_TRUE(list_files(folder).empty());
}

TEST(commands, list_every_kind_in_words_and_in_json) {
  const auto folder = make_folder("list");
  for (const char* kind : {"ages", "skulls", "features", "areas", "expressions", "landmarks", "qualities"}) {
    ProgramRun run = run_shell(folder, std::string("mien list ") + kind);
    EXPECT_EQ(run.status, 0) << kind << run.err;
    EXPECT_GT(std::count(run.out.begin(), run.out.end(), '\n'), 1) << kind;
    run = run_shell(folder, std::string("mien list --json ") + kind);
    EXPECT_EQ(run.status, 0) << kind << run.err;
    std::istringstream lines(run.out);
    for (std::string line; std::getline(lines, line);)
      EXPECT_TRUE(nlohmann::json::accept(line)) << kind << line;
  }
  const ProgramRun run = run_shell(folder, "mien list agse");
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find("did you mean 'ages'?"), std::string::npos) << run.err;
}

TEST(commands, print_a_schema) {
  const ProgramRun run = run_shell(make_folder("schema"), "mien schema");
  EXPECT_EQ(run.status, 0) << run.err;
  const auto schema = nlohmann::json::parse(run.out);
  EXPECT_TRUE(schema.at("properties").contains("clip"));
}

TEST(commands, make_a_file_to_begin_with_once) {
  const auto folder = make_folder("new");
  EXPECT_EQ(run_shell(folder, "mien new my_face").status, 0);
  ASSERT_EQ(list_files(folder), std::vector<std::string>{"my_face.yaml"});
  EXPECT_EQ(run_shell(folder, "mien check my_face.yaml").status, 0);
  const std::string before = read_file(folder / "my_face.yaml");
  const ProgramRun again = run_shell(folder, "mien new my_face");
  EXPECT_EQ(again.status, 2);
  EXPECT_NE(again.err.find("my_face.yaml"), std::string::npos) << again.err;
  EXPECT_EQ(read_file(folder / "my_face.yaml"), before);
}

TEST(commands, notice_a_full_disk_behind_their_output) {
  const ProgramRun run = run_shell(make_folder("full"), "mien --help >/dev/full");
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.err, "error: cannot write standard output: No space left on device\n");
}

}  // namespace
}  // namespace mien

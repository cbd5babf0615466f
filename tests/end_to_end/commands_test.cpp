// What the commands say and how they end, as told by product and help.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "commands/report.hpp"
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
       {"render", "frames", "still", "sheet", "mesh", "bust", "check", "explain", "list", "new", "schema"}) {
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

  // What JSON would take for its own stands escaped, and what it was is read back.
  write_file(folder / "a \"b\" \\c.yaml", "mien: 1\n'ha\"e\\d': {}\ntitle: \"a\\tb\"\n");
  const ProgramRun odd = run_shell(folder, "mien check 'a \"b\" \\c.yaml' --json");
  EXPECT_EQ(odd.status, 2);
  ASSERT_EQ(std::ranges::count(odd.err, '\n'), 2) << odd.err;
  const auto object = nlohmann::json::parse(odd.err.substr(0, odd.err.find('\n')));
  EXPECT_EQ(object.at("file"), "a \"b\" \\c.yaml");
  EXPECT_EQ(object.at("line"), 2);
  EXPECT_EQ(object.at("column"), 1);
  EXPECT_TRUE(object.at("message").get<std::string>().starts_with("unknown key 'ha\"e\\d'; ")) << odd.err;
}

TEST(commands, write_nothing_if_the_file_is_wrong) {
  const auto folder = make_folder("wrong");
  write_file(folder / "bad.yaml", "mien: 1\nclip:\n  keys:\n    - {at: 0s, express: smlie}\n");
  for (const char* command : {"render", "frames", "still", "sheet views", "mesh", "bust", "check"}) {
    const ProgramRun run = run_shell(folder, std::string("mien ") + command + " bad.yaml");
    EXPECT_EQ(run.status, 2) << command;
    EXPECT_TRUE(
        run.err.starts_with("bad.yaml:4:25: error: unknown expression 'smlie'; did you mean 'smile'?\n"))
        << command << ": " << run.err;
    EXPECT_EQ(list_files(folder), std::vector<std::string>{"bad.yaml"}) << command;
  }
}

TEST(commands, check_a_right_file_in_one_line_and_a_chart) {
  const auto folder = make_folder("check");
  write_file(folder / "tiny.yaml", kTinyClip);
  const ProgramRun run = run_shell(folder, "mien check tiny.yaml");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with("tiny.yaml: good; ")) << run.out;
  const std::string chart = run.out.substr(run.out.find('\n') + 1);
  EXPECT_TRUE(chart.starts_with("\n             0s ")) << chart;
  EXPECT_NE(chart.find("\nlips         "), std::string::npos) << chart;
  EXPECT_TRUE(
      std::all_of(chart.begin(), chart.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
  EXPECT_EQ(run_shell(folder, "mien check tiny.yaml --quiet").out, "");
  const ProgramRun json = run_shell(folder, "mien check tiny.yaml --json");
  EXPECT_EQ(std::count(json.out.begin(), json.out.end(), '\n'), 1) << json.out;
  EXPECT_EQ(nlohmann::json::parse(json.out).at("file"), "tiny.yaml");
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
  for (const char* kind :
       {"ages", "skulls", "people", "hair", "features", "areas", "expressions", "landmarks", "qualities"}) {
    ProgramRun run = run_shell(folder, std::string("mien list ") + kind);
    EXPECT_EQ(run.status, 0) << kind << run.err;
    EXPECT_GT(std::count(run.out.begin(), run.out.end(), '\n'), 1) << kind;
    run = run_shell(folder, std::string("mien list --json ") + kind);
    EXPECT_EQ(run.status, 0) << kind << run.err;
    std::istringstream lines(run.out);
    for (std::string line; std::getline(lines, line);)
      EXPECT_TRUE(nlohmann::json::accept(line)) << kind << line;
  }
  const std::string hair = run_shell(folder, "mien list hair").out;
  EXPECT_TRUE(hair.starts_with("none ")) << hair;
  EXPECT_NE(hair.find("\ncrop "), hair.npos) << hair;
  EXPECT_NE(hair.find("\nbeard: stubble "), hair.npos) << hair;
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

constexpr const char* kHeldClip = R"(mien: 1
clip:
  keys:
    - {at: 0s, express: neutral}
    - {at: 1s, express: {surprise: 1, fear: 0.8}, ease: linear}
    - {at: 2s, areas: {brow.left: {up: 1.5}}}
render: {size: 48x60, quality: draft}
)";

TEST(commands, tell_what_was_held_once_however_many_busts_have_it) {
  const auto folder = make_folder("held_busts");
  write_file(folder / "a.yaml",
             "mien: 1\nexpressions: {wide: {brows: {up: 1.6}}}\n"
             "busts: [{express: wide, triangles: 8000}, {express: wide, height: 60mm, triangles: 8000}]\n");
  const ProgramRun run = run_shell(folder, "mien bust a.yaml --no-stl -o out");
  const std::string note = "note: brows.up asked for 1.6";
  const std::size_t first = run.out.find(note);
  ASSERT_NE(first, std::string::npos) << run.out;
  EXPECT_EQ(run.out.find(note, first + 1), std::string::npos) << run.out;
}

TEST(commands, tell_what_limits_held_without_failing) {
  const auto folder = make_folder("held");
  write_file(folder / "a.yaml", kHeldClip);
  ProgramRun run = run_shell(folder, "mien check a.yaml");
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run.out.substr(0, run.out.find("\n\n") + 1),
            "a.yaml:5:26: note: brows.up asked for 1.6 (surprise 1 + fear 0.8); held at its limit, 1\n"
            "a.yaml:5:26: note: lids.upper asked for 1.7 (surprise 1 + fear 0.8); held at its limit, 1\n"
            "a.yaml:6:40: note: brow.left.up asked for 1.5; held at its limit, 1\n"
            "a.yaml: good; 48 frames at 24 a second, 47 drawings, 48x60, 0 busts\n");
  run = run_shell(folder, "mien check a.yaml --quiet");
  EXPECT_EQ(run.out + run.err, "");
  run = run_shell(folder, "mien check a.yaml --json");
  const auto object = nlohmann::json::parse(run.out.substr(0, run.out.find('\n')));
  EXPECT_EQ(
      object,
      (nlohmann::json{{"kind", "note"},
                      {"file", "a.yaml"},
                      {"line", 5},
                      {"column", 26},
                      {"area", "brow"},
                      {"side", "both"},
                      {"move", "up"},
                      {"asked", 1.6},
                      {"held", 1.0},
                      {"by", "surprise 1 + fear 0.8"},
                      {"message", "brows.up asked for 1.6 (surprise 1 + fear 0.8); held at its limit, 1"}}));
}

// 1.005 times a million is a little less than 1005000.
TEST(commands, numbers_in_json_are_rounded_and_not_cut) {
  EXPECT_EQ(round_to(1.005, 6), 1.005);
  EXPECT_EQ(round_to(-1.005, 6), -1.005);
  EXPECT_EQ(round_to(1.25, 1), 1.3);
  EXPECT_FALSE(std::signbit(round_to(-1e-9, 6)));
}

TEST(commands, that_make_something_tell_what_limits_held_of_it) {
  const auto folder = make_folder("held_too");
  write_file(folder / "a.yaml", kHeldClip);
  const std::string fifth =
      "a.yaml:5:26: note: brows.up asked for 1.6 (surprise 1 + fear 0.8); held at its limit, 1\n"
      "a.yaml:5:26: note: lids.upper asked for 1.7 (surprise 1 + fear 0.8); held at its limit, 1\n";
  const std::string sixth = "a.yaml:6:40: note: brow.left.up asked for 1.5; held at its limit, 1\n";
  EXPECT_EQ(run_shell(folder, "mien frames a.yaml --frames 1-1 2>/dev/null").out,
            fifth + sixth + "scenes  out/a/scenes\n");
  EXPECT_EQ(run_shell(folder, "mien mesh a.yaml --at 2s -o a.stl").out, sixth + "mesh    a.stl\n");
  EXPECT_EQ(run_shell(folder, "mien still a.yaml --at 1s -o a.png").out, fifth + "picture a.png\n");
  EXPECT_EQ(run_shell(folder, "mien mesh a.yaml -o a.stl").out, "mesh    a.stl\n")
      << "at 0 s nothing is held";
  EXPECT_EQ(run_shell(folder, "mien still a.yaml --at 1s -o a.png --quiet").out, "");
  EXPECT_EQ(run_shell(folder, "mien bust a.yaml --at 2s -o b").out.find(sixth), 0u);
}

TEST(commands, explain_a_moment_in_words_and_in_numbers) {
  const auto folder = make_folder("explain");
  write_file(folder / "a.yaml", kHeldClip);
  ProgramRun run = run_shell(folder, "mien explain a.yaml --at 1s --area brow.left");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(
      run.out.starts_with("a.yaml at 1s\n  100 % surprise 1 + fear 0.8 (key at 1s)\n\n"
                          "area         move    value  limit            held         moved\n"
                          "brow.left    up      +1.00  12."))
      << run.out;
  EXPECT_NE(run.out.find(" mm          asked +1.6   "), run.out.npos) << run.out;
  EXPECT_NE(run.out.find(" mm at brow_mid_l: "), run.out.npos) << run.out;
  EXPECT_NE(run.out.find("\na.yaml:5:26: note: brow.left.up asked for 1.6 ("), run.out.npos) << run.out;
  EXPECT_EQ(run_shell(folder, "mien explain a.yaml --at 24f --area brow.left").out, run.out);
  EXPECT_NE(
      run_shell(folder, "mien explain a.yaml --at 0.25s").out.find("  75 % neutral (key at 0s)\n   25 % "),
      std::string::npos);
  EXPECT_EQ(run_shell(folder, "mien explain a.yaml --express neutral").out,
            "a.yaml: mien/neutral\n\nnothing moves: every area is at rest\n");
  // Outward is outward on either side.
  std::string left = run_shell(folder, "mien explain a.yaml --express smile --area corner.left").out;
  EXPECT_NE(left.find(" out"), left.npos) << left;
  for (const auto& [from, to] : {std::pair{"corner.left ", "corner.right"}, std::pair{"_l:", "_r:"}})
    for (std::size_t at = 0; (at = left.find(from, at)) != left.npos;)
      left.replace(at, std::strlen(from), to);
  EXPECT_EQ(run_shell(folder, "mien explain a.yaml --express smile --area corner.right").out, left);
  run = run_shell(folder, "mien explain a.yaml --express anger --json");
  std::istringstream lines(run.out);
  int moves = 0;
  for (std::string line; std::getline(lines, line);) {
    const auto object = nlohmann::json::parse(line);
    if (object.at("kind") != "move") continue;
    ++moves;
    EXPECT_EQ(object.at("moved_mm").size(), 3u);
    if (object.at("area") == "brow.left" && object.at("move") == "up") {
      EXPECT_EQ(object.at("limit").at("thesis"), "EYEBROW_R_D_VERT_LIMIT");
      EXPECT_LT(object.at("moved_mm")[1], 0);
    }
  }
  EXPECT_GT(moves, 8);
  run = run_shell(folder, "mien explain a.yaml --area brow.lefft");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err, "error: unknown area 'brow.lefft'; did you mean 'brow.left'?\n");
  EXPECT_EQ(list_files(folder), std::vector<std::string>{"a.yaml"});
}

}  // namespace
}  // namespace mien

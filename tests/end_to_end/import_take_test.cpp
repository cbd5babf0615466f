// `mien import` of takes and expressions, as a user runs it.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/text.hpp"
#include "end_to_end/program.hpp"
#include "places.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;

// An empty folder with the samples of takes.
fs::path make_take_folder(const std::string& name) {
  const fs::path folder = make_folder(name);
  for (const auto& entry : fs::directory_iterator(fs::path(source_folder()) / "tests/import/takes"))
    fs::copy_file(entry.path(), folder / entry.path().filename());
  return folder;
}

TEST(import_take, what_is_written_is_right_and_what_is_lost_is_told) {
  const fs::path folder = make_take_folder("import_take");
  for (const char* name : {"live_link.csv", "mediapipe.json", "arkit.json", "openface.csv", "openfacefx.json",
                           "gesture.vrma", "smile.mhpose", "mpfb.json"}) {
    const ProgramRun run = run_shell(folder, std::string("mien import ") + name + " -o said.yaml");
    ASSERT_EQ(run.status, 0) << name << "\n" << run.err;
    EXPECT_NE(run.out.find("lost: "), std::string::npos) << name << "\n" << run.out;
    const ProgramRun check = run_shell(folder, "mien check said.yaml --quiet");
    EXPECT_EQ(check.status, 0) << name << "\n" << check.err << read_file(folder / "said.yaml");
    fs::remove(folder / "said.yaml");
  }
}

TEST(import_take, a_puffed_cheek_is_told_with_its_time) {
  const fs::path folder = make_take_folder("import_loss");
  const ProgramRun run = run_shell(folder, "mien import live_link.csv -o said.yaml --json");
  ASSERT_EQ(run.status, 0) << run.err;
  const auto report = nlohmann::json::parse(run.out.substr(0, run.out.find('\n')));
  EXPECT_EQ(report["rows"], 24);
  bool is_told = false;
  for (const auto& loss : report["losses"])
    if (loss["unit"] == "cheekPuff") {
      is_told = true;
      EXPECT_GT(loss["lost_mm2"], 0.02);
      EXPECT_NEAR(loss["at_s"].get<double>(), 23.0 / 60, 0.001);
    }
  EXPECT_TRUE(is_told) << run.out;
}

TEST(import_take, more_loss_than_allowed_writes_nothing) {
  const fs::path folder = make_take_folder("import_strict");
  const ProgramRun run = run_shell(folder, "mien import live_link.csv -o said.yaml --strict 1");
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find("of the motion is lost; expected 1 % at most"), std::string::npos) << run.err;
  EXPECT_FALSE(fs::exists(folder / "said.yaml"));
  EXPECT_EQ(run_shell(folder, "mien import live_link.csv -o said.yaml --strict 99 --quiet").status, 0);
  EXPECT_TRUE(fs::exists(folder / "said.yaml"));
}

// Our own avatar back again: its shapes have no names of ARKit's, so that VRM's names say what is meant.
TEST(import_take, expressions_of_an_avatar_become_ours) {
  const fs::path folder = make_take_folder("import_avatar");
  write_file(folder / "face.yaml", "mien: 1\nclip: {length: 0.1s}\n");
  ASSERT_EQ(run_shell(folder, "mien export face.yaml -o face.vrm --quiet").status, 0);
  const ProgramRun run = run_shell(folder, "mien import face.vrm -o said.yaml");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("expressions; lost: "), std::string::npos) << run.out;
  const std::string said = read_file(folder / "said.yaml");
  for (const char* name : {"happy", "angry", "sad", "surprised", "aa", "ih", "ou", "ee", "oh", "blinkLeft"})
    EXPECT_NE(said.find(std::string("\n  ") + name + ": {"), std::string::npos) << name << "\n" << said;
  const ProgramRun check = run_shell(folder, "mien check said.yaml --quiet");
  EXPECT_EQ(check.status, 0) << check.err << said;
}

TEST(import_take, a_broken_file_writes_nothing) {
  const fs::path folder = make_take_folder("import_broken");
  std::string text = read_file(folder / "live_link.csv");
  write_file(folder / "live_link.csv", text.replace(text.find("0.00000"), 7, "zero"));
  const ProgramRun run = run_shell(folder, "mien import live_link.csv -o said.yaml");
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find("live_link.csv:2:20: error: 'EyeBlinkLeft' is 'zero'; expected a number"),
            std::string::npos)
      << run.err;
  EXPECT_FALSE(fs::exists(folder / "said.yaml"));
}

}  // namespace
}  // namespace mien

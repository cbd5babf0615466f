// A stage from file to pictures: heads that grow, several actors, lights that change.
#include <gtest/gtest.h>

#include "end_to_end/program.hpp"

namespace mien {
namespace {

constexpr const char* kScene = R"(mien: 1
actors:
  ann:
    head: {age: infant}
    place: {at: [-110mm, 0, 0]}
    clip: {head: [{at: 0s}, {at: 1s, age: child}]}
  bob:
    place: {at: [110mm, 0, 0]}
clip:
  fps: 2
  light: [{at: 0s, set: candle}, {at: 1s, set: moon}]
  background: [{at: 0s, show: dark}, {at: 1s, show: "#102040"}]
  camera: [{at: 0s}, {at: 1s, look_at: bob.nose_tip, lens: 50mm}]
render: {size: 64x48, quality: draft}
)";

TEST(stage, renders_and_keeps_what_is_right) {
  const auto folder = make_folder("stage");
  write_file(folder / "scene.yaml", kScene);
  const ProgramRun run = run_shell(folder, "mien render scene.yaml --quiet");
  ASSERT_EQ(run.status, 0) << run.err;
  const auto picture = folder / "out/scene/frames/f0002.png";
  const std::string first = read_file(picture);
  const auto time = std::filesystem::last_write_time(picture);
  ASSERT_EQ(run_shell(folder, "mien render scene.yaml --quiet").status, 0);
  EXPECT_EQ(std::filesystem::last_write_time(picture), time);

  std::string other = kScene;
  other.replace(other.find("age: child"), 10, "age: adult");
  write_file(folder / "scene.yaml", other);
  ASSERT_EQ(run_shell(folder, "mien render scene.yaml --quiet").status, 0);
  EXPECT_NE(read_file(picture), first) << "half way to another head";
}

TEST(stage, commands_ask_which_actor_is_meant) {
  const auto folder = make_folder("which_actor");
  write_file(folder / "scene.yaml", kScene);
  const ProgramRun run = run_shell(folder, "mien mesh scene.yaml -o a.obj");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err, "error: scene.yaml has several actors; expected --actor with one of: ann, bob\n");
  ASSERT_EQ(run_shell(folder,
                      "mien mesh scene.yaml --actor ann --at 1s -o late.obj && "
                      "mien mesh scene.yaml --actor ann -o early.obj")
                .status,
            0);
  EXPECT_NE(read_file(folder / "late.obj"), read_file(folder / "early.obj"));
  EXPECT_NE(run_shell(folder, "mien explain scene.yaml --actor bob").out.find("nothing moves"),
            std::string::npos);
}

}  // namespace
}  // namespace mien

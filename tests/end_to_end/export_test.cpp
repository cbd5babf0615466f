// `mien export` and `mien check` of meshes, as a person runs them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "end_to_end/program.hpp"
#include "render/picture.hpp"

namespace mien {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(export_command, writes_what_the_ending_names_and_tells_how_near_it_is) {
  const auto folder = make_folder("export_command");
  write_file(folder / "tiny.yaml", kTinyClip);
  const ProgramRun run = run_shell(folder, "mien export tiny.yaml -o out/face.py");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("export  out/face.py\n"));
  EXPECT_THAT(run.out, HasSubstr(" mm from the face itself ("));
  EXPECT_THAT(list_files(folder), ElementsAre("out/face.glb", "out/face.py", "tiny.yaml"));
  EXPECT_THAT(read_file(folder / "out/face.py"), HasSubstr("FILE = \"face.glb\"\nFPS = 24\nLAST_FRAME = "));
  EXPECT_EQ(
      run_shell(folder, "mien export tiny.yaml -o again.glb --quiet && cmp again.glb out/face.glb").status,
      0);
}

TEST(export_command, draws_the_layout_alone) {
  const auto folder = make_folder("export_layout");
  write_file(folder / "tiny.yaml", kTinyClip);
  const ProgramRun run = run_shell(folder, "mien export tiny.yaml --uv layout.png");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, "layout  layout.png\n");
  EXPECT_THAT(list_files(folder), ElementsAre("layout.png", "tiny.yaml"));
  EXPECT_EQ(read_picture_size(folder / "layout.png").width_px, 2048);
}

TEST(export_command, refuses_what_it_cannot_write_and_writes_nothing) {
  const auto folder = make_folder("export_refused");
  write_file(folder / "tiny.yaml", kTinyClip);
  write_file(folder / "growing.yaml",
             "mien: 1\nclip: {length: 1s, head: [{at: 0s, age: child}, {at: 1s, age: adult}]}\n");
  const auto tell = [&](const std::string& words) {
    const ProgramRun run = run_shell(folder, "mien export " + words);
    EXPECT_EQ(run.status, 2) << words;
    return run.err;
  };
  EXPECT_EQ(tell("tiny.yaml -o face.fbx"),
            "error: -o face.fbx: unknown kind of export '.fbx'; expected a name that ends in .glb, .gltf, "
            ".vrm, .usda, .py, "
            ".csv, .json, .pc2, .mdd, .obj, .ply or .stl\n");
  EXPECT_EQ(tell("tiny.yaml -o face.obj"),
            "error: -o face.obj: each frame is a file of its own; expected a name with a place for its "
            "number, such as "
            "face_%04d.obj\n");
  EXPECT_EQ(tell("tiny.yaml -o tiny.yaml --uv tiny.yaml"),
            "error: --uv tiny.yaml: unknown kind of picture '.yaml'; expected a name that ends in .png\n");
  EXPECT_EQ(
      tell("tiny.yaml -o face.glb --targets faces"),
      "error: --targets faces: unknown set of targets; expected one of: moves, expressions, arkit, vrm\n");
  EXPECT_EQ(
      tell("tiny.yaml -o moves.csv --targets vrm"),
      "error: --targets vrm is not for .csv; expected a name that ends in one of: .glb, .gltf, .usda, .py\n");
  EXPECT_EQ(tell("tiny.yaml -o face.vrm --exact"),
            "error: --exact is not for .vrm; expected a name that ends in one of: .glb, .gltf, .usda, .py\n");
  EXPECT_EQ(tell("tiny.yaml -o face.glb --exact --targets arkit"),
            "error: --targets and --exact are two kinds of targets; give one of them\n");
  EXPECT_THAT(tell("growing.yaml -o face.glb"),
              HasSubstr("the head changes in time, and one that is exported stays as it is"));
  EXPECT_THAT(list_files(folder), ElementsAre("growing.yaml", "tiny.yaml"));
}

TEST(check_of_meshes, tells_faults_with_their_lines) {
  const auto folder = make_folder("check_meshes");
  write_file(folder / "good.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(run_shell(folder, "mien check good.obj").out,
            "good.obj: good; 3 points, 1 polygon, 1 open rim of 3 edges\n");
  write_file(folder / "wrong.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nf 1 2 3\nf 3 2 1\nf 2 3 1\n");
  const ProgramRun wrong = run_shell(folder, "mien check wrong.obj --faults faults.ply");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(
      wrong.err,
      HasSubstr("wrong.obj:4: error: point 3 at (5, 5, 5) is on no edge; expected two edges at least\n"));
  EXPECT_THAT(read_file(folder / "faults.ply"), HasSubstr("element face 3\n"));
  EXPECT_EQ(run_shell(folder, "mien check good.obj --faults good.obj").err,
            "error: --faults good.obj: unknown kind of mesh '.obj'; expected a name that ends in .ply\n");
  write_file(folder / "tiny.yaml", kTinyClip);
  EXPECT_EQ(run_shell(folder, "mien check tiny.yaml --faults f.ply").err,
            "error: --faults draws what is wrong with a mesh; expected one as the FILE\n");
}

}  // namespace
}  // namespace mien

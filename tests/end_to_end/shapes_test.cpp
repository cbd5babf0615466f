// One head as a picture, as a mesh and as a print.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "end_to_end/program.hpp"

namespace mien {
namespace {

TEST(still, is_one_picture_of_the_size_asked_for) {
  const auto folder = make_folder("still");
  write_file(folder / "tiny.yaml", kTinyClip);
  ProgramRun run =
      run_shell(folder, "mien still tiny.yaml --express surprise --angle 30 --size 40x50 -o face.png");
  ASSERT_EQ(run.status, 0) << run.err;
  run = run_shell(folder, "ffprobe -v error -show_entries stream=width,height -of csv=p=0 face.png");
  EXPECT_EQ(run.out, "40,50\n");
  EXPECT_EQ(list_files(folder), (std::vector<std::string>{"face.png", "tiny.yaml"}));
  EXPECT_EQ(run_shell(folder, "mien still tiny.yaml --express surprize -o b.png").status, 2);
}

TEST(mesh, has_a_group_a_part_and_landmarks_on_the_skin) {
  const auto folder = make_folder("mesh");
  write_file(folder / "tiny.yaml", kTinyClip);
  const ProgramRun run =
      run_shell(folder, "mien mesh tiny.yaml --express smile -o face.obj --landmarks face.json");
  ASSERT_EQ(run.status, 0) << run.err;
  std::istringstream lines(read_file(folder / "face.obj"));
  std::size_t vertices = 0, faces = 0;
  std::string groups;
  for (std::string line; std::getline(lines, line);) {
    vertices += line.starts_with("v ");
    faces += line.starts_with("f ");
    if (line.starts_with("g ")) groups += line.substr(2) + "\n";
  }
  EXPECT_GT(vertices, 20000u);
  EXPECT_GT(faces, 40000u);
  for (const char* part :
       {"skin", "eye_left", "eye_right", "brow_left", "teeth_upper", "teeth_lower", "tongue"})
    EXPECT_NE(groups.find(std::string(part) + "\n"), std::string::npos) << part;

  const auto landmarks = nlohmann::json::parse(read_file(folder / "face.json"));
  for (const char* name :
       {"v", "g", "n", "prn", "sn", "gn", "zy_l", "zy_r", "ex_l", "ch_l", "ch_r", "pupil_l"})
    ASSERT_TRUE(landmarks.contains(name)) << name;
  EXPECT_GT(landmarks["ch_l"][0], 0) << "the character's left is +x";
  EXPECT_GT(landmarks["prn"][2], landmarks["zy_l"][2]) << "z points out of the face";
  EXPECT_GT(landmarks["v"][1], landmarks["gn"][1]) << "y points up";
}

TEST(mesh, is_written_in_the_format_of_its_ending) {
  const auto folder = make_folder("mesh_formats");
  write_file(folder / "tiny.yaml", kTinyClip);
  ProgramRun run = run_shell(folder, "mien mesh tiny.yaml -o a.ply && mien mesh tiny.yaml -o a.stl");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(
      read_file(folder / "a.ply").starts_with("ply\nformat binary_little_endian 1.0\ncomment Tiny\n"));
  EXPECT_TRUE(read_file(folder / "a.stl").starts_with("mien, millimetres: Tiny "));
  run = run_shell(folder, "mien mesh tiny.yaml -o a.fbx");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(
      run.err,
      "error: -o a.fbx: unknown kind of mesh '.fbx'; expected a name that ends in .obj, .ply or .stl\n");
  EXPECT_EQ(list_files(folder), (std::vector<std::string>{"a.ply", "a.stl", "tiny.yaml"}));
}

}  // namespace
}  // namespace mien

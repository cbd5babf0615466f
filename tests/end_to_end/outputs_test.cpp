// No command loses a file that it reads, and a name says what is in it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "end_to_end/program.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;

// Every file below a folder with the hash of its content; of links, what they lead to.
std::map<std::string, std::string> read_all(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const std::string& file : list_files(folder)) files[file] = hash_hex(read_file(folder / file));
  return files;
}

// A file that names others of every kind.
fs::path make_author(const std::string& name) {
  const fs::path folder = make_folder(name), configs = fs::path(source_folder()) / "configs";
  write_file(folder / "a.yaml",
             "mien: 1\nhead: {mix: {other.yaml: 1}}\nclip:\n  include: nod.yaml\n"
             "  keys: [{at: 0s, express: smile}]\n  tracks: [{csv: talk.csv}]\n"
             "render: {size: 48x60, quality: draft}\nbusts: [{express: smile, triangles: 8000}]\n");
  write_file(folder / "other.yaml", "mien: 1\nhead: {mesh: my_half.obj}\n");
  write_file(folder / "my_half.obj", read_file(fs::path(source_folder()) / "templates/head/half.obj"));
  write_file(folder / "nod.yaml", "mien: 1\nclip: {keys: [{at: 0.1s, express: neutral}]}\n");
  write_file(folder / "talk.csv", "time,lips.lower\n0,0\n0.1,0.2\n");
  return folder;
}

struct Case {
  std::string command, message;
};

void expect_refused(const fs::path& folder, const std::vector<Case>& cases) {
  const auto before = read_all(folder);
  for (const auto& [command, message] : cases) {
    const ProgramRun run = run_shell(folder, "mien " + command);
    EXPECT_EQ(run.status, 2) << command;
    EXPECT_EQ(run.err, "error: " + message + "\n") << command;
    EXPECT_EQ(run.out, "") << command;
  }
  EXPECT_EQ(read_all(folder), before) << "nothing is written";
}

TEST(outputs, are_no_file_that_is_read) {
  const auto folder = make_author("outputs_read");
  for (const char* link : {"link.png", "link.svg", "link.json"}) fs::create_symlink("a.yaml", folder / link);
  fs::create_hard_link(folder / "nod.yaml", folder / "hard.png");
  fs::create_hard_link(folder / "my_half.obj", folder / "half.ply");
  fs::create_directory(folder / "busts");
  fs::create_symlink("../other.yaml", folder / "busts/bust_smile.stl");
  fs::create_directories(folder / "clip/frames");
  fs::create_hard_link(folder / "talk.csv", folder / "clip/frames/f0002.png");
  expect_refused(
      folder,
      {{"still a.yaml -o link.png", "-o link.png: it is a.yaml, which is read; expected another name"},
       {"still a.yaml -o ./hard.png", "-o ./hard.png: it is nod.yaml, which is read; expected another name"},
       {"sheet views a.yaml -o hard.png",
        "-o hard.png: it is nod.yaml, which is read; expected another name"},
       {"sheet strip a.yaml -o link.svg", "-o link.svg: it is a.yaml, which is read; expected another name"},
       {"sheet exposure a.yaml -o talk.csv",
        "-o talk.csv: it is the file, which is read; expected another name"},
       {"sheet exposure a.yaml -o ../outputs_read/talk.csv",
        "-o ../outputs_read/talk.csv: it is talk.csv, which is read; expected another name"},
       {"mesh a.yaml --half -o my_half.obj",
        "-o my_half.obj: it is the file, which is read; expected another name"},
       {"mesh a.yaml -o half.ply", "-o half.ply: it is my_half.obj, which is read; expected another name"},
       {"mesh a.yaml -o m.obj --landmarks link.json",
        "--landmarks link.json: it is a.yaml, which is read; expected another name"},
       {"bust a.yaml -o busts",
        "busts/bust_smile.stl: it is other.yaml, which is read; expected another name"},
       {"render a.yaml -o clip",
        "clip/frames/f0002.png: it is talk.csv, which is read; expected another name"}});
}

TEST(outputs, are_not_miens_own_data) {
  const auto folder = make_author("outputs_own");
  const fs::path data = fs::path(source_folder()) / "templates/head/half_points.csv";
  const std::string before = read_file(data);
  expect_refused(
      folder, {{fmt::format("sheet exposure a.yaml -o '{}'", data.string()),
                fmt::format("-o {}: it belongs to mien's own data; expected another name", data.string())}});
  EXPECT_EQ(read_file(data), before);
}

TEST(outputs, are_two_files_where_two_are_written) {
  const auto folder = make_author("outputs_two");
  write_file(folder / "m.obj", "old");
  fs::create_symlink("m.obj", folder / "m.json");
  fs::create_hard_link(folder / "m.obj", folder / "n.json");
  expect_refused(folder, {{"mesh a.yaml -o m.obj --landmarks m.json",
                           "--landmarks m.json: it is -o m.obj too; expected two files"},
                          {"mesh a.yaml -o ./m.obj --landmarks n.json",
                           "--landmarks n.json: it is -o ./m.obj too; expected two files"}});
}

TEST(outputs, end_as_their_kind_does) {
  const auto folder = make_author("outputs_ending");
  std::vector<Case> cases{
      {"still a.yaml -o a.yaml",
       "-o a.yaml: unknown kind of picture '.yaml'; expected a name that ends in .png"},
      {"still a.yaml -o x.jpg",
       "-o x.jpg: unknown kind of picture '.jpg'; expected a name that ends in .png"},
      {"still a.yaml -o face", "-o face: unknown kind of picture ''; expected a name that ends in .png"},
      {"sheet ages a.yaml -o x.pdf",
       "-o x.pdf: unknown kind of picture '.pdf'; expected a name that ends in .png"},
      {"sheet strip a.yaml -o x.png",
       "-o x.png: unknown kind of sheet '.png'; expected a name that ends in .svg"},
      {"sheet exposure a.yaml -o x.svg",
       "-o x.svg: unknown kind of sheet '.svg'; expected a name that ends in .csv"},
      {"mesh a.yaml -o m.obj --landmarks a.yaml",
       "--landmarks a.yaml: unknown kind of landmarks '.yaml'; expected a name that ends in .json"},
      {"mesh a.yaml -o m.obj --landmarks m.obj",
       "--landmarks m.obj: unknown kind of landmarks '.obj'; expected a name that ends in .json"},
      {"mesh a.yaml -o m.glb",
       "-o m.glb: unknown kind of mesh '.glb'; expected a name that ends in .obj, .ply or .stl"},
      {"mesh a.yaml --half -o m.stl",
       "-o m.stl: unknown kind of mesh '.stl'; expected a name that ends in .obj"},
      {"new x.png", "x.png: unknown kind of file '.png'; expected a name that ends in .yaml or .yml"}};
  for (const char* name : {"out/a.png", "m.stl", "a.yaml", "old.avi"})
    cases.push_back(
        {fmt::format("render a.yaml -o ok.mp4 -o {}", name),
         fmt::format(
             "-o {}: expected a folder or a clip, whose name ends in .mp4, .webm, .mov, .gif, .webp or "
             ".apng; '{}' is the ending of another file",
             name, fs::path(name).extension().string())});
  cases.push_back(
      {"render a.yaml -o ok.mp4 -o ./ok.mp4", "-o ./ok.mp4: it is -o ok.mp4 too; expected two files"});
  for (const char* command : {"frames", "bust"})
    for (const char* name : {"clip.gif", "clip.MP4", "out/a.png", "m.stl", "a.yaml"})
      cases.push_back({fmt::format("{} a.yaml -o {}", command, name),
                       fmt::format("-o {}: expected the name of a folder; '{}' is the ending of a file", name,
                                   fs::path(name).extension().string())});
  expect_refused(folder, cases);
  EXPECT_EQ(run_shell(folder,
                      "mien frames a.yaml --frames 1-1 -o v1.2 && mien frames a.yaml --frames 1-1 -o x.gif/ "
                      "&& mien mesh a.yaml -o M.OBJ && mien new v1.3")
                .status,
            0);
  for (const char* made : {"v1.2/scenes/f0001.pov", "x.gif/scenes/f0001.pov", "M.OBJ", "v1.3.yaml"})
    EXPECT_TRUE(fs::exists(folder / made)) << made;
}

TEST(outputs, are_files_where_files_go_and_folders_where_folders_go) {
  const auto folder = make_author("outputs_place");
  write_file(folder / "taken", "a file");
  write_file(folder / "half/frames", "a file");
  for (const char* place : {"dir.png", "dir.obj", "dir.csv", "clip/frames/f0001.png", "clip/scenes/f0002.pov",
                            "busts/bust_smile.scad", "late/frames/f0009.png"})
    fs::create_directories(folder / place);
  const std::string is_folder = "it is a folder; expected the name of a file";
  expect_refused(folder, {{"render a.yaml -o taken", "-o taken: it is a file; expected a folder"},
                          {"frames a.yaml -o taken", "-o taken: it is a file; expected a folder"},
                          {"bust a.yaml -o taken", "-o taken: it is a file; expected a folder"},
                          {"render a.yaml -o taken/x", "-o taken/x: 'taken' is no folder"},
                          {"render a.yaml -o half", "half/frames: it is a file; expected a folder"},
                          {"frames a.yaml -o half", "half/frames: it is a file; expected a folder"},
                          {"still a.yaml -o taken/x.png", "-o taken/x.png: 'taken' is no folder"},
                          {"sheet views a.yaml -o taken/x/y.png", "-o taken/x/y.png: 'taken' is no folder"},
                          {"new taken/x", "taken/x.yaml: 'taken' is no folder"},
                          {"still a.yaml -o dir.png", "-o dir.png: " + is_folder},
                          {"mesh a.yaml -o dir.obj", "-o dir.obj: " + is_folder},
                          {"sheet exposure a.yaml -o dir.csv", "-o dir.csv: " + is_folder},
                          {"render a.yaml -o clip", "clip/frames/f0001.png: " + is_folder},
                          {"frames a.yaml -o clip", "clip/scenes/f0002.pov: " + is_folder},
                          {"bust a.yaml -o busts", "busts/bust_smile.scad: " + is_folder}});
  // A folder that is named like a frame past the end is somebody's own.
  const ProgramRun run = run_shell(folder, "mien frames a.yaml -o late");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(fs::is_directory(folder / "late/frames/f0009.png"));
}

TEST(outputs, that_the_machine_refuses_are_told_in_one_line) {
  const auto folder = make_author("outputs_refused");
  const std::string none = "No such file or directory";  // nobody makes files in /proc
  for (const Case& refused :
       std::vector<Case>{{"render a.yaml -o /proc/x", "cannot write in /proc/x: " + none},
                         {"frames a.yaml -o /proc/x", "cannot write in /proc/x: " + none},
                         {"bust a.yaml -o /proc/x", "cannot write in /proc/x: " + none},
                         {"still a.yaml -o /proc/x.png", "cannot write in /proc: " + none},
                         {"mesh a.yaml -o /proc/x.obj", "cannot write /proc/x.obj: " + none},
                         {"new /proc/x", "cannot write /proc/x.yaml: " + none}}) {
    const ProgramRun run = run_shell(folder, "mien " + refused.command);
    EXPECT_EQ(run.status, 1) << refused.command;
    EXPECT_EQ(run.err, "error: " + refused.message + "\n") << refused.command;
  }
}

}  // namespace
}  // namespace mien

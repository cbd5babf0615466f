// One folder has one writer, a frame shows what its key says, and what dead runs left goes.
#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/file.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <thread>

#include "end_to_end/program.hpp"
#include "render/picture.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::MatchesRegex;

// Two files of one stem that show two faces in each of their three frames.
fs::path make_two_faces(const std::string& name) {
  const fs::path folder = make_folder(name);
  const std::string clip = kTinyClip;
  const auto with_start = [&](const char* expression) {
    return std::string(clip).replace(clip.find("neutral"), 7, expression);
  };
  write_file(folder / "a/p.yaml", with_start("anger"));
  write_file(folder / "b/p.yaml", with_start("surprise"));
  return folder;
}

// A povray that says that it runs, and waits until it may.
std::string make_waiting_povray(const fs::path& folder) {
  return make_program(folder, "povray",
                      fmt::format("touch '{0}/started'\nwhile [ ! -e '{0}/go' ]; do sleep 0.05; done\n"
                                  "exec /usr/bin/env PATH=/usr/local/bin:/usr/bin:/bin povray \"$@\"\n",
                                  folder.string()));
}

std::string start_first(const fs::path& folder, const char* option = "") {
  return make_waiting_povray(folder) + "'" + program_path() + "' render a/p.yaml -o X --jobs 1 " + option +
         " >first.out 2>first.err & first=$!\n"
         "while [ ! -e started ] && kill -0 $first; do sleep 0.05; done\n";
}

// Their pixels: a povray that waits is another povray, so the keys in them differ.
std::map<std::string, std::vector<std::uint8_t>> read_pictures(const fs::path& folder) {
  std::map<std::string, std::vector<std::uint8_t>> pictures;
  for (const std::string& file : list_files(folder / "frames"))
    pictures[file] = read_pixels(folder / "frames" / file).rgb;
  return pictures;
}

TEST(writers, a_folder_has_one_at_a_time) {
  const auto folder = make_two_faces("one_writer");
  ASSERT_EQ(run_shell(folder, "mien render a/p.yaml -o Y --quiet").status, 0);
  const ProgramRun run =
      run_shell(folder, start_first(folder) +
                            "mien frames b/p.yaml -o X 2>second.err; echo $?\n"
                            "mien render b/p.yaml --frames 3-3 -o ./X/ 2>third.err; echo $?\n"
                            "mien bust b/p.yaml -o X 2>fourth.err; echo $?\n"
                            "ls -A X | grep -v mien-work; touch go; wait $first; echo $?\nls -A X X/frames | "
                            "grep -v '^X/store'\n");
  EXPECT_EQ(run.out,
            "1\n1\n1\n.mien.lock\nstore\n0\n"
            "X:\nframes\nmanifest.json\np.mp4\nposter.png\nstore\n\n"
            "X/frames:\nf0001.png\nf0002.png\nf0003.png\n")
      << run.err << read_file(folder / "first.err");
  for (const auto& [log, name] : {std::pair{"second.err", "X"}, {"third.err", "./X/"}, {"fourth.err", "X"}})
    EXPECT_THAT(read_file(folder / log),
                MatchesRegex(fmt::format("error: {} is being written by another run \\(process [0-9]+: "
                                         ".*mien render a/p.yaml -o X --jobs 1\\); wait for its end or write "
                                         "elsewhere with -o\n",
                                         name)));
  EXPECT_EQ(read_pictures(folder / "X"), read_pictures(folder / "Y"));
  const ProgramRun again =
      run_shell(folder, make_waiting_povray(folder) + "'" + program_path() + "' render a/p.yaml -o X");
  EXPECT_EQ(again.status, 0);
  EXPECT_THAT(again.err, HasSubstr("frames: 0 done, 3 kept"));
  EXPECT_EQ(read_pictures(folder / "X"), read_pictures(folder / "Y"));
}

TEST(writers, a_lock_dies_with_its_process) {
  const auto folder = make_two_faces("dead_writer");
  const ProgramRun run =
      run_shell(folder, start_first(folder) +
                            "kill -9 $first; wait $first; ls -A X | grep lock\n"
                            "mien render b/p.yaml -o X --quiet; echo $?; ls -A X X/frames\n");
  EXPECT_EQ(run.out,
            ".mien.lock\n0\nX:\nframes\nmanifest.json\np.mp4\nposter.png\nstore\n\n"
            "X/frames:\nf0001.png\nf0002.png\nf0003.png\n")
      << run.err;
}

// As on a network disk without locks: the kernel refuses every flock(2) of this process and its children.
void forbid_locks() {
  std::array<sock_filter, 4> program{{
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_flock, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOLCK),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  }};
  const sock_fprog filter{program.size(), program.data()};
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  if (::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) != 0) ::_exit(77);
}

ProgramRun run_without_locks(const fs::path& folder, const std::string& command) {
  ProgramRun run;
  std::thread([&] {  // the filter is this thread's and its children's
    forbid_locks();
    run = run_shell(folder, command);
  })
      .join();
  return run;
}

// Its scenes lie where no other run writes, and a picture is known by what it shows.
TEST(writers, without_locks_a_second_run_spoils_no_frame) {
  const auto folder = make_two_faces("no_locks");
  ASSERT_EQ(run_shell(folder, "mien render a/p.yaml -o Y --quiet").status, 0);
  const std::string note =
      "note: the disk of X has no locks; nothing keeps a second run from writing there too\n";
  const ProgramRun run = run_without_locks(
      folder, start_first(folder) +
                  "mien frames b/p.yaml -o X 2>second.err; echo $?; touch go; wait $first; echo $?\n"
                  "mien frames b/p.yaml -o X --json 2>json.err >&2; ls -A X/frames");
  EXPECT_EQ(run.out, "scenes  X/scenes\n0\n0\nf0001.png\nf0002.png\nf0003.png\n") << run.err;
  EXPECT_EQ(read_file(folder / "second.err").find(note), 0u) << read_file(folder / "second.err");
  EXPECT_EQ(
      read_file(folder / "json.err")
          .find("{\"kind\":\"note\",\"message\":\"the disk of X has no locks; nothing keeps a second run "
                "from writing there too\"}\n"),
      0u);
  EXPECT_EQ(read_pictures(folder / "X"), read_pictures(folder / "Y"));
}

TEST(writers, clear_what_dead_runs_left_and_nothing_else) {
  const auto folder = make_two_faces("left");
  ASSERT_EQ(run_shell(folder, "mien render a/p.yaml -o X --quiet").status, 0);
  const std::vector<std::string> whole = list_files(folder / "X");
  const std::vector<std::string> left{"scenes/f0002.pov.123.part",
                                      "scenes/head.inc.9.part",
                                      "scenes/p.ini.9.part",
                                      "frames/f0001.png.123.part",
                                      "frames/.mien-work-a1b2c3/1.png",
                                      "manifest.json.4567.part",
                                      "store/0123456789abcdef.png.7.part",
                                      "store/.mien-work-a1b2c3/1.png",
                                      "poster.png.4567.part",
                                      "bust_smile.stl.77.part",
                                      ".mien-work-d4e5f6/000001.png"};
  const std::vector<std::string> others{"notes.1.part", "frames/holiday.png.2.part", "scenes/f0001.pov.part",
                                        "frames/.mien-work", "take.7.part"};
  for (const char* command :
       {"render a/p.yaml -o X", "frames a/p.yaml -o X", "bust a/p.yaml --no-stl -o X"}) {
    for (const auto* files : {&left, &others})
      for (const std::string& file : *files) write_file(folder / "X" / file, "half");
    // Somebody writes this one still.
    write_file(folder / "X/frames/f0003.png.88.part", "half");
    const int living = ::open((folder / "X/frames/f0003.png.88.part").c_str(), O_RDONLY | O_CLOEXEC);
    ::flock(living, LOCK_SH);
    const ProgramRun run = run_shell(folder, std::string("mien ") + command + " --quiet");
    EXPECT_EQ(run.status, 0) << run.err;
    for (const std::string& file : left)
      EXPECT_FALSE(fs::exists(folder / "X" / file)) << command << ": " << file;
    for (const std::string& file : others)
      EXPECT_TRUE(fs::exists(folder / "X" / file)) << command << ": " << file;
    EXPECT_TRUE(fs::exists(folder / "X/frames/f0003.png.88.part")) << command;
    EXPECT_FALSE(fs::exists(folder / "X/frames/.mien-work-a1b2c3")) << command;
    ::close(living);
  }
  for (const std::string& file : others) fs::remove(folder / "X" / file);
  for (const char* bust : {"bust_neutral.scad", "bust_neutral.txt"}) fs::remove(folder / "X" / bust);
  ASSERT_EQ(run_shell(folder, "mien frames a/p.yaml -o X --quiet").status, 0);
  fs::remove_all(folder / "X/scenes");
  EXPECT_EQ(list_files(folder / "X"), whole);
}

TEST(writers, of_one_file_clear_what_dead_runs_left_of_it) {
  const auto folder = make_two_faces("left_beside");
  for (const char* file :
       {"f.obj.12.part", "l.json.12.part", "x.csv.12.part", "n.yaml.12.part", "mine.12.part"})
    write_file(folder / file, "half");
  EXPECT_EQ(run_shell(folder, "mien mesh a/p.yaml -o f.obj --landmarks l.json").status, 0);
  EXPECT_EQ(run_shell(folder, "mien sheet exposure a/p.yaml -o x.csv").status, 0);
  EXPECT_EQ(run_shell(folder, "mien new n").status, 0);
  EXPECT_EQ(list_files(folder), (std::vector<std::string>{"a/p.yaml", "b/p.yaml", "f.obj", "l.json",
                                                          "mine.12.part", "n.yaml", "x.csv"}));
}

// timeout(1) sends its signal to the process and to its group.
TEST(writers, clear_their_own_when_a_signal_comes_twice_at_once) {
  const auto folder = make_two_faces("twice");
  const ProgramRun run =
      run_shell(folder, start_first(folder) +
                            "kill -INT $first; kill -INT $first; kill -TERM $first; wait $first; "
                            "echo $?; ls -A X X/store");
  EXPECT_EQ(run.out, "130\nX:\nstore\n\nX/store:\n") << run.err;
  EXPECT_EQ(read_file(folder / "first.err").substr(read_file(folder / "first.err").find("error")),
            "error: interrupted; what was finished is kept, run again to go on\n");
}

}  // namespace
}  // namespace mien

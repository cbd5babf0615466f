#include "render/driver.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <map>
#include <thread>

#include "core/error.hpp"
#include "render/scratch.hpp"

namespace mien {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kStage =
    "#version 3.7; global_settings{assumed_gamma 1}\n"
    "camera{location <0,0,-3> look_at 0 right x*image_width/image_height} light_source{<3,3,-3> 1}\n";

// Scenes and pictures as the program lays them out, in a folder with an odd name.
struct Shoot {
  explicit Shoot(int frame_count) {
    write_file(scratch.path / "library ö/ball.inc", "#declare Ball = sphere{0,1 pigment{srgb <1,.5,.2>}}\n");
    write_file(scratch.path / "scenes/stage.inc", kStage);
    for (int number = 1; number <= frame_count; ++number) {
      const auto scene = scratch.path / fmt::format("scenes/f{:04}.pov", number);
      write_file(scene, fmt::format("#include \"stage.inc\"\n#include \"ball.inc\"\n"
                                    "object{{Ball translate x*{}/10}}\n",
                                    number));
      frames.push_back({number, scene, scratch.path / fmt::format("my frames é/f{:04}.png", number),
                        fmt::format("key{}", number)});
    }
    settings.width_px = 32;
    settings.height_px = 24;
    settings.libraries = {scratch.path / "library ö"};
    settings.jobs = 4;
  }

  void render() {
    was_kept.clear();
    render_frames(frames, settings, {[this](int number, bool kept) { was_kept[number] = kept; }});
  }

  std::string find_error() {
    return find_message<RunError>([this] { render(); });
  }

  // Of finished pictures and all else in their folder.
  std::ptrdiff_t count_pictures() const { return count_files(frames.front().picture.parent_path()); }

  Scratch scratch;
  std::vector<FrameJob> frames;
  RenderSettings settings;
  std::map<int, bool> was_kept;
};

TEST(driver, renders_frames_that_are_the_same_from_one_and_four_processes) {
  Shoot shoot(4);
  shoot.render();
  EXPECT_EQ(shoot.was_kept, (std::map<int, bool>{{1, false}, {2, false}, {3, false}, {4, false}}));
  EXPECT_EQ(shoot.count_pictures(), 4);
  std::vector<std::string> pictures;
  for (const FrameJob& frame : shoot.frames) {
    pictures.push_back(read_file(frame.picture));
    EXPECT_EQ(find_picture_fault(pictures.back(), {32, 24}), "");
    EXPECT_EQ(read_picture_key(frame.picture), frame.key);
    if (frame.number <= 2) std::filesystem::remove(frame.picture);
  }
  EXPECT_NE(pictures[0], pictures[1]);
  shoot.settings.jobs = 1;
  shoot.render();
  for (std::size_t i = 0; i < pictures.size(); ++i)
    EXPECT_EQ(read_file(shoot.frames[i].picture), pictures[i]);
}

TEST(driver, renders_only_what_is_missing_changed_or_damaged) {
  Shoot shoot(5);
  shoot.render();
  shoot.frames[0].key = "another";
  std::filesystem::remove(shoot.frames[1].picture);
  const std::string whole = read_file(shoot.frames[2].picture);
  write_file(shoot.frames[2].picture, whole.substr(0, whole.size() - 40));
  const auto before = std::filesystem::last_write_time(shoot.frames[3].picture);
  shoot.render();
  EXPECT_EQ(shoot.was_kept, (std::map<int, bool>{{1, false}, {2, false}, {3, false}, {4, true}, {5, true}}));
  EXPECT_EQ(read_file(shoot.frames[2].picture), whole);
  EXPECT_EQ(std::filesystem::last_write_time(shoot.frames[3].picture), before);
}

TEST(driver, starts_nothing_when_all_is_there) {
  Shoot shoot(1);
  shoot.render();
  const FakeProgram fake("povray", "exit 9\n");
  shoot.render();
  EXPECT_EQ(shoot.was_kept, (std::map<int, bool>{{1, true}}));
  shoot.frames.clear();
  EXPECT_NO_THROW(shoot.render());
}

TEST(driver, passes_the_options_on_and_reads_no_stray_settings) {
  Shoot shoot(1);
  const FakeProgram fake(
      "povray", "echo \"$POVINI\" > ../../said; cat \"$POVINI\" >> ../../said; echo \"$@\" >> ../../said\n");
  shoot.settings.povray_options = {"+AM2", "+A0.1"};
  shoot.settings.libraries.push_back(shoot.scratch.path / "scenes");  // named once only
  shoot.find_error();
  EXPECT_EQ(read_file(shoot.scratch.path / "said"),
            "povray.ini\nWork_Threads=1\n"
            "+I../../scenes/f0001.pov +O1.png +L../../scenes +Llink1 +W32 +H24 -D +WT1 +FN8 +AM2 +A0.1\n");
}

TEST(driver, tells_a_failing_scene_and_keeps_the_others) {
  Shoot shoot(3);
  write_file(
      shoot.frames[1].scene,
      "#include \"stage.inc\"\nsphere { 0, an_undeclared_identifier_with_a_name_that_is_long_enough }\n");
  EXPECT_EQ(shoot.find_error(),
            "frame 2: povray failed (exit status 1)\n"
            "  command: cd '" +
                (shoot.scratch.path / "scenes").string() + "' && povray +If0002.pov '+L" +
                (shoot.scratch.path / "library ö").string() +
                "' +W32 +H24 -D +WT1 +FN8\n"
                "  File '../../scenes/f0002.pov' line 2: Parse Error: Expected 'numeric expression', "
                "undeclared identifier"
                " 'an_undeclared_identifier_with_a_name_that_is_long_enough' found instead\n"
                "  Fatal error in parser: Cannot parse input.\n"
                "  Render failed");
  EXPECT_EQ(shoot.was_kept, (std::map<int, bool>{{1, false}, {3, false}}));
  EXPECT_EQ(shoot.count_pictures(), 2);
}

TEST(driver, refuses_an_empty_scene_and_a_bare_background) {
  Shoot shoot(1);
  write_file(shoot.frames[0].scene, "#include \"stage.inc\"\nsky_sphere{pigment{gradient y}}\n");
  EXPECT_THAT(shoot.find_error(), HasSubstr("frame 1: povray found no objects in the scene\n  command: cd "));
  write_file(shoot.frames[0].scene, "#include \"stage.inc\"\nsphere{-9*z,1}\n");
  EXPECT_THAT(shoot.find_error(), HasSubstr("frame 1: povray's picture is all one colour\n  command: "));
  EXPECT_EQ(shoot.count_pictures(), 0);
}

TEST(driver, tells_the_first_of_many_failures_and_starts_no_more) {
  Shoot shoot(9);
  const FakeProgram fake("povray",
                         "case $1 in *f0001.pov) sleep 0.3;; esac; echo \"$1\" >> ../../said; exit 7\n");
  const std::string error = shoot.find_error();
  EXPECT_THAT(error, HasSubstr("frame 1: povray failed (exit status 7)"));
  EXPECT_THAT(error, HasSubstr("\n  failed, too: frame 2, frame 3, frame 4"));
  const std::string said = read_file(shoot.scratch.path / "said");
  EXPECT_EQ(std::ranges::count(said, '\n'), 5) << "one of them twice";
}

// A povray that does as `script` says before it traces.
std::string build_moody_povray(const std::string& script) {
  return script + "\nPATH=/usr/local/bin:/usr/bin:/bin exec povray \"$@\"\n";
}

TEST(driver, tries_a_frame_that_failed_once_more) {
  for (const auto& [frames, jobs] :
       {std::pair{"*f0003.pov", 2}, {"*f0001.pov", 1}, {"*.pov", 4}, {"*.pov", 1}}) {
    Shoot shoot(5);
    shoot.settings.jobs = jobs;
    const FakeProgram fake("povray",
                           build_moody_povray(fmt::format("case $1 in {}) if [ ! -e ../../tried${{1##*/}} ]; "
                                                          "then : > ../../tried${{1##*/}}; exit 9; fi;; esac",
                                                          frames)));
    EXPECT_NO_THROW(shoot.render()) << frames;
    EXPECT_EQ(shoot.count_pictures(), 5) << frames;
  }
}

// The first `times` of every frame: as povray says it where its threads do not come up.
std::string build_busy_machine(int times) {
  return fmt::format(
      "echo >> ../../late${{1##*/}}; [ $(wc -l < ../../late${{1##*/}}) -gt {} ] || {{ "
      "echo 'Timed out waiting for worker thread startup'; exit 1; }}",
      times);
}

TEST(driver, waits_for_a_machine_too_busy_to_start_on) {
  for (const int jobs : {1, 2}) {
    Shoot shoot(2);
    shoot.settings.jobs = jobs;
    const FakeProgram fake("povray", build_moody_povray(build_busy_machine(3)));
    EXPECT_NO_THROW(shoot.render()) << jobs;
    EXPECT_EQ(shoot.count_pictures(), 2) << jobs;
  }
}

// A second try is made once povray starts, and once only: it may begin while the success of the frame beside
// it is still unjudged.
TEST(driver, a_second_try_waits_for_a_busy_machine_as_well) {
  const std::string script =
      "case $1 in *f0002.pov) sleep 0.5;; *f0001.pov) echo >> ../../tries; n=$(wc -l < ../../tries); "
      "if [ $n -eq 1 ]; then exit 9; fi; "
      "if [ $n -le 4 ]; then echo 'Timed out waiting for worker thread startup'; exit 1; fi;; esac";
  for (const int jobs : {1, 2}) {
    Shoot shoot(3);
    shoot.settings.jobs = jobs;
    const FakeProgram fake("povray", build_moody_povray(script));
    EXPECT_NO_THROW(shoot.render()) << jobs;
    EXPECT_EQ(shoot.count_pictures(), 3) << jobs;
    EXPECT_EQ(std::ranges::count(read_file(shoot.scratch.path / "tries"), '\n'), 5) << jobs;
    EXPECT_FALSE(shoot.was_kept[1]) << jobs;
  }
}

TEST(driver, does_not_wait_for_ever_for_a_busy_machine) {
  Shoot shoot(1);
  const FakeProgram fake("povray", build_moody_povray(build_busy_machine(1000)));
  const std::string error = shoot.find_error();
  EXPECT_THAT(error, HasSubstr("frame 1: povray failed (exit status 1)\n  command: "));
  EXPECT_THAT(error, EndsWith("\n  Timed out waiting for worker thread startup"));
}

// What a shoot of so many frames comes to with that povray, one or two at once.
void expect_failures(int frame_count, int jobs, const std::string& script, const std::string& first,
                     const std::string& others, int pictures) {
  Shoot shoot(frame_count);
  shoot.settings.jobs = jobs;
  const FakeProgram fake("povray", build_moody_povray(script));
  const std::string error = shoot.find_error();
  EXPECT_THAT(error, HasSubstr(first + ": povray failed (exit status 9)"));
  EXPECT_THAT(error, testing::EndsWith("\n  failed, too: " + others));
  EXPECT_EQ(shoot.count_pictures(), pictures);
}

TEST(driver, goes_on_after_a_frame_that_fails_twice_and_tells_them_at_the_end) {
  expect_failures(7, 2, "case $1 in *f0003.pov | *f0005.pov) exit 9;; esac", "frame 3", "frame 5", 5);
}

TEST(driver, stops_when_nothing_works_any_more) {
  expect_failures(12, 1, "echo >> ../../said\n[ $(wc -l < ../../said) -lt 3 ] || exit 9", "frame 3",
                  "frame 4, frame 5, frame 6, frame 7, frame 8", 2);
}

TEST(driver, tells_what_a_strange_povray_did) {
  Shoot shoot(1);
  const auto find_error_with = [&](const std::string& script) {
    const FakeProgram fake("povray", script);
    const std::string error = shoot.find_error();
    EXPECT_EQ(shoot.count_pictures(), 0) << script;
    return error.substr(0, error.find('\n'));
  };
  EXPECT_EQ(find_error_with("touch 1.pov-state; kill -SEGV $$\n"),
            "frame 1: povray was ended by signal 11 (Segmentation fault)");
  EXPECT_EQ(find_error_with("exit 0\n"), "frame 1: povray wrote no picture");
  EXPECT_EQ(find_error_with("convert -size 9x7 gradient: 1.png\n"),
            "frame 1: povray's picture is 9x7 pixels, not 32x24");
  EXPECT_EQ(find_error_with("convert -size 32x24 gradient: png:- | head -c 100 > 1.png\n"),
            "frame 1: povray's picture does not decode: the file is cut short");
  EXPECT_EQ(find_error_with(": > 1.png\n"), "frame 1: povray's picture does not decode: the file is empty");
}

TEST(driver, ends_povray_and_cleans_up_on_a_signal) {
  Shoot shoot(3);
  shoot.settings.jobs = 2;
  const FakeProgram fake("povray",
                         "case $1 in *f0001.pov) convert -size 32x24 gradient: 1.png; exit 0;; esac\n"
                         "touch 2.pov-state; echo $$ >> ../../ids; exec sleep 60\n");
  install_signal_handlers();
  const auto ids = shoot.scratch.path / "ids";
  std::thread finger([&] {
    // Two sleepers mean that frame 1 has ended; its picture is judged right after.
    wait_for_lines(ids, 2);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    ::kill(::getpid(), SIGTERM);
  });
  EXPECT_THROW(shoot.render(), Interrupted);
  finger.join();
  install_signal_handlers();
  EXPECT_EQ(shoot.was_kept, (std::map<int, bool>{{1, false}}));
  EXPECT_EQ(shoot.count_pictures(), 1);
  std::istringstream numbers(read_file(ids));
  for (pid_t id; numbers >> id;) EXPECT_TRUE(is_gone(id));
}

TEST(driver, removes_what_a_killed_run_left_but_nothing_of_a_living_one) {
  Shoot shoot(1);
  const auto folder = shoot.frames[0].picture.parent_path();
  write_file(folder / ".mien-work-dead01/1.png", "half");
  std::filesystem::path living;
  {
    const FakeProgram fake("povray", "ls -d ../.mien-work-* > ../../said; exec sleep 60\n");
    const pid_t other = ::fork();
    if (other == 0) {
      shoot.find_error();
      ::_exit(0);
    }
    wait_for_lines(shoot.scratch.path / "said", 1);
    EXPECT_THAT(read_or_empty(shoot.scratch.path / "said"), Not(HasSubstr("dead01")));
    EXPECT_EQ(shoot.count_pictures(), 3);  // the folder, its povray.ini and its link to the library
    shoot.frames[0].number = 2;
    const FakeProgram failing("povray", "exit 1\n");
    EXPECT_THAT(shoot.find_error(), HasSubstr("frame 2: povray failed"));
    EXPECT_EQ(shoot.count_pictures(), 3);
    ::kill(other, SIGKILL);
    ::waitpid(other, nullptr, 0);
  }
  shoot.render();
  EXPECT_EQ(shoot.count_pictures(), 1);
}

TEST(driver, tells_a_place_that_cannot_be_written) {
  Shoot shoot(1);
  shoot.frames[0].picture = "/dev/full/frames/f0001.png";
  EXPECT_EQ(shoot.find_error(), "cannot write in /dev/full/frames: Not a directory");
}

TEST(driver, tells_a_full_disk_in_one_line) {
  Shoot shoot(1);
  const pid_t child = ::fork();
  if (child == 0) {
    // A limit on a file's size stands in for the disk: povray cannot write its state file.
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{4096, 4096};
    ::setrlimit(RLIMIT_FSIZE, &small);
    shoot.settings.width_px = 320;
    const std::string error = shoot.find_error();
    ::_exit(error == "cannot write " + shoot.frames[0].picture.string() + ": File too large" ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(shoot.count_pictures(), 0);
}

}  // namespace
}  // namespace mien

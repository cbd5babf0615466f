// What is right already is kept: after an interruption, after a change, after damage.
#include <gtest/gtest.h>

#include <map>

#include "end_to_end/program.hpp"
#include "places.hpp"
#include "render/picture.hpp"

namespace mien {
namespace {

using Times = std::map<std::string, std::filesystem::file_time_type>;

Times read_times(const std::filesystem::path& folder) {
  Times times;
  for (const std::string& file : list_files(folder))
    times[file] = std::filesystem::last_write_time(folder / file);
  return times;
}

TEST(resume, renders_only_what_is_missing_damaged_or_changed) {
  const auto folder = make_folder("resume");
  const auto frames = folder / "out/tiny/frames";
  write_file(folder / "tiny.yaml", kTinyClip);
  ASSERT_EQ(run_shell(folder, "mien render tiny.yaml").status, 0);
  const Times first = read_times(frames);

  ASSERT_EQ(run_shell(folder, "mien render tiny.yaml").status, 0);
  EXPECT_EQ(read_times(frames), first) << "an unchanged file renders nothing";

  std::filesystem::remove(frames / "f0002.png");
  std::filesystem::resize_file(frames / "f0003.png", 300);
  ASSERT_EQ(run_shell(folder, "mien render tiny.yaml").status, 0);
  const Times mended = read_times(frames);
  EXPECT_EQ(mended.at("f0001.png"), first.at("f0001.png"));
  EXPECT_NE(mended.at("f0002.png"), first.at("f0002.png"));
  EXPECT_NE(mended.at("f0003.png"), first.at("f0003.png"));

  std::string changed = kTinyClip;
  changed.replace(changed.find("smile"), 5, "anger");
  write_file(folder / "tiny.yaml", changed);
  ASSERT_EQ(run_shell(folder, "mien render tiny.yaml").status, 0);
  const Times other = read_times(frames);
  EXPECT_EQ(other.at("f0001.png"), mended.at("f0001.png")) << "the first frame is neutral as before";
  EXPECT_NE(other.at("f0003.png"), mended.at("f0003.png"));

  // Of the same shape: the scenes stay what they are.
  ASSERT_EQ(run_shell(folder, "mien frames tiny.yaml").status, 0);
  const std::string scene = read_file(folder / "out/tiny/scenes/f0001.pov");
  changed.replace(changed.find("48x60"), 5, "96x120");
  write_file(folder / "tiny.yaml", changed);
  ASSERT_EQ(run_shell(folder, "mien render tiny.yaml --keep-scenes").status, 0);
  EXPECT_EQ(read_file(folder / "out/tiny/scenes/f0001.pov"), scene);
  for (const std::string& frame : list_files(frames)) {
    EXPECT_EQ(read_picture_size(frames / frame).width_px, 96) << frame;
    EXPECT_EQ(read_picture_size(frames / frame).height_px, 120) << frame;
  }
}

TEST(resume, goes_on_after_ctrl_c_with_nothing_left_behind) {
  const auto folder = make_folder("interrupt");
  std::string clip = kTinyClip;
  clip.replace(clip.find("0.125s"), 6, "1s");
  write_file(folder / "tiny.yaml", clip);
  const ProgramRun run =
      run_shell(folder, std::string("'") + program_path() +
                            "' render tiny.yaml --jobs 1 & id=$!\n"
                            "while [ ! -e out/tiny/frames/f0003.png ] && kill -0 $id; do sleep 0.1; done\n"
                            "kill -INT $id; wait $id");
  EXPECT_EQ(run.status, 130) << run.err;
  EXPECT_NE(run.err.find("interrupted; what was finished is kept, run again to go on"), std::string::npos)
      << run.err;
  const Times kept = read_times(folder / "out/tiny/frames");
  EXPECT_GE(kept.size(), 2u);
  EXPECT_LT(kept.size(), 24u);
  for (const auto& [name, time] : kept) EXPECT_TRUE(name.size() == 9 && name.ends_with(".png")) << name;

  const ProgramRun again = run_shell(folder, "mien render tiny.yaml");
  ASSERT_EQ(again.status, 0) << again.err;
  const Times all = read_times(folder / "out/tiny/frames");
  EXPECT_EQ(all.size(), 24u);
  for (const auto& [name, time] : kept) EXPECT_EQ(all.at(name), time) << name << " was rendered twice";
}

}  // namespace
}  // namespace mien

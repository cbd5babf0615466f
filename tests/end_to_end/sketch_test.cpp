// Pictures without POV-Ray: what lands where, and how near they are to POV-Ray's.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "end_to_end/program.hpp"
#include "render/picture.hpp"

namespace mien {
namespace {

using Names = std::vector<std::string>;

TEST(sketched, clips_leave_the_clip_and_nothing_else) {
  const auto folder = make_folder("sketched");
  write_file(folder / "tiny.yaml", kTinyClip);
  const ProgramRun run = run_shell(folder, "mien render tiny.yaml --quality sketch");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("out/tiny/tiny_sketch.mp4"), std::string::npos) << run.out;
  EXPECT_EQ(list_files(folder / "out"), (Names{"tiny/manifest_sketch.json", "tiny/tiny_sketch.mp4"}));
  const auto manifest = nlohmann::json::parse(read_file(folder / "out/tiny/manifest_sketch.json"));
  EXPECT_EQ(manifest.at("quality"), "sketch");
  EXPECT_EQ(manifest.at("clip"), "tiny_sketch.mp4");
  EXPECT_EQ(manifest.at("frames"), 3);
  EXPECT_EQ(manifest.at("width"), 48);
  EXPECT_EQ(run_shell(folder,
                      "ffprobe -v error -count_frames -select_streams v:0 -show_entries "
                      "stream=nb_read_frames,width,height -of csv=p=0 out/tiny/tiny_sketch.mp4")
                .out,
            "48,60,3\n");
}

TEST(sketched, clips_are_the_same_bytes_whatever_the_number_of_threads) {
  const auto folder = make_folder("sketched_jobs");
  std::string clip = kTinyClip;
  clip.replace(clip.find("fps: 24"), 7, "fps: 24\n  head: [{at: 0s, age: child}, {at: 80ms, age: adult}]");
  write_file(folder / "tiny.yaml", clip);
  for (const char* jobs : {"1", "2", "5"})
    EXPECT_EQ(run_shell(folder, std::string("mien render tiny.yaml --quality sketch --quiet -o j") + jobs +
                                    " --jobs " + jobs)
                  .status,
              0);
  const std::string one = read_file(folder / "j1/tiny_sketch.mp4");
  EXPECT_EQ(read_file(folder / "j2/tiny_sketch.mp4"), one);
  EXPECT_EQ(read_file(folder / "j5/tiny_sketch.mp4"), one);
}

TEST(sketched, clips_show_some_frames_or_designs_side_by_side) {
  const auto folder = make_folder("sketched_beside");
  write_file(folder / "tiny.yaml", kTinyClip);
  ProgramRun run =
      run_shell(folder, "mien render tiny.yaml --quality sketch --frames 2-3 --beside real,comic");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(list_files(folder / "out"), (Names{"tiny/manifest_sketch.json", "tiny/tiny_sketch_2-3.mp4"}));
  EXPECT_EQ(run_shell(folder,
                      "ffprobe -v error -count_frames -select_streams v:0 -show_entries "
                      "stream=nb_read_frames,width,height -of csv=p=0 out/tiny/tiny_sketch_2-3.mp4")
                .out,
            "96,60,2\n");
}

// Which pixels are not ground, whose colour is that of the first.
std::vector<bool> find_silhouette(const Pixels& picture) {
  std::vector<bool> silhouette;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
    int apart = 0;
    for (std::size_t c = 0; c < 3; ++c)
      apart = std::max(apart, std::abs(int{picture.rgb[i + c]} - int{picture.rgb[c]}));
    silhouette.push_back(apart > 24);
  }
  return silhouette;
}

// Pixels of one silhouette that lie more than one pixel within or without the other.
int count_astray(const std::vector<bool>& silhouette, const std::vector<bool>& other,
                 const PictureSize& size) {
  int astray = 0;
  for (int y = 1; y + 1 < size.height_px; ++y)
    for (int x = 1; x + 1 < size.width_px; ++x) {
      const bool here = silhouette[static_cast<std::size_t>(y * size.width_px + x)];
      bool is_near = false;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          is_near |= other[static_cast<std::size_t>((y + dy) * size.width_px + x + dx)] == here;
      astray += is_near ? 0 : 1;
    }
  return astray;
}

// Mean difference a channel, of 255, and silhouettes.
void expect_near(const Pixels& a, const Pixels& b, double most) {
  ASSERT_EQ(a.rgb.size(), b.rgb.size());
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(int{a.rgb[i]} - int{b.rgb[i]});
  EXPECT_LE(sum / static_cast<double>(a.rgb.size()), most);
  EXPECT_EQ(count_astray(find_silhouette(a), find_silhouette(b), a.size), 0);
  EXPECT_EQ(count_astray(find_silhouette(b), find_silhouette(a), a.size), 0);
}

TEST(sketched, stills_look_as_povray_s) {
  const auto folder = make_folder("sketched_stills");
  for (const char* render :
       {"{background: sky}", "{style: ink, background: sky}", "{style: plaster, background: sun}"}) {
    write_file(folder / "face.yaml",
               std::string("mien: 1\nhead: {age: teenager, look: {skin: brown}}\nrender: ") + render + "\n");
    const std::string still = "mien still face.yaml --express smile --angle 30 --size 120x150 --quiet ";
    ASSERT_EQ(run_shell(folder, still + "--quality sketch -o a.png").status, 0);
    ASSERT_EQ(run_shell(folder, still + "--quality good -o b.png").status, 0);
    SCOPED_TRACE(render);
    expect_near(read_pixels(folder / "a.png"), read_pixels(folder / "b.png"), 3);
  }
}

TEST(sketched, stills_say_in_their_name_what_they_are_and_need_no_povray) {
  const auto folder = make_folder("sketched_name");
  write_file(folder / "face.yaml", "mien: 1\nrender: {quality: sketch, size: 48x60}\n");
  const std::string path = make_program(folder, "povray", "exit 9\n");
  const ProgramRun run = run_shell(folder, path + "mien still face.yaml --express smile");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(list_files(folder / "out"), Names{"face/still_sketch.png"});
}

TEST(sketched, sheets_have_their_marks) {
  const auto folder = make_folder("sketched_sheet");
  write_file(folder / "face.yaml", "mien: 1\n");
  const std::string sheet = "mien sheet views face.yaml --size 100x90 --quiet ";
  ASSERT_EQ(run_shell(folder, sheet + "--quality sketch").status, 0);
  EXPECT_EQ(list_files(folder / "out"), Names{"face/sheet_views_sketch.png"});
  ASSERT_EQ(run_shell(folder, sheet + "--quality good -o b.png").status, 0);
  const Pixels a = read_pixels(folder / "out/face/sheet_views_sketch.png"), b = read_pixels(folder / "b.png");
  ASSERT_EQ(a.rgb.size(), b.rgb.size());
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(int{a.rgb[i]} - int{b.rgb[i]});
  EXPECT_LE(sum / static_cast<double>(a.rgb.size()), 3);
}

TEST(sketched, scenes_are_refused) {
  const auto folder = make_folder("sketched_frames");
  write_file(folder / "tiny.yaml", kTinyClip);
  const ProgramRun run = run_shell(folder, "mien frames tiny.yaml --quality sketch");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(
      run.err,
      "error: quality 'sketch' is mien's own drawing, without scenes; expected --quality draft, good or "
      "best\n");
  EXPECT_EQ(list_files(folder), Names{"tiny.yaml"});
}

TEST(sketched, clips_that_fail_leave_the_last_one) {
  const auto folder = make_folder("sketched_failure");
  write_file(folder / "tiny.yaml", kTinyClip);
  ASSERT_EQ(run_shell(folder, "mien render tiny.yaml --quality sketch --quiet").status, 0);
  const std::string before = read_file(folder / "out/tiny/tiny_sketch.mp4");
  const std::string path =
      make_program(folder, "ffmpeg", "head -c 5 >/dev/null; echo 'no room' >&2; exit 7\n");
  const ProgramRun run = run_shell(folder, path + "mien render tiny.yaml --quality sketch --quiet");
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.err.find("out/tiny/tiny_sketch.mp4: ffmpeg failed (exit status 7)"), std::string::npos)
      << run.err;
  EXPECT_NE(run.err.find("no room"), std::string::npos) << run.err;
  EXPECT_EQ(read_file(folder / "out/tiny/tiny_sketch.mp4"), before);
  EXPECT_EQ(list_files(folder / "out"), (Names{"tiny/manifest_sketch.json", "tiny/tiny_sketch.mp4"}));
}

}  // namespace
}  // namespace mien

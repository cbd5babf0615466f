// The main job on a clip of three tiny frames: what lands where, and that nothing but the file decides the
// pixels.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "end_to_end/program.hpp"
#include "render/picture.hpp"

namespace mien {
namespace {

// "frame 0 hash\nframe 1 hash\n..." of decoded pixels: dates and other chunks of the files do not count.
std::string hash_pixels(const std::filesystem::path& folder, const std::string& pattern) {
  const ProgramRun run =
      run_shell(folder, "ffmpeg -v error -i " + pattern + " -pix_fmt rgb24 -f framemd5 - | grep -v '^#'");
  EXPECT_EQ(run.status, 0) << run.err;
  return run.out;
}

// One render for all tests of this file; they only look at it.
const std::filesystem::path& find_rendered() {
  static const std::filesystem::path kFolder = [] {
    const auto folder = make_folder("render");
    write_file(folder / "tiny.yaml", kTinyClip);
    const ProgramRun run = run_shell(folder, "mien render tiny.yaml --jobs 1 --keep-scenes");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("out/tiny/tiny.mp4"), std::string::npos) << run.out;
    return folder;
  }();
  return kFolder;
}

TEST(render, writes_scenes_frames_clip_and_poster) {
  const auto files = list_files(find_rendered() / "out/tiny");
  for (const char* file : {"frames/f0001.png", "frames/f0002.png", "frames/f0003.png", "poster.png",
                           "scenes/head.inc", "scenes/tiny.ini", "tiny.mp4"})
    EXPECT_NE(std::find(files.begin(), files.end(), file), files.end()) << file;
  for (const std::string& file : files)
    EXPECT_EQ(file.find("tmp"), std::string::npos) << file << " was left behind";
  const auto folder = find_rendered() / "out/tiny";
  EXPECT_EQ(read_file(folder / "poster.png"), read_file(folder / "frames/f0003.png")) << "the smile";
  const auto manifest = nlohmann::json::parse(read_file(folder / "manifest.json"));
  EXPECT_EQ(manifest.at("frames"), 3);
  EXPECT_EQ(manifest.at("width"), 48);
  EXPECT_EQ(manifest.at("height"), 60);
  ASSERT_EQ(manifest.at("drawings").size(), 3u);
  for (int i = 0; i < 3; ++i) {
    const auto& drawing = manifest.at("drawings")[static_cast<std::size_t>(i)];
    EXPECT_EQ(drawing.at("frame"), i + 1);
    EXPECT_EQ(drawing.at("picture"), "frames/f000" + std::to_string(i + 1) + ".png");
    EXPECT_EQ(drawing.at("key"), read_picture_key(folder / drawing.at("picture").get<std::string>()));
  }
}

TEST(render, a_part_has_a_name_of_its_own_and_held_frames_have_their_drawing) {
  const auto folder = make_folder("render_part");
  std::string clip = kTinyClip;
  clip.replace(clip.find("fps: 24"), 7, "fps: 24\n  draw: twos\n  length: 0.1667s");
  write_file(folder / "tiny.yaml", clip);
  ASSERT_EQ(run_shell(folder, "mien render tiny.yaml --frames 2-4 --quiet").status, 0);
  const auto files = list_files(folder / "out/tiny");
  const auto has = [&](const char* file) { return std::ranges::find(files, file) != files.end(); };
  EXPECT_TRUE(has("tiny_2-4.mp4"));
  EXPECT_FALSE(has("tiny.mp4"));
  EXPECT_FALSE(has("frames/f0001.png"));
  const auto frames = folder / "out/tiny/frames";
  EXPECT_EQ(read_file(frames / "f0004.png"), read_file(frames / "f0003.png"));
  EXPECT_NE(read_file(frames / "f0004.png"), read_file(frames / "f0002.png"));

  // A clip that became shorter has no frames behind its end.
  write_file(folder / "tiny.yaml", kTinyClip);
  ASSERT_EQ(run_shell(folder, "mien frames tiny.yaml --quiet").status, 0);
  EXPECT_FALSE(std::filesystem::exists(frames / "f0004.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out/tiny/scenes/f0004.pov"));
  EXPECT_TRUE(std::filesystem::exists(frames / "f0003.png"));
}

TEST(render, gives_the_clip_the_count_size_and_rate_of_the_file) {
  const ProgramRun run =
      run_shell(find_rendered(),
                "ffprobe -v error -count_frames -select_streams v -show_entries "
                "stream=codec_name,width,height,pix_fmt,color_space,r_frame_rate,nb_read_frames "
                "-of default=noprint_wrappers=1 out/tiny/tiny.mp4");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out,
            "codec_name=h264\nwidth=48\nheight=60\npix_fmt=yuv420p\ncolor_space=bt709\nr_frame_rate=24/1\n"
            "nb_read_frames=3\n");
}

TEST(render, moves_the_face_from_frame_to_frame) {
  const std::string hashes = hash_pixels(find_rendered(), "out/tiny/frames/f%04d.png");
  std::vector<std::string> frames;
  for (std::size_t at = 0, end; (end = hashes.find('\n', at)) != std::string::npos; at = end + 1)
    frames.push_back(hashes.substr(hashes.rfind(' ', end) + 1, end - hashes.rfind(' ', end) - 1));
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_NE(frames[0], frames[1]);
  EXPECT_NE(frames[1], frames[2]);
}

TEST(render, writes_the_same_with_one_job_and_with_four) {
  const auto one = find_rendered();
  const auto four = make_folder("render_jobs_4");
  write_file(four / "tiny.yaml", kTinyClip);
  const ProgramRun run = run_shell(four, "mien render tiny.yaml --jobs 4 --keep-scenes");
  ASSERT_EQ(run.status, 0) << run.err;
  ASSERT_EQ(list_files(one), list_files(four));
  for (const std::string& file : list_files(one / "out/tiny/scenes"))
    EXPECT_EQ(read_file(one / "out/tiny/scenes" / file), read_file(four / "out/tiny/scenes" / file)) << file;
  EXPECT_EQ(hash_pixels(one, "out/tiny/frames/f%04d.png"), hash_pixels(four, "out/tiny/frames/f%04d.png"));
}

TEST(render, shows_what_povray_alone_shows) {
  const auto ours = find_rendered();
  const auto alone = make_folder("povray_alone");
  write_file(alone / "tiny.yaml", kTinyClip);
  ProgramRun run = run_shell(alone, "mien frames tiny.yaml");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_FALSE(std::filesystem::exists(alone / "out/tiny/tiny.mp4"));
  run = run_shell(alone, "povray out/tiny/scenes/tiny.ini");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(hash_pixels(ours, "out/tiny/frames/f%04d.png"), hash_pixels(alone, "out/tiny/frames/f%04d.png"));
}

TEST(render, puts_designs_beside_each_other) {
  const auto folder = make_folder("beside");
  write_file(folder / "tiny.yaml", kTinyClip);
  write_file(folder / "out/tiny/real/frames/f0001.png.4711.part", "of a run that was killed");
  const std::string command = "mien render tiny.yaml --beside real,comic --jobs 2 --keep-scenes";
  const ProgramRun run = run_shell(folder, command);
  ASSERT_EQ(run.status, 0) << run.err;
  const auto out = folder / "out/tiny";
  const auto manifest = nlohmann::json::parse(read_file(out / "manifest.json"));
  EXPECT_EQ(manifest.at("width"), 96);
  EXPECT_EQ(manifest.at("drawings").size(), 3u);
  for (const auto& drawing : manifest.at("drawings")) {
    const std::string name = drawing.at("picture");
    EXPECT_EQ(drawing.at("key"), read_picture_key(out / name)) << name;
    const Pixels whole = read_pixels(out / name);
    ASSERT_EQ(whole.size.width_px, 96);
    int left_px = 0;
    for (const char* design : {"real", "comic"}) {
      const Pixels part = read_pixels(out / design / name);
      Pixels page = whole;
      paste_pixels(page, part, left_px, 0);
      EXPECT_EQ(page.rgb, whole.rgb) << design << " in " << name;
      left_px += part.size.width_px;
    }
  }
  const auto files = list_files(out);
  for (const char* file : {"tiny.mp4", "poster.png", "real/scenes/head.inc", "comic/scenes/head.inc"})
    EXPECT_NE(std::find(files.begin(), files.end(), file), files.end()) << file;
  for (const std::string& file : files)
    EXPECT_EQ(file.find(".part"), std::string::npos) << file << " was left behind";

  // What is there already is kept, and what is damaged is made again.
  const auto picture = out / "frames/f0002.png";
  const std::string whole = read_file(picture);
  const auto written = std::filesystem::last_write_time(out / "frames/f0001.png");
  write_file(picture, whole.substr(0, whole.size() / 2));
  ASSERT_EQ(run_shell(folder, command).status, 0);
  EXPECT_EQ(read_file(picture), whole);
  EXPECT_EQ(std::filesystem::last_write_time(out / "frames/f0001.png"), written);
}

TEST(render, says_what_cannot_stand_beside_each_other) {
  const auto folder = make_folder("beside_wrong");
  write_file(folder / "tiny.yaml", kTinyClip);
  const auto expect = [&](const std::string& designs, int status, const std::string& error) {
    const ProgramRun run = run_shell(folder, "mien render tiny.yaml --beside " + designs);
    EXPECT_EQ(run.status, status);
    EXPECT_EQ(run.err, error);
  };
  expect("real", 2, "error: --beside: 'real' is not two to four designs such as real,comic\n");
  expect("real,cubist", 2,
         "error: --beside: unknown design 'cubist'; known: real, caricature, comic, manga\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  write_file(folder / "out/tiny/comic", "a file");
  expect("real,comic", 2, "error: out/tiny/comic: it is a file; expected a folder\n");
  EXPECT_EQ(list_files(folder / "out"), std::vector<std::string>{"tiny/comic"});
}

TEST(render, says_first_that_a_program_is_missing) {
  const auto folder = make_folder("no_povray");
  write_file(folder / "tiny.yaml", kTinyClip);
  const ProgramRun run = run_shell(folder, "PATH=/nowhere mien render tiny.yaml");
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.err, "error: povray is not installed; install it with: apt-get install povray\n");
  EXPECT_EQ(list_files(folder), std::vector<std::string>{"tiny.yaml"});
}

}  // namespace
}  // namespace mien

// No drawing is traced twice, whatever was edited, and nothing is left that nobody asked for.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "end_to_end/program.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// In a clip's store, beside the list of what they were made from.
std::size_t count_stored(const fs::path& store) {
  const auto files = list_files(store);
  return files.size() - static_cast<std::size_t>(std::ranges::count(files, "drawings.txt"));
}

// A second of a clip on ones, between these keys.
std::string build_clip(const std::string& keys, const std::string& more = "") {
  return "mien: 1\ntitle: Store\nrender: {size: 16x20, quality: draft}\nclip:\n  fps: 12\n  length: 1s\n" +
         more + "  keys:\n" + keys;
}

constexpr const char* kThere =
    "    - {at: 0.25s, express: neutral}\n    - {at: 0.75s, express: smile, ease: linear}\n";

// How many drawings a render of clip.yaml with this text traces.
int render(const fs::path& folder, const std::string& text, const std::string& options = "") {
  write_file(folder / "clip.yaml", text);
  const ProgramRun run = run_shell(folder, "mien render clip.yaml " + options);
  EXPECT_EQ(run.status, 0) << run.err;
  const std::size_t end = run.err.find(" to trace\n");
  EXPECT_NE(end, std::string::npos) << run.err;
  if (end == std::string::npos) return -1;
  const int planned = std::stoi(run.err.substr(run.err.rfind(' ', end - 1)));
  EXPECT_THAT(run.err, HasSubstr(fmt::format("frames: {} done", planned)));
  return planned;
}

TEST(store, traces_nothing_that_exists_whatever_was_edited) {
  const auto folder = make_folder("store_edits");
  EXPECT_EQ(render(folder, build_clip(kThere)), 7) << "of 12 frames: held, five between, held";
  const std::string manifest = read_file(folder / "out/clip/manifest.json");
  EXPECT_EQ(render(folder, build_clip(kThere)), 0) << "nothing";
  EXPECT_EQ(read_file(folder / "out/clip/manifest.json"), manifest);
  std::string text = build_clip(kThere);
  EXPECT_EQ(render(folder, text.replace(text.find("Store"), 5, "Other")), 0) << "another title";
  EXPECT_EQ(render(folder,
                   build_clip(
                       "    - {at: 0s, express: neutral}\n    - {at: 0.5s, express: smile, ease: linear}\n")),
            0)
      << "moved";
  EXPECT_EQ(
      render(folder,
             build_clip(
                 "    - {at: 0.25s, express: smile}\n    - {at: 0.75s, express: neutral, ease: linear}\n")),
      0)
      << "reversed";
  std::string longer = build_clip(kThere);
  EXPECT_EQ(render(folder, longer.replace(longer.find("length: 1s"), 10, "length: 3s")), 0) << "longer";
  EXPECT_EQ(
      render(folder,
             build_clip(
                 "    - {at: 0.25s, express: neutral}\n    - {at: 0.75s, express: anger, ease: linear}\n")),
      6)
      << "another key: all but the first drawing";
  EXPECT_EQ(render(folder, build_clip(kThere)), 0) << "as it was at first";
  EXPECT_EQ(read_file(folder / "out/clip/manifest.json"), manifest);
}

TEST(store, knows_the_povray_that_traced) {
  const auto folder = make_folder("store_povray");
  EXPECT_EQ(render(folder, build_clip(kThere)), 7);
  const std::string other =
      make_program(folder, "povray", "exec /usr/bin/env PATH=/usr/local/bin:/usr/bin:/bin povray \"$@\"\n");
  const ProgramRun run = run_shell(folder, other + "'" + program_path() + "' render clip.yaml");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("12 frames, 7 drawings, 7 to trace\n"));
  EXPECT_EQ(render(folder, build_clip(kThere)), 0) << "the first one's pictures are there as well";
}

TEST(store, leaves_a_clip_its_frames_and_the_store) {
  const auto folder = make_folder("store_left");
  render(folder, build_clip(kThere));
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder / "out/clip"))
    names.push_back(entry.path().filename().string());
  EXPECT_THAT(names,
              testing::UnorderedElementsAre("clip.mp4", "frames", "manifest.json", "poster.png", "store"));
  EXPECT_EQ(count_stored(folder / "out/clip/store"), 7u);
  EXPECT_TRUE(fs::equivalent(folder / "out/clip/frames/f0011.png", folder / "out/clip/frames/f0012.png"))
      << "a held drawing takes no room of its own";
  render(folder, build_clip(kThere), "--keep-scenes");
  EXPECT_TRUE(fs::exists(folder / "out/clip/scenes/f0012.pov"));
  EXPECT_TRUE(fs::exists(folder / "out/clip/scenes/clip.ini"));
}

TEST(store, is_bounded_and_keeps_what_is_shown) {
  const auto folder = make_folder("store_bound");
  render(folder, build_clip(kThere));
  const std::string other =
      build_clip("    - {at: 0.25s, express: anger}\n    - {at: 0.75s, express: fear}\n");
  EXPECT_EQ(render(folder, other, "--store 0"), 7);
  EXPECT_EQ(count_stored(folder / "out/clip/store"), 7u);
  EXPECT_EQ(render(folder, other), 0);
  for (const auto& [size, wrong] :
       {std::pair{"2TB", "2TB"}, {"GB", "GB"}, {"-1MB", "-1MB"}, {"1.5GB", "1.5GB"}}) {
    const ProgramRun run = run_shell(folder, fmt::format("mien render clip.yaml --store={}", size));
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.err, fmt::format("error: --store: '{}' is not a size such as 2GB or 500MB\n", wrong));
  }
}

TEST(store, is_emptied_by_clean) {
  const auto folder = make_folder("store_clean");
  render(folder, build_clip(kThere), "--keep-scenes");
  write_file(folder / "out/clip/frames/holiday.png", "somebody's own");
  const ProgramRun run = run_shell(folder, "mien clean clip.yaml");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, testing::MatchesRegex("cleaned  out/clip: [0-9]+ files, [0-9]+\\.[0-9] MB\n"));
  EXPECT_EQ(list_files(folder / "out/clip"),
            (std::vector<std::string>{"clip.mp4", "frames/holiday.png", "manifest.json", "poster.png"}));
  EXPECT_EQ(run_shell(folder, "mien clean clip.yaml --json").out,
            "{\"cleaned\":\"out/clip\",\"files\":0,\"bytes\":0}\n");
  EXPECT_EQ(render(folder, build_clip(kThere)), 7);
}

TEST(store, takes_back_from_frames_what_it_has_lost) {
  const auto folder = make_folder("store_lost");
  render(folder, build_clip(kThere));
  fs::remove_all(folder / "out/clip/store");
  EXPECT_EQ(render(folder, build_clip(kThere)), 0);
  EXPECT_EQ(count_stored(folder / "out/clip/store"), 7u);
}

TEST(store, leaves_the_scene_of_a_frame_that_fails_where_it_can_be_tried) {
  const auto folder = make_folder("store_fails");
  write_file(folder / "clip.yaml", build_clip(kThere));
  const std::string path = make_program(folder, "povray", "echo 'Parse Error: no luck' >&2\nexit 1\n");
  const ProgramRun run =
      run_shell(folder, "{ " + path + "'" + program_path() + "' render clip.yaml --jobs 1; }");
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("cd out/clip/scenes && povray +If0"));
  const std::vector<std::string> files = list_files(folder / "out/clip/scenes");
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files.back(), "head.inc");
  EXPECT_EQ(
      run_shell(folder, "cd out/clip/scenes && povray +I" + files.front() + " -D +W16 +H20 +Ox.png").status,
      0);
}

// The poster's frame holds the drawing before it, and so many drawings are worth a preview.
TEST(store, shows_a_preview_while_it_works) {
  const auto folder = make_folder("store_preview");
  write_file(folder / "clip.yaml",
             "mien: 1\nrender: {size: 16x20, quality: draft}\nclip:\n  fps: 24\n  draw: twos\n  keys:\n"
             "    - {at: 0s, express: neutral}\n    - {at: 25f, express: smile}\n    - {at: 57f, express: "
             "neutral}\n");
  const ProgramRun run = run_shell(folder, "mien render clip.yaml --json --jobs 1");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, testing::ContainsRegex(
                           "\"event\":\"plan\",\"frames\":57,\"drawings\":2[0-9],\"to_trace\":2[0-9]"));
  const std::string told = "{\"event\":\"preview\",\"path\":\"out/clip/clip_preview.mp4\"}\n";
  std::size_t count = 0;
  for (std::size_t at = run.err.find(told); at != run.err.npos; at = run.err.find(told, at + 1)) ++count;
  EXPECT_EQ(count, 3u) << "every eighth, fourth and second";
  EXPECT_EQ(run.out, "{\"clip\":\"out/clip/clip.mp4\"}\n{\"poster\":\"out/clip/poster.png\"}\n");
  EXPECT_FALSE(fs::exists(folder / "out/clip/clip_preview.mp4")) << "the clip is there";
  const std::string first = run.err.substr(run.err.find("\"stage\":\"frames\""));
  EXPECT_THAT(first.substr(0, 40), HasSubstr("\"frame\":25,")) << "the poster's drawing";
  EXPECT_EQ(read_file(folder / "out/clip/poster.png"), read_file(folder / "out/clip/frames/f0026.png"));
}

TEST(store, of_all_clips_is_emptied_where_none_is_named) {
  const auto folder = make_folder("store_clean_all");
  for (const char* file :
       {"out/a/store/0123456789abcdef.png", "out/a/comic/store/0123456789abcdef.png",
        "out/a/frames/f0001.png", "out/a/a.mp4", "out/b/scenes/f0001.pov", "out/c/mine.png"})
    write_file(folder / file, "0123456789");
  const ProgramRun run = run_shell(folder, "mien clean");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out,
            "cleaned  out/a: 3 files, 0.0 MB\ncleaned  out/b: 1 file, 0.0 MB\n"
            "cleaned  out/c: 0 files, 0.0 MB\n");
  EXPECT_EQ(list_files(folder), (std::vector<std::string>{"out/a/a.mp4", "out/c/mine.png"}));
  const ProgramRun none = run_shell(folder, "mien clean nobody.yaml");
  EXPECT_EQ(none.status, 2);
  EXPECT_EQ(none.err, "error: out/nobody: there is no such folder\n");
  EXPECT_EQ(run_shell(folder, "mien clean a b").err, "error: 'b' is one word too many for 'mien clean'\n");
  EXPECT_EQ(run_shell(folder, "mien clean -o out/c --quiet").out, "");
}

}  // namespace
}  // namespace mien

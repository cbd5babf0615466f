#include "render/video.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "render/picture.hpp"
#include "render/process.hpp"
#include "render/scratch.hpp"
#include "render/video_kind.hpp"

namespace mien {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// `count` pictures of a colour that grows redder, in a folder with an odd name.
struct Reel {
  explicit Reel(int count, int width = 32, int height = 24) {
    for (int i = 1; i <= count; ++i) {
      const Rgb colour{static_cast<unsigned char>(40 * i), 100, 210};
      pictures.push_back(scratch.path / fmt::format("my frames é %d/f{:04}.png", i));
      write_file(pictures.back(), build_picture(width, height, colour, colour));
    }
  }

  // What ffprobe says of the clip, as "key=value" lines.
  std::string probe() const {
    return run_process(
               {"ffprobe", "-v", "error", "-count_frames", "-show_streams", "-show_format", "clip ö.mp4"},
               scratch.path)
        .output;
  }

  // The first frame's pixels, decoded to RGB.
  std::string decode() const {
    return run_process({"ffmpeg", "-v", "error", "-i", "clip ö.mp4", "-frames:v", "1", "-f", "rawvideo",
                        "-pix_fmt", "rgb24", "-"},
                       scratch.path)
        .output;
  }

  std::string find_error() {
    return find_message<RunError>([this] { write_video(pictures, 24, clip); });
  }

  Scratch scratch;
  std::vector<std::filesystem::path> pictures;
  std::filesystem::path clip = scratch.path / "clip ö.mp4";
};

TEST(video, has_the_frames_rate_and_tags_it_should) {
  Reel reel(3);
  const auto& p = reel.pictures;
  write_video({p[0], p[0], p[1], p[1], p[2]}, 24, reel.clip);
  const std::string facts = reel.probe();
  for (const char* fact : {"codec_name=h264", "width=32", "height=24", "pix_fmt=yuv420p", "color_range=tv",
                           "color_space=bt709", "color_transfer=bt709", "color_primaries=bt709",
                           "r_frame_rate=24/1", "avg_frame_rate=24/1", "nb_read_frames=5"})
    EXPECT_THAT(facts, HasSubstr(std::string(fact) + "\n"));
  const std::string bytes = read_file(reel.clip);
  EXPECT_LT(bytes.find("moov"), bytes.find("mdat"));  // faststart
  EXPECT_EQ(count_files(reel.scratch.path), 3 + 1 + 1);
}

TEST(video, shows_the_colours_of_the_pictures) {
  Reel reel(1);
  write_video(reel.pictures, 24, reel.clip);
  const std::string rgb = reel.decode();
  ASSERT_EQ(rgb.size(), 32u * 24 * 3);
  EXPECT_NEAR(static_cast<unsigned char>(rgb[0]), 40, 3);
  EXPECT_NEAR(static_cast<unsigned char>(rgb[1]), 100, 3);
  EXPECT_NEAR(static_cast<unsigned char>(rgb[2]), 210, 3);
}

TEST(video, pads_odd_sides_with_the_border_itself) {
  for (const auto& [width, height] : {std::pair{33, 25}, {34, 25}, {33, 26}}) {
    Reel reel(1, width, height);
    write_video(reel.pictures, 24, reel.clip);
    EXPECT_THAT(reel.probe(), HasSubstr("width=34\nheight=26\n"));
    const std::string rgb = reel.decode();
    ASSERT_EQ(rgb.size(), 34u * 26 * 3);
    for (std::size_t i = 0; i < rgb.size(); ++i)
      EXPECT_NEAR(static_cast<unsigned char>(rgb[i]), static_cast<unsigned char>(rgb[i % 3]), 2) << i;
  }
}

TEST(video, is_the_same_bytes_whatever_the_cores) {
  Reel reel(4);
  write_video(reel.pictures, 24, reel.clip);
  const std::string first = read_file(reel.clip);
  const FakeProgram fake("ffmpeg", "PATH=${PATH#*:}; exec taskset -c 0 ffmpeg \"$@\"\n");
  std::filesystem::remove(reel.clip);
  write_video(reel.pictures, 24, reel.clip);
  EXPECT_TRUE(read_file(reel.clip) == first);
}

TEST(video, refuses_pictures_that_ffmpeg_would_pass_over) {
  Reel reel(3);
  write_file(reel.pictures[1], read_file(reel.pictures[1]).substr(0, 60));
  EXPECT_EQ(reel.find_error(),
            reel.pictures[1].string() + " is not a whole PNG picture: the file is cut short");
  write_file(reel.pictures[1], "");
  EXPECT_EQ(reel.find_error(), reel.pictures[1].string() + " is not a whole PNG picture: the file is empty");
  std::filesystem::remove(reel.pictures[1]);
  EXPECT_EQ(reel.find_error(), "cannot read " + reel.pictures[1].string() + ": No such file or directory");
  for (const auto& [width, height] : {std::pair{16, 16}, {32, 26}, {30, 24}}) {
    write_file(reel.pictures[1], build_picture(width, height));
    EXPECT_EQ(reel.find_error(),
              fmt::format("{} is {}x{} pixels, but {} is 32x24; a clip needs one size",
                          reel.pictures[1].string(), width, height, reel.pictures[0].string()));
  }
  reel.pictures.clear();
  EXPECT_EQ(reel.find_error(), "a clip needs one picture at least");
  EXPECT_FALSE(std::filesystem::exists(reel.clip));
}

TEST(video, tells_a_failing_ffmpeg_and_keeps_the_old_clip) {
  Reel reel(1);
  write_file(reel.clip, "the old clip");
  {
    const FakeProgram fake("ffmpeg", "echo 'Unknown encoder libx264' >&2; echo half > clip.mp4; exit 1\n");
    const std::string error = reel.find_error();
    EXPECT_THAT(error, StartsWith(reel.clip.string() +
                                  ": ffmpeg failed (exit status 1)\n  command: ffmpeg -nostdin "));
    EXPECT_TRUE(error.ends_with("\n  Unknown encoder libx264")) << error;
  }
  {
    const FakeProgram fake("ffprobe", "echo 7\n");
    EXPECT_EQ(reel.find_error(), "ffmpeg made a clip of 7 frames, not 1: " + reel.clip.string());
  }
  EXPECT_EQ(read_file(reel.clip), "the old clip");
  EXPECT_EQ(count_files(reel.scratch.path), 3);
}

Pixels build_pixels(int width, int height, std::uint8_t red) {
  Pixels pixels{{width, height}, {}};
  for (int i = 0; i < width * height; ++i) pixels.rgb.insert(pixels.rgb.end(), {red, 100, 210});
  return pixels;
}

TEST(video, can_be_fed_frame_by_frame) {
  Reel reel(0);
  VideoStream stream = start_video({{33, 25}, 24}, reel.clip);
  for (const int red : {40, 40, 80})
    append_frame(stream, build_pixels(33, 25, static_cast<std::uint8_t>(red)));
  EXPECT_FALSE(std::filesystem::exists(reel.clip)) << "complete or absent";
  finish_video(stream);
  const std::string facts = reel.probe();
  for (const char* fact : {"codec_name=h264", "width=34", "height=26", "pix_fmt=yuv420p", "color_range=tv",
                           "color_space=bt709", "avg_frame_rate=24/1", "nb_read_frames=3"})
    EXPECT_THAT(facts, HasSubstr(fact));
  const std::string pixels = reel.decode();
  EXPECT_NEAR(static_cast<unsigned char>(pixels[0]), 40, 3);
  EXPECT_NEAR(static_cast<unsigned char>(pixels[2]), 210, 3);
}

TEST(video, that_is_not_finished_leaves_nothing) {
  Reel reel(0);
  {
    VideoStream stream = start_video({{32, 24}, 24}, reel.clip);
    append_frame(stream, build_pixels(32, 24, 10));
  }
  EXPECT_TRUE(std::filesystem::is_empty(reel.scratch.path));
}

TEST(video, says_what_is_wrong_with_a_stream) {
  Reel reel(0);
  VideoStream stream = start_video({{32, 24}, 24}, reel.clip);
  EXPECT_EQ(find_message<RunError>([&] { append_frame(stream, build_pixels(24, 32, 10)); }),
            "a picture of 24x32 pixels for a clip of 32x24");
  VideoStream empty = start_video({{32, 24}, 24}, reel.scratch.path / "empty.mp4");
  EXPECT_EQ(find_message<RunError>([&] { finish_video(empty); }), "a clip needs one picture at least");
}

// What ffprobe says of a clip of each kind, and of WebP, which it cannot read, what its chunks say.
TEST(video, is_of_the_kind_that_its_name_ends_in) {
  const Reel reel(3, 33, 25);
  const auto& p = reel.pictures;
  const auto read = [&](const char* name) {
    const std::filesystem::path clip = reel.scratch.path / name;
    write_video({p[0], p[0], p[1], p[2], p[2]}, 24, clip);
    const std::string once = read_file(clip);
    write_video({p[0], p[0], p[1], p[2], p[2]}, 24, clip);
    EXPECT_EQ(read_file(clip), once) << name << ": the same pictures are the same bytes";
    return run_process(
               {"ffprobe", "-v", "error", "-count_frames", "-show_entries",
                "stream=codec_name,width,height,pix_fmt,color_space,nb_read_frames", "-of", "csv=p=0", name},
               reel.scratch.path)
        .output;
  };
  EXPECT_EQ(read("clip.mp4"), "h264,34,26,yuv420p,bt709,5\n");
  EXPECT_EQ(read("clip.webm"), "vp9,34,26,yuv420p,bt709,5\n");
  EXPECT_THAT(read("clip.MOV"), testing::MatchesRegex("prores,33,25,yuv444p1[02]le,bt709,5\n"));
  EXPECT_THAT(read("clip.gif"), testing::MatchesRegex("gif,33,25,bgra,[a-z]+,5\n"));
  EXPECT_THAT(read("clip.apng"), testing::MatchesRegex("apng,33,25,rgb24,[a-z]+,5\n"));
  read("clip.webp");
  const std::string webp = read_file(reel.scratch.path / "clip.webp");
  EXPECT_EQ(webp.substr(0, 4) + webp.substr(8, 4), "RIFFWEBP");
  EXPECT_NE(webp.find("ANIM"), webp.npos);
}

TEST(video, of_one_or_two_pictures_is_made_in_every_kind) {
  const Reel reel(1);
  for (const std::string& ending : list_video_endings())
    EXPECT_NO_THROW(write_video(reel.pictures, 24, reel.scratch.path / ("one" + ending))) << ending;
  const std::vector<std::filesystem::path> held{reel.pictures[0], reel.pictures[0]};
  for (const std::string& ending : list_video_endings())
    EXPECT_NO_THROW(write_video(held, 24, reel.scratch.path / ("two" + ending))) << ending;
}

TEST(video, is_judged_by_size_rate_and_count) {
  const Reel reel(3);
  for (const std::string& ending : list_video_endings()) {
    const std::string name = "clip" + ending;
    write_video(reel.pictures, 24, reel.scratch.path / name);
    const auto find = [&](const PictureSize& size, int fps, std::size_t count) {
      return find_video_fault(reel.scratch.path, name, {size, fps}, count);
    };
    EXPECT_EQ(find({32, 24}, 24, 3), "") << name;
    EXPECT_EQ(find({30, 24}, 24, 3), "ffmpeg made a clip of 32x24 pixels, not 30x24") << name;
    EXPECT_NE(find({32, 24}, 24, 4), "") << name;
    EXPECT_EQ(find({32, 24}, 12, 3).empty(), ending == ".gif") << name;
  }
  EXPECT_EQ(find_video_fault(reel.scratch.path, "clip.mp4", {{32, 24}, 24}, 9),
            "ffmpeg made a clip of 3 frames, not 9");
  EXPECT_EQ(find_video_fault(reel.scratch.path, "clip.mp4", {{32, 24}, 25}, 3),
            "ffmpeg made a clip of 24/1 frames a second, not 25");
  EXPECT_EQ(find_video_fault(reel.scratch.path, "clip.webp", {{32, 24}, 24}, 9),
            "ffmpeg made a clip of 124 ms, not 375");
}

// A tone of a second and a half, 8000 samples a second; silent but for a click at half a second.
std::filesystem::path write_click(const Scratch& scratch) {
  constexpr int kRate = 8000, kCount = kRate * 3 / 2;
  std::string wav;
  const auto append = [&wav](std::uint32_t number, int bytes) {
    for (int i = 0; i < bytes; ++i) wav += static_cast<char>(number >> (8 * i) & 0xFF);
  };
  wav = "RIFF";
  append(36 + 2 * kCount, 4);
  wav += "WAVEfmt ";
  for (const auto& [number, bytes] :
       {std::pair{16u, 4}, {1u, 2}, {1u, 2}, {8000u, 4}, {16000u, 4}, {2u, 2}, {16u, 2}})
    append(number, bytes);
  wav += "data";
  append(2 * kCount, 4);
  for (int i = 0; i < kCount; ++i) append(i >= kRate / 2 && i < kRate / 2 + 40 ? 20000 : 0, 2);
  write_file(scratch.path / "my click é.wav", wav);
  return scratch.path / "my click é.wav";
}

// When the first loud sample is heard, s.
double find_click_s(const std::filesystem::path& folder, const std::string& clip) {
  const std::string samples = run_process({"ffmpeg", "-v", "error", "-i", clip, "-map", "0:a", "-ac", "1",
                                           "-ar", "8000", "-f", "s16le", "-"},
                                          folder)
                                  .output;
  for (std::size_t i = 0; i + 1 < samples.size(); i += 2)
    if (static_cast<signed char>(samples[i + 1]) > 20) return static_cast<double>(i / 2) / 8000;
  return -1;
}

TEST(video, is_heard_where_its_kind_can_be) {
  const Reel reel(1);
  const std::vector<std::filesystem::path> two_seconds(48, reel.pictures[0]);
  const std::filesystem::path wav = write_click(reel.scratch);
  constexpr double kNear_s = 0.004;  // encoders ring before a click
  for (const char* name : {"heard.mp4", "heard.webm", "heard.mov"}) {
    EXPECT_TRUE(is_film(name));
    for (const auto& [at_s, click_s] : {std::pair{0.0, 0.5}, {0.75, 1.25}, {-0.25, 0.25}}) {
      write_video(two_seconds, 24, reel.scratch.path / name, Sound{wav, at_s});
      EXPECT_NEAR(find_click_s(reel.scratch.path, name), click_s, kNear_s) << name << " at " << at_s;
      EXPECT_EQ(find_video_fault(reel.scratch.path, name, {{32, 24}, 24}, 48, true), "");
    }
  }
  write_video(two_seconds, 24, reel.scratch.path / "silent.gif", Sound{wav, 0});
  write_video(two_seconds, 24, reel.scratch.path / "silent.mp4");
  EXPECT_FALSE(is_film("silent.gif"));
  EXPECT_EQ(find_video_fault(reel.scratch.path, "silent.mp4", {{32, 24}, 24}, 48, true),
            "ffmpeg made a clip without sound");
  EXPECT_THAT(find_video_fault(reel.scratch.path, "heard.mov", {{32, 24}, 24}, 48, true), "");
  EXPECT_THAT(find_message<RunError>([&] {
                write_video(two_seconds, 24, reel.scratch.path / "x.mp4", Sound{reel.pictures[0], 0});
              }),
              HasSubstr("x.mp4: ffmpeg failed"));
}

TEST(video, of_sketches_is_heard_too) {
  const Reel reel(1);
  VideoStream stream =
      start_video({{32, 24}, 24}, reel.scratch.path / "fed.mp4", Sound{write_click(reel.scratch), 0.25}, 24);
  for (int i = 0; i < 24; ++i) append_frame(stream, read_pixels(reel.pictures[0]));
  finish_video(stream);
  EXPECT_NEAR(find_click_s(reel.scratch.path, "fed.mp4"), 0.75, 0.004);
}

// Three pictures, red in their left half and transparent in the right one.
std::vector<std::filesystem::path> write_clear(const Scratch& scratch) {
  std::vector<std::filesystem::path> pictures;
  for (int i = 0; i < 3; ++i) {
    Pixels picture = make_pixels({32, 24});
    picture.alpha.assign(picture.rgb.size() / 3, 255);
    for (std::size_t k = 0; k < picture.alpha.size(); ++k) {
      picture.rgb[3 * k] = static_cast<std::uint8_t>(200 + i);
      if (k % 32 >= 16) picture.alpha[k] = 0;
    }
    pictures.push_back(scratch.path / fmt::format("clear{}.png", i));
    write_file(pictures.back(), build_png(picture));
  }
  return pictures;
}

// The alpha of the first frame in the middle of each half, or its red in an .mp4.
std::pair<int, int> read_halves(const std::filesystem::path& folder, const std::string& name) {
  std::vector<std::string> words{"ffmpeg", "-v", "error"};
  if (name.ends_with(".webm")) words.insert(words.end(), {"-c:v", "libvpx-vp9"});
  words.insert(words.end(), {"-i", name, "-frames:v", "1", "-pix_fmt", "rgba", "-f", "rawvideo", "-"});
  const std::string rgba = run_process(words, folder).output;
  if (rgba.size() < std::size_t{4} * 32 * 24) return {-1, -1};
  const auto at = [&](int x) {
    return static_cast<int>(static_cast<unsigned char>(
        rgba[4 * (12 * 32 + static_cast<std::size_t>(x)) + (name.ends_with(".mp4") ? 1 : 3)]));
  };
  return {at(8), at(24)};
}

TEST(video, is_transparent_where_its_kind_can_be) {
  const Scratch scratch;
  const auto pictures = write_clear(scratch);
  for (const std::string& ending : list_video_endings()) {
    const std::string name = "clear" + ending;
    write_video(pictures, 24, scratch.path / name);
    const VideoForm form{{32, 24}, 24, true};
    EXPECT_EQ(find_video_fault(scratch.path, name, form, 3), "") << name;
    if (ending == ".webp") continue;  // ffmpeg cannot read its own; its flag is judged above
    const auto [left, right] = read_halves(scratch.path, name);
    if (ending == ".mp4") {
      EXPECT_LT(left, 20) << "red, without green";
      EXPECT_GT(right, 245) << "white";
    } else {
      EXPECT_GT(left, 250) << name;
      EXPECT_LT(right, 5) << name;
    }
  }
  const Reel opaque(3);
  for (const char* name : {"o.webm", "o.mov", "o.apng"}) {
    write_video(opaque.pictures, 24, scratch.path / name);
    EXPECT_EQ(find_video_fault(scratch.path, name, {{32, 24}, 24, true}, 3),
              "ffmpeg made a clip without transparency")
        << name;
  }
}

TEST(video, says_how_often_it_is_to_be_seen_where_it_can) {
  const Reel reel(3);
  const auto find_bytes = [&](const std::string& ending, int plays) {
    write_video(reel.pictures, 24, reel.scratch.path / ("plays" + ending), {}, plays);
    return read_file(reel.scratch.path / ("plays" + ending));
  };
  // The Netscape block counts how often a GIF begins again; the chunks ANIM and acTL how often it plays.
  const auto gif = [&](int plays) {
    const std::string bytes = find_bytes(".gif", plays);
    const std::size_t at = bytes.find("NETSCAPE2.0");
    return at == bytes.npos ? -1 : static_cast<int>(static_cast<unsigned char>(bytes[at + 13]));
  };
  EXPECT_EQ(gif(0), 0) << "for ever";
  EXPECT_EQ(gif(1), -1) << "once";
  EXPECT_EQ(gif(3), 2);
  const auto at_chunk = [&](const std::string& ending, const char* chunk, std::size_t offset, int plays) {
    const std::string bytes = find_bytes(ending, plays);
    return static_cast<int>(static_cast<unsigned char>(bytes[bytes.find(chunk) + offset]));
  };
  for (const int plays : {0, 1, 3}) {
    EXPECT_EQ(at_chunk(".webp", "ANIM", 12, plays), plays);
    EXPECT_EQ(at_chunk(".apng", "acTL", 11, plays), plays);
  }
}

TEST(video, is_heard_anew_in_each_round) {
  const Reel reel(1);
  const std::vector<std::filesystem::path> rounds(72, reel.pictures[0]);  // two of a second and a half
  Sound sound{write_click(reel.scratch), 0.25};
  sound.rounds = 2;
  sound.round_s = 1.5;
  sound.heard_s = 1;
  write_video(rounds, 24, reel.scratch.path / "rounds.mov", sound);
  const auto find_after_s = [&](const char* from_s) {
    run_process({"ffmpeg", "-v", "error", "-y", "-ss", from_s, "-i", "rounds.mov", "-vn", "cut.wav"},
                reel.scratch.path);
    return find_click_s(reel.scratch.path, "cut.wav");
  };
  EXPECT_NEAR(find_after_s("0"), 0.75, 0.004);
  EXPECT_NEAR(find_after_s("1"), 1.25, 0.004) << "at 2.25 s";
  sound.heard_s = 0.5;  // before the click
  write_video(rounds, 24, reel.scratch.path / "rounds.mov", sound);
  EXPECT_EQ(find_after_s("0"), -1);
}

}  // namespace
}  // namespace mien

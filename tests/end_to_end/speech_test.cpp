// Lines that are said: seen, heard at their time, and told in words where they cannot be.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>

#include "end_to_end/program.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr int kRate = 48000;

std::string build_said(const std::string& line) {
  return "mien: 1\nrender: {size: 48x60, quality: draft}\nclip:\n  fps: 24\n  say:\n    - " + line + "\n";
}

// When a film is first heard and how long it is, s.
std::pair<double, double> hear(const fs::path& folder, const std::string& film) {
  const ProgramRun run =
      run_shell(folder, fmt::format("ffmpeg -v error -y -i {} -ac 1 -ar {} -f s16le heard.raw", film, kRate));
  EXPECT_EQ(run.status, 0) << run.err;
  const std::string bytes = read_file(folder / "heard.raw");
  const std::size_t count = bytes.size() / 2;
  std::size_t first = count;
  for (std::size_t i = 0; i < count && first == count; ++i) {
    std::int16_t sample = 0;
    std::memcpy(&sample, bytes.data() + 2 * i, 2);
    if (std::abs(sample) > 1000) first = i;
  }
  return {static_cast<double>(first) / kRate, static_cast<double>(count) / kRate};
}

TEST(speech, is_heard_at_its_time) {
  const auto folder = make_folder("speech_heard");
  write_file(folder / "said.yaml", build_said("{at: 1s, text: \"Pa pa.\"}"));
  ASSERT_EQ(run_shell(folder, "mien render said.yaml --quality sketch --quiet").status, 0);
  const auto [first_s, length_s] = hear(folder, "out/said/said_sketch.mp4");
  EXPECT_NEAR(first_s, 1.04, 0.05) << "a p is silent at first";
  EXPECT_GT(length_s, 1.5);
  EXPECT_EQ(list_files(folder / "out/said").size(), 2u) << "the film and its manifest; no sound is left";
  ASSERT_EQ(run_shell(folder, "mien render said.yaml --quality sketch --quiet --frames 13-40 -o cut").status,
            0);
  EXPECT_NEAR(hear(folder, "cut/said_sketch_13-40.mp4").first, first_s - 0.5, 0.03);
}

TEST(speech, follows_the_mouths_of_another_program) {
  const auto folder = make_folder("speech_mouths");
  write_file(folder / "line.tsv", "0.00\tX\n0.10\tD\n0.40\tA\n0.50\tF\n0.70\tX\n");
  write_file(folder / "said.yaml", build_said("{at: 0.5s, mouths: line.tsv}"));
  const ProgramRun run = run_shell(folder, "mien sheet exposure said.yaml -o said.csv");
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string csv = read_file(folder / "said.csv");
  EXPECT_THAT(csv, testing::StartsWith("frame,time_s,drawing,held,key,changed,sound\n"));
  EXPECT_THAT(csv, HasSubstr("\n15,0.583333,")) << csv;
  write_file(folder / "line.tsv", "0.00\tX\n0.10\tQ\n0.70\tX\n");
  const ProgramRun wrong = run_shell(folder, "mien check said.yaml");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.err, HasSubstr("line.tsv:2:6: error: ")) << wrong.err;
}

TEST(speech, is_written_as_cues_that_say_the_same) {
  const auto folder = make_folder("speech_import");
  write_file(folder / "line.tsv", "0.00\tX\n0.10\tD\n0.40\tA\n0.50\tF\n0.70\tX\n1.20\tB\n1.40\tX\n");
  ASSERT_EQ(run_shell(folder, "mien import line.tsv -o said.yaml").status, 0);
  const std::string text = read_file(folder / "said.yaml");
  EXPECT_THAT(text, HasSubstr("\n        - {at: 0.25s, express: AA}\n"));
  EXPECT_THAT(text, HasSubstr("\n        - {at: 0.45s, express: PP}\n"));
  const ProgramRun check = run_shell(folder, "mien check said.yaml");
  EXPECT_EQ(check.status, 0) << check.err;
  const ProgramRun face = run_shell(folder, "mien explain said.yaml --at 0.45s --area lips");
  EXPECT_THAT(face.out, HasSubstr("0.55")) << face.out << ": pressed, as at a p";
  const ProgramRun again = run_shell(folder, "mien import line.tsv -o said.yaml");
  EXPECT_EQ(again.status, 2);
  EXPECT_EQ(again.err, "error: said.yaml exists; expected the name of a new file\n");
  write_file(folder / "words.vtt", "WEBVTT\n\n00:00:01.000 --> 00:00:02.000\nHello you\n");
  const ProgramRun words = run_shell(folder, "mien import words.vtt");
  EXPECT_EQ(words.status, 2);
  EXPECT_THAT(words.err, HasSubstr("words.vtt has words and no mouths; expected phonemes or shapes"));
}

TEST(speech, tells_voices_and_programs_that_are_not_there) {
  const auto folder = make_folder("speech_wrong");
  write_file(folder / "said.yaml", build_said("{text: Hello, voice: klingonese}"));
  const ProgramRun voice = run_shell(folder, "mien render said.yaml");
  EXPECT_EQ(voice.status, 2);
  EXPECT_THAT(
      voice.err,
      HasSubstr("said.yaml:6:28: error: unknown voice 'klingonese'; expected one of: mien-speak --voices\n"));
  EXPECT_FALSE(fs::exists(folder / "out"));
  write_file(folder / "said.yaml", build_said("{text: Hello}"));
  fs::copy_file(program_path(), folder / "alone");
  const ProgramRun alone = run_shell(folder, "PATH=/usr/bin:/bin ./alone check said.yaml");
  EXPECT_EQ(alone.status, 2);
  EXPECT_THAT(alone.err,
              HasSubstr("said.yaml:6:14: error: there is no mien-speak to say it; it is built where "
                        "libespeak-ng-dev is installed: ./run setup, then ./run build\n"));
}

TEST(speech, tells_tools_and_rooms_that_are_not_there_as_such) {
  const auto folder = make_folder("speech_tools");
  write_file(folder / "line.wav", "no sound");
  write_file(folder / "said.yaml", build_said("{text: Hello, sound: line.wav}"));
  const std::string program = program_path();
  const ProgramRun none = run_shell(folder, "PATH=/nowhere '" + program + "' check said.yaml");
  EXPECT_EQ(none.status, 1);
  EXPECT_EQ(none.err, "error: ffprobe is not installed; install it with: apt-get install ffmpeg\n");
  const ProgramRun wrong = run_shell(folder, "mien check said.yaml");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.err, HasSubstr("said.yaml:6:28: error: 'line.wav' has no sound that ffmpeg can read"));
  const ProgramRun full = run_shell(folder, "TMPDIR=/dev/null/none mien check said.yaml");
  EXPECT_EQ(full.status, 1) << full.err;
  EXPECT_EQ(full.err.find("said.yaml:"), std::string::npos) << full.err << ": the file is right";
}

TEST(speech, shows_words_beside_the_chart_and_lines_that_meet) {
  const auto folder = make_folder("speech_check");
  write_file(folder / "said.yaml", build_said("{text: We go home}\n    - {at: 0.2s, text: Now}"));
  const ProgramRun run = run_shell(folder, "mien check said.yaml");
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.out, HasSubstr("\nwords        We"));
  EXPECT_THAT(run.out, HasSubstr("said.yaml:7:7: warning: this line begins at 0.2"));
}

}  // namespace
}  // namespace mien

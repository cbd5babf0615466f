// A clip's sound, from the file to the film.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "end_to_end/program.hpp"

namespace mien {
namespace {

TEST(sound, that_is_none_is_told_before_anything_is_drawn) {
  const auto folder = make_folder("no_sound");
  write_file(folder / "clip.yaml", "mien: 1\nclip:\n  length: 1s\n  sound: voice.wav\n");
  write_file(folder / "voice.wav", "no sound");
  for (const char* options : {"", "--quality sketch"}) {
    const ProgramRun run = run_shell(folder, fmt::format("mien render clip.yaml {}", options));
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.err,
              "clip.yaml:4:10: error: 'voice.wav' has no sound that ffmpeg can read; expected a file such as "
              "voice.wav\n");
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  }
}

}  // namespace
}  // namespace mien

// Lines understood: words found in a recording, mouths of other programs placed in time.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "config/config_fixture.hpp"
#include "core/text.hpp"
#include "places.hpp"
#include "shipped.hpp"
#include "voice/line.hpp"
#include "voice/recording.hpp"
#include "voice/speaker.hpp"

namespace mien {
namespace {

const SpeechData& speech() { return *shipped().stock.language->speech; }

TEST(line, finds_the_words_of_a_recording) {
  const std::string text = "Good morning. This is the second part.";
  const SpokenText slow = speak_text(text, "en-us", 0.7);
  const auto folder = make_test_folder();
  // With half a second of silence before it.
  std::string wav = *slow.wav;
  const std::string silence(static_cast<std::size_t>(22050) & ~std::size_t{1}, '\0');
  wav.insert(44, silence);
  for (const auto& [at, value] :
       {std::pair{std::size_t{4}, wav.size() - 8}, std::pair{std::size_t{40}, wav.size() - 44}})
    for (std::size_t i = 0; i < 4; ++i) wav[at + i] = static_cast<char>(value >> (8 * i));
  write_file(folder / "line.wav", wav);
  SaySpec line;
  line.at_s = 1;
  line.text = text;
  line.sound = FileReference{folder / "line.wav", {}};
  const SpokenLine found = understand_line(line, speech(), 24);
  ASSERT_EQ(found.words.size(), slow.words.size());
  for (std::size_t i = 0; i < found.words.size(); ++i)
    EXPECT_NEAR(found.words[i].from_s, 1 + 0.5 + slow.words[i].at_s, 0.12) << found.words[i].text;
  ASSERT_EQ(found.sounds.size(), 1u);
  EXPECT_EQ(found.sounds[0].at_s, 1);
}

TEST(line, warps_phrase_by_phrase) {
  const std::vector<VoicedSpan> said{{0, 1}, {2, 3}}, heard{{1, 3}, {10, 10.5}};
  EXPECT_DOUBLE_EQ(warp_time_s(0, said, heard), 1);
  EXPECT_DOUBLE_EQ(warp_time_s(0.5, said, heard), 2);
  EXPECT_DOUBLE_EQ(warp_time_s(1, said, heard), 3);
  EXPECT_DOUBLE_EQ(warp_time_s(1.5, said, heard), 6.5) << "in the pause";
  EXPECT_DOUBLE_EQ(warp_time_s(2.5, said, heard), 10.25);
  EXPECT_DOUBLE_EQ(warp_time_s(9, said, heard), 10.5);
  EXPECT_DOUBLE_EQ(warp_time_s(1.5, said, {{0, 6}}), 3) << "other pauses: all of it together";
}

TEST(line, places_letters_and_words_of_other_programs) {
  const auto folder = make_test_folder();
  write_file(folder / "line.tsv", "0.00\tX\n0.50\tD\n0.80\tA\n0.90\tX\n1.00\tB\n1.20\tX\n");
  SaySpec line;
  line.at_s = 2;
  line.mouths = FileReference{folder / "line.tsv", {}};
  const SpokenLine letters = understand_line(line, speech(), 24);
  std::vector<std::string> names;
  for (const MouthSegment& segment : letters.segments) names.push_back(speech().visemes[segment.viseme].name);
  EXPECT_EQ(names, (std::vector<std::string>{"AA", "PP", "rest", "SS"}))
      << "a long rest is a pause, a short one a mouth";
  EXPECT_EQ(letters.phonemes.size(), 4u) << "and so is what charts and warnings have of it";
  EXPECT_DOUBLE_EQ(letters.from_s, 2.5);
  EXPECT_DOUBLE_EQ(letters.to_s, 3.2);

  write_file(folder / "line.vtt",
             "WEBVTT\n\n00:00:01.000 --> 00:00:03.000\n<00:00:01.000>Bob <00:00:02.000>may\n");
  line.mouths = FileReference{folder / "line.vtt", {}};
  const SpokenLine words = understand_line(line, speech(), 24);
  ASSERT_EQ(words.words.size(), 2u);
  EXPECT_EQ(words.words[1].text, "may");
  EXPECT_DOUBLE_EQ(words.words[1].from_s, 4);
  EXPECT_EQ(speech().visemes[words.segments.front().viseme].name, "PP");
  EXPECT_DOUBLE_EQ(words.segments.front().from_s, 3);
  EXPECT_NEAR(words.segments.back().to_s, 5, 1e-9) << "a word fills its time";
}

}  // namespace
}  // namespace mien

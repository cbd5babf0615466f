#include "timeline/speech_advice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mien {
namespace {

using testing::ElementsAre;

const Place kLine{"said.yaml", 4, 7};

// Ten sounds of 50 ms, two words of five.
ClipSpec build_said() {
  ClipSpec clip;
  for (int i = 0; i < 10; ++i)
    clip.phonemes.push_back({0.05 * i, 0.05 * (i + 1), std::string(1, static_cast<char>('a' + i)), kLine});
  clip.words = {{0, 0.25, "abcde", kLine}, {0.25, 0.5, "fghij", kLine}};
  return clip;
}

std::vector<double> list_times(double step_s) {
  std::vector<double> times;
  for (int i = 0; i * step_s < 0.5; ++i) times.push_back(i * step_s + 0.001);
  return times;
}

std::vector<std::string> list_advice(const ClipSpec& clip, const std::vector<double>& times) {
  std::vector<std::string> messages;
  for (const Diagnostic& advice : advise_speech(clip, times)) messages.push_back(advice.message);
  return messages;
}

TEST(speech_advice, is_silent_where_drawings_show_enough) {
  EXPECT_THAT(advise_speech(build_said(), list_times(0.04)), testing::IsEmpty());
  EXPECT_THAT(advise_speech(build_said(), list_times(0.08)), testing::IsEmpty()) << "a third may go by";
}

TEST(speech_advice, tells_mouths_that_are_too_short_to_be_seen) {
  EXPECT_THAT(
      list_advice(build_said(), list_times(0.125)),
      ElementsAre(
          "mouths too short to be seen: no drawing shows 6 of its 10 sounds: b at 0.05s, d at 0.15s, e at "
          "0.2s, g at 0.3s, i at 0.4s ...; a slower 'pace' or 'draw: ones' shows more"));
}

TEST(speech_advice, tells_words_that_no_drawing_shows) {
  EXPECT_THAT(list_advice(build_said(), {0.3}),
              testing::Contains("no drawing shows 1 of its words: abcde; 'draw: ones' shows the most"));
}

TEST(speech_advice, tells_lines_that_meet) {
  ClipSpec clip = build_said();
  const Place other{"said.yaml", 5, 7};
  clip.phonemes.push_back({0.45, 0.6, "z", other});
  const std::vector<Diagnostic> advice = advise_speech(clip, list_times(0.04));
  ASSERT_EQ(advice.size(), 1u);
  EXPECT_EQ(advice[0].place.line, 5);
  EXPECT_EQ(
      advice[0].message,
      "this line begins at 0.45s, and the one before it is said until 0.5s; one mouth says one of them");
}

}  // namespace
}  // namespace mien

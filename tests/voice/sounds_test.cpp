// Sounds of speech become mouths: one by one, along the alphabet, and in every voice that can be asked.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "config/load_spec.hpp"
#include "core/text.hpp"
#include "end_to_end/program.hpp"
#include "shipped.hpp"
#include "voice/sentences.hpp"
#include "voice/sounds.hpp"
#include "voice/speaker.hpp"
#include "voice/text.hpp"

namespace mien {
namespace {

using testing::ElementsAre;

const SpeechData& speech() { return *shipped().stock.language->speech; }

std::vector<std::string> name_mouths(std::string_view ipa) {
  std::vector<std::string> names;
  for (const std::size_t viseme : find_ipa_visemes(speech(), ipa))
    names.push_back(speech().visemes[viseme].name);
  return names;
}

TEST(sounds, have_their_mouths) {
  EXPECT_THAT(name_mouths("p"), ElementsAre("PP"));
  EXPECT_THAT(name_mouths("aɪ"), ElementsAre("AA", "IH")) << "two letters, one name";
  EXPECT_THAT(name_mouths("tʃ"), ElementsAre("SH"));
  EXPECT_THAT(name_mouths("ɑː"), ElementsAre("AA")) << "a mark changes no mouth";
  EXPECT_THAT(name_mouths("ˈfiː"), ElementsAre("FF", "IY"));
  EXPECT_THAT(name_mouths("pf"), ElementsAre("PP", "FF"));
  EXPECT_THAT(name_mouths(""), ElementsAre());
  EXPECT_THAT(name_mouths("?#"), ElementsAre());
}

TEST(sounds, share_their_time) {
  const auto segments =
      list_segments(speech(), {{0, 0.1, "m", 0}, {0.1, 0.3, "aɪ", 1}, {0.3, 0.5, "", 0}, {0.5, 0.6, "s", 0}});
  ASSERT_EQ(segments.size(), 4u);
  EXPECT_NEAR(segments[1].to_s, 0.1 + 0.6 * 0.2, 1e-9) << "three fifths";
  EXPECT_EQ(segments[1].stress, 1);
  EXPECT_EQ(segments[2].to_s, 0.3);
  EXPECT_EQ(segments[3].from_s, 0.5) << "silence makes no mouth";
  for (std::size_t i = 0; i < segments.size(); ++i) EXPECT_LT(segments[i].from_s, segments[i].to_s) << i;
}

TEST(sounds, of_other_programs_have_mouths) {
  for (const char* letter : {"A", "B", "C", "D", "E", "F", "G", "H", "X"})
    EXPECT_EQ(speech().rhubarb.count(letter), 1u) << letter;
  EXPECT_EQ(speech().preston_blair.size(), 10u);
  EXPECT_GE(speech().arpabet.size(), 39u) << "those of the CMU dictionary";
}

TEST(said_text, tells_stress_and_questions) {
  const SaidText said = read_said_text("Is it *you*? Schön, *sehr schön*.");
  EXPECT_EQ(said.plain, "Is it you? Schön, sehr schön.");
  ASSERT_EQ(said.stressed.size(), 2u);
  EXPECT_EQ(take_letters(said.plain, said.stressed[0]), "you");
  EXPECT_EQ(take_letters(said.plain, said.stressed[1]), "sehr schön") << "letters, not bytes";
  ASSERT_EQ(said.questions.size(), 1u);
  EXPECT_EQ(take_letters(said.plain, said.questions[0]), "Is it you");
  EXPECT_EQ(read_said_text("a * b").plain, "a * b") << "a lonely star is a star";
}

TEST(speaker, tells_sounds_words_and_bytes) {
  const SpokenText spoken = speak_text("Bob may pump.", "en-us", 1);
  std::string all;
  double last_s = 0;
  for (const SpeechSound& sound : spoken.sounds) {
    all += sound.ipa;
    EXPECT_GE(sound.from_s, last_s);
    EXPECT_GE(sound.to_s, sound.from_s);
    last_s = sound.from_s;
  }
  EXPECT_EQ(all, "bɑːbmeɪpʌmp");
  ASSERT_EQ(spoken.words.size(), 3u);
  EXPECT_EQ(spoken.words[1].from, 4);
  EXPECT_EQ(spoken.words[1].length, 3);
  ASSERT_TRUE(spoken.wav);
  EXPECT_EQ(spoken.wav->substr(0, 4), "RIFF");
  EXPECT_NEAR(static_cast<double>(spoken.wav->size() - 44) / 2 / 22050, spoken.length_s, 1e-9);
  EXPECT_GT(speak_text("Bob may pump.", "en-us", 0.7).length_s, 1.2 * spoken.length_s) << "slower";
}

// Without stress, pauses and the marks of words.
std::string take_bare_ipa(std::string ipa) {
  for (const char* mark : {"ˈ", "ˌ", " ", "\n", "_", "(en)", "(fr)", "(de)", "-"})
    for (std::size_t at = ipa.find(mark); at != std::string::npos; at = ipa.find(mark))
      ipa.erase(at, std::string(mark).size());
  return ipa;
}

// When the last that is heard of a WAV ends, s: the program adds a pause.
double find_end_s(const std::string& wav) {
  constexpr std::size_t kHeader = 44;
  constexpr int kHeard = 300;
  std::size_t last = 0;
  for (std::size_t at = kHeader; at + 1 < wav.size(); at += 2) {
    std::int16_t sample = 0;
    std::memcpy(&sample, wav.data() + at, 2);
    if (std::abs(sample) > kHeard) last = at;
  }
  return static_cast<double>(last - kHeader) / 2 / 22050;
}

TEST(speaker, has_the_sounds_of_the_program_itself) {
  if (std::system("espeak-ng --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no espeak-ng on the PATH";
  const auto folder = make_folder("speaker_itself");
  for (const Sentence& sentence : kSentences) {
    const SpokenText spoken = speak_text(sentence.text, sentence.voice, 1);
    std::string all;
    for (const SpeechSound& sound : spoken.sounds) all += sound.ipa;
    write_file(folder / "said.txt", sentence.text);
    const std::string program =
        fmt::format("espeak-ng -s 165 -v {} --ipa -w whole.wav -f said.txt >ipa.txt", sentence.voice);
    ASSERT_EQ(run_shell(folder, program).status, 0);
    EXPECT_EQ(take_bare_ipa(all), take_bare_ipa(read_file(folder / "ipa.txt"))) << sentence.text;
    EXPECT_NEAR(find_end_s(*spoken.wav), find_end_s(read_file(folder / "whole.wav")), 0.01) << sentence.text;
  }
}

TEST(speaker, speaks_mouths_in_many_languages) {
  for (const auto& [voice, text] : std::vector<std::pair<std::string, std::string>>{
           {"de", "Zwölf Boxkämpfer jagen Viktor quer über den großen Sylter Deich."},
           {"fr-fr", "Portez ce vieux whisky au juge blond qui fume."},
           {"es", "El pingüino Wenceslao hizo kilómetros bajo exhaustiva lluvia."},
           {"pt", "Luís argüia à Júlia que brações, fé, chá, óxido, pôr, zângão eram palavras do português."},
           {"it", "Quel vituperabile xenofobo zelante assaggia il whisky."},
           {"pl", "Zażółć gęślą jaźń."},
           {"ru", "Съешь же ещё этих мягких французских булок."},
           {"en-gb", "The quick brown fox jumps over the lazy dog."}}) {
    const SpokenText spoken = speak_text(text, voice, 1);
    std::size_t sounds = 0, mouths = 0;
    for (const SpeechSound& sound : spoken.sounds) {
      if (sound.ipa.empty()) continue;
      ++sounds;
      mouths += find_ipa_visemes(speech(), sound.ipa).empty() ? 0 : 1;
      EXPECT_FALSE(find_ipa_visemes(speech(), sound.ipa).empty()) << voice << ": '" << sound.ipa << "'";
    }
    EXPECT_GT(sounds, 10u) << voice;
  }
}

}  // namespace
}  // namespace mien

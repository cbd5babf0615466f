// SPDX-License-Identifier: GPL-3.0-or-later
// Speaks a text with eSpeak NG and tells when it says what. A program of its own, as that library's licence
// asks: mien starts it as it starts POV-Ray, and does without it where it is not built.
//   mien-speak --voice en-us --pace 1 --wav OUT.wav TEXT      16 bit, mono; on stdout a JSON object
//   mien-speak --voices                                       the names of all voices, one a line
// {"rate": 22050, "samples": 51486, "phonemes": [{"at": 0.012, "to": 0.041, "ipa": "b", "stress": 0}, ...],
//  "words": [{"at": 0.0, "from": 0, "length": 3}, ...]}: times in seconds; an empty `ipa` is silence; a
//  word's place
// in TEXT is counted in letters.
#include <espeak-ng/speak_lib.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace {

constexpr int kUsage = 2;
constexpr double kWordsAMinute = 165;  // at pace 1

struct Phoneme {
  int at_ms = 0;
  std::string ipa;
  int stress = 0;  // 1: the word's first, 2: a second one
};

struct Word {
  int at_ms = 0;
  int from = 0, length = 0;  // letters
};

struct Speech {
  int rate = 0;
  std::vector<std::int16_t> samples;
  std::vector<Phoneme> phonemes;
  std::vector<Word> words;
};

// eSpeak NG hands sound and events to one function; what they go into, it tells each event again.
int take_sound(short* wave, int count, espeak_EVENT* events) {
  for (; events->type != espeakEVENT_LIST_TERMINATED; ++events) {
    auto& speech = *static_cast<Speech*>(events->user_data);
    if (events->type == espeakEVENT_PHONEME) {
      const std::size_t size = strnlen(events->id.string, sizeof events->id.string);
      speech.phonemes.push_back({events->audio_position, {events->id.string, size}, 0});
    }
    if (events->type == espeakEVENT_WORD)
      speech.words.push_back({events->audio_position, events->text_position - 1, events->length});
  }
  if (wave != nullptr && count > 0) {
    auto& speech = *static_cast<Speech*>(events->user_data);
    speech.samples.insert(speech.samples.end(), wave, wave + count);
  }
  return 0;
}

// The text in IPA, with the marks of stress that the events leave out.
std::string read_transcription(const std::string& text) {
  constexpr int kIpa = 2;
  std::string all;
  const void* rest = text.c_str();
  while (rest != nullptr)
    if (const char* clause = espeak_TextToPhonemes(&rest, espeakCHARS_UTF8, kIpa)) all += clause;
  return all;
}

// Sets the stress of each phoneme that the transcription has in the same order; of the others nothing is
// known.
void find_stress(const std::string& transcription, std::vector<Phoneme>& phonemes) {
  constexpr std::string_view kFirst = "ˈ", kSecond = "ˌ";
  constexpr std::size_t kFar = 24;  // bytes; further on it is another phoneme of that name
  std::size_t at = 0;
  for (Phoneme& phoneme : phonemes) {
    if (phoneme.ipa.empty()) continue;
    const std::size_t found = transcription.find(phoneme.ipa, at);
    if (found == std::string::npos || found > at + kFar) continue;
    const std::string_view before = std::string_view(transcription).substr(0, found);
    phoneme.stress = before.ends_with(kFirst) ? 1 : before.ends_with(kSecond) ? 2 : 0;
    at = found + phoneme.ipa.size();
  }
}

// The voice of a language, "en-gb", which eSpeak NG's own names leave out for some; "+f3" behind it is a
// variant.
std::string find_voice(const std::string& asked) {
  const std::size_t plus = asked.find('+');
  const std::string language = asked.substr(0, plus);
  const std::string variant = plus == std::string::npos ? "" : asked.substr(plus);
  for (const espeak_VOICE** voice = espeak_ListVoices(nullptr); voice != nullptr && *voice != nullptr;
       ++voice)
    // Languages are a list: a byte of priority, a name that ends with 0, and so on to one without priority.
    for (const char* each = (*voice)->languages; *each != 0; each += std::strlen(each + 1) + 2)
      if (language == each + 1) return (*voice)->identifier + variant;
  return asked;
}

Speech speak(const std::string& text, const std::string& voice, double pace) {
  Speech speech;
  speech.rate = espeak_Initialize(
      AUDIO_OUTPUT_SYNCHRONOUS, 0, nullptr,
      espeakINITIALIZE_PHONEME_EVENTS | espeakINITIALIZE_PHONEME_IPA | espeakINITIALIZE_DONT_EXIT);
  if (speech.rate <= 0) throw std::runtime_error("eSpeak NG cannot be set up; is espeak-ng-data installed?");
  espeak_SetSynthCallback(take_sound);
  if (espeak_SetVoiceByName(find_voice(voice).c_str()) != EE_OK &&
      espeak_SetVoiceByName(voice.c_str()) != EE_OK)
    throw std::invalid_argument("unknown voice '" + voice + "'");
  espeak_SetParameter(espeakRATE, static_cast<int>(kWordsAMinute * pace + 0.5), 0);
  if (espeak_Synth(text.c_str(), text.size() + 1, 0, POS_CHARACTER, 0, espeakCHARS_UTF8, nullptr, &speech) !=
          EE_OK ||
      espeak_Synchronize() != EE_OK)
    throw std::runtime_error("eSpeak NG does not speak");
  find_stress(read_transcription(text), speech.phonemes);
  return speech;
}

template <typename T>
void write_number(std::ofstream& out, T value) {
  for (std::size_t i = 0; i < sizeof value; ++i) out.put(static_cast<char>(value >> (8 * i)));
}

void write_wav(const std::string& path, const Speech& speech) {
  std::ofstream out(path, std::ios::binary);
  const auto bytes = static_cast<std::uint32_t>(2 * speech.samples.size());
  const auto rate = static_cast<std::uint32_t>(speech.rate);
  out << "RIFF";
  write_number<std::uint32_t>(out, 36 + bytes);
  out << "WAVEfmt ";
  write_number<std::uint32_t>(out, 16);
  write_number<std::uint16_t>(out, 1);  // plain samples
  write_number<std::uint16_t>(out, 1);  // one channel
  write_number<std::uint32_t>(out, rate);
  write_number<std::uint32_t>(out, 2 * rate);
  write_number<std::uint16_t>(out, 2);
  write_number<std::uint16_t>(out, 16);
  out << "data";
  write_number<std::uint32_t>(out, bytes);
  for (const std::int16_t sample : speech.samples)
    write_number<std::uint16_t>(out, static_cast<std::uint16_t>(sample));
  if (!out.flush()) throw std::runtime_error("cannot write " + path);
}

nlohmann::ordered_json describe(const Speech& speech) {
  nlohmann::ordered_json told{{"rate", speech.rate}, {"samples", speech.samples.size()}};
  told["phonemes"] = nlohmann::ordered_json::array();
  const double end_s = static_cast<double>(speech.samples.size()) / speech.rate;
  for (std::size_t i = 0; i < speech.phonemes.size(); ++i) {
    const Phoneme& phoneme = speech.phonemes[i];
    const double to_s = i + 1 < speech.phonemes.size() ? speech.phonemes[i + 1].at_ms / 1000.0 : end_s;
    told["phonemes"].push_back(
        {{"at", phoneme.at_ms / 1000.0}, {"to", to_s}, {"ipa", phoneme.ipa}, {"stress", phoneme.stress}});
  }
  told["words"] = nlohmann::ordered_json::array();
  for (const Word& word : speech.words)
    told["words"].push_back({{"at", word.at_ms / 1000.0}, {"from", word.from}, {"length", word.length}});
  return told;
}

void print_voices() {
  espeak_Initialize(AUDIO_OUTPUT_SYNCHRONOUS, 0, nullptr, espeakINITIALIZE_DONT_EXIT);
  std::vector<std::string> names;
  for (const espeak_VOICE** voice = espeak_ListVoices(nullptr); voice != nullptr && *voice != nullptr;
       ++voice)
    names.emplace_back((*voice)->languages + 1);  // behind a byte of priority
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  for (const std::string& name : names) std::cout << name << '\n';
}

struct Asked {
  std::string voice = "en-us", wav, text;
  double pace = 1;
  bool has_text = false;
};

Asked read_words(const std::vector<std::string>& words) {
  Asked asked;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool has_value = i + 1 < words.size();
    if (words[i] == "--voice" && has_value)
      asked.voice = words[++i];
    else if (words[i] == "--pace" && has_value)
      asked.pace = std::stod(words[++i]);
    else if (words[i] == "--wav" && has_value)
      asked.wav = words[++i];
    else
      asked.text = words[i], asked.has_text = true;
  }
  return asked;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words == std::vector<std::string>{"--voices"}) {
      print_voices();
      return 0;
    }
    const Asked asked = read_words(words);
    if (!asked.has_text) {
      std::cerr << "Usage: mien-speak [--voice NAME] [--pace NUMBER] [--wav FILE] TEXT | --voices\n";
      return kUsage;
    }
    const Speech speech = speak(asked.text, asked.voice, asked.pace);
    if (!asked.wav.empty()) write_wav(asked.wav, speech);
    std::cout << describe(speech).dump() << '\n';
    return 0;
  } catch (const std::invalid_argument& e) {
    std::cerr << "error: " << e.what() << '\n';
    return kUsage;
  } catch (const std::exception& e) {
    std::cerr << "error: " << e.what() << '\n';
    return 1;
  }
}

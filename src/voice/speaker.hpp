// Texts that are spoken: by mien-speak, a program beside this one that knows eSpeak NG.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "voice/sounds.hpp"

namespace mien {

// A word's place in its text is counted in letters.
struct SpokenPlace {
  double at_s = 0;
  int from = 0, length = 0;
};

struct SpokenText {
  double length_s = 0;
  std::vector<SpeechSound> sounds;  // one after the other, silences too
  std::vector<SpokenPlace> words;
  std::shared_ptr<const std::string> wav;  // 16 bit, mono
};

// Whether there is a mien-speak, beside this program or on the PATH.
bool has_speaker();

// Speaks a text, or remembers what it spoke; there must be a speaker. Throws RunError with mien-speak's words
// ("unknown voice 'xx'"), and where its sound cannot be written.
SpokenText speak_text(const std::string& text, const std::string& voice, double pace);

}  // namespace mien

// One line of `say`, understood: what is heard, what the mouth does and what goes with it, in the clip's
// time.
#pragma once

#include <string>
#include <vector>

#include "config/clip_spec.hpp"
#include "config/speech_data.hpp"
#include "voice/sounds.hpp"

namespace mien {

// A word of a line.
struct LineWord {
  double from_s = 0, to_s = 0;
  std::string text;
  bool is_stressed = false, asks = false;  // asks: a question ends with it
};

struct SpokenLine {
  double from_s = 0, to_s = 0;
  std::vector<MouthSegment> segments;  // without those of pauses
  std::vector<LineWord> words;
  std::vector<SpokenWord> phonemes;
  std::vector<SpokenSound> sounds;  // none or one
};

// Throws InputError with the mistake at its place in the file: an unknown voice, no mien-speak, a broken file
// of mouths, a sound that ffmpeg cannot read.
SpokenLine understand_line(const SaySpec& line, const SpeechData& data, int fps);

}  // namespace mien

// From the sounds of a language to the mouths that they make.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/speech_data.hpp"

namespace mien {

// A sound of speech, or silence.
struct SpeechSound {
  double from_s = 0, to_s = 0;
  std::string ipa;  // empty: silence
  int stress = 0;   // 1: the word's first, 2: a second one
};

// A mouth for a while.
struct MouthSegment {
  double from_s = 0, to_s = 0;
  std::size_t viseme = 0;
  int stress = 0;
};

// The mouths of a sound in the phonetic alphabet, "aɪ", "tʃ", "ɑː": the longest names first; marks and
// letters that are not known make none.
VisemeIndices find_ipa_visemes(const SpeechData& data, std::string_view ipa);

// The first of two mouths has three fifths of the time.
void append_segments(const VisemeIndices& visemes, double from_s, double to_s, int stress,
                     std::vector<MouthSegment>& into);

// In the sounds' order; silence makes none.
std::vector<MouthSegment> list_segments(const SpeechData& data, const std::vector<SpeechSound>& sounds);

}  // namespace mien

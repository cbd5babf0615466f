// What a mouth does when, as other programs write it: Rhubarb Lip Sync, Moho and Papagayo, the Montreal
// Forced Aligner and Praat, captions with words, and tables of phonemes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace mien {

// More is no speech of one mouth but another kind of file: three a second for nine hours.
inline constexpr std::size_t kMaxMouthCues = 100'000;
inline constexpr double kMaxMouthTime_s = 24 * 3600;
// A TextGrid has some 100 bytes a cue, and phonemes and words.
inline constexpr std::uintmax_t kMaxMouthBytes = 32 << 20;

// What the names of a track are of.
//   rhubarb        A to H and X, the shapes of Rhubarb Lip Sync
//   preston_blair  AI E O U etc L WQ MBP FV rest
//   ipa            a phoneme in IPA, as it stands in the file: "tʃ", "aɪ", "iː"
//   arpabet        a phoneme of CMUdict, a vowel with its stress if the file has it: "HH", "AH0"
//   words          a word of the language that is spoken, without punctuation around it
enum class MouthNames { rhubarb, preston_blair, ipa, arpabet, words };

// Something a mouth does for a while: a shape's letter, a phoneme or a word.
struct MouthCue {
  double from_s = 0, to_s = 0;  // 0 <= from_s < to_s
  std::string name;
  int line = 0;  // of the file, from 1
};

// Where no cue is, between them too, the mouth rests.
struct MouthTrack {
  MouthNames names = MouthNames::rhubarb;
  std::vector<MouthCue> cues;   // one at least; by time, none overlaps the one before it
  std::vector<MouthCue> words;  // where the file has words beside phonemes; by time, too
  double end_s = 0;             // of the recording, as far as the file tells; of the last cue at least
};

// Reads FILE by its ending, and one that ends in .txt by its content:
//   .tsv .xml .json  Rhubarb Lip Sync
//   .dat             switch data of Moho, as Rhubarb, Papagayo and others write it, from frame 1 on; the last
//                    line's mouth stays for a frame
//   .pgo             Papagayo, with one voice
//   .TextGrid        Praat and the Montreal Forced Aligner, long or short, with a tier 'phones', 'words' or
//                    both; silences (sil, sp, spn) are no cues
//   .vtt             WebVTT; words of a cue without times of their own share its time evenly
//   .csv             from,to,phoneme or time,phoneme: seconds and IPA; no phoneme is a pause
// UTF-8, or UTF-16 with a byte order mark. Of two cues that overlap by less than a millisecond the later one
// is cut. `fps` is the rate of the frames that some files count in, for those that do not say it themselves
// (0: the file must say it itself). Throws InputError "FILE:LINE:COL: error: what was found; what was
// expected".
MouthTrack load_mouth_track(const std::filesystem::path& file, double fps);

}  // namespace mien

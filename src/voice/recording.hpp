// A recording and the words in it: which of its moments are which words'.
#pragma once

#include <filesystem>
#include <vector>

#include "voice/sounds.hpp"

namespace mien {

struct VoicedSpan {
  double from_s = 0, to_s = 0;
};

// Where somebody speaks: what is louder than a twentieth of the loudest moments, with pauses of a fifth of a
// second at least between. Throws RunError with ffmpeg's words.
std::vector<VoicedSpan> find_voiced(const std::filesystem::path& sound);

// The same for sounds that were spoken to a text: pauses of as much.
std::vector<VoicedSpan> find_voiced(const std::vector<SpeechSound>& sounds);

// A moment of the one on the other: span by span if they have as many pauses, else all together as if they
// had none.
double warp_time_s(double time_s, const std::vector<VoicedSpan>& from, const std::vector<VoicedSpan>& to);

}  // namespace mien

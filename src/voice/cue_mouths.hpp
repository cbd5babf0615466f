// The mouths of a track that another program wrote.
#pragma once

#include <vector>

#include "import/mouth_track.hpp"
#include "voice/sounds.hpp"

namespace mien {

// Those of one cue, and its stress where its name tells it ("AH0": none; what is not told is left as it is).
VisemeIndices find_cue_visemes(const SpeechData& data, MouthNames names, std::string name, int& stress);

// Whether a cue is a mouth that rests for so long that it is a pause.
bool is_pause(const SpeechData& data, const VisemeIndices& visemes, const MouthCue& cue);

// Of all cues that name mouths, pauses left out; words alone have none.
std::vector<MouthSegment> list_track_segments(const MouthTrack& track, const SpeechData& data);

}  // namespace mien

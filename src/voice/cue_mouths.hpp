// The mouths of a track that another program wrote.
#pragma once

#include <vector>

#include "import/mouth_track.hpp"
#include "voice/sounds.hpp"

namespace mien {

// A cue that is no pause: its mouths, and its stress where its name tells it ("AH0": none; what is not told
// is left as it is).
struct CueMouths {
  MouthCue cue;
  VisemeIndices visemes;
  int stress = 2;
};

// A mouth that rests for a quarter of a second is a pause. Words alone have no mouths.
std::vector<CueMouths> list_cue_mouths(const MouthTrack& track, const SpeechData& data);

// The same as one way of the mouth.
std::vector<MouthSegment> list_track_segments(const MouthTrack& track, const SpeechData& data);

}  // namespace mien

// The tracks of a clip or of a script with their cues, made ready to be sampled.
#pragma once

#include "timeline/cues.hpp"

namespace mien {

struct Layers {
  KeyTrack pose, turn, camera;
  KeyTrack reach;  // of the pose's keys: of those areas that are the first or the last to move
  double most_reach = 1;
  CueStack cues;
  Ticks length = 0;
};

Layers build_layers(const ClipSpec& clip);
KeyTrack build_table(const TimeTable& table);

// The face with all cues upon it, not yet held within its limits; the head's turn is the track's and the
// cues'.
FaceState sample_layers(const Layers& layers, Ticks time);

// The same, of which only some moves are asked for: the others and the head's turn mean nothing.
FaceState sample_layers(const Layers& layers, Ticks time, const Moves& only);

// The same without any cue upon it.
FaceState sample_keys(const Layers& layers, Ticks time, const Moves& only);

}  // namespace mien

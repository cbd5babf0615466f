// The tracks of a clip or of a script with their cues, made ready to be sampled.
#pragma once

#include <map>

#include "timeline/cues.hpp"

namespace mien {

// What several cues play, each made ready once: a script of ten cues that play a script of ten cues is two
// scripts and not eleven.
struct LayerStore {
  std::map<const ClipSpec*, std::shared_ptr<const Layers>> scripts;
  std::map<const TimeTable*, std::shared_ptr<const KeyTrack>> tables;
};

struct Layers {
  KeyTrack pose, turn, camera;
  KeyTrack place;  // x, y, z in mm and the turn in degrees; without keys the actor stays where it stands
  KeyTrack reach;  // of the pose's keys: of those areas that are the first or the last to move
  double most_reach = 1;
  Moves moves = kAreaMoves;  // what the clip may move: muscles and units as well, if it names any
  CueStack cues;
  std::vector<TrackLaw> laws;  // by time
  Ticks length = 0;
};

Layers build_layers(const ClipSpec& clip);
Layers build_layers(const ClipSpec& clip, LayerStore& store);

// The script or the table, from the store if it is there.
std::shared_ptr<const Layers> share_script(const std::shared_ptr<const ClipSpec>& script, LayerStore& store);
std::shared_ptr<const KeyTrack> share_table(const std::shared_ptr<const TimeTable>& table, LayerStore& store);

KeyTrack build_table(const TimeTable& table);

// The face with all cues upon it, not yet held within its limits; the head's turn is the track's and the
// cues'.
FaceState sample_layers(const Layers& layers, Ticks time);

// The same, of which only some moves are asked for: the others and the head's turn mean nothing.
FaceState sample_layers(const Layers& layers, Ticks time, const Moves& only);

// The same without any cue upon it.
FaceState sample_keys(const Layers& layers, Ticks time, const Moves& only);

}  // namespace mien

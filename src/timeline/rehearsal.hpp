// A clip played once from its beginning to its end, for all who look at it as a whole.
#pragma once

#include <string>
#include <vector>

#include "timeline/performance.hpp"

namespace mien {

// What a frame shows of the face and of the head's turning.
struct Shown {
  Pose pose;
  double turn_deg = 0, nod_deg = 0, tilt_deg = 0;
};

// Frame by frame, from 0; a held frame is as its drawing is.
struct Rehearsal {
  std::vector<double> drawn_s;        // the times of the drawings
  std::vector<Shown> shown;           // all in all
  std::vector<Pose> asked;            // by keys and cues alone: nothing leans, drifts, looks or blinks
  std::vector<Pose> keys;             // by the keys alone; of a clip without cues empty, since it is `asked`
  std::vector<std::string> drawings;  // as list_drawing_keys has them
  std::vector<Held> held;  // what the limits hold back in time (most_held.hpp), at any frame's time
};

// On all cores; the same on any number of them.
Rehearsal rehearse(const Performance& performance);

// The file's whole ledger, with what its people are held back from in time.
std::vector<Held> list_held(const Spec& spec, const std::vector<Rehearsal>& rehearsals);

}  // namespace mien

// Which frames show the same drawing, so that none is drawn twice.
#pragma once

#include <string>
#include <vector>

#include "timeline/performance.hpp"

namespace mien {

// For each frame (from 0) the first frame that shows the very same moment: everybody's pose, turn and head
// and the camera equal to the last bit. A frame of its own shows itself. Held drawings (twos), rests and
// cycles fall together. Of `everybody` who plays the keys of the drawings (list_drawing_keys), each with as
// many frames as the clip, whose light, camera and background count too.
std::vector<int> compute_drawings(const ClipSpec& clip,
                                  const std::vector<std::vector<std::string>>& everybody);
std::vector<int> compute_drawings(const Performance& performance);

// Frame by frame a word that two frames share if and only if one drawing does for both: of the pose, the turn
// and the head, and of the camera's numbers. The head's own eyes do not count.
std::vector<std::string> list_drawing_keys(const Performance& performance);

// The same of one moment, to which looks and blinks are still to be added (sample_unlooking).
std::string compute_drawing_key(const Performance& performance, double time_s, Moment unlooking);

// The frame (from 0) that says most: the first that shows the key whose areas are moved furthest in sum. For
// posters.
int find_poster_frame(const ClipSpec& clip);

}  // namespace mien

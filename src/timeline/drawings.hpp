// Which frames show the same drawing, so that none is drawn twice.
#pragma once

#include <vector>

#include "timeline/performance.hpp"

namespace mien {

// For each frame (from 0) the first frame that shows the very same moment: everybody's pose, turn and head
// and the camera equal to the last bit. A frame of its own shows itself. Held drawings (twos), rests and
// cycles fall together. The first performance counts the frames and has the camera.
std::vector<int> find_drawings(const std::vector<const Performance*>& performances);
std::vector<int> find_drawings(const Performance& performance);

// The frame (from 0) that says most: the first that shows the key whose areas are moved furthest in sum. For
// posters.
int find_poster_frame(const ClipSpec& clip);

}  // namespace mien

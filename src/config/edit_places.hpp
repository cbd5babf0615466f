// Where a text has its keys and blinks: what a timeline points at.
#pragma once

#include <string>
#include <vector>

#include "config/edit_text.hpp"

namespace mien {

struct TimedPlace {
  double at_s = 0;  // of the clip
  Place place;
};

// The items of `clip.TRACK` ("camera", "blinks") that have a time, in the order of the text; of an actor's
// own clip if there is one of that name. What other files add, or an alias hides, has no place here.
std::vector<TimedPlace> list_timed_places(const EditText& text, const std::string& actor,
                                          const std::string& track, int fps);

// The place of what stands at a time; none: line 0.
Place find_timed_place(const std::vector<TimedPlace>& places, double at_s);

}  // namespace mien

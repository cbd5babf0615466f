// What a moment is made of: for `mien explain`.
#pragma once

#include <string>
#include <vector>

#include "timeline/performance.hpp"

namespace mien {

// A key or a cue that a moment shows, and how much of it there is.
struct MomentPart {
  std::string label;
  double at_s = 0;  // of the key, or when the cue began
  double share = 1;
  bool is_cue = false;
  bool is_endless = false;  // a cue without an end: nothing comes after it on its areas
  double reach = 1;
  std::vector<Held> held;  // of itself
  // Of a key that is being left: what its release says, and how much of each part is off.
  std::vector<std::pair<std::string, double>> released = {};
  std::string order = {};  // of a key that is being reached: who leads, where it is not the natural order
};

// The keys around the moment (one, exactly at its time), then the cues from below. A key's share is that of
// an area in the middle of the others' `lead`.
std::vector<MomentPart> list_parts(const Performance& performance, double time_s);

// What the limits hold back of a moment: of its parts by themselves, and of what they come to
// (most_held.hpp).
std::vector<Held> list_held_at(const Performance& performance, double time_s);

}  // namespace mien

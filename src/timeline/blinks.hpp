// Blinks: where a clip has them, and what one does to a pose.
#pragma once

#include <vector>

#include "config/clip_spec.hpp"

namespace mien {

// Closing is the quick half. Human figures are 0.066..0.078 s and 0.1..0.24 s (see blinks.cpp); shorter than
// a frame and the lids would snap, longer and the face looks sleepy.
inline constexpr double kBlinkClosing_s = 0.080;
inline constexpr double kBlinkOpening_s = 0.200;

// The least time between two shut moments; nearer, they would melt into one.
inline constexpr double kBlinkGap_s = kBlinkClosing_s + kBlinkOpening_s + 0.12;

// The least time between the two of a double blink: the first has just opened.
inline constexpr double kDoubleGap_s = kBlinkClosing_s + kBlinkOpening_s + 0.02;

struct Blink {
  double at_s = 0;   // the moment at which the lids are furthest down
  double depth = 1;  // how far: 1 is shut

  bool operator==(const Blink&) const = default;
};

// The blinks of a clip, ascending: those asked for, those that great moves of the eyes and the head take
// along, and between them the clip's own at `blink.per_minute`, irregular as people's are. Each is at the
// time of a drawing, so that the shut lids are seen on twos and threes too. The same seed gives the same
// blinks on every machine.
std::vector<Blink> place_blinks(const ClipSpec& clip);

// How far the lids are shut at a time: 0 not at all, 1 fully; at each blink's moment exactly its depth.
double compute_blink_closure(const std::vector<Blink>& blinks, double time_s);

// Brings both upper lids `closure` of their way to shut (-1). A lid that is lower already stays where it is.
void close_lids(Pose& pose, double closure);

}  // namespace mien

// What an animator would say of a clip that is right but will not read well.
#pragma once

#include <array>
#include <vector>

#include "core/error.hpp"
#include "timeline/rehearsal.hpp"

namespace mien {

// How far each move takes the skin at value 1 and at -1 on a head, mm.
struct MoveReach {
  std::array<double, kMoveCount> plus_mm{}, minus_mm{};
};

// The least a face may be held to be read: "never hold an apex under 5 frames, 6 is the animator's minimum"
// (face-facts 3.6).
inline constexpr int kLeastHold_frames = 6;

// The furthest that skin moves in a frame before the eye sees a jump: a blink's lid, the quickest thing in a
// face, comes to about as much.
inline constexpr double kFastest_mm = 12;

// Of a clip whose keys are by time, and of what it comes to. Warnings at the keys they speak of, in their
// order:
//   a face that is held for less than kLeastHold_frames and left again
//   areas that move more than kFastest_mm a frame on their way to a key (lids and eyes may)
//   keys whose face no drawing shows in full: after the end, between two drawings, given no time
//   areas that a key releases and that do not move on the way to the next one
// then at the cues that no drawing shows in full, and at those without an end that hold areas over keys which
// ask for something else, as they are in the clip, and at all that swings faster than its drawings can carry
// (jitter.hpp); at last what is wrong with lines that are said (speech_advice.hpp)
std::vector<Diagnostic> advise_clip(const ClipSpec& clip, const Rehearsal& rehearsal, const MoveReach& reach);

}  // namespace mien

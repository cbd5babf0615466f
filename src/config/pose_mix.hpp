// Poses as sums of other poses, held within their limits.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "config/areas.hpp"
#include "config/ledger.hpp"

namespace mien {

// Of upper lids. Two poses that both shut one do not shut it twice.
inline constexpr std::array<bool, kChannelCount> kIsUpperLid = [] {
  std::array<bool, kChannelCount> lids{};
  for (std::size_t i = 0; i < kChannelCount; ++i) lids[i] = !kChannels[i].minus.meets.empty();
  return lids;
}();

// How an expression's moves answer to its strength and to other expressions; indexed as kChannels.
struct Manner {
  std::array<double, kChannelCount> dominance, growth;  // all 1 is plain

  Manner() { dominance.fill(1), growth.fill(1); }
};

struct PoseShare {
  double weight = 1;
  Pose pose;
  std::shared_ptr<const Manner> manner = {};  // plain without it
};

// The weighted sum, move by move, as it is to be before `strength` (0..1) makes it less. Two eyelids that
// both close do not close twice: of the closures (below 0) of an upper lid the lowest counts and not their
// sum. A move's growth g has it go with the g-th power of the strength: late if over 1, early if under. Where
// one share lifts and another lowers, the way of less dominance d against D keeps only 2 d^2/(d^2 + D^2) of
// what the other opposes; ways of equal dominance cancel as in any sum.
Pose mix_poses(const std::vector<PoseShare>& shares, double strength = 1);

// What an author asks of a face.
struct PoseAsk {
  Pose pose;              // what it starts from
  double reach = 1;       // how many times their limits the values of `pose` may go
  double strength = 1;    // of `pose`
  AreaValues areas;       // in place of `pose`'s own values
  double exaggerate = 1;  // of all
};

// A pose within its limits, and what the limits held back of it.
struct HeldPose {
  Pose pose;
  double reach = 1;        // how many times its limits it may go: at most kMaxExaggerate
  std::vector<Held> held;  // places only of values written in `areas`
};

// `pose` times `strength`, with each value of `areas` in place of its own, times `exaggerate`, held within
// the moves' ranges times `reach` and `exaggerate`. Limits that are ends of the body (find_stop) are not
// lifted, and what exaggeration alone takes past them is not told.
HeldPose hold_pose(const PoseAsk& ask);

}  // namespace mien

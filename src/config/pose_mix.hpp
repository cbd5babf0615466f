// Poses as sums of other poses.
#pragma once

#include <vector>

#include "config/areas.hpp"

namespace mien {

struct PoseShare {
  double weight = 1;
  Pose pose;
};

// The weighted sum, move by move. Two eyelids that both close do not close twice: of the closures (below 0)
// of an upper lid the lowest counts and not their sum.
Pose mix_poses(const std::vector<PoseShare>& shares);

// `pose` times `strength`, then with each value of `areas` in place of its own, each held within its move's
// range.
Pose build_pose(const Pose& pose, double strength, const AreaValues& areas);

}  // namespace mien

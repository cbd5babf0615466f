// The property sweep of posed faces: how sound the worst of 12,000 is.
#pragma once

#include <functional>
#include <vector>

#include "frames/pose_sweep.hpp"

namespace mien {

// For each check the worst value, its head, the pose's seed and its areas over a half.
void print_sweep_table(const SweepTable& table, const std::vector<SweepHead>& heads,
                       const std::function<Pose(unsigned)>& build_pose);

// Runs the sweep and prints it.
void measure_poses();

}  // namespace mien

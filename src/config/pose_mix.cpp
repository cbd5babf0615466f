#include "config/pose_mix.hpp"

#include <algorithm>

namespace mien {

Pose mix_poses(const std::vector<PoseShare>& shares) {
  Pose mixed;
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    const bool is_lid = kMoves[i].area == "lid" && kMoves[i].move == "upper";
    double sum = 0, lowest = 0;
    for (const PoseShare& share : shares) {
      const double value = share.weight * share.pose.values[i];
      if (is_lid && value < 0)
        lowest = std::min(lowest, value);
      else
        sum += value;
    }
    mixed.values[i] = sum + lowest;
  }
  return mixed;
}

Pose build_pose(const Pose& pose, double strength, const AreaValues& areas) {
  Pose built;
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    const double value = areas.values[i].value_or(pose.values[i] * strength);
    built.values[i] = std::clamp(value, kMoves[i].low, kMoves[i].high);
  }
  return built;
}

}  // namespace mien

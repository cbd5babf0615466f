#include "config/pose_mix.hpp"

#include <algorithm>

namespace mien {

namespace {

// Whether `exaggerate` lifts a move's limit, downward and upward.
const auto kIsLifted = [] {
  std::array<std::array<bool, 2>, kMoveCount> lifted{};
  for (std::size_t i = 0; i < kMoveCount; ++i)
    lifted[i] = {find_stop(i, -1).empty(), find_stop(i, 1).empty()};
  return lifted;
}();

}  // namespace

Pose mix_poses(const std::vector<PoseShare>& shares) {
  Pose mixed;
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    double sum = 0, lowest = 0;
    for (const PoseShare& share : shares) {
      const double value = share.weight * share.pose.values[i];
      if (kIsUpperLid[i] && value < 0)
        lowest = std::min(lowest, value);
      else
        sum += value;
    }
    mixed.values[i] = sum + lowest;
  }
  return mixed;
}

HeldPose hold_pose(const PoseAsk& ask) {
  HeldPose built;
  built.reach = std::min(kMaxExaggerate, ask.reach * ask.exaggerate);
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    const double value = ask.areas.values[i].value_or(ask.pose.values[i] * ask.strength);
    const double asked = value * ask.exaggerate;
    const bool is_lifted = kIsLifted[i][asked < 0 ? 0 : 1];
    const double reach = is_lifted ? built.reach : 1;
    const double held = std::clamp(asked, kMoves[i].low * reach, kMoves[i].high * reach);
    built.pose.values[i] = held;
    const bool is_past =
        is_lifted ? held != asked : value != std::clamp(value, kMoves[i].low, kMoves[i].high);
    if (!is_past) continue;
    const auto place = ask.areas.places.find(i);
    built.held.push_back({i, asked, held, place == ask.areas.places.end() ? Place{} : place->second, ""});
  }
  return built;
}

}  // namespace mien

// Poses for tests.
#pragma once

#include <random>

#include "config/areas.hpp"

namespace mien {

// Every move anywhere within its limits.
inline Pose build_random_pose(std::mt19937& random) {
  Pose pose;
  for (std::size_t i = 0; i < kMoveCount; ++i)
    pose.values[i] = std::uniform_real_distribution<double>(kMoves[i].low, kMoves[i].high)(random);
  return pose;
}

}  // namespace mien

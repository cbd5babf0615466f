// The property sweep of posed faces: how sound the worst of 12,000 is.
#pragma once

namespace mien {

// Prints for each check the worst value, its head, the pose's seed and its areas over a half.
void measure_poses();

}  // namespace mien

// What concerns all who play: where the camera looks and through what lens, the lights, what lies behind.
#pragma once

#include <string>
#include <vector>

#include "config/clip_spec.hpp"

namespace mien {

// So much of what the camera looks at, where it goes from one thing to another. Shares sum to 1.
struct AimShare {
  Aim aim;
  double share = 1;
};

struct StageMoment {
  std::vector<AimShare> aims;
  double lens_mm = kPortraitLens_mm;
  std::vector<LightShare> lights;            // none: as the scene's own, the studio
  std::vector<BackgroundShare> backgrounds;  // none: the scene's own
};

// The stage at a time; at a key's time exactly the key's. A light set that stays is dimmed and carried round;
// another one is faded in while it is faded out.
StageMoment sample_stage(const ClipSpec& clip, double time_s);

// 16 hexadecimal digits that differ for moments that differ.
std::string compute_stage_key(const StageMoment& moment);

}  // namespace mien

// What a quality means to POV-Ray: the numbers behind draft, good and best.
#pragma once

#include "core/staging.hpp"

namespace mien {

struct PovrayQuality {
  int light_samples;  // of the key light, along each side; 1 is a hard shadow, 3 shows as steps on the neck
  int key_depth;  // POV-Ray's `adaptive`: 2^depth + 1 samples a side to begin with; 0 may miss thin things
  const char* threshold;  // anti-aliasing: the difference between neighbours that asks for more rays
  int depth;              // anti-aliasing: depth^2 rays for such a pixel; brows and lashes need 9 or more
};

PovrayQuality find_povray_quality(Quality quality);

}  // namespace mien

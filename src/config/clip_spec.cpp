#include "config/clip_spec.hpp"

#include <algorithm>
#include <cmath>

namespace mien {

int count_frames(const ClipSpec& clip) {
  return std::max(1, static_cast<int>(std::lround(clip.length_s * clip.fps)));
}

}  // namespace mien

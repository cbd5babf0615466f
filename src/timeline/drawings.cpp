#include "timeline/drawings.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <unordered_map>

#include "core/text.hpp"

namespace mien {

namespace {

// All numbers of a moment as bytes; 0 and -0 alike.
std::string key_of(const Moment& moment) {
  std::string bytes;
  const auto add = [&](double value) {
    value += 0.0;  // folds -0
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
  };
  for (const double value : moment.pose.values) add(value);
  for (const double value : {moment.turn.turn_deg, moment.turn.nod_deg, moment.turn.tilt_deg,
                             moment.camera.angle_deg, moment.camera.height_deg, moment.camera.distance})
    add(value);
  return hash_hex(bytes);  // 64 bits: two of 100,000 moments fall together by chance once in 10^9 clips
}

}  // namespace

std::vector<int> find_drawings(const Performance& performance) {
  const int count = count_frames(performance.clip);
  std::vector<int> first(count);
  std::unordered_map<std::string, int> seen;
  // Eyes that no limit holds: two looks that these eyes cannot tell apart may differ on another head.
  Performance unheld = performance;
  unheld.idle.eyes.left = unheld.idle.eyes.right = {180, 180, 180, 180};
  for (int frame = 0; frame < count; ++frame) {
    const double time_s = find_drawing_time_s(performance.clip, frame);
    first[frame] = seen.emplace(key_of(sample_performance(unheld, time_s)), frame).first->second;
  }
  return first;
}

int find_poster_frame(const ClipSpec& clip) {
  double most = -1, time_s = 0;
  for (const PoseKey& key : clip.keys) {
    double sum = 0;
    for (const double value : key.pose.values) sum += std::abs(value);
    if (sum <= most) continue;
    most = sum;
    time_s = key.at_s;
  }
  return std::clamp(static_cast<int>(std::lround(time_s * clip.fps)), 0, count_frames(clip) - 1);
}

}  // namespace mien

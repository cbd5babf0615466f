#include "timeline/drawings.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>

#include "core/parallel.hpp"
#include "core/text.hpp"
#include "timeline/bytes.hpp"
#include "timeline/head_track.hpp"
#include "timeline/stage_track.hpp"

namespace mien {

namespace {

// All numbers of a moment as bytes.
std::string key_of(const Moment& moment) {
  std::string bytes;
  for (const double value : moment.pose.values) append_bytes(bytes, value);
  for (const double value : {moment.turn.turn_deg, moment.turn.nod_deg, moment.turn.tilt_deg,
                             moment.camera.angle_deg, moment.camera.height_deg, moment.camera.distance})
    append_bytes(bytes, value);
  return hash_hex(bytes);  // 64 bits: two of 100,000 moments fall together by chance once in 10^9 clips
}

}  // namespace

std::vector<int> find_drawings(const Performance& performance) {
  const std::vector<const Performance*> alone{&performance};
  return find_drawings(alone);
}

std::vector<int> find_drawings(const std::vector<const Performance*>& performances) {
  const ClipSpec& clip = performances.front()->clip;
  const int count = count_frames(clip);
  std::vector<int> first(count);
  std::unordered_map<std::string, int> seen;
  // Eyes that no limit holds: two looks that these eyes cannot tell apart may differ on another head.
  std::vector<Performance> unheld;
  for (const Performance* performance : performances) {
    unheld.push_back(*performance);
    unheld.back().idle.eyes.left = unheld.back().idle.eyes.right = {180, 180, 180, 180};
  }
  std::vector<std::string> keys(static_cast<std::size_t>(count));
  for_each_index(keys.size(), count_cores(), [&](std::size_t frame, int) {
    const double time_s = find_drawing_time_s(clip, static_cast<int>(frame));
    std::string& key = keys[frame] = find_stage_key(sample_stage(clip, time_s));
    for (const Performance& performance : unheld) {
      key += key_of(sample_performance(performance, time_s));
      if (const auto& heads = performance.clip.head; !heads.empty())
        key += find_head_key(sample_head(heads, time_s));
    }
  });
  for (int frame = 0; frame < count; ++frame)
    first[frame] = seen.emplace(keys[static_cast<std::size_t>(frame)], frame).first->second;
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

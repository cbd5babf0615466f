#include "timeline/drawings.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>

#include "core/pool.hpp"
#include "core/text.hpp"
#include "timeline/bytes.hpp"
#include "timeline/head_track.hpp"
#include "timeline/stage_track.hpp"

namespace mien {

namespace {

// All numbers of a moment as bytes.
std::string key_of(const Moment& moment) {
  std::string bytes;
  bytes.reserve(sizeof(double) * (kMoveCount + 7));
  const std::size_t count = has_doctrine(moment.pose) ? kChannelCount : kMoveCount;
  for (std::size_t i = 0; i < count; ++i) append_bytes(bytes, moment.pose.values[i]);
  for (const double value :
       {moment.turn.turn_deg, moment.turn.nod_deg, moment.turn.tilt_deg, moment.turn.breath_mm,
        moment.camera.angle_deg, moment.camera.height_deg, moment.camera.distance})
    append_bytes(bytes, value);
  if (moment.place)
    for (const double value :
         {moment.place->to_mm.x, moment.place->to_mm.y, moment.place->to_mm.z, moment.place->turn_deg})
      append_bytes(bytes, value);
  if (!moment.is_there) bytes = "away";
  return hash_hex(bytes);  // 64 bits: two of 100,000 moments fall together by chance once in 10^9 clips
}

}  // namespace

std::string compute_drawing_key(const Performance& performance, double time_s, Moment unlooking) {
  // Eyes that no limit holds: two looks that these eyes cannot tell apart may differ on another head.
  EyeRig eyes;
  eyes.left = eyes.right = {180, 180, 180, 180};
  add_looks_and_blinks(performance.idle, eyes, time_s, unlooking.camera, unlooking.turn, unlooking.pose);
  const std::vector<HeadKey>& heads = performance.clip.head;
  return key_of(unlooking) + (heads.empty() ? "" : compute_head_key(sample_head(heads, time_s)));
}

std::vector<std::string> list_drawing_keys(const Performance& performance) {
  std::vector<std::string> keys(static_cast<std::size_t>(count_frames(performance.clip)));
  for_each_index(keys.size(), count_workers(), [&](std::size_t frame, int) {
    const double time_s = compute_drawing_time_s(performance.clip, static_cast<int>(frame));
    const FaceState asked = sample_layers(*performance.layers, compute_ticks(time_s));
    keys[frame] = compute_drawing_key(performance, time_s, sample_unlooking(performance, time_s, asked));
  });
  return keys;
}

std::vector<int> compute_drawings(const Performance& performance) {
  return compute_drawings(performance.clip, {list_drawing_keys(performance)});
}

std::vector<int> compute_drawings(const ClipSpec& clip,
                                  const std::vector<std::vector<std::string>>& everybody) {
  const int count = count_frames(clip);
  std::vector<int> first(static_cast<std::size_t>(count));
  std::unordered_map<std::string, int> seen;
  for (int frame = 0; frame < count; ++frame) {
    std::string key = compute_stage_key(sample_stage(clip, compute_drawing_time_s(clip, frame)));
    for (const std::vector<std::string>& keys : everybody) key += keys.at(static_cast<std::size_t>(frame));
    first[static_cast<std::size_t>(frame)] = seen.emplace(std::move(key), frame).first->second;
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

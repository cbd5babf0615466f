// Key frames and their in-betweens: Burtnyk and Wein (1976), as Yen (1990) uses them for the nine areas. An
// in-between is the eased linear mix of the two keys around it, value by value.
#include "timeline/performance.hpp"

#include <algorithm>
#include <cmath>

#include "timeline/easing.hpp"

namespace mien {
namespace {

// Keys in the order of their times; of keys at one time the last written is last. A track without keys rests.
template <typename Key>
void sort_track(std::vector<Key>& keys) {
  if (keys.empty()) keys.emplace_back();
  std::stable_sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) { return a.at_s < b.at_s; });
}

// std::lerp: exact at both ends and never outside them, which a + (b - a) * t is not.
PoseKey mix_keys(const PoseKey& from, const PoseKey& to, double share) {
  PoseKey mixed = from;
  for (std::size_t i = 0; i < kMoveCount; ++i)
    mixed.pose.values[i] = std::lerp(from.pose.values[i], to.pose.values[i], share);
  return mixed;
}

TurnKey mix_keys(const TurnKey& from, const TurnKey& to, double share) {
  TurnKey mixed = from;
  mixed.turn_deg = std::lerp(from.turn_deg, to.turn_deg, share);
  mixed.nod_deg = std::lerp(from.nod_deg, to.nod_deg, share);
  mixed.tilt_deg = std::lerp(from.tilt_deg, to.tilt_deg, share);
  return mixed;
}

CameraKey mix_keys(const CameraKey& from, const CameraKey& to, double share) {
  CameraKey mixed = from;
  mixed.angle_deg = std::lerp(from.angle_deg, to.angle_deg, share);
  mixed.height_deg = std::lerp(from.height_deg, to.height_deg, share);
  mixed.distance = std::lerp(from.distance, to.distance, share);
  return mixed;
}

// The track at `time_s`. `keys` are sorted and at least one.
template <typename Key>
Key sample_track(const std::vector<Key>& keys, double time_s) {
  const auto next = std::upper_bound(keys.begin(), keys.end(), time_s,
                                     [](double time, const Key& key) { return time < key.at_s; });
  Key sampled = next == keys.begin() ? keys.front() : *(next - 1);
  if (next != keys.begin() && next != keys.end()) {
    const double fraction = (time_s - sampled.at_s) / (next->at_s - sampled.at_s);
    sampled = mix_keys(sampled, *next, ease(next->ease, fraction));
  }
  sampled.at_s = time_s;
  return sampled;
}

}  // namespace

Performance build_performance(const ClipSpec& clip) {
  Performance performance{clip, {}};
  sort_track(performance.clip.keys);
  sort_track(performance.clip.camera);
  sort_track(performance.clip.turn);
  performance.idle = build_idle(performance.clip);
  return performance;
}

Moment sample_performance(const Performance& performance, double time_s) {
  const ClipSpec& clip = performance.clip;
  const auto sample_pose = [&](double at_s) { return sample_track(clip.keys, at_s).pose; };
  Moment moment{sample_leaning(performance.idle.asymmetry, time_s, sample_pose),
                sample_track(clip.turn, time_s), sample_track(clip.camera, time_s)};
  add_idle(performance.idle, time_s, moment.camera, moment.pose, moment.turn);
  return moment;
}

double find_drawing_time_s(const ClipSpec& clip, int frame) {
  return static_cast<double>(frame - frame % std::max(clip.draw, 1)) / clip.fps;
}

}  // namespace mien

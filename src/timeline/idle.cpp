#include "timeline/idle.hpp"

namespace mien {

Idle build_idle(const ClipSpec& clip) {
  std::vector<double> keys_s;
  for (const PoseKey& key : clip.keys) keys_s.push_back(key.at_s);
  return {build_asymmetry(clip.asymmetry, std::move(keys_s)),
          build_drift(clip.drift),
          build_gaze(clip.gaze, clip.length_s),
          {},
          place_blinks(clip)};
}

void add_idle(const Idle& idle, double time_s, const CameraKey& camera, Pose& pose, TurnKey& turn) {
  add_drift(idle.drift, time_s, pose, turn);
  aim_eyes(idle.gaze, idle.eyes, time_s, turn, camera, pose);
  close_lids(pose, find_blink_closure(idle.blinks, time_s));
}

}  // namespace mien

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

void add_looks_and_blinks(const Idle& idle, const EyeRig& eyes, double time_s, const CameraKey& camera,
                          const TurnKey& turn, Pose& pose) {
  aim_eyes(idle.gaze, eyes, time_s, turn, camera, pose);
  close_lids(pose, compute_blink_closure(idle.blinks, time_s));
}

}  // namespace mien

#include "timeline/performance.hpp"

#include <algorithm>

#include "core/parallel.hpp"

namespace mien {
namespace {

// Keys in the order of their times; of keys at one time the last written is last. A track without keys rests.
template <typename Key>
void sort_track(std::vector<Key>& keys) {
  if (keys.empty()) keys.emplace_back();
  std::ranges::stable_sort(keys, {}, &Key::at_s);
}

double hold(double value, const Bounds& bounds) { return std::clamp(value, bounds.low, bounds.high); }

Pose hold_pose(const FaceState& face) {
  Pose pose;
  for (std::size_t i = 0; i < kMoveCount; ++i) pose.values[i] = hold_value(i, face.values[i], face.reach[i]);
  return pose;
}

TurnKey build_turn(const FaceState& face, double time_s) {
  TurnKey turn;
  turn.at_s = time_s;
  turn.turn_deg = hold(face.turn_deg[0], kTurnBounds[0]);
  turn.nod_deg = hold(face.turn_deg[1], kTurnBounds[1]);
  turn.tilt_deg = hold(face.turn_deg[2], kTurnBounds[2]);
  return turn;
}

CameraKey sample_camera(const Layers& layers, double time_s) {
  std::array<double, 3> numbers;
  sample_track(layers.camera, find_ticks(time_s), numbers);
  CameraKey camera;
  camera.at_s = time_s;
  camera.angle_deg = hold(numbers[0], kCameraBounds[0]);
  camera.height_deg = hold(numbers[1], kCameraBounds[1]);
  camera.distance = hold(numbers[2], kCameraBounds[2]);
  return camera;
}

}  // namespace

double hold_value(std::size_t move, double value, double reach) {
  const MoveInfo& info = kMoves[move];
  if (value >= info.low && value <= info.high) return value;
  const double end = value < 0 ? info.low : info.high;
  const double most = find_stop(move, value < 0 ? -1 : 1).empty() ? end * reach : end;
  return value < 0 ? std::max(value, most) : std::min(value, most);
}

Performance build_performance(const ClipSpec& clip) {
  Performance performance{clip, {}, std::make_shared<const Layers>(build_layers(clip))};
  sort_track(performance.clip.keys);
  sort_track(performance.clip.camera);
  sort_track(performance.clip.turn);
  performance.idle = build_idle(performance.clip);
  return performance;
}

Moment sample_performance(const Performance& performance, double time_s) {
  const Layers& layers = *performance.layers;
  const FaceState now = sample_layers(layers, find_ticks(time_s));
  const auto sample_pose = [&](double at_s, const Moves& only) {
    return hold_pose(at_s == time_s ? now : sample_layers(layers, find_ticks(at_s), only));
  };
  Moment moment{sample_leaning(performance.idle.asymmetry, time_s, sample_pose), build_turn(now, time_s),
                sample_camera(layers, time_s)};
  add_idle(performance.idle, time_s, moment.camera, moment.pose, moment.turn);
  return moment;
}

std::vector<Moment> sample_frames(const Performance& performance) {
  std::vector<Moment> moments(static_cast<std::size_t>(count_frames(performance.clip)));
  for_each_index(moments.size(), count_cores(), [&](std::size_t frame, int) {
    moments[frame] =
        sample_performance(performance, find_drawing_time_s(performance.clip, static_cast<int>(frame)));
  });
  return moments;
}

double find_drawing_time_s(const ClipSpec& clip, int frame) {
  return find_seconds(find_frame_ticks(find_drawn_frame(clip, frame), clip.fps));
}

}  // namespace mien

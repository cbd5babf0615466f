#include "timeline/performance.hpp"

#include <algorithm>

#include "config/law_numbers.hpp"
#include "timeline/track_laws.hpp"

namespace mien {
namespace {

// Keys in the order of their times; of keys at one time the last written is last. A track without keys rests.
template <typename Key>
void sort_track(std::vector<Key>& keys) {
  if (keys.empty()) keys.emplace_back();
  std::ranges::stable_sort(keys, {}, &Key::at_s);
}

double hold(double value, const Bounds& bounds) { return std::clamp(value, bounds.low, bounds.high); }

Pose hold_moves(const FaceState& face, const Moves& only) {
  Pose pose;
  for_each_move(only, [&](std::size_t i) { pose.values[i] = hold_value(i, face.values[i], face.reach[i]); });
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
  sample_track(layers.camera, compute_ticks(time_s), numbers);
  apply_laws(layers.laws, LawTrack::camera, compute_ticks(time_s), numbers);
  CameraKey camera;
  camera.at_s = time_s;
  camera.angle_deg = hold(numbers[0], kCameraBounds[0]);
  camera.height_deg = hold(numbers[1], kCameraBounds[1]);
  camera.distance = hold(numbers[2], kCameraBounds[2]);
  return camera;
}

}  // namespace

double hold_value(std::size_t move, double value, double reach) {
  const MoveInfo& info = kChannels[move];
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
  const Idle& idle = performance.idle;
  Moment moment = sample_unlooking(performance, time_s, sample_layers(layers, compute_ticks(time_s)));
  add_looks_and_blinks(idle, idle.eyes, time_s, moment.camera, moment.turn, moment.pose);
  return moment;
}

Pose hold_face(const FaceState& asked) { return hold_moves(asked, Moves().set()); }

namespace {

void add_standing(const Performance& performance, double time_s, Moment& moment) {
  const ClipSpec& clip = performance.clip;
  moment.is_there = time_s >= clip.enters_s && time_s < clip.leaves_s;
  if (clip.place.empty()) return;
  std::array<double, 4> numbers;
  sample_track(performance.layers->place, compute_ticks(time_s), numbers);
  apply_laws(performance.layers->laws, LawTrack::place, compute_ticks(time_s), numbers);
  for (std::size_t axis = 0; axis < 3; ++axis) numbers[axis] = hold(numbers[axis], kPlaceBounds);
  moment.place = PlaceKey{time_s, {}, {numbers[0], numbers[1], numbers[2]}, numbers[3]};
}

}  // namespace

Moment sample_unlooking(const Performance& performance, double time_s, const FaceState& asked) {
  const Layers& layers = *performance.layers;
  const auto sample_pose = [&](double at_s, const Moves& only) {
    return hold_moves(at_s == time_s ? asked : sample_layers(layers, compute_ticks(at_s), only), only);
  };
  Moment moment{sample_leaning(performance.idle.asymmetry, time_s, sample_pose), build_turn(asked, time_s),
                sample_camera(layers, time_s)};
  add_drift(performance.idle.drift, time_s, moment.pose, moment.turn);
  add_standing(performance, time_s, moment);
  return moment;
}

double compute_drawing_time_s(const ClipSpec& clip, int frame) {
  return compute_seconds(compute_frame_ticks(compute_drawn_frame(clip, frame), clip.fps));
}

}  // namespace mien

// Saccades: Bahill, Clark and Stark, "The main sequence" (1975); 21 + 2.2 A ms and no slow start, since the
// eye's plant is all but without inertia. While the head turns the eyes hold what they look at (the
// vestibulo-ocular reflex), and both meet there (vergence). Fixations last 0.2 s and more, the time it takes
// to choose the next one (face-facts 3.4).
#include "timeline/gaze.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "core/conventions.hpp"
#include "core/seeded.hpp"
#include "timeline/easing.hpp"
#include "timeline/head_turn.hpp"

namespace mien {
namespace {

// At `wander: 1`, degrees: of the size of a face seen across a table. Twice as much, and the eyes seem to
// search the room.
constexpr double kWanderSide_deg = 8, kWanderUp_deg = 4;
constexpr double kLeastFixation_s = 0.2, kMeanFixation_s = 1.1;
constexpr double kFixationSpread = 0.6;  // of the logarithm: many short ones, a few long

// From one end of what angles there are to the other (compute_saccade_s): whoever is to arrive later than
// that has not set out.
constexpr double kLongestSaccade_s = 1;

constexpr double kQuickTurn_degps = 25;  // a head that turns more slowly takes no blink along

// Yaw to the character's left and pitch upward, degrees in the head's own frame.
struct EyeAim {
  double side_deg = 0, up_deg = 0;
};
struct EyesAim {
  EyeAim left, right;
};

EyeAim compute_aim(const glm::dvec3& toward) {
  return {std::atan2(toward.x, toward.z) / kRadiansPerDegree,
          std::atan2(toward.y, std::hypot(toward.x, toward.z)) / kRadiansPerDegree};
}

glm::dvec3 compute_direction(double side_deg, double up_deg) {
  const double side = side_deg * kRadiansPerDegree, up = up_deg * kRadiansPerDegree;
  return {std::cos(up) * std::sin(side), std::sin(up), std::cos(up) * std::cos(side)};
}

glm::dvec3 compute_camera_mm(const EyeRig& rig, const CameraKey& camera) {
  return rig.camera_target_mm +
         rig.camera_mm * camera.distance * compute_direction(camera.angle_deg, camera.height_deg);
}

// The eyes of a head as it is turned, and the camera.
struct EyesNow {
  const EyeRig& rig;
  const CameraKey& camera;
  glm::dmat4 world_from_head;
  glm::dmat3 head_from_world;

  EyesNow(const EyeRig& rig_, const TurnKey& turn, const CameraKey& camera_)
      : rig(rig_),
        camera(camera_),
        world_from_head(compute_turn(rig_.pivot_mm, turn, 1)),
        head_from_world(glm::transpose(glm::dmat3(world_from_head))) {}  // of a rotation
};

// One key's aim, seen from the head.
EyesAim compute_aim(const GazeKey& key, const EyesNow& eyes) {
  if (key.look == LookAt::ahead) return {};
  if (key.look == LookAt::direction) {
    const EyeAim aim = compute_aim(eyes.head_from_world * compute_direction(key.side_deg, key.up_deg));
    return {aim, aim};
  }
  const glm::dvec3 place =
      key.look == LookAt::camera ? compute_camera_mm(eyes.rig, eyes.camera) : key.point_mm;
  const auto aim_from = [&](const glm::dvec3& centre) {
    return compute_aim(eyes.head_from_world *
                       (place - glm::dvec3(eyes.world_from_head * glm::dvec4(centre, 1))));
  };
  return {aim_from(eyes.rig.left_mm), aim_from(eyes.rig.left_mm * glm::dvec3(-1, 1, 1))};
}

double compute_amplitude_deg(const EyeAim& from, const EyeAim& to) {
  return std::hypot(to.side_deg - from.side_deg, to.up_deg - from.up_deg);
}

EyeAim mix_aims(const EyeAim& from, const EyeAim& to, double share) {
  return {std::lerp(from.side_deg, to.side_deg, share), std::lerp(from.up_deg, to.up_deg, share)};
}

// The share of a saccade gone that arrives at `at_s`, having left no sooner than `after_s`.
double compute_saccade_share(double amplitude_deg, double after_s, double at_s, double time_s) {
  const double length_s = std::min(compute_saccade_s(amplitude_deg), at_s - after_s);
  if (time_s >= at_s || length_s <= 0) return time_s >= at_s ? 1 : 0;
  return ease(Easing::out, 1 - (at_s - time_s) / length_s);
}

// The first of a list by time that is later than `time_s`.
template <typename Timed>
auto compute_next(const std::vector<Timed>& list, double time_s) {
  return std::upper_bound(list.begin(), list.end(), time_s,
                          [](double time, const Timed& timed) { return time < timed.at_s; });
}

// Where the keys want the eyes at a time, and the key at whose place they rest; none on the way to another.
struct KeysAim {
  EyesAim aim;
  const GazeKey* key = nullptr;
};

KeysAim sample_keys(const Gaze& gaze, const EyeRig& rig, double time_s, const TurnKey& turn,
                    const CameraKey& camera) {
  const std::vector<GazeKey>& keys = gaze.spec.keys;
  if (keys.empty()) return {};
  const auto next = compute_next(keys, time_s);
  const GazeKey& now = next == keys.begin() ? *next : *(next - 1);
  const EyesNow eyes(rig, turn, camera);
  const EyesAim from = compute_aim(now, eyes);
  if (next == keys.begin() || next == keys.end() || next->at_s - time_s > kLongestSaccade_s)
    return {from, &now};
  const EyesAim to = compute_aim(*next, eyes);
  // One time for both eyes, though one of them may have further to go.
  const double amplitude_deg =
      std::max(compute_amplitude_deg(from.left, to.left), compute_amplitude_deg(from.right, to.right));
  const double share = compute_saccade_share(amplitude_deg, now.at_s, next->at_s, time_s);
  return {{mix_aims(from.left, to.left, share), mix_aims(from.right, to.right, share)},
          share == 0 ? &now : nullptr};
}

EyeAim sample_fixations(const std::vector<Fixation>& fixations, double time_s) {
  if (fixations.empty()) return {};
  const auto next = compute_next(fixations, time_s);
  const Fixation& now = next == fixations.begin() ? *next : *(next - 1);
  const EyeAim from{now.side_deg, now.up_deg};
  if (next == fixations.begin() || next == fixations.end()) return from;
  const EyeAim to{next->side_deg, next->up_deg};
  return mix_aims(from, to,
                  compute_saccade_share(compute_amplitude_deg(from, to), now.at_s, next->at_s, time_s));
}

// `value` of a limit's way, which may be another one upward than downward, moved by `degrees`; not held.
double add_degrees(double degrees, double plus_deg, double minus_deg, double value) {
  if (plus_deg <= 0 || minus_deg <= 0) return value;  // an eye that cannot turn
  const double sum_deg = degrees + value * (value > 0 ? plus_deg : minus_deg);
  return sum_deg / (sum_deg > 0 ? plus_deg : minus_deg);
}

template <Side side>
void add_aim(const EyeAim& aim, const EyeReach& reach, Pose& pose) {
  constexpr std::size_t kSide = *find_move(Area::eye, side, "side"), kUp = *find_move(Area::eye, side, "up");
  pose.values[kSide] = add_degrees(aim.side_deg, reach.left_deg, reach.right_deg, pose.values[kSide]);
  pose.values[kUp] = add_degrees(aim.up_deg, reach.up_deg, reach.down_deg, pose.values[kUp]);
}

// In values that no limit holds.
void add_aims(const EyesAim& aim, const EyeRig& rig, Pose& pose) {
  add_aim<Side::left>(aim.left, rig.left, pose);
  add_aim<Side::right>(aim.right, rig.right, pose);
}

constexpr std::array<std::size_t, 4> kEyes{
    *find_move(Area::eye, Side::left, "side"), *find_move(Area::eye, Side::left, "up"),
    *find_move(Area::eye, Side::right, "side"), *find_move(Area::eye, Side::right, "up")};

// As an author would say it.
std::string describe(const GazeKey& key) {
  if (!key.actor.empty()) return "look at " + key.actor;
  switch (key.look) {
    case LookAt::ahead:
      return "look ahead";
    case LookAt::camera:
      return "look at the camera";
    case LookAt::direction:
      return fmt::format("look {:.4g}deg aside, {:.4g}deg up", key.side_deg, key.up_deg);
    case LookAt::point:
      return "look at a point";
  }
  return "look";
}

}  // namespace

double compute_saccade_s(double amplitude_deg) { return 0.021 + 0.0022 * amplitude_deg; }

Gaze build_gaze(const GazeSpec& spec, double length_s) {
  Gaze gaze{spec, {}};
  if (spec.wander <= 0) return gaze;
  std::mt19937_64 random = build_random(spec.seed, 0);
  const double free_s = kMeanFixation_s - kLeastFixation_s;
  for (double at_s = 0; at_s <= length_s;) {
    // The square of an even share: most fixations lie near, a few far.
    const double reach = sample_uniform(random, -1, 1), height = sample_uniform(random, -1, 1);
    gaze.fixations.push_back({at_s, spec.wander * kWanderSide_deg * reach * std::abs(reach),
                              spec.wander * kWanderUp_deg * height * std::abs(height)});
    at_s += kLeastFixation_s + free_s * std::exp(kFixationSpread * sample_normal(random) -
                                                 kFixationSpread * kFixationSpread / 2);
  }
  return gaze;
}

void aim_eyes(const Gaze& gaze, const EyeRig& rig, double time_s, const TurnKey& turn,
              const CameraKey& camera, Pose& pose) {
  if (gaze.spec.keys.empty() && gaze.fixations.empty()) return;
  EyesAim aim = sample_keys(gaze, rig, time_s, turn, camera).aim;
  const EyeAim offset = sample_fixations(gaze.fixations, time_s);
  for (EyeAim* eye : {&aim.left, &aim.right}) {
    eye->side_deg += offset.side_deg;
    eye->up_deg += offset.up_deg;
  }
  add_aims(aim, rig, pose);
  for (const std::size_t move : kEyes) pose.values[move] = std::clamp(pose.values[move], -1.0, 1.0);
}

std::vector<Held> list_held_looks(const Gaze& gaze, const EyeRig& rig, double time_s, const TurnKey& turn,
                                  const CameraKey& camera, const Pose& pose) {
  std::vector<Held> held;
  const KeysAim look = sample_keys(gaze, rig, time_s, turn, camera);
  if (look.key == nullptr) return held;
  Pose asked = pose;
  add_aims(look.aim, rig, asked);
  for (const std::size_t move : kEyes) {
    const double value = asked.values[move], most = std::clamp(value, -1.0, 1.0);
    constexpr double kSlack = 0.005;  // of the reach: a fifth of a degree, which nobody can see
    if (std::abs(value - most) > kSlack)
      held.push_back({move, value, most, look.key->place, describe(*look.key)});
  }
  return held;
}

std::vector<Shift> list_shifts(const GazeSpec& gaze, const std::vector<TurnKey>& turn,
                               const std::vector<CameraKey>& camera) {
  std::vector<Shift> shifts;
  const CameraKey view = camera.empty() ? CameraKey{} : camera.front();
  const EyeRig rig;
  const EyesNow eyes(rig, TurnKey{}, view);
  for (std::size_t i = 1; i < gaze.keys.size(); ++i) {
    const EyeAim from = compute_aim(gaze.keys[i - 1], eyes).left, to = compute_aim(gaze.keys[i], eyes).left;
    const double amplitude_deg = compute_amplitude_deg(from, to);
    shifts.push_back({gaze.keys[i].at_s - compute_saccade_s(amplitude_deg) / 2, amplitude_deg});
  }
  for (std::size_t i = 1; i < turn.size(); ++i) {
    const TurnKey &from = turn[i - 1], &to = turn[i];
    const double amplitude_deg = std::hypot(to.turn_deg - from.turn_deg, to.nod_deg - from.nod_deg);
    if (amplitude_deg < kQuickTurn_degps * (to.at_s - from.at_s)) continue;
    shifts.push_back({(from.at_s + to.at_s) / 2, amplitude_deg});
  }
  std::ranges::stable_sort(shifts, {}, &Shift::at_s);
  return shifts;
}

}  // namespace mien

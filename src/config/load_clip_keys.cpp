#include <fmt/format.h>
#include <algorithm>

#include "config/load_clip.hpp"

namespace mien {

namespace {

void load_angle(const YamlMapping& entries, std::string_view key, double low_deg, double high_deg,
                double& into) {
  if (const YamlValue* value = find_value(entries, key))
    load_quantity(*value, build_angle_measure(), low_deg, high_deg, into);
}

// A key's own values, over those of the key before it.
void load_values(const YamlMapping& entries, CameraKey& key) {
  load_angle(entries, "angle", -360, 360, key.angle_deg);
  load_angle(entries, "height", -60, 80, key.height_deg);
  if (const YamlValue* distance = find_value(entries, "distance"))
    load_number(*distance, 0.2, 4, key.distance);
}

void load_values(const YamlMapping& entries, TurnKey& key) {
  load_angle(entries, "turn", -kMaxTurn_deg, kMaxTurn_deg, key.turn_deg);
  load_angle(entries, "nod", -kMaxNod_deg, kMaxNod_deg, key.nod_deg);
  load_angle(entries, "tilt", -kMaxTilt_deg, kMaxTilt_deg, key.tilt_deg);
}

// The keys of one track, each a mapping with `at`, in rising time. `load_own` reads what else a key holds.
template <typename Key, typename LoadOwn>
std::vector<Key> load_track(const YamlMapping& clip, std::string_view name, const Names& words,
                            std::string_view example, const ClipClock& clock, const LoadOwn& load_own) {
  std::vector<Key> keys;
  const YamlValue* track = find_value(clip, name);
  if (track == nullptr) return keys;
  const std::string item = fmt::format("a key such as {}", example);
  std::optional<double> before_s;
  for (const YamlValue& value : load_list(*track, "a list of keys such as [" + std::string(example) + "]")) {
    Key key = keys.empty() ? Key{} : keys.back();
    key.ease = Key{}.ease;
    const YamlMapping entries = load_mapping(value, words, item);
    load_key_time(entries, value, clock, before_s, key.at_s);
    if constexpr (requires { key.place; }) key.place = find_place(value.document->source, value.spot);
    load_ease(entries, key.ease);
    load_own(entries, key);
    keys.push_back(std::move(key));
  }
  return keys;
}

}  // namespace

void load_key_time(const YamlMapping& entries, const YamlValue& key, const ClipClock& clock,
                   std::optional<double>& before_s, double& into) {
  const YamlValue* at = find_required(entries, "at", key, "a time such as 1.5s");
  if (at == nullptr || !load_time(*at, clock, into)) return;
  if (before_s && into <= *before_s)
    add_mistake(*at, fmt::format("{} is {}, not after the {} of the key before it; expected rising times",
                                 describe_subject(*at), format_quantity(into, clock.measure),
                                 format_quantity(*before_s, clock.measure)));
  before_s = into;
}

void load_ease(const YamlMapping& entries, Easing& into) {
  const YamlValue* value = find_value(entries, "ease");
  std::string name;
  if (value != nullptr && load_name(*value, "ease", kEasings, name))
    into = static_cast<Easing>(std::ranges::find(kEasings, name) - kEasings.begin());
}

void load_pose(const YamlMapping& entries, const ExpressionBook& book, PoseKey& key) {
  const Express express = load_posed(entries, book);
  key.pose = express.pose;
  key.label = express.label;
  key.reach = express.reach;
  key.held = express.held;
}

std::vector<PoseKey> load_pose_keys(const YamlMapping& clip, const ClipClock& clock,
                                    const ExpressionBook& book) {
  return load_track<PoseKey>(
      clip, "keys", kPoseKeyKeys, "{at: 1s, express: smile}", clock,
      [&](const YamlMapping& entries, PoseKey& key) { load_pose(entries, book, key); });
}

std::vector<CameraKey> load_camera_keys(const YamlMapping& clip, const ClipClock& clock) {
  return load_track<CameraKey>(clip, "camera", kCameraKeys, "{at: 1s, angle: 20deg}", clock,
                               [](const YamlMapping& entries, CameraKey& key) { load_values(entries, key); });
}

std::vector<TurnKey> load_turn_keys(const YamlMapping& clip, const ClipClock& clock) {
  return load_track<TurnKey>(clip, "turn", kTurnKeys, "{at: 1s, turn: 20deg}", clock,
                             [](const YamlMapping& entries, TurnKey& key) { load_values(entries, key); });
}

}  // namespace mien

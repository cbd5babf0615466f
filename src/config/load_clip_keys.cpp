#include <algorithm>

#include "config/load_clip.hpp"
#include "config/load_track.hpp"
#include "core/ticks.hpp"

namespace mien {

namespace {

// A number of a camera's or turn's key: an angle, or with no `measure` a plain one.
void load_live(const YamlMapping& entries, std::string_view key, const Measure* measure,
               const ClipReader& reader, double& into, FormulaPointer& live) {
  const YamlValue* value = find_value(entries, key);
  if (value == nullptr) return;
  live = nullptr;
  if (measure != nullptr ? is_formula(*value, *measure) : is_formula(*value))
    live = load_formula(*value, reader.formulas);
  else if (measure != nullptr)
    load_angle(*value, into);
  else
    load_number(*value, into);
}

// What formulas come to at the key's own time.
void settle(double at_s, const std::array<Bounds, 3>& bounds, const std::array<FormulaPointer, 3>& live,
            const std::array<double*, 3>& numbers) {
  for (std::size_t i = 0; i < live.size(); ++i)
    if (live[i]) *numbers[i] = std::clamp(evaluate_held(*live[i], at_s), bounds[i].low, bounds[i].high);
}

// A key's own values, over those of the key before it.
void load_values(const YamlMapping& entries, const ClipReader& reader, CameraKey& key) {
  const Measure angle = build_angle_measure();
  load_live(entries, "angle", &angle, reader, key.angle_deg, key.live[0]);
  load_live(entries, "height", &angle, reader, key.height_deg, key.live[1]);
  load_live(entries, "distance", nullptr, reader, key.distance, key.live[2]);
  settle(key.at_s, kCameraBounds, key.live, {&key.angle_deg, &key.height_deg, &key.distance});
}

void load_values(const YamlMapping& entries, const ClipReader& reader, TurnKey& key) {
  const Measure angle = build_angle_measure();
  load_live(entries, "turn", &angle, reader, key.turn_deg, key.live[0]);
  load_live(entries, "nod", &angle, reader, key.nod_deg, key.live[1]);
  load_live(entries, "tilt", &angle, reader, key.tilt_deg, key.live[2]);
  settle(key.at_s, kTurnBounds, key.live, {&key.turn_deg, &key.nod_deg, &key.tilt_deg});
}

constexpr const char* kCurve = "four numbers x1, y1, x2, y2 such as [0.3, 0, 0.2, 1]";  // as in CSS

void load_bezier(const YamlValue& value, Ease& into) {
  const std::vector<YamlValue> items = load_list(value, kCurve);
  if (items.size() != 4) {
    add_mistake(value, fmt::format("{} has {} item{}; expected {}", describe_subject(value), items.size(),
                                   items.size() == 1 ? "" : "s", kCurve));
    return;
  }
  Ease ease(Easing::bezier);
  const Form& curve = find_form(value, FormKind::curve);
  bool is_right = true;
  for (std::size_t i = 0; i < 4; ++i)
    is_right &= i % 2 == 0 ? load_number(items[i], 0, 1, ease.handles[i])
                           : load_number(items[i], curve.low, curve.high, ease.handles[i]);
  if (is_right) into = ease;
}

// A word, or the four numbers of a curve.
void load_ease(const YamlValue& value, Ease& into) {
  if (find_node(value).kind == NodeKind::list) return load_bezier(value, into);
  std::string name;
  if (!load_text(value, fmt::format("one of: {}, or {}", join_names(kEasings), kCurve), name)) return;
  const auto found = std::ranges::find(kEasings, name);
  if (found != kEasings.end())
    into = static_cast<Easing>(found - kEasings.begin());
  else
    add_mistake(value, describe_unknown("ease", name, kEasings) +
                           (suggest_name(name, kEasings).empty() ? fmt::format(", or {}", kCurve) : ""));
}

// What a key's release says of one part, and where.
struct PartRelease {
  std::size_t key = 0, part = 0;
  YamlValue value;
};

// `release: 0.5s` of a key, or `release: {brows: 12f, corners: 6f}`.
void load_release(const YamlMapping& entries, const ClipClock& clock, std::size_t key, Release& into,
                  std::vector<PartRelease>& told) {
  const YamlValue* value = find_value(entries, "release");
  if (value == nullptr) return;
  if (find_node(*value).kind != NodeKind::mapping) {
    double all_s = 0;
    if (!load_duration(*value, clock, all_s)) return;
    into.fill(all_s);
    told.push_back({key, 0, *value});
    return;
  }
  for (const YamlEntry& entry : load_section(*value)) {
    const auto part =
        static_cast<std::size_t>(std::ranges::find(kReleaseKeys, entry.key) - kReleaseKeys.begin());
    if (load_duration(entry.value, clock, into[part])) told.push_back({key, part, entry.value});
  }
}

// A release lies within the way to the next key, which is gone area by area.
void check_releases(const std::vector<PoseKey>& keys, const std::vector<PartRelease>& told,
                    const ClipClock& clock) {
  for (const auto& [key, part, value] : told) {
    if (key + 1 >= keys.size()) {
      add_mistake(value, fmt::format("{} stands in the last key; expected a key after it to go to",
                                     describe_subject(value)));
      continue;
    }
    const PoseKey& next = keys[key + 1];
    const double way_s = next.at_s - keys[key].at_s;
    if (way_s <= 0) continue;  // told already: times rise
    if (next.between != Between::ease)
      add_mistake(value,
                  fmt::format("{} is of a way that is '{}' for all areas; expected one with an 'ease'",
                              describe_subject(value), kBetweens[static_cast<std::size_t>(next.between)]));
    else if (compute_ticks(keys[key].release[part]) > compute_ticks(way_s))
      add_mistake(
          value, fmt::format("{} is {}; expected {} at most, when the next key comes",
                             describe_subject(value), format_quantity(keys[key].release[part], clock.measure),
                             format_quantity(way_s, clock.measure)));
  }
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

void load_between(const YamlMapping& entries, Between& into) {
  std::string name;
  if (const YamlValue* value = find_value(entries, "between"))
    if (load_name(*value, name))
      into = static_cast<Between>(std::ranges::find(kBetweens, name) - kBetweens.begin());
}

void load_way(const YamlMapping& entries, const ClipReader& reader, Ease& ease, Between& between) {
  ease = Ease{};
  between = reader.between;
  load_between(entries, between);
  const YamlValue* value = find_value(entries, "ease");
  if (value == nullptr) return;
  const YamlValue* beside = find_value(entries, "between");
  if (beside != nullptr && between != Between::ease)
    add_mistake(*beside, fmt::format("{} is '{}' and there is an 'ease' beside it; expected one of them",
                                     describe_subject(*beside), find_node(*beside).text));
  between = Between::ease;
  load_ease(*value, ease);
}

Express load_pose(const YamlMapping& entries, const ClipReader& reader, PoseKey& key) {
  Express express = load_posed(entries, *reader.book, &reader.formulas);
  key.pose = express.live ? evaluate_pose(*express.live, key.at_s).pose : express.pose;
  key.label = express.label;
  key.reach = express.reach;
  key.held = express.held;
  key.live = express.live;
  return express;
}

std::vector<PoseKey> load_pose_keys(const YamlMapping& clip, const ClipReader& reader) {
  std::vector<PartRelease> releases;
  std::size_t count = 0;
  std::vector<PoseKey> keys = load_track<PoseKey>(
      clip, "keys", "{at: 1s, express: smile}", reader, [&](const YamlMapping& entries, PoseKey& key) {
        load_pose(entries, reader, key);
        key.release = kNoRelease;
        load_release(entries, reader.clock, count++, key.release, releases);
      });
  check_releases(keys, releases, reader.clock);
  return keys;
}

std::vector<CameraKey> load_camera_keys(const YamlMapping& clip, const ClipReader& reader) {
  return load_track<CameraKey>(
      clip, "camera", "{at: 1s, angle: 20deg}", reader,
      [&](const YamlMapping& entries, CameraKey& key) { load_values(entries, reader, key); });
}

std::vector<TurnKey> load_turn_keys(const YamlMapping& clip, const ClipReader& reader) {
  return load_track<TurnKey>(
      clip, "turn", "{at: 1s, turn: 20deg}", reader,
      [&](const YamlMapping& entries, TurnKey& key) { load_values(entries, reader, key); });
}

}  // namespace mien

#include <fmt/format.h>
#include <algorithm>

#include "config/load_spec.hpp"
#include "config/sections.hpp"

namespace mien {

namespace {

constexpr int kMaxFps = 120;
constexpr int kMaxDraw = 12;          // held longer, a clip is a row of stills
constexpr double kMaxPerMinute = 60;  // blinks; people come to 15 or 20
constexpr int kMaxSeed = 1'000'000'000;

// What reading times needs.
struct Clock {
  Measure measure;
  double end_s = 0;  // the last time that kMaxFrames leave
};

bool load_time(const YamlValue& value, const Clock& clock, double& into) {
  return load_quantity(value, clock.measure, 0, clock.end_s, into);
}

void load_ease(const YamlMapping& entries, Easing& into) {
  const YamlValue* value = find_value(entries, "ease");
  std::string name;
  if (value != nullptr && load_name(*value, "ease", kEasings, name))
    into = static_cast<Easing>(std::ranges::find(kEasings, name) - kEasings.begin());
}

void load_angle(const YamlMapping& entries, std::string_view key, double low_deg, double high_deg,
                double& into) {
  if (const YamlValue* value = find_value(entries, key))
    load_quantity(*value, build_angle_measure(), low_deg, high_deg, into);
}

// A key's own values, over those of the key before it.
void load_values(const YamlMapping& entries, const ExpressionBook& book, PoseKey& key) {
  const Express express = load_posed(entries, book);
  key.pose = express.pose;
  key.label = express.label;
  key.reach = express.reach;
  key.held = express.held;
}

void load_values(const YamlMapping& entries, const ExpressionBook&, CameraKey& key) {
  load_angle(entries, "angle", -360, 360, key.angle_deg);
  load_angle(entries, "height", -60, 80, key.height_deg);
  if (const YamlValue* distance = find_value(entries, "distance"))
    load_number(*distance, 0.2, 4, key.distance);
}

void load_values(const YamlMapping& entries, const ExpressionBook&, TurnKey& key) {
  load_angle(entries, "turn", -60, 60, key.turn_deg);
  load_angle(entries, "nod", -40, 40, key.nod_deg);
  load_angle(entries, "tilt", -30, 30, key.tilt_deg);
}

// The keys of one track, each a mapping with `at`, in rising time.
template <typename Key>
std::vector<Key> load_track(const YamlMapping& clip, std::string_view name, const Names& words,
                            std::string_view example, const Clock& clock, const ExpressionBook& book) {
  std::vector<Key> keys;
  const YamlValue* track = find_value(clip, name);
  if (track == nullptr) return keys;
  const std::string item = fmt::format("a key such as {}", example);
  std::optional<double> before_s;
  for (const YamlValue& value : load_list(*track, "a list of keys such as [" + std::string(example) + "]")) {
    Key key = keys.empty() ? Key{} : keys.back();
    key.ease = Key{}.ease;
    const YamlMapping entries = load_mapping(value, words, item);
    const YamlValue* at = find_required(entries, "at", value, "a time such as 1.5s");
    if (at != nullptr && load_time(*at, clock, key.at_s)) {
      if (before_s && key.at_s <= *before_s)
        add_mistake(*at, fmt::format("{} is {}, not after the {} of the key before it; expected rising times",
                                     describe_subject(*at), format_quantity(key.at_s, clock.measure),
                                     format_quantity(*before_s, clock.measure)));
      before_s = key.at_s;
    }
    load_ease(entries, key.ease);
    load_values(entries, book, key);
    keys.push_back(std::move(key));
  }
  return keys;
}

void load_draw(const YamlValue& value, int& into) {
  const YamlNode& node = find_node(value);
  if (node.kind == NodeKind::text && !parse_number(node.text)) {
    std::string name;
    if (load_name(value, "draw", kDraws, name))
      into = 1 + static_cast<int>(std::ranges::find(kDraws, name) - kDraws.begin());
  } else {
    load_whole(value, 1, kMaxDraw, into, "frames a drawing");
  }
}

void load_blink(const YamlValue& value, BlinkSpec& blink) {
  const YamlMapping entries = load_mapping(value, kBlinkKeys, "a mapping such as {per_minute: 15, seed: 7}");
  if (const YamlValue* rate = find_value(entries, "per_minute"))
    load_number(*rate, 0, kMaxPerMinute, blink.per_minute, "blinks a minute");
  int seed = 0;
  if (const YamlValue* number = find_value(entries, "seed");
      number != nullptr && load_whole(*number, 0, kMaxSeed, seed))
    blink.seed = static_cast<std::uint64_t>(seed);
}

// One key at the beginning for a track that has none.
void fill_tracks(ClipSpec& clip, const ExpressionBook& book) {
  if (clip.keys.empty()) {
    clip.keys.emplace_back();
    load_values({}, book, clip.keys.back());
  }
  if (clip.camera.empty()) clip.camera.emplace_back();
  if (clip.turn.empty()) clip.turn.emplace_back();
}

}  // namespace

ClipSpec load_clip(const YamlValue* value, const ExpressionBook& book) {
  ClipSpec clip;
  YamlMapping entries;
  if (value != nullptr) entries = load_mapping(*value, kClipKeys, "a mapping such as {fps: 24, keys: [...]}");
  if (const YamlValue* fps = find_value(entries, "fps"))
    load_whole(*fps, 1, kMaxFps, clip.fps, "frames a second");
  if (const YamlValue* draw = find_value(entries, "draw")) load_draw(*draw, clip.draw);

  Clock clock{build_time_measure(clip.fps), static_cast<double>(kMaxFrames) / clip.fps};
  clock.measure.note = fmt::format(" ({} frames)", kMaxFrames);
  clip.keys = load_track<PoseKey>(entries, "keys", kPoseKeyKeys, "{at: 1s, express: smile}", clock, book);
  clip.camera = load_track<CameraKey>(entries, "camera", kCameraKeys, "{at: 1s, angle: 20deg}", clock, book);
  clip.turn = load_track<TurnKey>(entries, "turn", kTurnKeys, "{at: 1s, turn: 20deg}", clock, book);
  fill_tracks(clip, book);

  if (const YamlValue* blink = find_value(entries, "blink")) load_blink(*blink, clip.blink);
  if (const YamlValue* blinks = find_value(entries, "blinks"))
    for (const YamlValue& item : load_list(*blinks, "a list of times such as [1s, 2.5s]"))
      if (double at_s = 0; load_time(item, clock, at_s)) clip.blinks_s.push_back(at_s);
  std::ranges::sort(clip.blinks_s);

  clip.length_s = std::max({clip.keys.back().at_s, clip.camera.back().at_s, clip.turn.back().at_s});
  if (const YamlValue* length = find_value(entries, "length")) load_time(*length, clock, clip.length_s);
  return clip;
}

}  // namespace mien

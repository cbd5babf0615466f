#include <fmt/format.h>

#include <algorithm>

#include "config/load_spec.hpp"
#include "config/load_track.hpp"
#include "config/sections.hpp"

namespace mien {

namespace {

constexpr const char* kWholeFrame = "all";  // what the camera looks at without `look_at`

void load_values(const YamlMapping& entries, LightKey& key) {
  if (const YamlValue* set = find_value(entries, "set")) load_name(*set, key.set);
  if (const YamlValue* brightness = find_value(entries, "brightness"))
    load_number(*brightness, key.brightness);
  if (const YamlValue* angle = find_value(entries, "angle")) load_angle(*angle, key.angle_deg);
}

// A named background, or a colour.
void load_values(const YamlMapping& entries, BackgroundKey& key) {
  const YamlValue* show = find_value(entries, "show");
  if (show == nullptr) return;
  const YamlNode& node = find_node(*show);
  key.colour = node.kind == NodeKind::text ? parse_colour(node.text) : std::nullopt;
  if (key.colour) return;
  if (node.kind == NodeKind::text && !node.text.starts_with("#"))
    load_name(*show, key.name);
  else
    add_unexpected(*show, "a colour such as \"#203040\", or one of: " + join_names(kBackgrounds));
}

// A landmark or everyday word, behind "ann." if there are actors; or a point.
void load_aim(const YamlValue& value, const AimWords& words, Aim& aim) {
  const NodeKind kind = find_node(value).kind;
  aim = {};
  if (kind == NodeKind::list) {
    if (load_lengths(value, aim.point_mm)) aim.kind = Aim::Kind::point;
    return;
  }
  std::string name;
  if (!load_text(value, "a place such as nose_tip, or three lengths such as [0, 20mm, 90mm]", name)) return;
  if (name == kWholeFrame) return;
  Names known{kWholeFrame};
  for (const std::string& place : words.places) {
    if (words.actors.empty()) known.push_back(place);
    for (const std::string& actor : words.actors) known.push_back(actor + "." + place);
  }
  if (std::ranges::find(known, name) == known.end())
    return add_mistake(value, describe_unknown("place", name, known));
  const std::size_t dot = name.find('.');
  aim.kind = Aim::Kind::landmark;
  if (dot != std::string::npos) aim.actor = name.substr(0, dot);
  aim.landmark = dot == std::string::npos ? name : name.substr(dot + 1);
}

// For tracks of keys without curves or formulas.
ClipReader build_reader(const ClipSpec& clip, const NamedTimes& times) {
  ClipReader reader;
  reader.clock = build_clip_clock(clip.fps, &times);
  return reader;
}

// Tells a key of `head:` that is one too many.
bool has_few_keys(const YamlMapping& entries, HeadCounts& counts) {
  const YamlValue* track = find_value(entries, "head");
  if (track == nullptr || find_node(*track).kind != NodeKind::list) return true;
  for (const YamlValue& item : load_list(*track, "")) {
    if (++counts.keys <= kMaxHeadKeys) continue;
    add_mistake(item, fmt::format("more than {} keys of 'clip.head'; expected fewer", kMaxHeadKeys));
    return false;
  }
  return true;
}

// The head of another file, or one mixed of several, in place of what was before. Hair, limits and rules stay
// those of the one who plays.
void load_other_start(const YamlMapping& entries, const HeadSource& source, const HeadSpec& first,
                      HeadSpec& head) {
  const YamlValue* file = find_value(entries, "file");
  const YamlValue* mix = find_value(entries, "mix");
  if (file == nullptr && mix == nullptr) return;
  if (file != nullptr && mix != nullptr)
    add_mistake(*mix, "'mix' stands beside 'file'; expected one of both");
  HeadSpec other;
  if (file != nullptr && !load_head_file(*file, source, other)) return;
  if (file == nullptr) load_head_mix(*mix, source, other);
  other.hair = first.hair;
  other.limits = first.limits;
  other.limit_lengths = first.limit_lengths;
  other.match_level = first.match_level;
  other.follows_thesis = first.follows_thesis;
  other.said = first.said;
  head = std::move(other);
}

// Without `length:` a clip lasts until its last key.
template <typename Key>
void stretch_clip(const YamlMapping& entries, const std::vector<Key>& keys, ClipSpec& clip) {
  if (find_value(entries, "length") == nullptr && !keys.empty())
    clip.length_s = std::max(clip.length_s, keys.back().at_s);
}

}  // namespace

void load_head_track(const YamlMapping& entries, const HeadSource& source, const HeadSpec& first,
                     const NamedTimes& times, ClipSpec& clip) {
  HeadKey start;
  start.head = first;
  if (!has_few_keys(entries, *source.counts)) return;
  clip.head = load_track<HeadKey>(
      entries, "head", "{at: 1s, age: child}", build_reader(clip, times),
      [&](const YamlMapping& key_entries, HeadKey& key) {
        load_other_start(key_entries, source, first, key.head);
        load_growth(key_entries, *source.words, key.head);
      },
      start);
  stretch_clip(entries, clip.head, clip);
}

void load_camera_sights(const YamlMapping& entries, const AimWords& words, ClipSpec& clip) {
  const YamlValue* track = find_value(entries, "camera");
  if (track == nullptr || find_node(*track).kind != NodeKind::list) return;
  const std::vector<YamlValue> items = load_list(*track, "");
  if (items.size() != clip.camera.size()) return;
  CameraKey before;
  for (std::size_t i = 0; i < items.size(); ++i) {
    CameraKey& key = clip.camera[i];
    key.aim = before.aim;
    key.lens_mm = before.lens_mm;
    if (find_node(items[i]).kind == NodeKind::mapping) {
      const YamlMapping own = load_free_mapping(items[i], "");
      if (const YamlValue* aim = find_value(own, "look_at")) load_aim(*aim, words, key.aim);
      if (const YamlValue* lens = find_value(own, "lens")) load_length(*lens, key.lens_mm);
    }
    before = key;
  }
}

void load_light_tracks(const YamlMapping& entries, const NamedTimes& times, ClipSpec& clip) {
  const ClipReader reader = build_reader(clip, times);
  clip.light = load_track<LightKey>(
      entries, "light", "{at: 1s, set: candle}", reader,
      [](const YamlMapping& key_entries, LightKey& key) { load_values(key_entries, key); });
  clip.background = load_track<BackgroundKey>(
      entries, "background", "{at: 1s, show: dark}", reader,
      [](const YamlMapping& key_entries, BackgroundKey& key) { load_values(key_entries, key); });
  stretch_clip(entries, clip.light, clip);
  stretch_clip(entries, clip.background, clip);
}

}  // namespace mien

#include "config/load_clip.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "config/load_spec.hpp"
#include "config/sections.hpp"

namespace mien {

namespace {

constexpr int kMaxFps = 120;

// One key at the beginning for a track that has none.
void fill_tracks(ClipSpec& clip, const ExpressionBook& book) {
  if (clip.keys.empty()) {
    clip.keys.emplace_back();
    load_pose({}, book, clip.keys.back());
  }
  if (clip.camera.empty()) clip.camera.emplace_back();
  if (clip.turn.empty()) clip.turn.emplace_back();
}

}  // namespace

bool load_time(const YamlValue& value, const ClipClock& clock, double& into) {
  return load_quantity(value, clock.measure, 0, clock.end_s, into);
}

ClipSpec load_clip(const YamlValue* value, const ExpressionBook& book) {
  ClipSpec clip;
  YamlMapping entries;
  if (value != nullptr) entries = load_mapping(*value, kClipKeys, "a mapping such as {fps: 24, keys: [...]}");
  if (const YamlValue* fps = find_value(entries, "fps"))
    load_whole(*fps, 1, kMaxFps, clip.fps, "frames a second");
  load_draw(entries, clip);

  ClipClock clock{build_time_measure(clip.fps), static_cast<double>(kMaxFrames) / clip.fps};
  clock.measure.note = fmt::format(" ({} frames)", kMaxFrames);
  clip.keys = load_pose_keys(entries, clock, book);
  clip.camera = load_camera_keys(entries, clock);
  clip.turn = load_turn_keys(entries, clock);
  fill_tracks(clip, book);
  load_idle(entries, clock, clip);

  clip.length_s = std::max({clip.keys.back().at_s, clip.camera.back().at_s, clip.turn.back().at_s});
  if (!clip.gaze.keys.empty()) clip.length_s = std::max(clip.length_s, clip.gaze.keys.back().at_s);
  if (const YamlValue* length = find_value(entries, "length")) load_time(*length, clock, clip.length_s);
  return clip;
}

}  // namespace mien

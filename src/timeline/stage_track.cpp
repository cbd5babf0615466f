#include "timeline/stage_track.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "config/law_numbers.hpp"
#include "core/text.hpp"
#include "core/ticks.hpp"
#include "timeline/bytes.hpp"
#include "timeline/key_span.hpp"
#include "timeline/track_laws.hpp"

namespace mien {

namespace {

bool is_same(const Aim& a, const Aim& b) {
  return a.kind == b.kind && a.actor == b.actor && a.landmark == b.landmark && a.point_mm == b.point_mm;
}

// One thing if both ends are the same or the way is not begun, else both by their shares.
template <typename Share, typename Key, typename Build, typename IsSame>
std::vector<Share> fade(const KeySpan<Key>& span, const Build& build, const IsSame& are_same) {
  if (span.share == 0 || are_same(*span.from, *span.to)) return {build(*span.from, 1.0)};
  if (span.share == 1) return {build(*span.to, 1.0)};
  return {build(*span.from, 1 - span.share), build(*span.to, span.share)};
}

// A key of the lights with the laws upon its numbers.
LightShare build_light(const std::vector<TrackLaw>& laws, const LightKey& key, double time_s) {
  std::array<double, 2> numbers{key.brightness, key.angle_deg};
  apply_laws(laws, LawTrack::light, compute_ticks(time_s), numbers);
  const Bounds& bright = list_law_numbers(LawTrack::light)[kBrightnessNumber].bounds;
  return {key.set, std::clamp(numbers[kBrightnessNumber], bright.low, bright.high),
          numbers[kLightAngleNumber]};
}

std::vector<LightShare> sample_lights(const ClipSpec& clip, double time_s) {
  const bool has_laws = std::ranges::find(clip.laws, LawTrack::light, &TrackLaw::track) != clip.laws.end();
  if (clip.light.empty() && !has_laws) return {};
  if (clip.light.empty()) return {build_light(clip.laws, LightKey{}, time_s)};
  const KeySpan<LightKey> span = find_span(clip.light, time_s);
  const auto is_same_set = [](const LightKey& a, const LightKey& b) { return a.set == b.set; };
  std::vector<LightShare> lights = fade<LightShare>(
      span,
      [&](const LightKey& key, double share) {
        LightShare light = build_light(clip.laws, key, time_s);
        light.bright *= share;
        return light;
      },
      is_same_set);
  if (is_same_set(*span.from, *span.to)) {
    LightKey now = *span.from;
    now.brightness = std::lerp(span.from->brightness, span.to->brightness, span.share);
    now.angle_deg = std::lerp(span.from->angle_deg, span.to->angle_deg, span.share);
    lights.front() = build_light(clip.laws, now, time_s);
  }
  return lights;
}

std::vector<BackgroundShare> sample_backgrounds(const std::vector<BackgroundKey>& keys, double time_s) {
  if (keys.empty()) return {};
  return fade<BackgroundShare>(
      find_span(keys, time_s),
      [](const BackgroundKey& key, double share) {
        return BackgroundShare{key.name, key.colour, share};
      },
      [](const BackgroundKey& a, const BackgroundKey& b) {
        return a.colour == b.colour && (a.colour || a.name == b.name);
      });
}

}  // namespace

StageMoment sample_stage(const ClipSpec& clip, double time_s) {
  StageMoment moment;
  if (!clip.camera.empty()) {
    const KeySpan<CameraKey> span = find_span(clip.camera, time_s);
    std::array<double, kLensNumber + 1> numbers{};
    numbers[kLensNumber] = std::lerp(span.from->lens_mm, span.to->lens_mm, span.share);
    apply_laws(clip.laws, LawTrack::camera, compute_ticks(time_s), numbers);
    moment.lens_mm = std::clamp(numbers[kLensNumber], kShortestLens_mm, kLongestLens_mm);
    moment.aims = fade<AimShare>(
        span,
        [](const CameraKey& key, double share) {
          return AimShare{key.aim, share};
        },
        [](const CameraKey& a, const CameraKey& b) { return is_same(a.aim, b.aim); });
  }
  moment.lights = sample_lights(clip, time_s);
  moment.backgrounds = sample_backgrounds(clip.background, time_s);
  return moment;
}

std::string compute_stage_key(const StageMoment& moment) {
  std::string bytes;
  append_bytes(bytes, moment.lens_mm);
  for (const AimShare& aim : moment.aims) {
    bytes += fmt::format("{} {} {};", static_cast<int>(aim.aim.kind), aim.aim.actor, aim.aim.landmark);
    for (int axis = 0; axis < 3; ++axis) append_bytes(bytes, aim.aim.point_mm[axis]);
    append_bytes(bytes, aim.share);
  }
  for (const LightShare& light : moment.lights) {
    bytes += light.set;
    append_bytes(bytes, light.bright);
    append_bytes(bytes, light.angle_deg);
  }
  for (const BackgroundShare& background : moment.backgrounds) {
    bytes += background.colour ? "#" : background.name;
    append_bytes(bytes, background.colour.value_or(glm::vec3(0)));
    append_bytes(bytes, background.share);
  }
  return hash_hex(bytes);
}

}  // namespace mien

#include "timeline/stage_track.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/text.hpp"
#include "timeline/bytes.hpp"
#include "timeline/key_span.hpp"

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

std::vector<LightShare> sample_lights(const std::vector<LightKey>& keys, double time_s) {
  if (keys.empty()) return {};
  const KeySpan<LightKey> span = find_span(keys, time_s);
  const auto is_same_set = [](const LightKey& a, const LightKey& b) { return a.set == b.set; };
  std::vector<LightShare> lights = fade<LightShare>(
      span,
      [](const LightKey& key, double share) {
        return LightShare{key.set, share * key.brightness, key.angle_deg};
      },
      is_same_set);
  if (is_same_set(*span.from, *span.to)) {
    lights.front().bright = std::lerp(span.from->brightness, span.to->brightness, span.share);
    lights.front().angle_deg = std::lerp(span.from->angle_deg, span.to->angle_deg, span.share);
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
    moment.lens_mm = std::lerp(span.from->lens_mm, span.to->lens_mm, span.share);
    moment.aims = fade<AimShare>(
        span,
        [](const CameraKey& key, double share) {
          return AimShare{key.aim, share};
        },
        [](const CameraKey& a, const CameraKey& b) { return is_same(a.aim, b.aim); });
  }
  moment.lights = sample_lights(clip.light, time_s);
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

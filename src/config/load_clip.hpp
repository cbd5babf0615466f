// The parts of `clip:`, each from the clip's entries to its field of clip_spec.hpp.
#pragma once

#include "config/clip_spec.hpp"
#include "config/expressions.hpp"
#include "config/yaml_reader.hpp"

namespace mien {

// What reading times needs.
struct ClipClock {
  Measure measure;
  double end_s = 0;  // the last time that kMaxFrames leave
};

bool load_time(const YamlValue& value, const ClipClock& clock, double& into);

// `at:` of a key of a track, which must come after `before_s`; that is made this key's then.
void load_key_time(const YamlMapping& entries, const YamlValue& key, const ClipClock& clock,
                   std::optional<double>& before_s, double& into);

// `ease:` of a key.
void load_ease(const YamlMapping& entries, Easing& into);

// The pose of a key: `express`, `strength`, `exaggerate`, `areas`. Without them it is neutral.
void load_pose(const YamlMapping& entries, const ExpressionBook& book, PoseKey& key);

// `keys:`, `camera:` and `turn:`; empty if there is no such key.
std::vector<PoseKey> load_pose_keys(const YamlMapping& clip, const ClipClock& clock,
                                    const ExpressionBook& book);
std::vector<CameraKey> load_camera_keys(const YamlMapping& clip, const ClipClock& clock);
std::vector<TurnKey> load_turn_keys(const YamlMapping& clip, const ClipClock& clock);

// `draw:`.
void load_draw(const YamlMapping& entries, ClipSpec& clip);

// What the face does by itself: `blink:`, `blinks:`, `gaze:`, `drift:` and `asymmetry:`.
void load_idle(const YamlMapping& entries, const ClipClock& clock, ClipSpec& clip);

}  // namespace mien

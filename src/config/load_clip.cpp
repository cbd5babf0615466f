#include "config/load_clip.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "config/load_spec.hpp"
#include "config/named_file.hpp"
#include "config/sections.hpp"
#include "core/ticks.hpp"

namespace mien {

namespace {

constexpr int kMaxChecks = 2000;  // moments at which a formula is tried; more only cost time

// One key at the beginning for a track that has none.
void fill_tracks(ClipSpec& clip, const ClipReader& reader) {
  if (clip.keys.empty()) {
    clip.keys.emplace_back();
    load_pose({}, reader, clip.keys.back());
  }
  if (clip.camera.empty()) clip.camera.emplace_back();
  if (clip.turn.empty()) clip.turn.emplace_back();
}

// Frames from one time to another, both ends with them; fewer where there are very many.
std::vector<double> list_times(double from_s, double to_s, int fps) {
  const double frames = std::max(0.0, (to_s - from_s) * fps);
  const int count = std::max(1, static_cast<int>(std::min<double>(frames, kMaxChecks)));
  std::vector<double> times_s;
  for (int i = 0; i < count; ++i) {
    const double at_s = from_s + (to_s - from_s) * i / count;
    times_s.push_back(count < kMaxChecks ? compute_seconds(compute_ticks(std::round(at_s * fps) / fps))
                                         : at_s);
  }
  times_s.front() = from_s;
  times_s.push_back(to_s);
  return times_s;
}

void check_pose(const PoseKey& key, const ClipReader& reader, const std::vector<double>& times_s) {
  if (!key.live) return;
  for (const LivePose::Share& share : key.live->shares)
    if (share.weight.formula) check_formula(share.weight.formula, reader.formulas, times_s);
  if (key.live->strength.formula) check_formula(key.live->strength.formula, reader.formulas, times_s);
  for (const LivePose::Value& value : key.live->values)
    check_formula(value.formula, reader.formulas, times_s);
}

void check_pose(const TurnKey& key, const ClipReader& reader, const std::vector<double>& times_s) {
  for (const FormulaPointer& formula : key.live)
    if (formula) check_formula(formula, reader.formulas, times_s);
}

void check_pose(const CameraKey& key, const ClipReader& reader, const std::vector<double>& times_s) {
  for (const FormulaPointer& formula : key.live)
    if (formula) check_formula(formula, reader.formulas, times_s);
}

// A key is there from the one before it to the one after it.
template <typename Key>
void check_keys(const std::vector<Key>& keys, const ClipReader& reader, double end_s, int fps) {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const double from_s = i == 0 ? 0 : keys[i - 1].at_s;
    const double to_s = i + 1 == keys.size() ? std::max(end_s, keys[i].at_s) : keys[i + 1].at_s;
    check_pose(keys[i], reader, list_times(std::min(from_s, to_s), to_s, fps));
  }
}

// Every formula has a value whenever it is asked.
void check_formulas(const ClipSpec& clip, const ClipReader& reader) {
  check_keys(clip.keys, reader, clip.length_s, clip.fps);
  check_keys(clip.turn, reader, clip.length_s, clip.fps);
  check_keys(clip.camera, reader, clip.length_s, clip.fps);
  for (const CueSpec& cue : clip.cues) {
    const double from_s = std::clamp(cue.from_s, 0.0, clip.length_s);
    const double to_s = std::clamp(cue.end_s, from_s, std::max(from_s, clip.length_s));
    check_pose(cue.what, reader, list_times(from_s, to_s, clip.fps));
  }
}

// {after: ann.hello, delay: 0.3s}.
bool load_waiting_time(const YamlValue& value, const ClipClock& clock, double& into) {
  const std::optional<double> found_s = load_named_time(value, clock);
  if (!found_s) return false;
  const double at_s = *found_s;
  if (at_s < 0 || at_s > clock.end_s) {
    add_mistake(value, fmt::format("{} comes to {}; expected a time from 0s to {}{}", describe_subject(value),
                                   format_quantity(at_s, clock.measure),
                                   format_quantity(clock.end_s, clock.measure), clock.measure.note));
    return false;
  }
  into = compute_seconds(compute_ticks(at_s));
  return true;
}

}  // namespace

ClipClock build_clip_clock(int fps, const NamedTimes* times) {
  ClipClock clock{build_time_measure(fps), static_cast<double>(kMaxFrames) / fps, 0, times, {}};
  clock.measure.note = fmt::format(" ({} frames)", kMaxFrames);
  return clock;
}

void load_fps(const YamlMapping& entries, int& into) {
  if (const YamlValue* fps = find_value(entries, "fps")) load_whole(*fps, into);
}

bool load_time(const YamlValue& value, const ClipClock& clock, double& into) {
  if (clock.times != nullptr && find_node(value).kind == NodeKind::mapping)
    return load_waiting_time(value, clock, into);
  if (!load_duration(value, clock, into)) return false;
  into = compute_seconds(compute_ticks(clock.start_s) + compute_ticks(into));
  return true;
}

bool load_duration(const YamlValue& value, const ClipClock& clock, double& into) {
  if (!load_quantity(value, clock.measure, 0, clock.end_s, into)) return false;
  into = compute_seconds(compute_ticks(into));
  return true;
}

double compute_last_s(const ClipSpec& clip) {
  double last_s = 0;
  for (const PoseKey& key : clip.keys) last_s = std::max(last_s, key.at_s);
  for (const CameraKey& key : clip.camera) last_s = std::max(last_s, key.at_s);
  for (const TurnKey& key : clip.turn) last_s = std::max(last_s, key.at_s);
  for (const CueSpec& cue : clip.cues)
    last_s = std::max(last_s, std::isfinite(cue.end_s) ? cue.end_s : std::max(cue.full_s, 0.0));
  return last_s;
}

void load_layers(const YamlMapping& entries, const ClipReader& reader, ClipSpec& into) {
  const auto merge = [](auto& keys, auto more) {
    for (auto& key : more) {
      std::erase_if(keys, [&](const auto& other) { return other.at_s == key.at_s; });
      keys.push_back(std::move(key));
    }
    std::ranges::stable_sort(keys, [](const auto& a, const auto& b) { return a.at_s < b.at_s; });
  };
  merge(into.keys, load_pose_keys(entries, reader));
  merge(into.camera, load_camera_keys(entries, reader));
  merge(into.turn, load_turn_keys(entries, reader));
  load_tables(entries, reader, into.cues);
  load_cues(entries, reader, into.cues);
  load_laws(entries, reader, into.cues);
  std::ranges::stable_sort(into.cues, [](const CueSpec& a, const CueSpec& b) {
    return std::pair(a.layer, a.from_s) < std::pair(b.layer, b.from_s);
  });
  into.lead = reader.lead;
  into.length_s = compute_last_s(into);
  if (const YamlValue* length = find_value(entries, "length"))
    load_duration(*length, reader.clock, into.length_s);
  check_formulas(into, reader);
}

ClipSpec load_clip(const YamlValue* value, const ExpressionBook& book, const ClipSetting& setting) {
  ClipSpec clip;
  if (setting.shared != nullptr) {
    clip.fps = setting.shared->fps;
    clip.draw = setting.shared->draw;
    clip.draw_changes = setting.shared->draw_changes;
  }
  YamlMapping entries;
  if (value != nullptr) entries = load_section(*value);
  load_fps(entries, clip.fps);

  ClipLibrary library;
  ClipReader reader;
  reader.clock = build_clip_clock(clip.fps, setting.times);
  reader.clock.others = setting.others;
  reader.book = std::make_shared<const ExpressionBook>(book);
  reader.library = &library;
  reader.formulas.found = &library.formulas;
  reader.formulas.fps = clip.fps;
  if (value != nullptr) reader.files.push_back(find_canonical(value->document->source.file));
  load_draw(entries, reader.clock, clip);
  load_between(entries, reader.between);
  reader.lead = load_lead(entries, reader.clock);
  load_includes(entries, reader, clip);
  if (const YamlValue* inputs = find_value(entries, "inputs")) load_inputs(*inputs, {}, reader.formulas);
  load_scripts(entries, reader);
  load_layers(entries, reader, clip);
  load_idle(entries, reader.clock, clip);
  if (!clip.gaze.keys.empty() && find_value(entries, "length") == nullptr)
    clip.length_s = std::max(clip.length_s, clip.gaze.keys.back().at_s);
  if (clip.length_s > reader.clock.end_s) {
    add_mistake(*value, fmt::format("{} ends at {}; expected {} at most{}", describe_subject(*value),
                                    format_quantity(clip.length_s, reader.clock.measure),
                                    format_quantity(reader.clock.end_s, reader.clock.measure),
                                    reader.clock.measure.note));
    clip.length_s = reader.clock.end_s;
  }
  check_scripts(reader);
  fill_tracks(clip, reader);
  return clip;
}

}  // namespace mien

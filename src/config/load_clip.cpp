#include "config/load_clip.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "config/constants.hpp"
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

// A formula of so many bytes takes twice as long as the shortest.
constexpr double kWorkBytes = 64;
constexpr double kPoseWork = 3;  // of a cue without formulas, a frame: it is played, leaned and judged
// How often a formula's number is asked for: in a frame, and besides in a frame's steps for its swings, of
// which there are no more than that (timeline/jitter.cpp).
constexpr double kAsked = 4, kSteps = 8, kMostSteps = 200'000;

double compute_work(const Formula& formula) {
  return 1 + static_cast<double>(count_bytes_used(formula)) / kWorkBytes;
}

double compute_work(const FormulaPointer& formula) { return formula ? compute_work(*formula) : 0; }

// Of a pose's formulas, once.
double compute_work(const PoseKey& key) {
  if (!key.live) return 0;
  double work = compute_work(key.live->strength.formula);
  for (const LivePose::Share& share : key.live->shares) work += compute_work(share.weight.formula);
  for (const LivePose::Value& value : key.live->values) work += compute_work(value.formula);
  return work;
}

template <typename Key>
double compute_work(const Key& key) {
  double work = 0;
  for (const FormulaPointer& formula : key.live) work += compute_work(formula);
  return work;
}

// What asking for a number over so many frames comes to.
double compute_asked(double frames) { return kAsked * frames + std::min(kSteps * frames, kMostSteps); }

// What each script asks for in a frame, by its clip.
using ScriptWork = std::map<const ClipSpec*, double>;

double compute_frame_work(const ClipSpec& script, ScriptWork& known);

double compute_frame_work(const CueSpec& cue, ScriptWork& known) {
  return kPoseWork + kAsked * compute_work(cue.what) +
         (cue.script ? compute_frame_work(*cue.script, known) : 0.0);
}

// At its busiest moment.
double compute_frame_work(const ClipSpec& script, ScriptWork& known) {
  if (const auto found = known.find(&script); found != known.end()) return found->second;
  std::vector<std::pair<double, double>> changes;  // of what there is, by time
  for (const CueSpec& cue : script.cues) {
    const double work = compute_frame_work(cue, known);
    changes.emplace_back(cue.from_s, work);
    changes.emplace_back(cue.end_s, -work);
  }
  std::ranges::sort(changes);
  double now = 0, most = 0;
  for (const auto& [time_s, work] : changes) most = std::max(most, now += work);
  double keys = 0;
  for (const PoseKey& key : script.keys) keys = std::max(keys, compute_work(key));
  return known[&script] = kPoseWork + kAsked * keys + most;
}

// The swings that are looked for in a script, a step.
double compute_script_swings(const ClipSpec& script) {
  double work = script.turn.size() > 1 ? 3 : 0;
  for (const CueSpec& cue : script.cues) work += compute_work(cue.what);
  return work;
}

template <typename Key>
double compute_keys_work(const std::vector<Key>& keys, double end_s, int fps) {
  double work = 0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const double from_s = i == 0 ? 0 : keys[i - 1].at_s;
    const double to_s = i + 1 == keys.size() ? std::max(end_s, keys[i].at_s) : keys[i + 1].at_s;
    work += compute_work(keys[i]) * compute_asked((to_s - from_s) * fps);
  }
  return work;
}

// Trying a formula at each of so many times, and no further if that is too much.
void check_number(const FormulaPointer& formula, const ClipReader& reader,
                  const std::vector<double>& times_s) {
  double& work = reader.library->counts->work;
  if (work > kMaxWork) return;
  work += static_cast<double>(times_s.size()) * compute_work(*formula);
  if (work <= kMaxWork) return check_formula(formula, reader.formulas, times_s);
  const auto found =
      std::ranges::find(reader.library->formulas, formula, [](const auto& pair) { return pair.first; });
  if (found != reader.library->formulas.end())
    add_mistake(
        found->second,
        fmt::format("with {} the formulas before it take too long to try at every time; expected fewer, "
                    "shorter ones or fewer that use each other",
                    describe_subject(found->second)));
}

void check_pose(const PoseKey& key, const ClipReader& reader, const std::vector<double>& times_s) {
  if (!key.live) return;
  for (const LivePose::Share& share : key.live->shares)
    if (share.weight.formula) check_number(share.weight.formula, reader, times_s);
  if (key.live->strength.formula) check_number(key.live->strength.formula, reader, times_s);
  for (const LivePose::Value& value : key.live->values) check_number(value.formula, reader, times_s);
}

void check_pose(const TurnKey& key, const ClipReader& reader, const std::vector<double>& times_s) {
  for (const FormulaPointer& formula : key.live)
    if (formula) check_number(formula, reader, times_s);
}

void check_pose(const CameraKey& key, const ClipReader& reader, const std::vector<double>& times_s) {
  for (const FormulaPointer& formula : key.live)
    if (formula) check_number(formula, reader, times_s);
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
  for (const TrackLaw& law : clip.laws) {
    const double from_s = std::clamp(law.from_s, 0.0, clip.length_s);
    const double to_s = std::clamp(law.end_s, from_s, std::max(from_s, clip.length_s));
    if (law.value.formula) check_number(law.value.formula, reader, list_times(from_s, to_s, clip.fps));
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

// A file alone, or with the time when it begins.
void load_sound(const YamlValue& value, const ClipClock& clock, std::optional<SoundSpec>& into) {
  std::optional<FileReference> file;
  double at_s = 0;
  if (find_node(value).kind == NodeKind::text) {
    load_file(value, file);
  } else {
    const YamlMapping entries = load_section(value);
    if (const YamlValue* named = find_required(entries, "file", value, "a file such as voice.wav"))
      load_file(*named, file);
    if (const YamlValue* at = find_value(entries, "at")) load_duration(*at, clock, at_s);
  }
  if (file) into = SoundSpec{*file, at_s};
}

}  // namespace

bool count_part(const YamlValue& item, const ClipReader& reader) {
  if (reader.library == nullptr) return true;
  std::size_t& parts = reader.library->counts->parts;
  if (++parts == kMaxParts + 1)
    add_mistake(item,
                fmt::format("more than {} keys, cues, laws and tracks; expected fewer (those of a script "
                            "count for each set of parameters that it is played with)",
                            kMaxParts));
  return parts <= kMaxParts;
}

double compute_work(const ClipSpec& clip) {
  ScriptWork scripts;
  double work = compute_keys_work(clip.keys, clip.length_s, clip.fps) +
                compute_keys_work(clip.turn, clip.length_s, clip.fps) +
                compute_keys_work(clip.camera, clip.length_s, clip.fps);
  for (const CueSpec& cue : clip.cues) {
    const double from_s = std::clamp(cue.from_s, 0.0, clip.length_s);
    const double frames =
        (std::clamp(cue.end_s, from_s, std::max(from_s, clip.length_s)) - from_s) * clip.fps;
    work += frames * kPoseWork + compute_asked(frames) * compute_work(cue.what);
    if (cue.script)
      work += frames * compute_frame_work(*cue.script, scripts) +
              std::min(kSteps * frames, kMostSteps) * compute_script_swings(*cue.script);
  }
  for (const TrackLaw& law : clip.laws) {
    const double from_s = std::clamp(law.from_s, 0.0, clip.length_s);
    const double to_s = std::clamp(law.end_s, from_s, std::max(from_s, clip.length_s));
    work += compute_asked((to_s - from_s) * clip.fps) * (1 + compute_work(law.value.formula));
  }
  return work;
}

void check_work(const std::vector<const ClipSpec*>& clips, const YamlValue& place) {
  double work = 0;
  for (const ClipSpec* clip : clips) work += compute_work(*clip);
  if (work > kMaxWork)
    add_mistake(place,
                fmt::format("{} is {:.3g} numbers to work out over its {} frames; expected {:.3g} at most: "
                            "fewer cues, laws and formulas at one time, or a shorter clip (a script "
                            "counts with all that it plays)",
                            describe_subject(place), work, count_frames(*clips.front()), kMaxWork));
}

ClipClock build_clip_clock(int fps, const NamedTimes* times) {
  ClipClock clock{build_time_measure(fps), static_cast<double>(kMaxFrames) / fps, 0, times, {}};
  clock.measure.note = fmt::format(" ({} frames)", kMaxFrames);
  return clock;
}

void load_fps(const YamlMapping& entries, int& into) {
  if (const YamlValue* fps = find_value(entries, "fps")) load_whole(find_deciding(*fps, true), into);
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
  for (const TrackLaw& law : clip.laws)
    last_s = std::max(last_s, std::isfinite(law.end_s) ? law.end_s : std::max(law.full_s, 0.0));
  return last_s;
}

void load_layers(const YamlMapping& entries, const ClipReader& reader, ClipSpec& into) {
  // Of two keys at one time the later read one counts.
  const auto merge = [](auto& keys, auto more) {
    std::set<double> times_s;
    for (const auto& key : more) times_s.insert(key.at_s);
    std::erase_if(keys, [&](const auto& other) { return times_s.contains(other.at_s); });
    for (auto key = more.begin(); key != more.end(); ++key)
      if (std::next(key) == more.end() || std::next(key)->at_s != key->at_s) keys.push_back(std::move(*key));
    std::ranges::stable_sort(keys, [](const auto& a, const auto& b) { return a.at_s < b.at_s; });
  };
  merge(into.keys, load_pose_keys(entries, reader));
  merge(into.camera, load_camera_keys(entries, reader));
  merge(into.turn, load_turn_keys(entries, reader));
  load_tables(entries, reader, into);
  load_cues(entries, reader, into.cues);
  load_laws(entries, reader, into);
  std::ranges::stable_sort(into.cues, [](const CueSpec& a, const CueSpec& b) {
    return std::pair(a.layer, a.from_s) < std::pair(b.layer, b.from_s);
  });
  std::ranges::stable_sort(into.laws, {}, &TrackLaw::from_s);
  into.lead = reader.lead;
  into.length_s = compute_last_s(into);
  if (const YamlValue* length = find_value(entries, "length"))
    into.has_length = load_duration(find_deciding(*length, false), reader.clock, into.length_s);
  // A clip that is read again when its length is known (load_spec.cpp) is tried then.
  const RuntimeUse* use = reader.formulas.words.use;
  if (use == nullptr || !use->is_asked) check_formulas(into, reader);
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
  if (setting.counts != nullptr) library.counts = setting.counts;
  reader.formulas.count = &library.counts->formulas;
  reader.formulas.fps = clip.fps;
  reader.formulas.words.fps = clip.fps;
  if (value != nullptr && value->constants != nullptr) reader.formulas.words = value->constants->words;
  if (setting.is_everybodys) reader.of = ClipOf::everybody;
  if (setting.shared != nullptr) reader.of = ClipOf::actor;
  if (setting.inputs != nullptr) reader.formulas.inputs = *setting.inputs;
  if (value != nullptr) reader.files.push_back(find_canonical(value->document->source.file));
  load_draw(entries, reader.clock, clip);
  load_between(entries, reader.between);
  reader.lead = load_lead(entries, reader.clock);
  load_includes(entries, reader, clip);
  if (const YamlValue* inputs = find_value(entries, "inputs"))
    load_inputs(*inputs, {}, reader.clock, reader.formulas);
  if (setting.found != nullptr) *setting.found = reader.formulas.inputs;
  set_constants(build_constants(reader.formulas), entries);
  load_scripts(entries, reader);
  load_layers(entries, reader, clip);
  load_idle(entries, reader.clock, clip);
  if (const YamlValue* sound = find_value(entries, "sound")) load_sound(*sound, reader.clock, clip.sound);
  load_say(entries, reader, clip.say);
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

// The parts of `clip:`, each from the clip's entries to its field of clip_spec.hpp.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "config/clip_spec.hpp"
#include "config/expressions.hpp"
#include "config/load_formula.hpp"
#include "config/named_times.hpp"
#include "config/sections.hpp"
#include "config/yaml_reader.hpp"

namespace mien {

// What reading times needs.
struct ClipClock {
  Measure measure;
  double end_s = 0;    // the last time that kMaxFrames leave
  double start_s = 0;  // of the clip's time, where the file's own begins
  const NamedTimes* times = nullptr;
  Names others = {};  // actors that one may look at
};

ClipClock build_clip_clock(int fps, const NamedTimes* times = nullptr);

// `fps:` of a clip's entries.
void load_fps(const YamlMapping& entries, int& into);

// A moment, as "1.5s" or {after: ann.hello, delay: 0.3s}, and a length of time; both in whole ticks
// (core/ticks.hpp).
bool load_time(const YamlValue& value, const ClipClock& clock, double& into);
bool load_duration(const YamlValue& value, const ClipClock& clock, double& into);

// `at:` of a key of a track, which must come after `before_s`; that is made this key's then.
void load_key_time(const YamlMapping& entries, const YamlValue& key, const ClipClock& clock,
                   std::optional<double>& before_s, double& into);

// The column `name` of a table of times, into `series`. Mistakes are told at their lines; that there is no
// such column at `asked`.
struct Series;
void load_series_table(const std::filesystem::path& path, const std::string& name, const YamlValue& asked,
                       const ClipClock& clock, Series& series);

// Without `attack` and `release`. Outside its rows a table gives the areas back within these: shorter is a
// jump, longer blurs the first word. A face goes more slowly than it comes, 1.5 to 2 times: one that goes as
// it came looks played backward.
inline constexpr double kTableAttack_s = 0.1, kTableRelease_s = 0.2;
inline constexpr double kReleasePerAttack = 1.75;

// A script as it was written; it is read anew for each set of parameters that it is played with.
struct ScriptText {
  YamlValue body;
  std::shared_ptr<const ExpressionBook> book;  // of the file that it stands in
  ClipClock clock;
  Inputs inputs;
  FormulaWords words;
};

struct TakeTable;

// Everything that all the files of one clip share.
struct ClipLibrary {
  std::map<std::string, ScriptText> scripts;
  std::map<std::string, std::shared_ptr<const ClipSpec>> played;  // by the script's name and its parameters
  // By file, frames a second and `between`: a table that many tracks show is read once.
  std::map<std::tuple<std::string, int, Between>, std::shared_ptr<const TimeTable>> tables;
  std::map<std::string, std::shared_ptr<const TakeTable>> takes;  // by file and how it is read
  std::set<std::string> played_names;
  std::deque<std::pair<FormulaPointer, YamlValue>> formulas;
  // Of `include`, by the file as it is named: values point into them. Empty: it cannot be read, as was told.
  std::map<std::string, std::optional<YamlDocument>> documents;
  std::map<std::filesystem::path, Names> inputs;  // of files included before
  int include_count = 0;
  ClipCounts own;
  ClipCounts* counts = &own;  // of the whole file
};

// Of a file with all that it includes, its scripts once for each set of parameters: ten thousand are an hour
// with a key in each second.
inline constexpr std::size_t kMaxParts = 20'000;

// The work of playing a clip once and of judging it, counted in numbers that are worked out, of some 0.2 us
// each (compute_work): at this many `mien check` takes five seconds.
inline constexpr double kMaxWork = 4e7;

// Whose clip it is: of the only one, of everybody, or of one of several.
enum class ClipOf { one, everybody, actor };

// Where a part of a clip is read: in which file, or in which script.
struct ClipReader {
  ClipClock clock;
  std::shared_ptr<const ExpressionBook> book;
  FormulaReader formulas;
  Between between = Between::ease;  // of keys that say nothing of it
  LeadSpec lead;
  ClipLibrary* library = nullptr;
  ClipOf of = ClipOf::one;
  std::vector<std::string> scripts;          // being read, the outermost first
  std::vector<std::filesystem::path> files;  // the same of files
};

// Counts one more key, cue, law or track; false if there are too many, which is told once, at the first one.
bool count_part(const YamlValue& item, const ClipReader& reader);

// How many numbers `mien check` works out for a clip: three a frame for each cue while it is there, a formula
// some twelve times (in all steps of a frame, for its swings), one of 64 bytes as two, and a script for all
// that it has at its busiest moment.
double compute_work(const ClipSpec& clip);

// Tells a mistake at `place` if of all clips of a file that is more than kMaxWork.
void check_work(const std::vector<const ClipSpec*>& clips, const YamlValue& place);

// `between:` and `ease:` of a key.
void load_way(const YamlMapping& entries, const ClipReader& reader, Ease& ease, Between& between);
void load_between(const YamlMapping& entries, Between& into);

// The pose of a key or a cue at its time: `express`, `strength`, `exaggerate`, `areas`. Without them it is
// neutral. Returns how long it takes to come, s.
Express load_pose(const YamlMapping& entries, const ClipReader& reader, PoseKey& key);

// `keys:`, `camera:` and `turn:`; empty if there is no such key.
std::vector<PoseKey> load_pose_keys(const YamlMapping& clip, const ClipReader& reader);
std::vector<CameraKey> load_camera_keys(const YamlMapping& clip, const ClipReader& reader);
std::vector<TurnKey> load_turn_keys(const YamlMapping& clip, const ClipReader& reader);

// `cues:`, `laws:` and `tracks:`, appended.
void load_cues(const YamlMapping& clip, const ClipReader& reader, std::vector<CueSpec>& into);
void load_laws(const YamlMapping& clip, const ClipReader& reader, ClipSpec& into);
void load_tables(const YamlMapping& clip, const ClipReader& reader, ClipSpec& into);

// `say:`, appended.
void load_say(const YamlMapping& clip, const ClipReader& reader, std::vector<SaySpec>& into);

// `attack: 0.4s`, `release: 0.8s` of a cue, a law or a table; false if there is none.
bool load_duration(const YamlMapping& entries, std::string_view key, const ClipClock& clock, double& into);
void load_rule(const YamlMapping& entries, Rule& into);

// A time table of moves; empty, with mistakes told in it, if it is wrong.
std::shared_ptr<const TimeTable> load_move_table(const std::filesystem::path& file, int fps,
                                                 Findings& findings);

// `scripts:` into the library.
void load_scripts(const YamlMapping& clip, const ClipReader& reader);
// The script that `name` names, with its parameters; empty if there is no such script or it is being read
// already.
std::shared_ptr<const ClipSpec> play_script(const YamlValue& name, const YamlValue* parameters,
                                            const ClipReader& reader);
// Reads the scripts that nobody played, for their mistakes.
void check_scripts(const ClipReader& reader);

// `include:`: the other files' tracks, cues, laws, scripts and inputs.
void load_includes(const YamlMapping& clip, ClipReader& reader, ClipSpec& into);

// All that a file's or a script's entries ask of these, on top of what is there; by time.
void load_layers(const YamlMapping& entries, const ClipReader& reader, ClipSpec& into);

// The last time of any key, and of any cue that ends.
double compute_last_s(const ClipSpec& clip);

// `draw:` and `lead:`.
void load_draw(const YamlMapping& entries, const ClipClock& clock, ClipSpec& clip);
LeadSpec load_lead(const YamlMapping& entries, const ClipClock& clock);

// What the face does by itself: `blink:`, `blinks:`, `gaze:`, `drift:` and `asymmetry:`.
void load_idle(const YamlMapping& entries, const ClipClock& clock, ClipSpec& clip);

}  // namespace mien

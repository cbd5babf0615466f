// The clip of a file as plain values: what moves when. spec.hpp holds the rest of the file.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/areas.hpp"
#include "config/formula.hpp"
#include "config/head_spec.hpp"
#include "config/idle_spec.hpp"
#include "config/ledger.hpp"
#include "config/live_pose.hpp"
#include "core/staging.hpp"

namespace mien {

enum class Easing { linear, in, out, in_out, hold, back, bounce, bezier };

// How the way to a key is shared out over its time.
struct Ease {
  Easing kind = Easing::in_out;
  std::array<double, 4> handles{};  // of a bezier: x1 y1 x2 y2, x from 0 to 1

  Ease() = default;
  Ease(Easing kind_) : kind(kind_) {}
  bool operator==(const Ease&) const = default;
};

// What the way to a key is: eased from key to key, or a curve through all of them.
enum class Between {
  ease,    // each way by itself, as its `ease` says
  linear,  // straight
  smooth,  // a curve that never passes its keys
  spline,  // the natural cubic spline
};

// How long after the first of them each sets out, and how much earlier than the last it arrives.
struct LeadSpec {
  std::array<double, kLeadCount> after_s{};  // in the order of LeadPart; all 0: together
  bool suits_shapes = false;                 // others lead where a mouth goes to a certain shape (lead.hpp)
};

// An order of the areas, as the table of areas has it.
constexpr LeadSpec build_lead_spec(double AreaLead::*after_s, bool suits_shapes = false) {
  LeadSpec spec{{}, suits_shapes};
  for (const AreaInfo& area : kAreas)
    spec.after_s[static_cast<std::size_t>(area.lead.part)] = area.lead.*after_s;
  spec.after_s[static_cast<std::size_t>(kHeadLead.part)] = kHeadLead.*after_s;
  return spec;
}

// `lead: natural`.
inline constexpr LeadSpec kNaturalLead = build_lead_spec(&AreaLead::natural_s, true);

// How long each part of the face takes to come off a key, s, on the way to the next one; it sets out at once
// and then rests until the next key's time. Below 0: as the clip's lead has it.
using Release = std::array<double, kFacePartCount>;
inline constexpr Release kNoRelease = [] {
  Release release{};
  release.fill(-1);
  return release;
}();

// One key of the performance. The pose is what `express`, `strength` and `areas` come to.
struct PoseKey {
  double at_s = 0;
  Ease ease;          // how the way from the key before to this one is gone
  Pose pose;          // at `at_s`, of a live one
  std::string label;  // "smile 0.8": for messages and charts
  double reach = 1;   // as of an expression
  std::vector<Held> held = {};
  Between between = Between::ease;
  std::shared_ptr<const LivePose> live = {};  // instead of `pose`, if numbers of it are formulas
  Place place = {};                           // in the file; nothing for a key that mien adds
  Release release = kNoRelease;
};

// What the camera looks at.
struct Aim {
  enum class Kind { frame, landmark, point };
  Kind kind = Kind::frame;  // frame: the middle of all that is to be seen
  std::string actor;        // of the landmark; empty: the only one
  std::string landmark;     // where it lies on the resting face: the camera does not shake with it
  glm::dvec3 point_mm{0};
};

struct CameraKey {
  double at_s = 0;
  Ease ease;
  double angle_deg = 0;   // about the head, + shows more of the character's left side
  double height_deg = 0;  // + looks down from above
  double distance = 1;    // 1 frames the whole bust at any picture shape; 0.5 is half as far
  Between between = Between::ease;
  std::array<FormulaPointer, 3> live = {};  // instead of the numbers, in their order
  double lens_mm = kPortraitLens_mm;
  Aim aim;
};

// A neck's ways to each side.
inline constexpr double kMaxTurn_deg = 60, kMaxNod_deg = 40, kMaxTilt_deg = 30;

struct TurnKey {
  double at_s = 0;
  Ease ease;
  double turn_deg = 0;  // head to the character's left (+)
  double nod_deg = 0;   // chin down (+)
  double tilt_deg = 0;  // crown toward the character's left shoulder (+)
  Between between = Between::ease;
  std::array<FormulaPointer, 3> live = {};
  double breath_mm = 0;  // how far a breath has lifted the shoulders; no key says it
  Place place = {};      // in the file
};

// Where an actor stands, as the place of spec.hpp.
struct PlaceKey {
  double at_s = 0;
  Ease ease;
  glm::dvec3 to_mm{0};
  double turn_deg = 0;
  Between between = Between::ease;
  Place place = {};  // in the file
};

// What an author may write for the camera's and the head's numbers, and where curves and formulas are held.
struct Bounds {
  double low, high;
};
inline constexpr std::array<Bounds, 3> kCameraBounds{{{-360, 360}, {-60, 80}, {0.2, 4}}};
inline constexpr std::array<Bounds, 3> kTurnBounds{
    {{-kMaxTurn_deg, kMaxTurn_deg}, {-kMaxNod_deg, kMaxNod_deg}, {-kMaxTilt_deg, kMaxTilt_deg}}};

// A table of moves in time.
struct TimeTable {
  std::vector<std::size_t> moves;  // one a column
  std::vector<double> at_s;        // rising
  std::vector<double> values;      // row by row
  Between between = Between::linear;
};

// Who has an area where several ask for it.
enum class Rule {
  over,   // the later one, which covers what lies below
  add,    // both: their sum
  max,    // whoever moves it further from rest
  share,  // all that say so, by their weights
};

// Layers lie on the keys, the higher upon the lower; within one, later ones upon earlier ones.
enum class Layer { table, cue, speech, law };

inline constexpr double kForever_s = std::numeric_limits<double>::infinity();

struct ClipSpec;

// Something that begins, is there for a while and goes: 0 at `from_s` and at `end_s`, all there between
// `full_s` and `ebb_s`. What it shows is a script's or a table's or, without both, `what`.
struct CueSpec {
  double from_s = 0, full_s = 0, ebb_s = kForever_s, end_s = kForever_s;
  Layer layer = Layer::cue;
  Rule rule = Rule::over;
  bool has_lead = true;  // comes and goes area by area, as the clip's `lead` says
  double amount = 1;     // how much of it there is when it is all there
  std::bitset<kChannelCount> owns;
  PoseKey what;  // its time is not looked at
  std::shared_ptr<const ClipSpec> script = {};
  bool is_repeated = false;                     // begins anew whenever its length is over
  std::shared_ptr<const TimeTable> table = {};  // its times count from `start_s`
  double start_s = 0;                           // when a script's or a table's time is 0
};

// What a law moves that is no area: a number of one of these tracks (law_numbers.hpp).
enum class LawTrack { camera, turn, light, place };

// A number of a track that follows a formula while the law is there, upon the track's keys. It comes and goes
// as a CueSpec.
struct TrackLaw {
  LawTrack track = LawTrack::camera;
  std::size_t number = 0;
  double from_s = 0, full_s = 0, ebb_s = kForever_s, end_s = kForever_s;
  Rule rule = Rule::over;
  Number value;
  Bounds range{0, 0};  // the value is held there
  double shift = 0;    // what the track's number lacks of the author's: of a camera as an actor sees it
  std::string label;   // "law of camera.angle"
  Place place = {};    // in the file
};

// From the first frame at `at_s` or later on.
struct DrawChange {
  double at_s = 0;
  int draw = 1;
};

// The head as it is at one time: the file's own `head:` with all that this key and those before it changed.
struct HeadKey {
  double at_s = 0;
  Ease ease;
  HeadSpec head;
};

// One of the light sets of templates/povray, faded from key to key.
struct LightKey {
  double at_s = 0;
  Ease ease;
  std::string set = "studio";
  double brightness = 1;
  double angle_deg = 0;  // about the head: + brings the light round to the character's left
};

// What lies behind: a background of templates/povray, or a colour.
struct BackgroundKey {
  double at_s = 0;
  Ease ease;
  std::string name = "studio";
  std::optional<glm::vec3> colour;  // instead of a named one; srgb 0..1
};

// A file that the clip is given.
struct SoundSpec {
  FileReference file;
  double at_s = 0;
};

// A line that is said: by a voice that is made, by a recording, or without a sound.
struct SaySpec {
  double at_s = 0;
  std::string text;             // "*words*" are stressed; empty: `mouths` says it all
  std::string voice = "en-us";  // as eSpeak NG names it
  double pace = 1;
  std::optional<FileReference> sound = {}, mouths = {};
  double strength = 1;     // of all that the mouth does
  double share = 1.0 / 3;  // how much of the feeling's the mouth's corners keep
  double still = 0;        // 1: nothing but the mouth moves
  Place place = {}, text_place = {}, voice_place = {}, mouths_place = {};  // in the file
};

// What is heard of a line.
struct SpokenSound {
  double at_s = 0;
  std::filesystem::path file = {};              // this one,
  std::shared_ptr<const std::string> wav = {};  // or these bytes
};

// A word or a sound of a line, for charts.
struct SpokenWord {
  double from_s = 0, to_s = 0;
  std::string text;
  Place place = {};  // of its line, in the file
};

struct ClipSpec {
  int fps = 24;
  int draw = 1;                               // each drawing is held for this many frames: ones, twos, threes
  std::vector<DrawChange> draw_changes = {};  // by time
  std::vector<PoseKey> keys;         // by time, at least one: a missing list is one neutral key at 0 s
  std::vector<CameraKey> camera;     // by time, at least one
  std::vector<TurnKey> turn;         // by time, at least one
  std::vector<CueSpec> cues = {};    // by layer, then by time
  std::vector<TrackLaw> laws = {};   // of camera, turn, light and place, by time
  LeadSpec lead = {};                // of a file that says nothing of it kNaturalLead
  std::vector<HeadKey> head = {};    // by time; none: one head for the whole clip
  std::vector<PlaceKey> place = {};  // by time; none: the actor stays where it stands
  double enters_s = 0, leaves_s = kForever_s;  // when an actor is there: from the one until before the other
  std::vector<LightKey> light = {};            // by time; none: the studio
  std::vector<BackgroundKey> background = {};  // by time; none: as `render:` says
  std::vector<double> blinks_s;                // blinks asked for at exact times (their shut moment)
  BlinkSpec blink;
  GazeSpec gaze;
  DriftSpec drift;
  AsymmetrySpec asymmetry;
  std::optional<SoundSpec> sound = {};
  std::vector<SaySpec> say = {};          // by time
  std::vector<SpokenSound> spoken = {};   // what `say` comes to, added when it is spoken (voice/speech.hpp)
  std::vector<SpokenWord> words = {};     // likewise
  std::vector<SpokenWord> phonemes = {};  // likewise, in IPA
  bool has_length = false;                // it is the author's
  double length_s = 0;  // `length:`, else the time of the last key of any track, or where the last cue ends
};

// The number of frames of the clip: one at 0 s and one each 1/fps after it, up to and including `length_s`
// rounded to the frame; at least 1. 3 s at 24 frames a second are 72 frames: the frame at 3 s would be the
// first of the next second and is left out, unless the clip is a single moment.
int count_frames(const ClipSpec& clip);

// For how many frames the drawing of frame `frame` (from 0) is held.
int find_draw(const ClipSpec& clip, int frame);

// The frame (from 0) whose drawing frame `frame` shows: itself, or an earlier one where drawings are held.
int compute_drawn_frame(const ClipSpec& clip, int frame);

}  // namespace mien

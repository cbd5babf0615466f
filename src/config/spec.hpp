// One YAML file as plain values: every key has its default here, and a default gives a good picture.
// load_spec.hpp fills it; nobody changes it afterwards.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "config/areas.hpp"
#include "config/ledger.hpp"
#include "core/error.hpp"

namespace mien {

// Weights by name, each above 0, summing to 1: `age: adult` is {{"adult", 1}}.
using Mix = std::map<std::string, double>;

struct Look {
  glm::vec3 skin{0.863f, 0.682f, 0.561f};  // "#dcae8f", srgb 0..1
  std::optional<glm::vec3> lips;           // empty: made from the skin's colour
  glm::vec3 iris{0.357f, 0.498f, 0.584f};  // "#5b7f95"
  glm::vec3 brow{0.227f, 0.165f, 0.125f};  // "#3a2a20"
  glm::vec3 hair{0.20f, 0.14f, 0.10f};     // "#332419"
};

// A file that another file names, as found from the folder of the file that names it.
struct FileReference {
  std::filesystem::path path;
  Place place;  // where it is named, for messages
};

// One local edit: the skin within `radius_mm` of a landmark follows `move_mm`, less and less outward.
struct SculptStroke {
  std::string at;  // a landmark ("chin" and other plain names are aliases of codes)
  glm::dvec3 move_mm{0};
  double radius_mm = 20;
};

struct HeadShare;

struct HeadSpec {
  std::optional<FileReference> mesh;  // the user's own half head, instead of the shipped one
  std::optional<FileReference> scan;  // a digitised head, wrapped by the shipped one
  std::vector<HeadShare> mix;         // heads of other files, mixed; weights sum to 1
  std::vector<SculptStroke> sculpt;   // in the order they were written, after all else
  std::string hair = "none";          // a cut of templates/head/hair.yaml; none: a bald head
  Mix age{{"adult", 1.0}};
  Mix skull{{"average", 1.0}};
  double character = 0;                    // -1 female .. 0 neither .. 1 male
  std::map<std::string, double> guides;    // guide line -> fraction of head height above the chin
  std::map<std::string, double> features;  // feature -> -1..1
  std::map<std::string, double> limits;    // limit of an area -> share of the head's own, 0..2
  Look look;
};

struct HeadShare {
  HeadSpec head;
  double weight = 1;
};

// A named expression after `from:` and the library were looked up: the whole pose.
struct Expression {
  std::string name;     // "smile"
  std::string library;  // "mien", "tezuka", or "" for one of the file's own
  Pose pose;
  double reach = 1;             // how many times its limits the pose may go: `exaggerate`
  std::vector<Held> held = {};  // what the limits held back of it
};

enum class Easing { linear, in, out, in_out, hold };

// One key of the performance. The pose is what `express`, `strength` and `areas` come to.
struct PoseKey {
  double at_s = 0;
  Easing ease = Easing::in_out;  // how the way from the key before to this one is gone
  Pose pose;
  std::string label;  // "smile 0.8": for messages and charts
  double reach = 1;   // as of an expression
  std::vector<Held> held = {};
};

struct CameraKey {
  double at_s = 0;
  Easing ease = Easing::in_out;
  double angle_deg = 0;   // about the head, + shows more of the character's left side
  double height_deg = 0;  // + looks down from above
  double distance = 1;    // 1 frames the whole bust at any picture shape; 0.5 is half as far
};

struct TurnKey {
  double at_s = 0;
  Easing ease = Easing::in_out;
  double turn_deg = 0;  // head to the character's left (+)
  double nod_deg = 0;   // chin down (+)
  double tilt_deg = 0;  // crown toward the character's left shoulder (+)
};

struct BlinkSpec {
  double per_minute = 0;  // 0: no blinks of their own
  std::uint64_t seed = 1;
};

struct ClipSpec {
  int fps = 24;
  int draw = 1;                   // each drawing is held for this many frames: ones, twos, threes
  std::vector<PoseKey> keys;      // by time, at least one: a missing list is one neutral key at 0 s
  std::vector<CameraKey> camera;  // by time, at least one
  std::vector<TurnKey> turn;      // by time, at least one
  std::vector<double> blinks_s;   // blinks asked for at exact times (their shut moment)
  BlinkSpec blink;
  double length_s = 0;  // `length:`, else the time of the last key of any track
};

enum class Quality { draft, good, best };

struct RenderSpec {
  int width_px = 480, height_px = 600;
  Quality quality = Quality::good;
  std::string background = "studio";  // a background of templates/povray
};

struct BustSpec {
  Expression expression;  // what `express` and `areas` come to; library and name for file names
  double height_mm = 80;  // whole print, base included
};

struct Spec {
  std::filesystem::path file;  // as given on the command line
  std::string name;            // file name without folder and ending: out/<name>/
  std::string title;
  HeadSpec head;
  double exaggerate = 1;                // of every key and bust that says none of its own
  std::string library = "mien";         // where a plain expression name is looked up after the file's own
  std::vector<Expression> expressions;  // all that can be named here: the file's own, then every library's
  ClipSpec clip;
  RenderSpec render;
  std::vector<BustSpec> busts;
};

// The number of frames of the clip: one at 0 s and one each 1/fps after it, up to and including `length_s`
// rounded to the frame; at least 1. 3 s at 24 frames a second are 72 frames: the frame at 3 s would be the
// first of the next second and is left out, unless the clip is a single moment.
int count_frames(const ClipSpec& clip);

}  // namespace mien

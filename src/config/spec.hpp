// One YAML file as plain values: every key has its default here, and a default gives a good picture.
// load_spec.hpp fills it; nobody changes it afterwards.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "config/areas.hpp"
#include "config/clip_spec.hpp"
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

// Between those of surprise (0.2 s) and of sadness (1.5 s): Recio et al. (2013) find that most expressions
// are known at any from 0.2 to 0.9 s.
inline constexpr double kDefaultAttack_s = 0.5;

// A named expression after `from:` and the library were looked up: the whole pose.
struct Expression {
  std::string name;     // "smile"
  std::string library;  // "mien", "tezuka", or "" for one of the file's own
  Pose pose;
  double reach = 1;                    // how many times its limits the pose may go: `exaggerate`
  std::vector<Held> held = {};         // what the limits held back of it
  double attack_s = kDefaultAttack_s;  // how long it takes to come, as a cue
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

}  // namespace mien

// One YAML file as plain values: every key has its default here, and a default gives a good picture.
// load_spec.hpp fills it; nobody changes it afterwards.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "config/areas.hpp"
#include "config/clip_spec.hpp"
#include "config/head_spec.hpp"
#include "config/ledger.hpp"
#include "core/staging.hpp"

namespace mien {

// Between those of surprise (0.2 s) and of sadness (1.5 s): Recio et al. (2013) find that most expressions
// are known at any from 0.2 to 0.9 s.
inline constexpr double kDefaultAttack_s = 0.5;

// A named expression after `from:` and the library were looked up: the whole pose.
struct Expression {
  std::string name;     // "smile"
  std::string library;  // "mien", "tezuka", or "" for one of the file's own
  Pose pose;
  double reach = 1;                           // how many times its limits the pose may go: `exaggerate`
  std::vector<Held> held = {};                // what the limits held back of it
  double attack_s = kDefaultAttack_s;         // how long it takes to come, as a cue
  std::shared_ptr<const Manner> manner = {};  // plain without it
  bool follows_thesis = false;                // its library says `rules: thesis`
  std::size_t numbers = 0;  // that stand in its text, both sides of an area as one; with what it starts from
};

struct BustSpec {
  Expression expression;       // what `express` and `areas` come to; library and name for file names
  double height_mm = 80;       // whole print, base included
  std::string base = "round";  // a word of kBaseWords
  std::string label;           // raised on the base's front
  bool is_hollow = false;
  double wall_mm = 2;       // of a hollow one
  double drain_mm = 4;      // diameter of its drain holes; 0: none
  glm::dvec2 magnet_mm{0};  // diameter and depth of a pocket in the underside; 0: none
  int triangles = 0;        // of the figure; 0: as many as its height asks for
};

// Where somebody stands: the origin of conventions.hpp moved to `at_mm`, the whole figure turned about its
// upright axis there.
struct PlaceSpec {
  glm::dvec3 at_mm{0};
  double turn_deg = 0;  // to the character's left (+)
};

// One of several who play together. Frames a second, drawings and length are the file's for all.
struct ActorSpec {
  std::string name;  // empty: the only one of a file without `actors`
  HeadSpec head;
  PlaceSpec place;
  ClipSpec clip;
};

struct MappingData;  // mapping_data.hpp

struct Spec {
  std::filesystem::path file;                // as given on the command line
  std::vector<std::filesystem::path> files;  // all that it is read from: itself, and what it names
  std::string name;                          // file name without folder and ending: out/<name>/
  std::string title;
  std::string author, licence;  // for files that say so
  HeadSpec head;
  bool keeps_to_nine = false;           // `head: {areas: nine}`: nothing moves but Tezuka's areas
  double exaggerate = 1;                // of every key and bust that says none of its own
  std::string library = "mien";         // where a plain expression name is looked up after the file's own
  std::vector<Expression> expressions;  // all that can be named here: the file's own, then every library's
  std::shared_ptr<const MappingData> mappings = {};  // by which notations of action units are read
  ClipSpec clip;                                     // with actors: what concerns all of them
  std::vector<ActorSpec> actors;  // in the file's order; none: `head` and `clip` are the only one's
  RenderSpec render;
  std::vector<BustSpec> busts;
  glm::dvec2 plate_mm{0};  // of the printer, on which all busts are to be arranged; 0: none
};

// Those who play: the file's actors, else the only one.
std::vector<ActorSpec> list_actors(const Spec& spec);

}  // namespace mien

// A head as plain values: what stands under `head:`. load_spec.hpp fills it.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "core/error.hpp"

namespace mien {

// Weights by name, each above 0, summing to 1: `age: adult` is {{"adult", 1}}.
using Mix = std::map<std::string, double>;

// A file that another file names, as found from the folder of the file that names it.
struct FileReference {
  std::filesystem::path path;
  Place place;  // where it is named, for messages
};

struct Look {
  glm::vec3 skin{0.863f, 0.682f, 0.561f};             // "#dcae8f", srgb 0..1
  std::optional<glm::vec3> lips;                      // empty: made from the skin's colour
  glm::vec3 iris{0.357f, 0.498f, 0.584f};             // "#5b7f95"
  glm::vec3 brow{0.227f, 0.165f, 0.125f};             // "#3a2a20"
  glm::vec3 hair{0.20f, 0.14f, 0.10f};                // "#332419"
  std::optional<glm::vec3> brow_old, hair_old;        // on a head that is all `old`; empty: the same
  bool is_brow_given = false, is_hair_given = false;  // by the author: such a colour stays
  std::string beard = "none";                         // one of templates/head/hair.yaml; children have none
  double lips_share = 1;                      // of the way from that colour to `lips`: less only between keys
  double freckles = 0, age_spots = 0;         // 0 none .. 1 as many as a skin has
  std::optional<double> age_spots_old;        // on a head that is all `old`; empty: the same
  bool are_age_spots_given = false;           // by the author: they stay
  std::optional<FileReference> texture = {};  // a picture over the skin, on the atlas of `mien export --uv`
};

// The same with brow, hair and age spots as they are at an age.
Look compute_aged_look(const Look& look, const Mix& age);

// One local edit: the skin within `radius_mm` of a landmark is scaled about it, turned about it, and follows
// `move_mm`, all less and less outward.
struct SculptStroke {
  std::string at;  // a landmark ("chin" and other plain names are aliases of codes)
  glm::dvec3 move_mm{0};
  double radius_mm = 20;
  double scale = 1;
  double turn_deg =
      0;  // counter-clockwise, seen with the axis toward the eye; of the left side, if there are two
  std::string about = "x";  // the axis: x, y or z of conventions.hpp

  bool operator==(const SculptStroke&) const = default;
};

// How far an area goes, as a length.
struct LimitLength {
  double value = 0;
  std::string unit = "mm";  // or a face unit (kFaceUnits)
  Place place = {};
  bool is_shared = false;  // told by a name that several moves have: each goes that far or as far as it can
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
  Mix design{{"real", 1.0}};                   // of templates/head/designs
  double character = 0;                        // -1 female .. 0 neither .. 1 male
  std::map<std::string, double> guides;        // guide line -> fraction of head height above the chin
  std::map<std::string, double> guide_shares;  // of the way there from the head's own line; none: all of it
  std::map<std::string, double> features;      // feature -> -1..1
  std::map<std::string, double> limits;        // limit of an area -> share of the head's own, 0..2
  std::map<std::string, LimitLength> limit_lengths;  // the same as a length; stands above a share
  std::optional<LimitLength> match_level;            // LIPS_MATCH_LEVEL above where the lips meet at rest
  bool follows_thesis = false;  // `rules: thesis`: the areas move as 5.3 says, to the letter
  Look look;
  std::optional<int> random;   // a seed: whatever the file says nothing of was drawn from it (people.hpp)
  std::set<std::string> said;  // what the file said: "skull", "features.nose_length", "look.iris"
};

struct HeadShare {
  HeadSpec head;
  double weight = 1;
};

}  // namespace mien

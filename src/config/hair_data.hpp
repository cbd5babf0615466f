// Cuts of hair and beards: templates/head/hair.yaml as plain values.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "config/findings.hpp"
#include "config/shape_data.hpp"

namespace mien {

struct HairKnot {
  std::string point;     // of the cage's left half
  double up_mm = 0;      // from there, on the adult
  std::string level_of;  // a point whose height it takes instead of its own; empty: its own
};

// A number that differs over the head: stations from the whorl (first) to the hairline (last), evenly spaced.
struct HairSpread {
  std::vector<double> front, side, back;
};

// How locks are combed.
struct HairComb {
  double side_mm = 0, from_deg = 0, to_deg = 0;  // the part: an arc, its degrees behind the top of the head
  double scalp_mm = 0;                           // width of the line of scalp that it shows
  double away = 1, down = 0, back = 0, droop = 0, swirl_deg = 0, jitter_deg = 0;
  double knot_deg = 0;  // where they are gathered, if `is_gathered`
  bool is_gathered = false;
};

// What locks are.
struct HairLocks {
  int count = 0;
  HairSpread length_mm;
  double width_mm = 5, tips_mm = 0, ragged = 0.3, root_band = 0, stand = 0, rise_mm = 10;
  double wave_mm = 0, wave_length_mm = 40, curl_mm = 0, curl_length_mm = 20;
  int rings = 9;
  double from_part = 0;                // share of them that begin at the part
  double deepest = 0.8, risen = 0.28;  // of the mass: where the lowest lie; of its length: out of the skin
  int gathers = 0;                     // in how many they fall together
  double gathered = 0;                 // how close to their middle, 0..1
  double widest = 0;                   // of its length: no lock is wider; 0: as wide as they are
};

// Single hairs.
struct HairDown {
  int count = 0;
  double length_mm = 6, radius_mm = 0.06, band_mm = 6, stand = 0.4;
};

struct HairTail {
  double radius_mm = 0, length_mm = 0, out_mm = 0;
};

// What a cut is in ink. The first two: the locks of its edge, none if 0. The others: what its locks are where
// they are carved, fewer and broader; 0 or less: as they are.
struct HairInk {
  double lock_mm = 0;
  std::array<double, 3> tips_mm{};  // at the front, the side and the back
  int count = 0;
  double width_mm = 0, longer = 1, mass = 0, jitter_deg = -1;
};

// templates/head/hair.yaml says what each number means.
struct HairCut {
  std::string meaning;
  double whorl_deg = 0, centre_mm = 0;
  std::vector<HairKnot> hairline, ends;
  HairSpread thick_mm;
  double edge_mm = 0, round_mm = 0, inset_mm = 7, mass = 0.4, sheet_mm = 6, tuck = 0, scalp = 0.8,
         soft_mm = 5, infant = 1;
  bool covers_ears = false, is_mirrored = false;
  bool is_drawn = false;  // in ink
  HairComb comb;
  HairLocks locks;
  HairDown down;
  double bun_radius_mm = 0;
  HairTail tail;
  HairInk ink;
};

// Part of a beard: how dense it is at named points of the cage's left half (0..1; nothing at all others), and
// which way its hairs lie: outward from the middle, up, forward.
struct BeardArea {
  std::map<std::string, double> density;
  glm::dvec3 way{0, -1, 0};
};

struct Beard {
  std::string meaning;
  std::map<std::string, double> shares;  // of each area
  int count = 0;
  double length_mm = 1, radius_mm = 0.05, stand = 0.5, paint = 0.4;
};

struct BeardData {
  std::map<std::string, BeardArea> areas;
  std::map<std::string, Beard> beards;
};

struct HairData {
  std::map<std::string, HairCut> cuts;  // one for each of kHairs but "none"
  BeardData beards;                     // one for each of kBeards but "none"
};

// Reads templates/head/hair.yaml; what does not fit, and names that `points` has not, is added to the
// findings.
HairData load_hair_data(const std::filesystem::path& file, const PointNames& points, Findings& findings);

}  // namespace mien

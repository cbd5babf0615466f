// A cut of hair: tapered locks over a dark mass, single hairs along its border, and a scalp painted under
// them.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "head/head.hpp"

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
};

// Single hairs.
struct HairDown {
  int count = 0;
  double length_mm = 6, radius_mm = 0.06, band_mm = 6, stand = 0.4;
};

struct HairTail {
  double radius_mm = 0, length_mm = 0, out_mm = 0;
};

// templates/head/hair.yaml says what each means.
struct HairCut {
  double whorl_deg = 0, centre_mm = 0;
  std::vector<HairKnot> hairline, ends;
  HairSpread thick_mm;
  double edge_mm = 0, round_mm = 0, inset_mm = 7, mass = 0.4, sheet_mm = 6, tuck = 0, scalp = 0.8,
         soft_mm = 5, infant = 1;
  bool covers_ears = false, is_mirrored = false;
  HairComb comb;
  HairLocks locks;
  HairDown down;
  double bun_radius_mm = 0;
  HairTail tail;
};

// By name. Throws RunError naming the file for what it does not understand.
std::map<std::string, HairCut> load_hair_cuts(const std::filesystem::path& file);

// One cut of templates/head/hair.yaml. Throws RunError for an unknown one.
HairCut load_hair_cut(const std::string& name);

// The parts of a cut, bound to the skin (Mount::strands): "hair_mass" (closed, and the only one that throws
// shadows; none where hair is too short), "hair" (the locks) and "hair_fine" (single hairs). Nothing for
// "none". Mirror images of each other on both halves where the cut says so. Throws RunError for an unknown
// cut.
std::vector<HeadPart> build_hair(const NeutralHead& head, const std::string& cut, const Look& look);

// How much of the scalp's colour hair hides, 0..1 a vertex of the skin; empty for "none".
std::vector<float> paint_scalp(const NeutralHead& head, const std::string& cut);

}  // namespace mien

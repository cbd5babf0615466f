// A cut of hair as a sculptor would carve it: one closed mass of locks that rides on the skin.
#pragma once

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

// templates/head/hair.yaml says what each means.
struct HairCut {
  double whorl_deg = 0, centre_mm = 0;
  std::vector<HairKnot> hairline;
  std::vector<double> front_mm, side_mm, back_mm;
  double edge_mm = 0, round_mm = 0, sheet_mm = 0, tuck = 0;
  bool covers_ears = false;
  int locks = 0, split = 0;
  double lock_depth_mm = 0, split_depth_mm = 0, tufts = 0, tuft_depth_mm = 0;
  double swirl_deg = 0, wave_deg = 0, tips_mm = 0, infant = 1;
  double bun_radius_mm = 0;
};

// By name. Throws RunError naming the file for what it does not understand.
std::map<std::string, HairCut> load_hair_cuts(const std::filesystem::path& file);

// The part "hair" of a cut of templates/head/hair.yaml, each vertex bound to the skin (Mount::strands);
// nothing for "none". Closed: its underside lies in the skin, or hangs free. Throws RunError for an unknown
// cut.
std::vector<HeadPart> build_hair(const NeutralHead& head, const std::string& cut, const Look& look);

}  // namespace mien

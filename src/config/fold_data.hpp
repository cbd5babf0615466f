// templates/head/folds.yaml as values: where the skin folds and which moves of the face fold it.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "config/area_data.hpp"

namespace mien {

// A place of the left half: a point of the cage, or one a share of the way from it to another.
struct FoldPoint {
  std::string from, to;  // the same: no way to go
  double share = 0;
};

struct FoldLine {
  std::vector<FoldPoint> through;  // at least 2
  std::vector<double> depths;      // shares of the set's depth at even steps along the line; ends are 0
  std::vector<double> ink;  // the same for its stroke where that is drawn otherwise; none: as it is deep
  int file_line = 0;
};

// A product of signed values, each only where positive, times a share.
struct FoldDrive {
  double share = 1;
  std::vector<Driver> drivers;
};

// How unlike each other folds are, and a face's two sides: no line of the skin is ruled.
struct FoldUnevenness {
  std::uint32_t seed = 0;
  double along_mm = 10;  // of a line, that looks alike
  double aside_mm = 0;   // how far it strays at most
  double broken = 0;     // how much shallower its weakest places are, 0..1
  double shared_mm = 8;  // from the mid-line, where both sides begin to differ: they must meet there
};

struct FoldSet {
  std::string name;
  std::vector<FoldDrive> drives;     // summed
  double from = 0, to = 1;           // the sum at which a fold begins and is whole
  double rest = 0;                   // of a whole fold, what an old face at rest has of it
  double always = 0;                 // the same for a face at rest of any age
  std::vector<FoldDrive> stretched;  // summed: what pulls it flat, from 0 to 1
  double depth_mm = 0;               // of the whole fold, on the adult
  double width_mm = 1;               // half width of the groove in the skin at rest
  std::array<double, 2> rolls{};     // height of the swelling left and right of the line, shares of the depth
  double spread = 2;                 // how many widths from the line the swelling is highest
  double uneven = 1;                 // of the file's unevenness
  double edge = 1;                   // of the file's longest edge
  double ink = 0;        // how thick ink draws its lines at their deepest: half of it, in lines; 0: not
  double across_mm = 0;  // how far one side's folds go on over the mid-line; 0: they do not
  std::vector<FoldLine> lines;
};

struct FoldData {
  std::string file;                    // for messages
  std::map<std::string, double> ages;  // age -> how deep folds are against an adult's
  std::map<std::string, double>
      ages_at_rest;             // age -> how much of a set's `rest` its face has; none: nothing
  double female = 1, male = 1;  // the same for characters
  FoldUnevenness uneven;
  double edge = 1;  // longest edge of the skin in a groove, in its widths
  std::vector<FoldSet> sets;
};

// Reads templates/head/folds.yaml; what does not fit, and names that `points` has not, is added to the
// findings.
FoldData load_fold_data(const std::filesystem::path& file, const PointNames& points, Findings& findings);

}  // namespace mien

// What makes the adult's cage into another head, as plain values: templates/head/heads.yaml (ages, skulls,
// charts, warps), fields.csv and features.yaml.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "config/head_spec.hpp"
#include "config/point_names.hpp"
#include "core/monotone.hpp"

namespace mien {

// Heights by the names of config/words.hpp (kGuides, kEarGuides), as fractions of the head's height above the
// chin.
using GuideLines = std::map<std::string, double>;

// One age's chart.
struct GuideChart {
  double height_mm = 229;  // chin to crown
  GuideLines lines;
};

inline const MonotoneCurve kNoChange{{{-1, 1}, {1, 1}}, {0, 0}};  // factor 1 everywhere

// A change of the whole head by height: Loomis' guide lines move y, the widths and depths follow.
struct Warp {
  MonotoneCurve height;  // adult y -> this head's y, mm
  // Factors of x of the skull and of the features, and of z before and behind the ear canals.
  MonotoneCurve outer = kNoChange, inner = kNoChange, front = kNoChange, back = kNoChange;
  double brow_thickness = 1;               // width of the brows
  double eye = 1;                          // size of the ball and its lids
  double carry_e3 = 0.75, carry_e4 = 0.3;  // how far these rings follow the ball instead of the warp
};

// What a slider does at value 1, on the adult; at -1 the same backwards.
struct Feature {
  Handles handles;
  double eye_size = 0;        // share added to the ball and its lids
  glm::dvec2 eye_move_mm{0};  // outward, upward
  double eye_tilt_deg = 0;    // outer corner up
  double ear_size = 0;        // share added
  double ear_out_deg = 0;     // standing out further at 1 ...
  double ear_in_deg = 0;      // ... and less at -1: behind an ear there is not much room
  double brow_thickness = 0;  // share added to the width of the brows
  double character = 0;       // added to the head's
};

struct HeadShapes {
  std::map<std::string, Mix> ages, skulls;   // name -> mix of warps ("adult" and none: the adult itself)
  std::map<std::string, GuideChart> charts;  // of each age
  std::map<std::string, Warp> warps;
  std::map<std::string, Handles> fields;  // after the warp of the same name
  std::map<std::string, Feature> features;
};

// What a slider is called and where it shows.
struct FeatureInfo {
  std::string name;
  std::string meaning;                 // "tip and base of the nose 3 mm lower"
  std::string view = "three_quarter";  // from where it shows best: front, three_quarter or side
  // Where on the left half it shows: landmarks ("en_l"), else the points that it moves.
  std::vector<std::string> around;
};

struct ShapeData {
  HeadShapes heads;
  std::vector<FeatureInfo> features;  // in the file's order
};

// Reads the three files of `folder` (templates/head). What does not fit, and names that `points` has not, is
// added to the findings; a broken line of fields.csv throws RunError "FILE:LINE: ...".
ShapeData load_shape_data(const std::filesystem::path& folder, const PointNames& points, Findings& findings);

}  // namespace mien

// Ages, skulls and character: the adult cage made into another head, by the tables of
// templates/head/heads.yaml.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "config/head_spec.hpp"
#include "head/fields.hpp"
#include "head/guides.hpp"
#include "head/head.hpp"
#include "head/monotone.hpp"

namespace mien {

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

// Reads heads.yaml and, if it is there, features.yaml of `folder` (templates/head). Throws RunError with file
// and line for what it does not understand.
HeadShapes load_head_shapes(const std::filesystem::path& folder);

// The cage and the eye under a warp: the eye's rings and lids follow the ball as a similarity.
HeadForm apply_warp(const Cage& cage, const Eye& eye, const Warp& warp);

// Makes `form`, the adult or a head that stands for it, into the head of `spec`: ages mixed, each with its
// guide lines as far from the adult's as its chart says, then skulls, character and features added at the
// head's size, then guide lines moved. `adult` is the shipped one. Throws InputError if moved guide lines
// cross.
void shape_head(const HeadShapes& shapes, const HeadSpec& spec, const Cage& adult, HeadForm& form);

// Forms are mixed as sums: from nothing, each addition with its weight.
HeadForm make_empty_form(const Cage& cage);
void add_form(HeadForm& sum, const HeadForm& addition, double weight);

// Fuller lips part and thinner ones bare the teeth: brings the two to the contact they have on `adult`,
// column by column, at the form's size against it. What one lip moves its rings share, so the borders hardly
// know.
void close_lips(const Cage& adult, double size, HeadForm& form);

// The guide lines of a head made by `spec` without its own guides.
GuideLines find_guides(const HeadShapes& shapes, const HeadSpec& spec, const Cage& adult, const Eye& eye);

// Where the guide lines stand on a head as it was built, mm: chin, mouth_line, nose_base, eye_line,
// brow_line, hairline and crown (the skin's highest place), upward.
std::vector<std::pair<std::string, double>> measure_guide_heights(const NeutralHead& head);

// A feature as templates/head/features.yaml tells it.
struct FeatureInfo {
  std::string name;
  std::string meaning;                 // "tip and base of the nose 3 mm lower"
  std::string view = "three_quarter";  // from where it shows best: front, three_quarter or side
  // Where on the left half it shows: landmarks ("en_l"), else the points that it moves.
  std::vector<std::string> around;
};

// In the file's order; none if the file is not there. Throws RunError with file and line.
std::vector<FeatureInfo> load_features(const std::filesystem::path& folder);

}  // namespace mien

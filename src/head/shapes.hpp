// Ages, skulls and character: the adult cage made into another head, by the tables of
// templates/head/heads.yaml.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "config/spec.hpp"
#include "head/fields.hpp"
#include "head/monotone.hpp"

namespace mien {

// A change of the whole head by height: Loomis' guide lines move y, the widths and depths follow.
struct Warp {
  MonotoneCurve height;                    // adult y -> this head's y, mm
  MonotoneCurve outer, inner;              // factor of x of the skull and of the features
  MonotoneCurve front, back;               // factor of z before and behind the ear canals
  double eye = 1;                          // size of the ball and its lids
  double carry_e3 = 0.75, carry_e4 = 0.3;  // how far these rings follow the ball instead of the warp
};

struct HeadShapes {
  std::map<std::string, Mix> ages, skulls;  // name -> mix of warps ("adult" and none: the adult itself)
  std::map<std::string, Warp> warps;
  std::map<std::string, Handles> fields;    // after the warp of the same name
  std::map<std::string, Handles> features;  // at value 1; at -1 the same backwards
};

// Reads heads.yaml and, if it is there, features.yaml of `folder` (templates/head). Throws RunError with file
// and line for what it does not understand.
HeadShapes load_head_shapes(const std::filesystem::path& folder);

// Makes the adult cage and eye into the head of `spec`: ages mixed, then skulls, character and features added
// at the head's size, then guide lines moved. Throws InputError if moved guide lines cross.
void shape_head(const HeadShapes& shapes, const HeadSpec& spec, Cage& cage, Eye& eye);

// The guide lines' heights on a head made by `spec` without its own guides, as fractions of head height above
// the chin: hairline, brow_line, eye_line, nose_base, mouth_line.
std::map<std::string, double> find_guides(const HeadShapes& shapes, const HeadSpec& spec, const Cage& adult,
                                          const Eye& eye);

}  // namespace mien

// One face as units of another program: an expression of MPFB, a pose of MakeHuman.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "import/take.hpp"

namespace mien {

struct PosedUnit {
  std::string name;  // as the mapping has it
  double value = 0;
  int line = 0, column = 0;  // where the file says it
};

struct UnitPose {
  std::string file;
  std::string name;          // of the expression, as the file says; empty: it says none
  std::string_view mapping;  // whose units they are: "arkit", "makehuman"
  std::vector<PosedUnit> units;
};

// Reads by its content:
//   .json    MPFB's expression: {"name": .., "face_units": {"jawOpen": 0.4}} of ARKit's units, and as mien
//            writes it what these leave over: "mien": {"lips.press": 0.1}
//   .mhpose  MakeHuman's pose: {"name": .., "unit_poses": {"LeftBrowDown": 0.4}}
// Throws InputError "FILE:LINE:COL: error: what was found; what was expected".
UnitPose load_unit_pose(const std::filesystem::path& file);

// The face as a take of one row: what takes are judged by, it is judged by, too.
Take build_unit_take(const UnitPose& pose);

// Whether a file is one of these, by its name and its first words.
bool is_unit_pose(const std::filesystem::path& file);

}  // namespace mien

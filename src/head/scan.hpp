// Somebody else's mesh with landmarks on it, ready to be wrapped.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "head/form.hpp"
#include "head/least_squares.hpp"
#include "import/polygons.hpp"

namespace mien {

// Where something is said, and the line's text: for messages. Nowhere, where a scan was made by the program.
struct SaidAt {
  Place place;
  std::string line;
};

struct ScanMark {
  std::string name;   // as in the file: "ex_l"
  glm::dvec3 at{0};   // in the mesh's unit
  LinearRow place;    // the same place on our skin, as a form over the cage
  double weight = 1;  // how well the place is defined: less for extremes such as the crown
  SaidAt said{};      // of a half's other side where the first is
};

struct Scan {
  Polygons mesh;           // a cloud of points is made a surface when it is loaded
  std::vector<bool> rims;  // of each position: the cloud ends there; empty: open edges tell
  std::vector<ScanMark> marks;
  double unit_mm = 0;  // 0: not told; the unit that makes a head of it is taken
  SaidAt marks_said, unit_said;
  std::vector<Diagnostic> warnings;  // of points that were left out
};

// The mesh and the landmarks beside it (NAME.landmarks.yaml, else NAME.yaml). A half (all x on one side of 0,
// to a hundredth of its size) is made whole; of its landmarks one side is enough. Throws InputError for
// broken files, clouds of too few points, unknown or missing landmarks, and landmarks that do not lie on the
// mesh. Points far from all others are left out, with a warning.
Scan load_scan_files(const HeadStock& stock, const std::filesystem::path& mesh, bool is_half);

}  // namespace mien

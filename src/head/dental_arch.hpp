// The arch the teeth stand on, and the cuts through a row of them from which teeth and gums are made.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "head/head.hpp"
#include "head/part_numbers.hpp"

namespace mien {

// Where the rows stand: fitted to the lips of one head.
struct DentalArch {
  const MouthNumbers& numbers;
  double scale = 1;       // of this mouth against the adult's
  double lips_y_mm = 0;   // the line between the lips
  double front_z_mm = 0;  // of the upper row's front
  double curve = 0.021;   // 1/mm: of the lips, z = front - curve x^2
  double growth = 1;      // of the teeth out of the gums: 0 none yet
};

// A row or its gum: its numbers, and +1 for the upper one, which grows downward, -1 for the lower one.
struct TeethRow {
  const TeethRowNumbers& numbers;
  int sign = 1;
};

// One cut through the row, x >= 0: where it is on the arch, which way is out, and where in its tooth.
struct ToothCut {
  glm::vec2 at{0};      // x, z behind the front (negative)
  glm::vec2 out{0, 1};  // unit, in the same plane
  double share = 0;     // 0 middle of the face, 1 the row's end
  double gap = 0;       // 1 between two teeth, 0 from a fifth of a tooth on
  double rise_mm = 0;   // of this tooth's biting edge
  double belly = 0;     // 1 in the middle of a tooth, 0 between teeth
};

// Cuts from the middle outward, closer together beside the gaps.
std::vector<ToothCut> cut_row(const DentalArch& arch, const TeethRow& row);

// The point of a cut `height_mm` above the lips' line (below it in the lower row), `out_mm` in front of the
// arch.
glm::vec3 place_in_row(const DentalArch& arch, const TeethRow& row, const ToothCut& cut, double height_mm,
                       double out_mm);

// How far the row's front lies behind the arch at a height: it leans back toward the gum.
double find_lean_mm(const DentalArch& arch, const TeethRow& row, double height_mm);

// The whole row, left and right, and the gum it grows from.
HeadPart build_teeth(const DentalArch& arch, const TeethRow& row);
HeadPart build_gum(const DentalArch& arch, const TeethRow& row);

}  // namespace mien

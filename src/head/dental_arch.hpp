// The arch the teeth stand on, and the teeth of one head in their places on it.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "config/part_numbers.hpp"
#include "head/head.hpp"

namespace mien {

// Where the rows stand: fitted to the lips of one head.
struct DentalArch {
  const MouthNumbers& numbers;
  double scale = 1;       // of this mouth against the adult's
  double lips_y_mm = 0;   // the line between the lips
  double front_z_mm = 0;  // of the upper row's front
  double half_mm = 28;    // the upper row's half width where it ends
  double depth_mm = 35;   // from its front to there
  double years = 20;      // how old the teeth are
};

// A row or its gum: its numbers, and +1 for the upper one, which grows downward, -1 for the lower one.
struct TeethRow {
  const TeethRowNumbers& numbers;
  int sign = 1;
};

// A place of the row's outside, x >= 0, seen from above.
struct ArchPlace {
  glm::vec2 at{0};        // x, z behind the arch's front (negative)
  glm::vec2 out{0, 1};    // unit, toward lips and cheeks
  glm::vec2 along{1, 0};  // unit, away from the middle of the face
};

// The row's outside as a line that can be walked along.
struct ArchLine {
  std::vector<glm::vec2> points;  // x, z
  std::vector<double> length_mm;  // from the middle to each
};

// One tooth of the left half. Lengths in mm of this head; heights as place_on_tooth takes them.
struct Tooth {
  std::size_t kind = 0;              // 0 the first incisor .. 6 the second molar
  double from_mm = 0, width_mm = 0;  // along the row; a milk tooth leaves some of its place free
  double free_mm = 0;
  double edge_mm = 0, neck_mm = 0;  // heights of its biting edge and of the gum's margin over its middle
  double grown = 1;                 // 0 still in the gum .. 1 out
  double milk = 0;                  // 1 a milk tooth, 0 a permanent one
  double share = 0;                 // of its middle: 0 middle of the face, 1 the row's end
  ArchPlace place;                  // of its middle
};

ArchLine trace_arch(const DentalArch& arch, const TeethRow& row);
ArchPlace compute_arch_place(const ArchLine& line, double length_mm);

// The teeth of half a row, first incisor first, side by side from the middle of the face to the row's end.
// All seven at every age: those that are not out yet, or just fallen, have grown 0.
std::vector<Tooth> lay_teeth(const DentalArch& arch, const TeethRow& row, const ArchLine& line);

// How far inward from the arch's middle line the row's outside lies at a way behind its front, mm: half its
// width there.
double compute_arch_half_mm(const DentalArch& arch, double behind_mm);

// How far the row's front lies behind the arch at a height: it leans back toward the gum, less so further
// back.
double compute_lean_mm(const DentalArch& arch, const TeethRow& row, double height_mm, double share);

// The whole row, left and right, and the gum it grows from.
HeadPart build_teeth(const DentalArch& arch, const TeethRow& row);
HeadPart build_gum(const DentalArch& arch, const TeethRow& row);

// What a drawing shows of the upper row: one band with a clean edge, as far down as its front teeth have
// grown.
HeadPart build_teeth_band(const DentalArch& arch, const TeethRow& row);

// The parts of build_mouth (head.hpp), its upper teeth a band.
std::vector<HeadPart> build_drawn_mouth(const NeutralHead& head);

// What hangs behind shut lips of a mouth of this scale and keeps the teeth from shining through: the inside
// of the upper lip, of its colour; it rides on the skin.
HeadPart build_lip_veil(const NeutralHead& head, double scale, const glm::vec3& srgb);

// The tongue at rest, its tip behind the lower teeth: append_loft's skin over kTongueRings upright rings of
// kTonguePoints each, from the throat to the tip, whose vertex is the last.
inline constexpr std::size_t kTongueRings = 20, kTonguePoints = 22;
HeadPart build_tongue(const DentalArch& arch);

}  // namespace mien

// What is printed and can still be posed: made by frames/, written by scene/, which need not know each other.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/holes.hpp"
#include "core/mesh.hpp"
#include "core/offsets.hpp"

namespace mien {

// Print coordinates: mm, z up, the face toward -y, the character's left at +x.

// A state of the bust that moves some vertices: a move at one of its values, an expression, the other stand.
// None of its vertices is of the eyes' or the mouth's patches.
using BustState = VertexOffsets;

// A move's own values, rising, 0 not among them; state i belongs to value i. Between two values the vertices
// go straight.
struct BustMove {
  std::string area, move;  // "brow.left", "up"
  std::string meaning;     // one line
  double low = -1, high = 1;
  std::vector<double> values;
  std::vector<std::size_t> states;
  double reach_low = 1, reach_high = 1;  // what a value of -1 or 1 comes to under the head's own limits
  bool has_slider = true;                // false: a print shows nothing of it
};

struct BustExpression {
  std::string name;
  std::vector<double> values;           // of the moves, within their limits
  std::size_t state = 0;                // what is missing when all moves are added up
  double open = 0;                      // of the jaw, in units of its limit
  std::array<glm::vec2, 2> gaze_rad{};  // of either eye: yaw to the character's left, pitch upward
};

inline constexpr int kPatchFine = 2;  // columns of a grid between two rims for each of the rims' own

// How many vertices a grid between two rims of `rim` vertices each has, `rows` steps from rim to rim.
inline std::uint32_t count_grid_vertices(std::size_t rim, int rows) {
  return static_cast<std::uint32_t>((kPatchFine * (static_cast<int>(rim) - 1) - 1) * (rows - 1));
}

// A grid of vertices between two rims: columns 1 .. 2n - 1 between the n + 1 of the rims, rows 1 .. rows - 1,
// column by column from `first` on.
struct BustGrid {
  std::vector<std::uint32_t> upper, lower;
  std::uint32_t first = 0;
  int rows = 0;

  std::uint32_t vertex_count() const { return count_grid_vertices(upper.size(), rows); }
};

// What the formula in frames/bust_eyes.cpp takes, on the print.
struct BustEye {
  BustGrid grid;
  glm::vec3 centre{0};
  double radius_mm = 0, iris_mm = 0, iris_depth_mm = 0, pupil_depth_mm = 0, slit_mm = 0, line_mm = 0;
  double light = 0;  // radii of the iris
};

inline constexpr float kNoTooth_mm = -1000;  // how far in front a tooth stands where there is none

// What the formula in frames/bust_mouth.cpp takes, on the print, with the jaw at rest. Teeth are sampled from
// -reach_mm to reach_mm; an edge and a place of the front a little further to the gum, as (z, depth to the
// front), depth kNoTooth_mm where there is no tooth.
struct BustMouth {
  BustGrid grid;
  double reach_mm = 0;
  std::vector<glm::vec2> upper_edge, upper_front, lower_edge, lower_front;
  glm::vec3 tongue{0}, tongue_radius{0};
  double line_mm = 0;
  glm::vec2 jaw_axis{0};     // (z, forward) of the axis, which is parallel to x
  double jaw_open_rad = 0;   // at its limit
  glm::vec2 jaw_forward{0};  // (z, forward) at its limit
};

// The lens of head/lens.hpp on the print; a drawn head's.
struct BustLens {
  glm::dvec3 middle{0};  // of the left eye
  double radius_mm = 1;
  double taller = 0, full = 1, end = 2, flat = 0;
  bool is_on = false;
};

// How far a cavity may reach for some thicknesses of its wall, the same in every pose: rows of places, one
// above the other, in columns around each row's middle.
struct CavityPlan {
  struct Wall {
    double wall_mm = 2;
    double top_mm = 0;               // the cavity's highest place, above the last middle
    std::vector<double> reaches_mm;  // from the middle, row after row; a row of zeros holds no cavity
  };

  std::vector<glm::dvec2> directions;  // of the columns as seen from above, unit, in the foot's order
  std::vector<double> heights_mm;      // of the rows, rising, from the figure's foot
  std::vector<double> middles_mm;      // y of the rows' middles; their x is 0
  std::vector<Wall> walls;             // from the thinnest on
};

// A bust whose file can pose it. All lengths at the height asked for.
struct PosableBust {
  std::string title;       // written as a comment only, after it was cleaned
  std::string expression;  // of `expressions`, shown when the file is opened
  double height_mm = 80;   // whole print with its base
  double figure_mm = 72;   // without
  double mm_per_head_mm = 0.3;
  std::string base_shape = "round";  // none, round, square, plinth
  double base_height_mm = 8, base_radius_mm = 16;
  std::string label;    // raised on the base's front; any UTF-8
  std::string letters;  // the glyphs it is drawn with, as a list in OpenSCAD's words
  double magnet_diameter_mm = 0, magnet_depth_mm = 2;
  bool is_hollow = false;
  double wall_mm = 2, drain_mm = 4;
  CavityPlan cavity;  // without walls: too small to be hollow

  std::vector<Triangle> triangles;  // open at the foot alone
  Loop foot;                        // the open edge; at rest its z is 0
  std::vector<glm::vec3> rest;      // the neutral pose on its own stand, before its lens
  std::vector<BustState> states;
  std::vector<BustMove> moves;
  std::vector<BustExpression> expressions;
  std::size_t other_stand = 0;  // state: on a foot for a base if it is cut flat, cut flat if it is on a foot
  double other_foot_mm = 0;     // where that stand's foot lies
  std::array<BustEye, 2> eyes;  // left, right
  double gaze_side_rad = 0, gaze_up_rad = 0, gaze_down_rad = 0;  // at the limits
  BustMouth mouth;
  BustLens lens;
};

}  // namespace mien

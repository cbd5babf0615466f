// The strokes of a drawn face: along which points of the skin they go, and how thick they are.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/model.hpp"
#include "frames/figure.hpp"

namespace mien {

struct StrokeWidth {
  double at = 0, width = 0;  // 0..1 along the stroke; half of it, in lines (or in mm of an adult's brow)
};

struct StrokeRule {
  const char* name;
  std::vector<const char*> points;  // of the left half, or "R:..." of the right one; inner to outer
  bool is_sided = true;             // drawn on both sides
  bool is_ridge = false;     // drawn where the skin faces the camera: beside an outline it would double it
  float in_profile = 1;      // how much thicker it is where the head is seen from the side
  float faced = 0.22f;       // there it is drawn whole: the cosine of its normal's angle to the view
  bool is_of_front = false;  // seen from the side it would fork off another
  bool is_of_near = false;   // on the far half of a head seen aslant it would be a knot at the outline
  bool is_of_level = false;  // from below it would be a stub above a corner that is lifted
  bool is_of_lid = false;    // seen from the side it would fill an eye that is nearly shut
  bool is_smooth = false;    // no waves: drawn along the mean of its points
  bool is_seam = false;      // where lips all but meet one line is enough: this one fades
  bool is_brow = false;      // in the brow's colour, its widths mm on an adult's eye of 16 mm
  bool is_on_hair = false;   // its points are those of the mass of hair
  bool lies_in_profile = false;  // comes down to the skin where that is seen along
  std::vector<StrokeWidth> widths;
  double lift_mm = 0.5, flat = 0.5;      // off the skin; how thick along its normal against across
  glm::vec3 wing{0};                     // a last point beyond the last, mm on such an eye; x outward
  double from = 0, to = 1;               // the part of the way that is drawn
  double less_below = 0;                 // seen from below, how much sooner it ends on either side
  std::vector<const char*> facing = {};  // points whose normals tell where it faces; none: its own
  std::vector<std::array<const char*, 2>> before =
      {};  // of each of its points two of the lips, which would hide it where they meet
};

// Half the width of a stroke so far along it.
double find_stroke_width(const std::vector<StrokeWidth>& widths, double at);

// A place of the skin: in a triangle of its vertices, by their shares.
struct StrokePoint {
  Triangle vertices{0, 0, 0};
  glm::vec3 shares{1, 0, 0};
};

// A stroke on one side, or across the middle.
struct InkStroke {
  StrokeRule rule;
  std::vector<StrokePoint> points;
  std::vector<std::uint32_t> facing;
  std::vector<std::array<std::uint32_t, 2>> before;
  float side = 1;                   // -1: of the right half
  std::optional<std::size_t> fold;  // whose amount its thickness is multiplied by, in Ink::folds
};

// The strokes that every drawn head has, and those of the folds that ink draws, as thick as they are deep on
// this head. `folds` gets what tells how much there is of each.
std::vector<InkStroke> list_strokes(const Figure& figure, const HeadSpec& spec,
                                    std::vector<FoldField>& folds);

inline constexpr int kStrokeSteps = 40, kStrokeSpokes = 8;

// Vertices and triangles of one stroke, in their order.
inline constexpr std::size_t kStrokeVertices = std::size_t{kStrokeSteps} * kStrokeSpokes;
std::vector<Triangle> list_stroke_triangles(std::uint32_t first);

// A line in space: places along it, the ways that it lies off what is below, and half its widths. Places
// are kStrokeSteps.
struct Tube {
  std::vector<glm::vec3> centres, lifts;
  std::vector<float> halves_mm;
};

// Appends its vertices; it is so thick along its lifts, `flat` against its width.
void append_tube(const Tube& tube, double flat, std::vector<glm::vec3>& vertices);

// Where a stroke is drawn: on a skin of these points and unit normals, seen from `camera_mm`; `line_mm` is a
// line's width there, `eye_size` that of the head's eye.
struct StrokeGround {
  const std::vector<glm::vec3>&positions, &normals;
  glm::vec3 camera_mm{0, 0, 900};
  double line_mm = 1, eye_size = 1;
  float beside = 0;  // 1: the head is seen from the side
  float met = 0;     // 1: the lips meet
  float below = 0;   // 1: the head is seen from below
};

// Appends the vertices of a stroke; `amount` is how much there is of it, 0..1.
void append_stroke(const InkStroke& stroke, double amount, const StrokeGround& ground,
                   std::vector<glm::vec3>& vertices);

}  // namespace mien

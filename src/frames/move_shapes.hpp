// What each move of the nine areas does to a figure, told so that others can pose it without the face:
// shapes to blend between and joints to turn. Writers of files that pose themselves take it from here.
//
// Shapes       A move's shape is where every vertex lies with that move at one value, to the last bit, and
// all
//              other moves at 0. What it adds is its difference from the neutral shape (all moves at 0).
// In-betweens  A move that does not go straight has shapes at values between 0 and its ends too. At a value
//              between two neighbours, 0 among them, the vertices lie on the straight line between the two:
//              compute_shape_weight tells how much there is of each. Of several moves the differences are
//              added.
// Error        At a shape's own value none. Halfway between two neighbours a vertex is within
//              ShapeRequest::tolerance_mm of its way in truth, unless the halvings were used up. Anywhere
//              between, measured on the adult with 0.02 mm asked for and without folds: the skin within 0.06
//              mm, hairs within 0.05 mm, but the lashes of an upper lid within 0.4 mm. measure_between_mm
//              tells it of any mesh. Moves that are added up are further off: expressions' own shapes are for
//              that.
// Mirrors      The shapes of the skin's mirrored moves are mirror images to the last bit. Hairs are not quite
//              alike on both sides, and may ask for other in-betweens on one.
// Joints       Rigid parts do not bend: eyeballs turn about their centres, teeth and tongue go with the jaw.
// A
//              joint tells the pivot and, for each move that turns it, the axis and the angle at the limits.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/offsets.hpp"
#include "frames/figure.hpp"

namespace mien {

// Where all vertices of some mesh lie in a pose: always as many, in one order. It is called from several
// threads at once.
using PlaceVertices = std::function<std::vector<glm::vec3>(const Pose&)>;

struct MoveShape {
  double value = 1;                  // of the move, never 0
  std::vector<glm::vec3> positions;  // of all vertices, in the space of the mesh
};

struct MoveShapes {
  std::size_t move = 0;           // in kMoves
  std::vector<MoveShape> shapes;  // by value, rising; the first and the last are at the move's ends
};

struct ShapeRequest {
  double tolerance_mm = 0.02;     // in the mesh's own space; less asks for more in-betweens
  int most_halvings = 3;          // of the way from 0 to an end, one more of a move with a single end
  std::vector<bool> is_left_out;  // vertices that something else places: no in-between is for them; or empty
};

// The shapes of all moves in the order of kMoves. `neutral` is place(Pose{}).
std::vector<MoveShapes> sample_move_shapes(const PlaceVertices& place, const std::vector<glm::vec3>& neutral,
                                           const ShapeRequest& request);

// How much there is of shape `i` at `value`, from 0 to 1; `values` are those of all the move's shapes,
// rising, and `value` is within the move's limits. templates/openscad/bust.scad has the same formula as
// `share`.
double compute_shape_weight(const std::vector<double>& values, std::size_t i, double value);

std::vector<double> list_shape_values(const MoveShapes& move);

// All vertices with one move at `value`, as whoever has only the shapes would place them.
std::vector<glm::vec3> blend_shapes(const std::vector<glm::vec3>& neutral, const MoveShapes& move,
                                    double value);

// The offsets from `from` to `to` that are longer than `slight_mm`, which has a number for each vertex
// (INFINITY: never).
VertexOffsets compute_offsets(const std::vector<glm::vec3>& from, const std::vector<glm::vec3>& to,
                              const std::vector<double>& slight_mm);

// How far a vertex is from its way in truth, at worst, in `steps` - 1 places between each two neighbours of a
// move. Vertices left out do not count.
double measure_between_mm(const PlaceVertices& place, const std::vector<glm::vec3>& neutral,
                          const MoveShapes& move, const ShapeRequest& request, int steps);

// The parts of a figure that bend (the skin, and hairs that stand on it), one behind the other: vertices
// [first, first + count) of what place_bent_parts returns are those of model.parts[part].
struct BentPart {
  std::size_t part = 0;
  std::size_t first = 0, count = 0;
};
std::vector<BentPart> list_bent_parts(const Figure& figure);

// Places them as deform_figure does, mm of the head's space. `figure` must outlive what is returned.
PlaceVertices place_bent_parts(const Figure& figure, bool has_folds);

// What a move does to a joint: a turn about `axis` by value x reach x rad, and a shift by value x reach x
// shift.
struct JointTurn {
  std::size_t move = 0;                    // in kMoves
  glm::dvec3 axis{1, 0, 0};                // unit; right-handed
  double plus_rad = 0, minus_rad = 0;      // at 1 and, to the other side, at -1
  double plus_reach = 1, minus_reach = 1;  // what the head's own limits make of 1 and -1
  glm::dvec3 shift_mm{0};                  // at 1
  bool is_rest_of_first = false;           // goes as far as the joint's first turn leaves of 1
};

struct Joint {
  std::string name;                // "eye_left", "eye_right", "jaw"
  glm::dvec3 pivot_mm{0};          // at rest, in the head's space; of the jaw any point of its axis
  std::vector<JointTurn> turns;    // the first is the outermost: it turns the axes of those behind it
  std::vector<std::size_t> parts;  // in the model: rigid ones that ride on it
};

// The joints in which a figure's rigid parts turn, by the numbers below; parts that stay with the skull have
// none.
std::vector<Joint> list_joints(const Figure& figure);
inline constexpr std::size_t kLeftEyeJoint = 0, kRightEyeJoint = 1, kJawJoint = 2;
inline constexpr std::size_t kSideTurn = 0, kUpTurn = 1;  // of an eye

// What a value of `sign` 1 or -1 of a move comes to under the head's own limits, at least 0.
double compute_move_reach(const Figure& figure, std::size_t move, int sign);

// The joint in a pose within the limits: world from rest, without a turn of the head.
glm::dmat4 place_joint(const Joint& joint, const Pose& pose);

}  // namespace mien

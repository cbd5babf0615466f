// What a figure stands on: rings from its foot down to the bed, a label, a pocket for a magnet, a hole to
// drain. Print coordinates: mm, z up, the bed at z = 0, the front toward -y, the character's left at +x.
#pragma once

#include <string>
#include <vector>

#include "core/holes.hpp"
#include "core/mesh.hpp"
#include "core/print_numbers.hpp"
#include "print/glyphs.hpp"

namespace mien {

enum class BaseShape {
  none,    // the foot goes straight down
  round,   // a moulded socle: hollow, torus, drum
  square,  // the same mouldings round a square with soft corners
  plinth,  // an upright block with a plain front
};

struct Base {
  BaseShape shape = BaseShape::round;
  double height_mm = 8;
  double radius_mm = 15;     // half the side of a square or plinth
  std::string label{};       // raised on the front; needs a shape
  double label_size_mm = 0;  // height of the letters; 0: as large as the front allows
  double label_raise_mm = kLabelRaise_mm;
  double magnet_diameter_mm = 0;  // of a pocket in the underside; 0: none
  double magnet_depth_mm = 0;
};

// A tunnel straight from the drain to the middle of the base's back, where air comes into the hollow while
// the underside lies on the bed. Its floor and ceiling are horizontal; width 0: there is none.
struct Vent {
  double width_mm = 0, low_mm = 0, high_mm = 0;
};

// Where a tunnel ends in a wall: two lines of as many vertices, its floor's and its ceiling's edge, in the
// order of the wall's rings.
struct VentMouth {
  Vent vent;
  Loop low, high;
};

// The vent of a base with a drain so wide. There is none without a shape, and where the upright back leaves
// less than kLeastDrain_mm above a magnet's pocket.
Vent find_vent(const Base& base, double drain_mm);

// Opens the band between two upright rings, whose triangles are those from `first` on that have vertices of
// both alone, for a mouth of the vent in its back. The band is append_band(mesh, from, to).
VentMouth cut_vent_mouth(Mesh& mesh, std::size_t first, const Loop& from, const Loop& to, const Vent& vent);

// The tunnel between a mouth in the base's back and one in the drain.
void append_tunnel(Mesh& mesh, const VentMouth& outside, const VentMouth& inside);

// The rings of the base below `foot`, from the top one to the outer edge of the underside (z = 0), each with
// a point for each of the foot's, in its order and at its angle. `foot` is horizontal, at z =
// base.height_mm, and star-shaped as seen from the z axis. Without a shape there is one ring straight below
// the foot, or none if that stands on the bed already. templates/openscad/base.scad has the same formula with
// the same numbers (core/print_numbers.hpp); a ring's point is the foot's moved outward by a share of the way
// to the outline.
std::vector<std::vector<glm::vec3>> list_base_rings(const Base& base, const std::vector<glm::vec3>& foot);

// The base's label as it fits the front of a base on this foot: letters as large as asked or, at 0, as the
// front allows; smaller if it is too narrow, and cut (Label::is_cut says so) if they became too small to
// read. Without strokes if there is no label, no front, or no room at all.
Label fit_label(const Base& base, const std::vector<glm::vec3>& foot, const Letters& letters);

// Joins the base to `body`, which is open along `foot_loop` (as find_boundary_loops gives it); closed
// afterwards, but for a round hole of `drain_mm` in the middle of the underside, or of the ceiling of the
// magnet's pocket, if that is above 0: its loop is returned, a vertex for each of the foot's and in their
// order. With `outside`, it stays open for the vent's mouth in its back, too, if its vent has a width: its
// lines are put there. The label is what fit_label makes of it. Normals are dropped. Throws RunError "the
// base's height of 0 mm is not above 0", "the magnet's pocket of 20 x 2 mm does not fit the base" and the
// like.
Loop append_base(Mesh& body, const Loop& foot_loop, const Base& base, const Letters& letters = {},
                 double drain_mm = 0, VentMouth* outside = nullptr);

}  // namespace mien

// A stretch of upright wall with raised letters, between two rings.
#pragma once

#include "core/holes.hpp"
#include "core/mesh.hpp"
#include "print/glyphs.hpp"

namespace mien {

// The free front of an upright wall: how wide, along the wall and symmetrical to x = 0, and how high.
struct LabelRoom {
  double width_mm = 0, height_mm = 0;
};

// `high` and `low` are the wall's rings, one above the other, counter-clockwise as seen from above.
LabelRoom compute_label_room(const std::vector<glm::vec3>& high, const std::vector<glm::vec3>& low);

// The band between the rings (vertices of `mesh`, as for compute_label_room, of one length) with `label`
// raised from its front by `raise_mm`; it must fit the room.
void append_label_band(Mesh& mesh, const Loop& high, const Loop& low, const Label& label, double raise_mm);

// A strip of triangles between two lines of vertices that run the same way, the second to the left of the
// first.
void append_strip(Mesh& mesh, const Loop& right, const Loop& left);

}  // namespace mien

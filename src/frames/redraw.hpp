// What a design does to a head that is posed: its lens about the eyes, the whole head drawn out or squashed
// as jaw and brows go (squash and stretch), and a pose that is told more clearly.
#pragma once

#include <vector>

#include "config/areas.hpp"
#include "config/clip_spec.hpp"
#include "core/model.hpp"
#include "face/face.hpp"
#include "head/lens.hpp"
#include "head/pairs.hpp"
#include "head/surface.hpp"

namespace mien {

// Of one head; built once.
struct Redraw {
  Lens lens;
  double jaw_stretch = 0, brow_stretch = 0, early = 0, lid_hood = 0;
  double floor_mm = 0, chin_mm = 0;  // the stretch begins at the neck's end, and is whole from the chin on
  std::vector<float> turn_shares;    // of each vertex of the surface: how far it goes with a turning head

  bool is_on() const { return lens.is_on() || jaw_stretch > 1e-9 || brow_stretch > 1e-9; }
};

Redraw build_redraw(const NeutralHead& head, const Face& face);

// The pose as a design has it: what is half shown is shown more clearly, at their limits areas are where they
// were; and upper lids are as low as the brows have them, or large eyes would stare beneath a frown.
Pose redraw_pose(const Redraw& redraw, const Pose& pose);

// How much taller the head is in a pose, as a share of its height; below 0: lower.
double compute_stretch(const Redraw& redraw, const Pose& pose);

// The most of it in any pose.
double compute_most_stretch(const Redraw& redraw);

// What the stretch does above the chin, for parts that keep their shape.
glm::dmat4 compute_stretching(const Redraw& redraw, double stretch);

// A point of the posed head through lens and stretch, before the head turns.
glm::dvec3 redraw_point(const Redraw& redraw, double stretch, const glm::dvec3& point);

// The skin's slots, posed and not turned, through all of it and then turned about the neck.
void redraw_slots(const Redraw& redraw, double stretch, const Surface& surface, const Face& face,
                  const TurnKey& turn, std::vector<Twin>& places);

// A part's mesh, moved by `world_from_rest` within the head and then the same, turned with the head.
void redraw_part(const Redraw& redraw, double stretch, const Mesh& rest, const glm::dmat4& head_from_rest,
                 const glm::dmat4& turned, PartShape& shape);

}  // namespace mien

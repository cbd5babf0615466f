// What muscles and units do to one head's cage: the fields of doctrines other than the areas.
//
// A muscle's pull is proportional to its contraction and worked out from the resting face, so that it is a
// field, and muscles add up in any order (geoface moves vertices muscle by muscle, where the order counts).
//
// Sources: K. Waters, "A muscle model for animating three-dimensional facial expression" (SIGGRAPH 1987),
// linear muscle and sphincter; J. Ahlberg, "CANDIDE-3" (2001), units as displacements of points.
#pragma once

#include <memory>
#include <vector>

#include "face/face.hpp"

namespace mien {

// How much of its pull a linear muscle has on a point: 0..1, the product of Waters' angular and radial terms.
// `to_point` is from the attachment to the point, `to_skin` from there to the insertion, mm; `half_rad` is
// half of the cone; `start` and `end` are shares of the length of `to_skin`.
double compute_pull(const glm::dvec3& to_point, const glm::dvec3& to_skin, double half_rad, double start,
                    double end);

// One of each muscle and unit that moves skin, in the order of the data.
std::vector<DrivenField> build_muscle_fields(const NeutralHead& head);
std::vector<DrivenField> build_unit_fields(const NeutralHead& head, const FaceUnits& units);

// Fields of a head, solved when the first pose asks for them and never for a head that none asks it of. Safe
// for any number of threads.
class DoctrineFields {
 public:
  const std::vector<DrivenField>& get_muscles(const NeutralHead& head);
  const std::vector<DrivenField>& get_units(const NeutralHead& head, const FaceUnits& units);

 private:
  struct Once;
  std::shared_ptr<Once> muscles_ = build(), units_ = build();
  static std::shared_ptr<Once> build();
};

}  // namespace mien

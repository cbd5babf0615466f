// The margin of the left eye's lids as a closed curve: what lashes and the wet line grow on.
#pragma once

#include <vector>

#include "head/binding.hpp"
#include "head/head.hpp"

namespace mien {

struct Lids {
  std::vector<glm::vec3> inner, outer, beyond;  // cage points E0_0..15, E1_0..15 and E2_0..15 on the skin
  glm::vec3 centre{0};                          // of the ball
  float radius_mm = 13;
  double scale = 1;  // of this eye against the adult's
  SkinPatch patch;   // the skin around the eye
};

Lids build_lids(const NeutralHead& head, double adult_ball_mm);

// t counts the lid's points: 0 inner corner, 4 middle of the upper lid, 8 outer corner, 12 middle of the
// lower lid. mix: 0 the margin's edge on the ball, 1 its outer edge.
glm::vec3 compute_on_margin(const Lids& lids, double t, double mix);

// Where a named point of the cage came to lie on the skin. Throws RunError for an unknown name.
glm::vec3 find_named_point(const NeutralHead& head, std::string_view name);

// Several of one ring: find_named_ring(head, "E1_", 0, 15).
std::vector<glm::vec3> find_named_ring(const NeutralHead& head, const std::string& stem, int first, int last);

// How high the eyes stand above the chin, or would without a design: short faces are young ones.
double compute_eye_to_chin_mm(const NeutralHead& head);

}  // namespace mien

// A tongue that moves in its mouth: out between the teeth and the lips as far as they leave it room, and up
// to the ridge behind the upper teeth. A muscle that keeps its volume (Kier and Smith, "Tongues, tentacles
// and trunks", 1985): what grows longer gets thinner.
#pragma once

#include <vector>

#include "core/model.hpp"
#include "face/face.hpp"
#include "head/head.hpp"

namespace mien {

// An upright ring of the tongue at rest, mm.
struct TongueRing {
  double y = 0, z = 0, half_high = 0, half_wide = 0;
  double from_tip = 0;  // backward
};

// What bending a head's tongue takes. Millimetres of its rest space, the jaw shut.
struct TongueRig {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::size_t part = kNone;  // in the model
  Mesh rest;
  std::vector<TongueRing> rings;        // from the throat to the tip
  std::vector<glm::vec3> upper, lower;  // places all over the front of both rows of teeth and their gums
  double scale = 1;                     // of this mouth against the adult's
  std::vector<float> lower_heights;     // of the grid that the tongue passes: the lower row alone
  glm::dvec3 tip{0}, ridge{0};          // ridge: where the raised tip comes to, behind the upper teeth
  double edge_z = 0;                    // of the lower front teeth's edge
};

// From the parts "tongue", "teeth_*" and "gum_*" of the undistorted model.
TongueRig build_tongue_rig(const NeutralHead& head, const Model& model);

// The tongue of a posed face, into `bent`: in the jaw's rest space, to be carried by compute_jaw. `points` is
// the posed cage, before the head is turned. False where the tongue rests: then nothing is done.
bool bend_tongue(const TongueRig& rig, const Face& face, const Pose& pose,
                 const std::vector<glm::dvec3>& points, Mesh& bent);

}  // namespace mien

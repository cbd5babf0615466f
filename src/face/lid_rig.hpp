// The lids of both eyes. Their rings turn about the eye's centre, round the axis from its inner to its outer
// corner; then the edges of the margins are set on the skin itself, since skin lies off its control points.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "config/area_data.hpp"
#include "config/areas.hpp"
#include "config/part_numbers.hpp"
#include "head/head.hpp"

namespace mien {

inline constexpr int kLidColumns = 16;  // 0 inner corner, 1..7 upper, 8 outer corner, 9..15 lower

// Numbers of one margin by column from the inner to the outer corner.
using LidRow = std::array<double, 9>;

// One ring of an eye's lids.
struct LidRing {
  std::array<std::uint32_t, kLidColumns> left{}, right{};  // control points
  std::array<glm::dvec3, kLidColumns> rest{};              // the left ones, mm
  bool is_inner = false;                                   // turns with the margin's inner edge
  double upper_share = 0, lower_share = 0;                 // of the lid's angle
  double shut_share = 0;                                   // of a shut upper lid's
  double least_radius_mm = 0;                              // from the eye's centre; 0: free
  glm::dvec3 bulge{0};                                     // mm, of a lower lid fully raised
};

// A control point's share in a place on the skin.
struct LidShare {
  std::size_t ring = 0;  // in LidRig::rings
  int column = 0;
  double share = 0;
};

// An edge of the margins: which control points put it where on the skin, and its place at rest by its height
// above the axis, how far out along it and how far from it.
struct LidEdge {
  std::size_t ring = 0;  // in LidRig::rings
  std::array<std::vector<LidShare>, kLidColumns> shares;
  LidRow upper_rad{}, lower_rad{};
  LidRow upper_along_mm{}, lower_along_mm{};  // ascending
  LidRow upper_radius_mm{}, lower_radius_mm{};
  std::array<double, kLidColumns> clear_mm{};  // off the eye: what it keeps wherever the eye looks
};

// The left eye; the right one is worked in its mirror.
struct LidRig {
  std::vector<LidRing> rings;
  std::array<LidEdge, 2> edges;  // inner (E0), outer (E1)
  Eye eye;
  EyeNumbers eye_numbers;
  glm::dvec3 axis{1, 0, 0};  // from the inner to the outer corner
  LidRow taper{};
  LidRow slide_upper_mm{}, slide_lower_mm{};  // of a shut lid toward the inner corner
  double pairing = 0;  // how far columns of both lids that meet come to lie beside each other
  LidRow meeting{};
  double least_gap_rad = 0, wide_rad = 0, raised_rad = 0;
  double follow_up = 0, follow_down = 0, follow_lower = 0;
  std::size_t lid_ring = 0, fold_ring = 0;  // E2, E3
  double fold_least = 0, fold_forward = 0;  // what keeps the fold over the lid; see areas.yaml
};

LidRig build_lid_rig(const NeutralHead& head, const LidData& data);

// What moves one eye's lids; `gaze` in the left eye's mirror for the right one.
struct LidPose {
  double upper = 0, lower = 0;
  double pitch_rad = 0;
  glm::dmat3 gaze{1};
};

// Turns one eye's lids in `points`, which are the cage's with all fields added.
void turn_lids(const LidRig& rig, const LidPose& pose, Side side, std::vector<glm::dvec3>& points);

}  // namespace mien

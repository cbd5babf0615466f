// The limits of the areas on one head: how far each way of each move goes at value 1.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "config/limits.hpp"
#include "face/face.hpp"

namespace mien {

// Each limit's share of what the head would have without `head.limits`, by move: 1 leaves it as it is.
struct LimitShares {
  std::array<double, kMoveCount> plus, minus;
  LimitShares();
};

// `limits` by the names of config/limits.hpp.
LimitShares compute_limit_shares(const std::map<std::string, double>& limits);

// A length told in a unit of this face.
double compute_length_mm(const FaceUnits& units, const LimitLength& length);

// The same with limits that are told as lengths, on this head: what share each is. Throws InputError at the
// place of one that the head cannot reach: "'brow.left.up' goes 21.4 mm at most on this head; expected no
// more than that".
void fit_limit_lengths(const NeutralHead& head, const Face& face,
                       const std::map<std::string, LimitLength>& lengths, LimitShares& shares);

// The pose of this head's areas: each value times the share of its limit. Without shares it is the same to
// the last bit.
Pose apply_limits(const LimitShares& shares, const Pose& pose);

// One limit, measured. Limits that are turns (lids, eyes, chin) are angles; the others are stored in face
// units, so that one performance reads the same on every head.
struct Limit {
  const LimitName* name = nullptr;
  std::string unit;    // "eye_nose"; "deg" for a turn
  double value = 0;    // in `unit`, the same on every head but for its share
  double mm = 0;       // on this head, along the axis; of a turn the way of the point
  double skin_mm = 0;  // the whole way of the skin there, which lies off its control point
  std::string point;   // where it is measured, of the cage: "E5_4", "R:E5_4"; "pupil" of an eye, "tongue"
  int axis = -1;       // along which: 0 x, 1 y; -1 for a turn
};

// In the order of config/limits.hpp.
std::vector<Limit> measure_limits(const NeutralHead& head, const Face& face, const LimitShares& shares);

}  // namespace mien

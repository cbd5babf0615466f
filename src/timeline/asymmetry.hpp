// No face is quite the same on both sides: which side of an area is later, and which does less.
#pragma once

#include <array>
#include <bitset>
#include <functional>
#include <string_view>
#include <vector>

#include "config/clip_spec.hpp"

namespace mien {

// Of one area, seeded.
struct AreaLean {
  std::string_view area;    // "brow", "lid", "corner": eyes move together
  Side late = Side::right;  // this side starts later, the other arrives sooner
  double delay_s = 0;       // 0.02..0.06 between the two; lids 0
  // This side's values are less by this share: at most the `amount` asked for, and three quarters of it at
  // least; lids half as much.
  Side weak = Side::right;
  double weakness = 0;
  std::array<std::bitset<kChannelCount>, 2> moves{};  // the left side's and the right one's
};

struct Asymmetry {
  std::vector<AreaLean> areas;  // none: off
  std::vector<double> keys_s;   // ascending
};

Asymmetry build_asymmetry(const AsymmetrySpec& spec, std::vector<double> keys_s);

// The time at which a side shows what both would show at `time_s`. Between two neighbours of `keys_s`
// (ascending) the late side waits at the first, the early one is there before the second: at a key's time
// both show the key.
double compute_side_time_s(const std::vector<double>& keys_s, double time_s, double delay_s, bool is_late);

// The pose of a face that leans. `sample` is the symmetric one's at a time. Key poses keep their times
// exactly; their weak sides are weaker, since that is what was asked for. A shut lid stays shut.
// `sample` may leave moves at rest that it is not asked for.
using PoseSampler = std::function<Pose(double time_s, const std::bitset<kChannelCount>& only)>;
Pose sample_leaning(const Asymmetry& asymmetry, double time_s, const PoseSampler& sample);

}  // namespace mien

// A pose whose numbers are formulas of time, in place of one that was worked out when the file was read.
#pragma once

#include <array>
#include <bitset>
#include <vector>

#include "config/formula.hpp"
#include "config/pose_mix.hpp"

namespace mien {

// A number as it was written: a plain one, or a formula.
struct Number {
  double value = 0;
  FormulaPointer formula = {};
};

double evaluate(const Number& number, double time_s);

// What PoseAsk is, before its numbers are known.
struct LivePose {
  struct Share {
    Number weight{1, {}};
    Pose pose;
    std::shared_ptr<const Manner> manner = {};
  };
  struct Value {
    std::size_t move = 0;
    FormulaPointer formula;
    double low = 0, high = 0;  // the formula's result is held there
    Place place;
  };
  std::vector<Share> shares;
  double reach = 1;
  Number strength{1, {}};  // held within 0..1
  AreaValues areas;        // plain ones
  std::vector<Value> values;
  double exaggerate = 1;
};

// The pose at a time, held within its limits, as hold_pose tells.
HeldPose evaluate_pose(const LivePose& live, double time_s);

// The same without a ledger, of some moves; the others mean nothing. Returns its reach.
double evaluate_pose(const LivePose& live, double time_s, const std::bitset<kChannelCount>& only,
                     std::array<double, kChannelCount>& into);

// Whether a limit may ever hold it: never a law, which is held within its own range before.
bool can_be_held(const LivePose& live);

}  // namespace mien

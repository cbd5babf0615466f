#include "config/live_pose.hpp"

#include <algorithm>

namespace mien {

double evaluate(const Number& number, double time_s) {
  return number.formula ? evaluate_held(*number.formula, time_s) : number.value;
}

namespace {

// One move of an area alone, as laws are: what evaluate_pose comes to, in a tenth of the time. Both sides may
// have one formula.
void evaluate_law(const LivePose& live, double time_s, const std::bitset<kChannelCount>& only,
                  std::array<double, kChannelCount>& into) {
  const Formula* known = nullptr;
  double number = 0;
  for (const LivePose::Value& value : live.values) {
    if (!only[value.move]) continue;
    if (value.formula.get() != known) number = evaluate_held(*value.formula, time_s);
    known = value.formula.get();
    const MoveInfo& info = kChannels[value.move];
    into[value.move] = std::clamp(std::clamp(number, value.low, value.high), info.low, info.high);
  }
}

bool is_law(const LivePose& live) {
  return !live.values.empty() && live.shares.empty() && live.exaggerate == 1 && live.reach == 1 &&
         std::ranges::none_of(live.areas.values, [](const auto& value) { return value.has_value(); });
}

}  // namespace

HeldPose evaluate_pose(const LivePose& live, double time_s) {
  std::vector<PoseShare> shares;
  for (const LivePose::Share& share : live.shares)
    shares.push_back({std::clamp(evaluate(share.weight, time_s), 0.0, 1.0), share.pose, share.manner});
  const double strength = std::clamp(evaluate(live.strength, time_s), 0.0, 1.0);
  PoseAsk ask{mix_poses(shares, strength), live.reach, strength, live.areas, live.exaggerate};
  for (const LivePose::Value& value : live.values) {
    const MoveInfo& info = kChannels[value.move];
    const double number = std::clamp(evaluate_held(*value.formula, time_s), value.low, value.high);
    ask.areas.values[value.move] = number;
    ask.areas.places.erase(value.move);
    if (number < info.low || number > info.high) ask.areas.places[value.move] = value.place;
  }
  return hold_pose(ask);
}

double evaluate_pose(const LivePose& live, double time_s, const std::bitset<kChannelCount>& only,
                     std::array<double, kChannelCount>& into) {
  if (is_law(live)) {
    evaluate_law(live, time_s, only, into);
    return 1;
  }
  const HeldPose held = evaluate_pose(live, time_s);
  into = held.pose.values;
  return held.reach;
}

bool can_be_held(const LivePose& live) {
  return !is_law(live) || std::ranges::any_of(live.values, [](const LivePose::Value& value) {
    return value.low < kChannels[value.move].low || value.high > kChannels[value.move].high;
  });
}

}  // namespace mien

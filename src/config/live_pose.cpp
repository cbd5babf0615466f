#include "config/live_pose.hpp"

#include <algorithm>

namespace mien {

double evaluate(const Number& number, double time_s) {
  return number.formula ? evaluate_held(*number.formula, time_s) : number.value;
}

namespace {

// One move of an area alone, as laws are: what evaluate_pose comes to, in a tenth of the time.
HeldPose evaluate_law(const LivePose& live, double time_s) {
  HeldPose built;
  for (const LivePose::Value& value : live.values) {
    const MoveInfo& info = kMoves[value.move];
    const double asked = std::clamp(evaluate_held(*value.formula, time_s), value.low, value.high);
    const double held = std::clamp(asked, info.low, info.high);
    built.pose.values[value.move] = held;
    if (held != asked) built.held.push_back({value.move, asked, held, value.place, ""});
  }
  return built;
}

bool is_law(const LivePose& live) {
  return live.shares.empty() && live.exaggerate == 1 && live.reach == 1 &&
         std::ranges::none_of(live.areas.values, [](const auto& value) { return value.has_value(); });
}

}  // namespace

HeldPose evaluate_pose(const LivePose& live, double time_s) {
  if (is_law(live)) return evaluate_law(live, time_s);
  std::vector<PoseShare> shares;
  for (const LivePose::Share& share : live.shares)
    shares.push_back({std::clamp(evaluate(share.weight, time_s), 0.0, 1.0), share.pose});
  PoseAsk ask{mix_poses(shares), live.reach, std::clamp(evaluate(live.strength, time_s), 0.0, 1.0),
              live.areas, live.exaggerate};
  for (const LivePose::Value& value : live.values) {
    const MoveInfo& info = kMoves[value.move];
    const double number = std::clamp(evaluate_held(*value.formula, time_s), value.low, value.high);
    ask.areas.values[value.move] = number;
    ask.areas.places.erase(value.move);
    if (number < info.low || number > info.high) ask.areas.places[value.move] = value.place;
  }
  return hold_pose(ask);
}

}  // namespace mien

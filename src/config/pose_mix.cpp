#include "config/pose_mix.hpp"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

// Whether `exaggerate` lifts a move's limit, downward and upward.
const auto kIsLifted = [] {
  std::array<std::array<bool, 2>, kChannelCount> lifted{};
  for (std::size_t i = 0; i < kChannelCount; ++i)
    lifted[i] = {find_stop(i, -1).empty(), find_stop(i, 1).empty()};
  return lifted;
}();

// What all shares ask of a move in one way, up or down, and how much they have to say there.
struct Way {
  double value = 0, dominance = 0;  // the dominance times the value's size, until it is divided by it

  void add(double change, double of_dominance) {
    value += change;
    dominance += std::abs(change) * of_dominance;
  }
};

// What is left of a way against the other.
double yield_to(const Way& other, const Way& way) {
  if (way.value == 0 || other.value == 0) return way.value;
  const double own = std::pow(way.dominance / way.value, 2);
  const double others = std::pow(other.dominance / other.value, 2);
  if (own >= others) return way.value;
  const double opposed = std::min(std::abs(way.value), std::abs(other.value));
  return way.value - std::copysign(opposed, way.value) * (1 - 2 * own / (own + others));
}

Pose mix_with_manners(const std::vector<PoseShare>& shares, double strength) {
  static const Manner plain;
  Pose mixed;
  for (std::size_t i = 0; i < kChannelCount; ++i) {
    Way up, down;
    for (const PoseShare& share : shares) {
      const Manner& manner = share.manner ? *share.manner : plain;
      const double growth = manner.growth[i];
      const double grown = growth == 1 || strength == 0 ? 1 : std::pow(strength, growth - 1);
      const double value = share.weight * grown * share.pose.values[i];
      if (value >= 0)
        up.add(value, manner.dominance[i]);
      else if (!kIsUpperLid[i])
        down.add(value, manner.dominance[i]);
      else if (value < down.value)
        down = {value, -value * manner.dominance[i]};
    }
    mixed.values[i] = yield_to(down, up) + yield_to(up, down);
  }
  return mixed;
}

}  // namespace

Pose mix_poses(const std::vector<PoseShare>& shares, double strength) {
  if (std::ranges::any_of(shares, [](const PoseShare& share) { return share.manner != nullptr; }))
    return mix_with_manners(shares, strength);
  Pose mixed;
  for (std::size_t i = 0; i < kChannelCount; ++i) {
    double sum = 0, lowest = 0;
    for (const PoseShare& share : shares) {
      const double value = share.weight * share.pose.values[i];
      if (kIsUpperLid[i] && value < 0)
        lowest = std::min(lowest, value);
      else
        sum += value;
    }
    mixed.values[i] = sum + lowest;
  }
  return mixed;
}

HeldPose hold_pose(const PoseAsk& ask) {
  HeldPose built;
  built.reach = std::min(kMaxExaggerate, ask.reach * ask.exaggerate);
  for (std::size_t i = 0; i < kChannelCount; ++i) {
    const double value = ask.areas.values[i].value_or(ask.pose.values[i] * ask.strength);
    const double asked = value * ask.exaggerate;
    const bool is_lifted = kIsLifted[i][asked < 0 ? 0 : 1];
    const double reach = is_lifted ? built.reach : 1;
    const double held = std::clamp(asked, kChannels[i].low * reach, kChannels[i].high * reach);
    built.pose.values[i] = held;
    const bool is_past =
        is_lifted ? held != asked : value != std::clamp(value, kChannels[i].low, kChannels[i].high);
    if (!is_past) continue;
    const auto place = ask.areas.places.find(i);
    built.held.push_back({i, asked, held, place == ask.areas.places.end() ? Place{} : place->second, ""});
  }
  return built;
}

}  // namespace mien

// 20..60 ms between the sides and a difference of a sixth read as life and not as contempt; of a twentieth,
// as is measured on the posed smiles of people, nothing is seen on a drawn head. Some 59 % of right-handed
// people smile stronger on the left (face-facts 3.6: Ekman; "a left-sided smile").
#include "timeline/asymmetry.hpp"

#include <algorithm>

#include "config/pose_mix.hpp"
#include "core/seeded.hpp"
#include "timeline/track.hpp"

namespace mien {
namespace {

constexpr double kLeastDelay_s = 0.02, kMostDelay_s = 0.06;
constexpr double kLeftIsStronger = 0.59;
constexpr double kLeastWeakness = 0.75;  // of the amount: an area that drew less would look even again
// The most that a delay may take of the way between two keys: more would make a quick move a jump.
constexpr double kMostOfWay = 0.3;

// Between two neighbours of the keys; of no length before the first and after the last.
struct Way {
  double from_s = 0, length_s = 0;
};

Way compute_way(const std::vector<double>& keys_s, double time_s) {
  const auto next = std::upper_bound(keys_s.begin(), keys_s.end(), time_s);
  if (next == keys_s.begin() || next == keys_s.end()) return {};
  return {*(next - 1), *next - *(next - 1)};
}

double compute_side_time_s(const Way& way, double time_s, double delay_s, bool is_late) {
  if (way.length_s == 0 || delay_s == 0) return time_s;
  const double waited_s = std::min(delay_s, kMostOfWay * way.length_s);
  const double moving_s = way.length_s - waited_s;
  const double gone_s = time_s - way.from_s - (is_late ? waited_s : 0);
  return way.from_s + way.length_s * std::clamp(gone_s / moving_s, 0.0, 1.0);
}

}  // namespace

Asymmetry build_asymmetry(const AsymmetrySpec& spec, std::vector<double> keys_s) {
  Asymmetry asymmetry{{}, std::move(keys_s)};
  if (spec.amount <= 0) return asymmetry;
  std::mt19937_64 random = build_random(spec.seed, 0);
  for (const AreaInfo& area : kAreas) {
    if (area.lean.weakness <= 0) continue;
    AreaLean lean{.area = area.name};
    lean.late = sample_uniform(random) < 0.5 ? Side::left : Side::right;
    lean.delay_s = sample_uniform(random, kLeastDelay_s, kMostDelay_s);
    if (!area.lean.is_late) lean.delay_s = 0;
    lean.weak = sample_uniform(random) < kLeftIsStronger ? Side::right : Side::left;
    lean.weakness = spec.amount * sample_uniform(random, kLeastWeakness, 1) * area.lean.weakness;
    for (std::size_t i = 0; i < kChannelCount; ++i)
      if (kChannels[i].of == area.area) lean.moves[kChannels[i].side == Side::left ? 0 : 1].set(i);
    asymmetry.areas.push_back(lean);
  }
  return asymmetry;
}

double compute_side_time_s(const std::vector<double>& keys_s, double time_s, double delay_s, bool is_late) {
  return compute_side_time_s(compute_way(keys_s, time_s), time_s, delay_s, is_late);
}

Pose sample_leaning(const Asymmetry& asymmetry, double time_s, const PoseSampler& sample) {
  Pose pose = sample(time_s, std::bitset<kChannelCount>().set());
  if (asymmetry.areas.empty()) return pose;
  const Way way = compute_way(asymmetry.keys_s, time_s);
  for (const AreaLean& lean : asymmetry.areas) {
    for (const Side side : {Side::left, Side::right}) {
      const double side_s = compute_side_time_s(way, time_s, lean.delay_s, side == lean.late);
      const std::bitset<kChannelCount>& moves = lean.moves[side == Side::left ? 0 : 1];
      const Pose other = side_s == time_s ? pose : sample(side_s, moves);
      for_each_move(moves, [&](std::size_t i) {
        const bool is_shutting = kIsUpperLid[i] && other.values[i] < 0;
        const double weakness = side == lean.weak && !is_shutting ? lean.weakness : 0;
        pose.values[i] = other.values[i] * (1 - weakness);
      });
    }
  }
  return pose;
}

}  // namespace mien

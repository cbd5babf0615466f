// The head of one who sits or stands still sways by a degree or so, mostly below half a hertz. A few sines
// whose strength falls as their frequency rises look the same (Perlin, "Improv", 1996, moves resting figures
// by band-limited noise).
#include "timeline/drift.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/seeded.hpp"
#include "core/smooth.hpp"

namespace mien {
namespace {

// At `amount: 1`. Twice as much and the figure looks drunk; half, and it is not seen in a small picture.
constexpr double kTurn_deg = 2.5, kNod_deg = 1.8, kTilt_deg = 1.8;
constexpr double kBrowsUp = 0.12, kBrowsTurn = 0.06, kCornersUp = 0.05;  // shares of the limit

// Breathing in takes two fifths of the time, breathing out longer, and then there is a rest (West,
// "Respiratory Physiology": in to out as 1 to 1.5 or 2).
constexpr double kIn = 0.4, kOut = 0.47;
// The neck straightens and the chin comes up a little with a full chest. 0.5 looks like a nod.
constexpr double kBreathNod_deg = 0.35;
constexpr double kShallow = 0.75;  // the shallowest breath's share of the deepest

using BothSides = std::array<std::size_t, 2>;
consteval BothSides find_both(Area area, std::string_view move) {
  return {*find_move(area, Side::left, move), *find_move(area, Side::right, move)};
}

Sway build_sway(std::uint64_t seed, std::uint64_t use) {
  std::mt19937_64 random = build_random(seed, use);
  Sway sway;
  const auto count = static_cast<double>(sway.waves.size());
  double sum = 0;
  for (std::size_t i = 0; i < sway.waves.size(); ++i) {
    const double place = (static_cast<double>(i) + sample_uniform(random)) / count;  // one in each part
    const double hz = kSlowest_hz * std::pow(kFastest_hz / kSlowest_hz, place);
    sway.waves[i] = {hz, sample_uniform(random, 0, 2 * std::numbers::pi), 1 / hz};
    sum += 1 / hz;
  }
  for (Sway::Wave& wave : sway.waves) wave.share /= sum;
  return sway;
}

// Within low..high, or as far out as it was.
void add_within(double low, double high, double more, double& value) {
  value = std::clamp(value + more, std::min(low, value), std::max(high, value));
}

void add_breath(const Drift& drift, double time_s, TurnKey& turn) {
  if (drift.breath_s <= 0) return;
  const double breaths = time_s / drift.breath_s + drift.breath_phase, begun = std::floor(breaths);
  // As deep as when it began, so that each one rises and falls smoothly.
  const double deep = sample_sway(drift.depth, (begun - drift.breath_phase) * drift.breath_s);
  const double full = sample_breath(breaths - begun) * std::lerp(kShallow, 1.0, (1 + deep) / 2);
  turn.breath_mm += kBreath_mm * full;
  add_within(-kMaxNod_deg, kMaxNod_deg, -kBreathNod_deg * full, turn.nod_deg);
}

}  // namespace

double sample_sway(const Sway& sway, double time_s) {
  double sum = 0;
  for (const Sway::Wave& wave : sway.waves)
    sum += wave.share * std::sin(2 * std::numbers::pi * wave.hz * time_s + wave.phase_rad);
  return sum;
}

double sample_breath(double phase) {
  if (phase < kIn) return smooth_share(phase / kIn);
  return smooth_share(std::max(1 - (phase - kIn) / kOut, 0.0));
}

Drift build_drift(const DriftSpec& spec) {
  const auto sway = [&](std::uint64_t use) { return build_sway(spec.seed, use); };
  Drift drift{spec.amount, sway(1), sway(2), sway(3), sway(4), sway(5), sway(6), 0, 0, sway(7)};
  if (spec.breaths_per_minute > 0) drift.breath_s = 60 / spec.breaths_per_minute;
  std::mt19937_64 random = build_random(spec.seed, 8);
  drift.breath_phase = sample_uniform(random);
  return drift;
}

void add_drift(const Drift& drift, double time_s, Pose& pose, TurnKey& turn) {
  add_breath(drift, time_s, turn);
  if (drift.amount <= 0) return;
  const auto swayed = [&](const Sway& sway, double most) {
    return drift.amount * most * sample_sway(sway, time_s);
  };
  add_within(-kMaxTurn_deg, kMaxTurn_deg, swayed(drift.turn, kTurn_deg), turn.turn_deg);
  add_within(-kMaxNod_deg, kMaxNod_deg, swayed(drift.nod, kNod_deg), turn.nod_deg);
  add_within(-kMaxTilt_deg, kMaxTilt_deg, swayed(drift.tilt, kTilt_deg), turn.tilt_deg);
  // Both sides alike: what sets them apart is `asymmetry`.
  const auto add = [&](const BothSides& moves, double more) {
    for (const std::size_t i : moves) add_within(kMoves[i].low, kMoves[i].high, more, pose.values[i]);
  };
  constexpr BothSides kUp = find_both(Area::brow, "up"), kTurn = find_both(Area::brow, "turn");
  constexpr BothSides kCorners = find_both(Area::corner, "up");
  add(kUp, swayed(drift.brows_up, kBrowsUp));
  add(kTurn, swayed(drift.brows_turn, kBrowsTurn));
  add(kCorners, swayed(drift.corners_up, kCornersUp));
}

}  // namespace mien

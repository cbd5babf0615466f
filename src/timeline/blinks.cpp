// Blinks as people have them: 11 to 19 a minute, closing 40..47 % quicker than opening (Sforza et al., 2008),
// the way down 66..78 ms with some 10 ms of contact (Doane, 1980). Their intervals are uneven, many short and
// a few long (Ponder and Kennedy, "On the act of blinking", 1927); a log-normal law is the simplest of that
// shape. Gaze shifts beyond some 33 degrees nearly always take a blink along, small ones seldom (Evinger et
// al., "Not looking while leaping", 1994).
#include "timeline/blinks.hpp"

#include <algorithm>
#include <cmath>

#include "core/seeded.hpp"
#include "timeline/easing.hpp"
#include "timeline/gaze.hpp"

namespace mien {
namespace {

// Spread of the intervals' logarithm. 0 is a metronome; much above 0.6 blinks come in bursts with long
// stares.
constexpr double kIntervalSpread = 0.5;

// How far down a blink comes that does not shut the eye. Less than half is not seen at 24 frames a second,
// nearly 1 is a shut eye badly drawn.
constexpr double kLeastDepth = 0.5, kMostDepth = 0.85;

// Shifts up to the first take no blink along, from the second on all do.
constexpr double kSeldomShift_deg = 12, kSureShift_deg = 33;

// A time until the next blink whose mean is `mean_s`, and never below the gap.
double sample_interval_s(std::mt19937_64& random, double mean_s) {
  const double free_s = std::max(mean_s - kBlinkGap_s, 0.0);
  const double skewed =
      std::exp(kIntervalSpread * sample_normal(random) - kIntervalSpread * kIntervalSpread / 2);
  return kBlinkGap_s + free_s * skewed;
}

// The time of the drawing nearest to `time_s` that the clip shows.
double snap_to_drawing_s(const ClipSpec& clip, double time_s) {
  const int last = count_frames(clip) - 1;
  const double frame = std::clamp(time_s * clip.fps, 0.0, static_cast<double>(last));
  const int before = compute_drawn_frame(clip, static_cast<int>(frame));
  int after = static_cast<int>(frame) + 1;
  while (after <= last && compute_drawn_frame(clip, after) != after) ++after;
  const bool is_after = after <= last && after - frame <= frame - before;
  return static_cast<double>(is_after ? after : before) / clip.fps;
}

bool is_free(const std::vector<Blink>& blinks, double time_s) {
  return std::none_of(blinks.begin(), blinks.end(),
                      [&](const Blink& other) { return std::abs(other.at_s - time_s) < kBlinkGap_s; });
}

void add_shift_blinks(const ClipSpec& clip, std::vector<Blink>& blinks) {
  if (clip.blink.shifts <= 0) return;
  std::mt19937_64 random = build_random(clip.blink.seed, 1);
  for (const Shift& shift : list_shifts(clip.gaze, clip.turn, clip.camera)) {
    const double share = (shift.amplitude_deg - kSeldomShift_deg) / (kSureShift_deg - kSeldomShift_deg);
    const bool is_taken = sample_uniform(random) < clip.blink.shifts * std::min(share, 1.0);
    const double snapped_s = snap_to_drawing_s(clip, shift.at_s);
    if (is_taken && is_free(blinks, snapped_s)) blinks.push_back({snapped_s, 1});
  }
}

// The clip's own, between those that are there already.
void add_own_blinks(const ClipSpec& clip, std::vector<Blink>& blinks) {
  if (clip.blink.per_minute <= 0) return;
  const std::vector<Blink> others = blinks;
  const double mean_s = 60 / clip.blink.per_minute * (1 + clip.blink.doubles);
  std::mt19937_64 random(clip.blink.seed);
  std::mt19937_64 kinds = build_random(clip.blink.seed, 2);  // of its own: kinds change no times
  const auto sample_depth = [&] {
    const bool is_partial = sample_uniform(kinds) < clip.blink.partial;
    const double depth = sample_uniform(kinds, kLeastDepth, kMostDepth);
    return is_partial ? depth : 1;
  };
  double last_s = -kBlinkGap_s;
  // A clip opens somewhere between two blinks, not just after one.
  double time_s = mean_s * sample_uniform(random);
  for (; time_s < clip.length_s; time_s += sample_interval_s(random, mean_s)) {
    const double snapped_s = snap_to_drawing_s(clip, time_s);
    if (snapped_s < last_s + kBlinkGap_s || !is_free(others, snapped_s)) continue;
    blinks.push_back({snapped_s, sample_depth()});
    last_s = snapped_s;
    if (sample_uniform(kinds) >= clip.blink.doubles) continue;
    // Half a drawing later than the least, so that the nearest drawing is not before it.
    const double second_s = snap_to_drawing_s(clip, snapped_s + kDoubleGap_s + 0.5 * clip.draw / clip.fps);
    if (second_s < snapped_s + kDoubleGap_s || !is_free(others, second_s)) continue;
    blinks.push_back({second_s, sample_depth()});
    last_s = second_s;
  }
}

}  // namespace

std::vector<Blink> place_blinks(const ClipSpec& clip) {
  std::vector<Blink> blinks;
  for (const double asked_s : clip.blinks_s) blinks.push_back({snap_to_drawing_s(clip, asked_s), 1});
  add_shift_blinks(clip, blinks);
  add_own_blinks(clip, blinks);
  std::ranges::sort(blinks, {}, &Blink::at_s);
  blinks.erase(std::unique(blinks.begin(), blinks.end()), blinks.end());
  return blinks;
}

double compute_blink_closure(const std::vector<Blink>& blinks, double time_s) {
  const auto first = std::ranges::lower_bound(blinks, time_s - kBlinkOpening_s, {}, &Blink::at_s);
  double closure = 0;
  for (auto blink = first; blink != blinks.end() && blink->at_s < time_s + kBlinkClosing_s; ++blink) {
    const double since_s = time_s - blink->at_s;
    const double share = since_s <= 0 ? ease(Easing::in_out, 1 + since_s / kBlinkClosing_s)
                                      : 1 - ease(Easing::in_out, since_s / kBlinkOpening_s);
    closure = std::max(closure, blink->depth * share);
  }
  return closure;
}

void close_lids(Pose& pose, double closure) {
  constexpr double kShut = -1;
  constexpr std::size_t kUppers[]{*find_move(Area::lid, Side::left, "upper"),
                                  *find_move(Area::lid, Side::right, "upper")};
  for (const std::size_t move : kUppers) {
    double& upper = pose.values[move];
    upper = std::min(upper, std::lerp(upper, kShut, closure));
  }
}

}  // namespace mien

// Blinks as people have them: 11 to 19 a minute, closing 40..47 % quicker than opening (Sforza et al., 2008),
// the way down 66..78 ms with some 10 ms of contact (Doane, 1980). Their intervals are uneven, many short and
// a few long (Ponder and Kennedy, "On the act of blinking", 1927); a log-normal law is the simplest of that
// shape.
#include "timeline/blinks.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "timeline/easing.hpp"

namespace mien {
namespace {

// Spread of the intervals' logarithm. 0 is a metronome; much above 0.6 blinks come in bursts with long
// stares.
constexpr double kIntervalSpread = 0.5;

// 0 <= u < 1. The library's own distributions may differ from one library to the next; this does not.
double sample_uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

// Near enough to a standard normal, never beyond +-6: the sum of twelve uniforms (Irwin and Hall, 1927).
double sample_normal(std::mt19937_64& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += sample_uniform(random);
  return sum;
}

// A time until the next blink whose mean is `mean_s`, and never below the gap.
double sample_interval_s(std::mt19937_64& random, double mean_s) {
  const double free_s = std::max(mean_s - kBlinkGap_s, 0.0);
  const double skewed =
      std::exp(kIntervalSpread * sample_normal(random) - kIntervalSpread * kIntervalSpread / 2);
  return kBlinkGap_s + free_s * skewed;
}

// The time of the drawing nearest to `time_s` that the clip shows.
double snap_to_drawing_s(const ClipSpec& clip, double time_s) {
  const int draw = std::max(clip.draw, 1);
  const int last_drawing = (count_frames(clip) - 1) / draw;
  const double nearest = std::round(time_s * clip.fps / draw);
  const double drawing = std::clamp(nearest, 0.0, static_cast<double>(last_drawing));
  return drawing * draw / clip.fps;
}

bool is_free(const std::vector<double>& blinks_s, double time_s) {
  return std::none_of(blinks_s.begin(), blinks_s.end(),
                      [&](double other_s) { return std::abs(other_s - time_s) < kBlinkGap_s; });
}

}  // namespace

std::vector<double> place_blinks(const ClipSpec& clip) {
  std::vector<double> blinks_s;
  for (const double asked_s : clip.blinks_s) blinks_s.push_back(snap_to_drawing_s(clip, asked_s));
  if (clip.blink.per_minute > 0) {
    const std::vector<double> asked_s = blinks_s;
    const double mean_s = 60 / clip.blink.per_minute;
    std::mt19937_64 random(clip.blink.seed);
    // A clip opens somewhere between two blinks, not just after one.
    double time_s = mean_s * sample_uniform(random);
    for (; time_s < clip.length_s; time_s += sample_interval_s(random, mean_s)) {
      const double snapped_s = snap_to_drawing_s(clip, time_s);
      const bool is_after_last =
          blinks_s.size() == asked_s.size() || blinks_s.back() + kBlinkGap_s <= snapped_s;
      if (is_after_last && is_free(asked_s, snapped_s)) blinks_s.push_back(snapped_s);
    }
  }
  std::sort(blinks_s.begin(), blinks_s.end());
  blinks_s.erase(std::unique(blinks_s.begin(), blinks_s.end()), blinks_s.end());
  return blinks_s;
}

double find_blink_closure(const std::vector<double>& blinks_s, double time_s) {
  const auto first = std::lower_bound(blinks_s.begin(), blinks_s.end(), time_s - kBlinkOpening_s);
  double closure = 0;
  for (auto shut_s = first; shut_s != blinks_s.end() && *shut_s < time_s + kBlinkClosing_s; ++shut_s) {
    const double since_s = time_s - *shut_s;
    closure = std::max(closure, since_s <= 0 ? ease(Easing::in_out, 1 + since_s / kBlinkClosing_s)
                                             : 1 - ease(Easing::in_out, since_s / kBlinkOpening_s));
  }
  return closure;
}

void close_lids(Pose& pose, double closure) {
  constexpr double kShut = -1;
  for (const Side side : {Side::left, Side::right}) {
    double& upper = pose.values[*find_move("lid", side, "upper")];
    upper = std::min(upper, std::lerp(upper, kShut, closure));
  }
}

}  // namespace mien

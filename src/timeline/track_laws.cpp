#include "timeline/track_laws.hpp"

#include <algorithm>
#include <cmath>

#include "config/law_numbers.hpp"
#include "timeline/easing.hpp"
#include "timeline/lead.hpp"

namespace mien {

namespace {

double compute_law_envelope(const TrackLaw& law, Ticks time) {
  const Ticks from = compute_ticks(law.from_s), full = compute_ticks(law.full_s),
              ebb = compute_ticks(law.ebb_s), end = compute_ticks(law.end_s);
  if (time < from || time >= end) return 0;
  const auto sample = [&](Ticks begin, Ticks until) {
    return ease(Easing::in_out, compute_led_fraction(begin, until, 0, 0, time));
  };
  return sample(from, full) * (1 - (time <= ebb ? 0 : sample(ebb, end)));
}

bool is_coming_over(const TrackLaw& later, const TrackLaw& law, Ticks time) {
  return later.track == law.track && later.number == law.number && later.rule == Rule::over &&
         compute_ticks(later.from_s) <= time && time < compute_ticks(later.full_s);
}

void lay_law(const TrackLaw& law, double weight, double rest, double time_s, double& number) {
  const double asked = std::clamp(evaluate(law.value, time_s), law.range.low, law.range.high);
  const double below = number + law.shift;
  double value = below;
  if (law.rule == Rule::over)
    value = std::lerp(below, asked, weight);
  else if (law.rule == Rule::add)
    value = below + weight * asked;
  else {
    // The furthest of each way, as of areas.
    const double kept = below - rest, part = weight * (asked - rest);
    value = rest + std::max({kept, part, 0.0}) + std::min({kept, part, 0.0});
  }
  number = value - law.shift;
}

// Those that share a number, by their weights; the keys have the rest.
void lay_shared(const std::vector<TrackLaw>& laws, LawTrack track, Ticks time, std::size_t at,
                double& number) {
  double weights = 0, values = 0;
  for (const TrackLaw& law : laws) {
    if (law.track != track || law.number != at || law.rule != Rule::share) continue;
    const double weight = compute_law_envelope(law, time);
    if (weight == 0) continue;
    const double asked =
        std::clamp(evaluate(law.value, compute_seconds(time)), law.range.low, law.range.high);
    weights += weight;
    values += weight * (asked - law.shift);
  }
  if (weights > 0) number = (1 - std::min(weights, 1.0)) * number + values / std::max(weights, 1.0);
}

}  // namespace

double compute_law_weight(const std::vector<TrackLaw>& laws, const TrackLaw& law, Ticks time) {
  if (law.rule == Rule::over)
    for (const TrackLaw& later : laws)
      if (later.from_s > law.from_s && is_coming_over(later, law, time)) {
        time = compute_ticks(later.from_s);  // the first one is the earliest
        break;
      }
  return compute_law_envelope(law, time);
}

void apply_laws(const std::vector<TrackLaw>& laws, LawTrack track, Ticks time, std::span<double> numbers) {
  if (laws.empty()) return;
  const auto rows = list_law_numbers(track);
  for (std::size_t i = 0; i < numbers.size(); ++i) lay_shared(laws, track, time, i, numbers[i]);
  for (const TrackLaw& law : laws) {
    if (law.track != track || law.rule == Rule::share || law.number >= numbers.size()) continue;
    const double weight = compute_law_weight(laws, law, time);
    if (weight > 0) lay_law(law, weight, rows[law.number].rest, compute_seconds(time), numbers[law.number]);
  }
}

}  // namespace mien

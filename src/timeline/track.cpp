// Key frames and their in-betweens: Burtnyk and Wein (1976), as Yen (1990) uses them for the nine areas. An
// in-between is the mix of the two keys around it, number by number, or lies on a curve through all of them.
#include "timeline/track.hpp"

#include <algorithm>
#include <cmath>

#include "core/curves.hpp"
#include "timeline/easing.hpp"

namespace mien {

namespace {

bool is_curve(Between between) { return between == Between::smooth || between == Between::spline; }

// The curves to the keys first + 1 .. last, which are all of one kind.
void build_curve(KeyTrack& track, std::size_t first, std::size_t last) {
  std::vector<double> at_s, values;
  for (std::size_t i = first; i <= last; ++i) at_s.push_back(compute_seconds(track.at[i] - track.at[first]));
  const bool is_spline = track.keys[last].between == Between::spline;
  for (std::size_t i = first + 1; i <= last; ++i) track.slopes[i].resize(track.channels);
  for (std::size_t channel = 0; channel < track.channels; ++channel) {
    values.clear();
    for (std::size_t i = first; i <= last; ++i) values.push_back(track.keys[i].values[channel]);
    const auto slopes = is_spline ? compute_spline_slopes(at_s, values) : compute_smooth_slopes(at_s, values);
    for (std::size_t i = first + 1; i <= last; ++i)
      track.slopes[i][channel] = {slopes[i - first - 1], slopes[i - first]};
  }
}

void build_curves(KeyTrack& track) {
  const auto goes_on = [&](std::size_t i, Between between) {
    return i < track.keys.size() && track.keys[i].between == between && track.at[i] > track.at[i - 1];
  };
  for (std::size_t first = 0; first + 1 < track.keys.size();) {
    std::size_t last = first + 1;
    const Between between = track.keys[last].between;
    if (is_curve(between) && goes_on(last, between)) {
      while (goes_on(last + 1, between)) ++last;
      build_curve(track, first, last);
    }
    first = last;
  }
}

using Numbers = std::array<double, kMaxChannels>;

// A key's numbers now; `room` is for those of a law.
std::span<const double> find_values(const TrackKey& key, Ticks time, Numbers& room) {
  if (!key.law) return key.values;
  const std::span<double> into = std::span(room).first(key.values.size());
  key.law(compute_seconds(time), into);
  return into;
}

// On a curve through the keys' own numbers; what laws add to these meanwhile comes on top.
void sample_curve(const KeyTrack& track, std::size_t to, Ticks time, const Moves& only,
                  std::span<double> into, std::span<const double> a, std::span<const double> b) {
  const TrackKey &from_key = track.keys[to - 1], &to_key = track.keys[to];
  const Ticks length = track.at[to] - track.at[to - 1];
  const double u = static_cast<double>(time - track.at[to - 1]) / static_cast<double>(length);
  for_each_move(only, [&](std::size_t i) {
    const auto [out, in] = track.slopes[to][i];
    into[i] = sample_cubic(from_key.values[i], to_key.values[i], out, in, compute_seconds(length), u) +
              std::lerp(a[i] - from_key.values[i], b[i] - to_key.values[i], u);
  });
}

void sample_way(const KeyTrack& track, std::size_t to, Ticks time, const Moves& only,
                std::span<double> into) {
  const TrackKey& key = track.keys[to];
  Numbers room_a, room_b;
  const std::span<const double> a = find_values(track.keys[to - 1], time, room_a);
  const std::span<const double> b = find_values(key, time, room_b);
  if (!track.slopes[to].empty()) {
    sample_curve(track, to, time, only, into, a, b);
    return;
  }
  const Ticks begin = track.at[to - 1], end = track.at[to];
  const bool is_even = key.between == Between::linear || key.ease.kind == Easing::linear;
  const Ease eased = is_even ? Ease(Easing::linear) : key.ease;
  const bool is_held = key.ease.kind == Easing::hold;
  const Lead& lead = track.leads[key.lead];
  const std::vector<Ticks>& releases = track.keys[to - 1].release;
  const bool is_led = !is_even && !is_held && !lead.after.empty();
  const bool is_released = !is_held && !releases.empty();
  Ticks known_after = -1;
  double led_share = 0;
  for_each_move(only, [&](std::size_t i) {
    const Ticks release = is_released ? releases[i] : -1;
    const Ticks after = is_led ? lead.after[i] : 0;
    if (release < 0 && after != known_after) {
      known_after = after;
      led_share = ease(
          eased, compute_led_fraction(begin, end, after, is_led ? lead.widest : 0, time, lead.most_share));
    }
    const double share =
        release < 0 ? led_share
                    : ease(eased, compute_led_fraction(begin, std::min(begin + release, end), 0, 0, time));
    // std::lerp: exact at both ends and never outside them, which a + (b - a) * t is not.
    into[i] = std::lerp(a[i], b[i], share);
  });
}

}  // namespace

KeyTrack build_track(std::vector<TrackKey> keys, std::size_t channels, Lead lead) {
  KeyTrack track;
  track.channels = channels;
  track.keys = std::move(keys);
  std::ranges::stable_sort(track.keys, {}, &TrackKey::at_s);
  for (const TrackKey& key : track.keys) track.at.push_back(compute_ticks(key.at_s));
  track.slopes.resize(track.keys.size());
  track.leads.push_back(std::move(lead));
  build_curves(track);
  return track;
}

void sample_track(const KeyTrack& track, Ticks time, std::span<double> into) {
  sample_track(track, time, Moves().set() >> (kChannelCount - track.channels), into);
}

void sample_track(const KeyTrack& track, Ticks time, const Moves& only, std::span<double> into) {
  const auto next = static_cast<std::size_t>(std::ranges::upper_bound(track.at, time) - track.at.begin());
  const bool is_on_key = next > 0 && track.at[next - 1] == time;
  if (next > 0 && next < track.at.size() && !is_on_key) return sample_way(track, next, time, only, into);
  Numbers room;
  const auto values = find_values(track.keys[next == 0 ? 0 : next - 1], time, room);
  for_each_move(only, [&](std::size_t i) { into[i] = values[i]; });
}

}  // namespace mien

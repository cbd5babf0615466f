// A track: numbers that go from key to key, all at the same times.
#pragma once

#include <array>
#include <bit>
#include <bitset>
#include <functional>
#include <span>
#include <vector>

#include "config/clip_spec.hpp"
#include "core/ticks.hpp"

namespace mien {

// The most numbers of a track: a pose's.
inline constexpr std::size_t kMaxChannels = kMoveCount;

// Some of a track's channels; of a pose's the moves.
using Moves = std::bitset<kMoveCount>;

// Does `work(i)` for each that is set, ascending.
template <typename Work>
void for_each_move(const Moves& only, const Work& work) {
  for (unsigned long rest = only.to_ulong(); rest != 0; rest &= rest - 1)
    work(static_cast<std::size_t>(std::countr_zero(rest)));
}

// A key's numbers as a law of time: (seconds, into as many as the track has).
using KeyLaw = std::function<void(double, std::span<double>)>;

struct TrackKey {
  double at_s = 0;
  Ease ease;  // as of PoseKey
  Between between = Between::ease;
  std::vector<double> values;  // as many in each key of a track
  KeyLaw law = {};             // empty: the values stay what they are
};

// Keys made ready to be sampled.
struct KeyTrack {
  std::size_t channels = 0;
  std::vector<TrackKey> keys;  // by time; of keys at one time the last written is last
  std::vector<Ticks> at;       // their times
  // For each key and channel the slopes of the curve to it: where it sets out and where it arrives. Empty for
  // a key that no curve leads to.
  std::vector<std::vector<std::array<double, 2>>> slopes;
  std::vector<Ticks> after;  // channel by channel: how much later it sets out
  Ticks widest = 0;          // the largest of them
};

// `after_s` are offsets of `lead`, one a channel or none at all.
KeyTrack build_track(std::vector<TrackKey> keys, std::size_t channels, std::span<const double> after_s = {});

// The numbers at a time: a key's own at its time exactly, the first key's before it and the last one's after
// it. An eased way is gone channel by channel (find_led_fraction); straight ways and curves together. With
// `only` some channels: the others are left as they are.
void sample_track(const KeyTrack& track, Ticks time, std::span<double> into);
void sample_track(const KeyTrack& track, Ticks time, const Moves& only, std::span<double> into);

// The share of a way's time, from `begin` to `end`, that is gone for one who sets out `after` later than the
// first and arrives so much earlier than the last, who sets out `widest` later. Nobody is later than a
// quarter of the way, and all are there at `end`.
double find_led_fraction(Ticks begin, Ticks end, Ticks after, Ticks widest, Ticks time);

}  // namespace mien

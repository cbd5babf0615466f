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
#include "timeline/lead.hpp"

namespace mien {

// The most numbers of a track: a pose's.
inline constexpr std::size_t kMaxChannels = kChannelCount;

// Some of a track's channels; of a pose's the moves.
using Moves = std::bitset<kChannelCount>;

// Those of the areas: what a clip has that no muscle and no unit moves.
inline const Moves kAreaMoves = Moves().set() >> (kChannelCount - kMoveCount);

// Whether the whole face is meant, and the head's turn with it.
inline bool is_whole(const Moves& only) { return (only & kAreaMoves) == kAreaMoves; }

// Does `work(i)` for each that is set, ascending.
template <typename Work>
void for_each_move(const Moves& only, const Work& work) {
  constexpr std::size_t kWord = 64;
  static const Moves kLow = ~0ull;
  for (std::size_t begin = 0; begin < only.size(); begin += kWord)
    for (unsigned long long rest = ((only >> begin) & kLow).to_ullong(); rest != 0; rest &= rest - 1)
      work(begin + static_cast<std::size_t>(std::countr_zero(rest)));
}

// A key's numbers as a law of time: (seconds, into as many as the track has).
using KeyLaw = std::function<void(double, std::span<double>)>;

struct TrackKey {
  double at_s = 0;
  Ease ease;  // as of PoseKey
  Between between = Between::ease;
  std::vector<double> values;  // as many in each key of a track
  KeyLaw law = {};             // empty: the values stay what they are
  std::size_t lead = 0;        // which of the track's leads the way to this key has
  // Channel by channel how long it takes to come off this key; below 0: as the way is led. Empty: all below.
  std::vector<Ticks> release = {};
};

// Keys made ready to be sampled.
struct KeyTrack {
  std::size_t channels = 0;
  std::vector<TrackKey> keys;  // by time; of keys at one time the last written is last
  std::vector<Ticks> at;       // their times
  // For each key and channel the slopes of the curve to it: where it sets out and where it arrives. Empty for
  // a key that no curve leads to.
  std::vector<std::vector<std::array<double, 2>>> slopes;
  std::vector<Lead> leads;  // the plain one, and those of the kinds of ways that there are
};

// Without a lead all channels go together.
KeyTrack build_track(std::vector<TrackKey> keys, std::size_t channels, Lead lead = {});

// The numbers at a time: a key's own at its time exactly, the first key's before it and the last one's after
// it. An eased way is gone channel by channel, as its lead or the release of the key before has it; straight
// ways and curves together. With `only` some channels: the others are left as they are.
void sample_track(const KeyTrack& track, Ticks time, std::span<double> into);
void sample_track(const KeyTrack& track, Ticks time, const Moves& only, std::span<double> into);

}  // namespace mien

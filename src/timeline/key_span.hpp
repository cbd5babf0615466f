// Where a time lies among the keys of a track.
#pragma once

#include <algorithm>
#include <vector>

#include "timeline/easing.hpp"

namespace mien {

// `share` of the way from one key to the next: 0..1, exactly 0 at a key's own time. Before the first key and
// after the last both are the same key.
template <typename Key>
struct KeySpan {
  const Key* from = nullptr;
  const Key* to = nullptr;
  double share = 0;
};

// `keys` are by time, and at least one.
template <typename Key>
KeySpan<Key> find_span(const std::vector<Key>& keys, double time_s) {
  const auto next = std::ranges::upper_bound(keys, time_s, {}, &Key::at_s);
  if (next == keys.begin()) return {&keys.front(), &keys.front()};
  const auto last = std::prev(next);
  if (next == keys.end()) return {&*last, &*last};
  const double share = ease(next->ease, (time_s - last->at_s) / (next->at_s - last->at_s));
  return {&*last, &*next, std::clamp(share, 0.0, 1.0)};
}

}  // namespace mien

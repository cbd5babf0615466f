// What the limits hold back in time: where curves, overshoots, sums of cues, formulas and looks ask for more.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "timeline/performance.hpp"

namespace mien {

// Of all that asked for too much of a move in one line, the most and when.
class MostHeld {
 public:
  // What the poses of keys and cues, and their sum `asked` (sample_layers), ask for at a time.
  void add_face(const Performance& performance, double time_s, const FaceState& asked);
  // What the gaze asks of eyes that are otherwise as `moment` has them (sample_unlooking).
  void add_looks(const Performance& performance, double time_s, const Moment& moment);
  // What was found at later times.
  void add(const MostHeld& later);

  // Each move of each line once, at the time at which it asks for most, by places and moves.
  std::vector<Held> list() const;

 private:
  struct Found {
    Held held;
    double time_s = 0;
  };
  using Key = std::tuple<std::string, int, int, std::size_t, bool>;
  std::map<Key, Found> found_;

  void add(const Held& held, double time_s);
  void add_live(const PoseKey& key, double time_s);
};

}  // namespace mien

#include "timeline/parts.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/parallel.hpp"
#include "timeline/easing.hpp"

namespace mien {

namespace {

// How much of the later one of two keys there is.
double find_share(const PoseKey& from, const PoseKey& to, double time_s) {
  const double fraction = (time_s - from.at_s) / (to.at_s - from.at_s);
  return to.between == Between::ease ? ease(to.ease, fraction) : fraction;
}

double find_most_weight(const CueStack& stack, const Cue& cue, Ticks time) {
  double most = 0;
  for (std::size_t move = 0; move < kMoveCount; ++move)
    if (cue.spec.owns[move]) most = std::max(most, find_weight(stack, cue, move, time));
  return most;
}

// The key that a move goes to or rests on.
const PoseKey& find_key(const std::vector<PoseKey>& keys, double time_s) {
  const auto next = std::ranges::lower_bound(keys, time_s, {}, &PoseKey::at_s);
  return next == keys.end() ? keys.back() : *next;
}

// Of all that asked for too much of a move in one line, the most.
class Most {
 public:
  void add(Held held, double time_s) {
    held.by = fmt::format("{}{}at {:.4g}s", held.by, held.by.empty() ? "" : " ", time_s);
    const auto key =
        std::tuple(held.place.file, held.place.line, held.place.column, held.move, held.asked < 0);
    add(key, held);
  }
  void add(const Most& later) {
    for (const auto& [key, held] : later.found_) add(key, held);
  }
  std::vector<Held> list() const {
    std::vector<Held> ledger;
    for (const auto& [key, held] : found_) ledger.push_back(held);
    sort_ledger(ledger);
    return ledger;
  }

 private:
  using Key = std::tuple<std::string, int, int, std::size_t, bool>;
  static constexpr double kNoise = 1e-9;  // of sums that are the same
  std::map<Key, Held> found_;

  void add(const Key& key, const Held& held) {
    const auto [known, is_new] = found_.try_emplace(key, held);
    if (!is_new && std::abs(held.asked) > std::abs(known->second.asked) + kNoise) known->second = held;
  }
};

void add_live(const PoseKey& key, double time_s, Most& most) {
  if (!key.live) return;
  for (Held held : evaluate_pose(*key.live, time_s).held) {
    if (held.place.line == 0) held.place = key.place;
    if (held.by.empty()) held.by = key.label;
    most.add(held, time_s);
  }
}

void add_frame(const Performance& performance, double time_s, Most& most) {
  const Layers& layers = *performance.layers;
  const Ticks time = find_ticks(time_s);
  const PoseKey& key = find_key(performance.clip.keys, time_s);
  add_live(key, time_s, most);
  std::array<const PoseKey*, kMoveCount> askers;
  askers.fill(&key);
  for (std::size_t layer = 0; layer < count_layers(layers.cues); ++layer)
    for (const Cue& cue : find_cues(layers.cues, layer, time)) {
      if (time < cue.from || time >= cue.end) continue;
      add_live(cue.spec.what, time_s, most);
      for (std::size_t move = 0; move < kMoveCount; ++move)
        if (cue.spec.owns[move]) askers[move] = &cue.spec.what;
    }
  const FaceState face = sample_layers(layers, time);
  for (std::size_t move = 0; move < kMoveCount; ++move) {
    const double asked = face.values[move], held = hold_value(move, asked, face.reach[move]);
    constexpr double kSlack = 1e-6;  // what nobody can see is not told
    if (std::abs(asked - held) > kSlack)
      most.add({move, asked, held, askers[move]->place, askers[move]->label}, time_s);
  }
}

// `without` is the performance without its gaze.
void add_looks(const Performance& performance, const Performance& without, double time_s, Most& most) {
  const Moment now = sample_performance(without, time_s);
  for (const Held& held :
       list_held_looks(performance.idle.gaze, performance.idle.eyes, time_s, now.turn, now.camera, now.pose))
    most.add(held, time_s);
}

}  // namespace

std::vector<MomentPart> list_parts(const Performance& performance, double time_s) {
  std::vector<MomentPart> parts;
  const auto add = [&](const PoseKey& key, double share) {
    if (share > 0) parts.push_back({key.label, key.at_s, share, false, key.reach, key.held});
  };
  const std::vector<PoseKey>& keys = performance.clip.keys;
  const auto next = std::ranges::upper_bound(keys, time_s, {}, &PoseKey::at_s);
  if (next == keys.begin() || next == keys.end()) {
    add(next == keys.begin() ? keys.front() : keys.back(), 1);
  } else {
    const double share = find_share(*(next - 1), *next, time_s);
    add(*(next - 1), 1 - share);
    add(*next, share);
  }
  const CueStack& stack = performance.layers->cues;
  for (const Cue& cue : stack.cues)
    if (const double share = find_most_weight(stack, cue, find_ticks(time_s)); share > 0)
      parts.push_back(
          {cue.spec.what.label, cue.spec.from_s, share, true, cue.spec.what.reach, cue.spec.what.held});
  return parts;
}

std::vector<Held> list_held_in_time(const Performance& performance) {
  const ClipSpec& clip = performance.clip;
  Performance without = performance;
  without.idle.gaze = {};
  without.idle.asymmetry = {};            // of brows, lids and corners: no affair of the eyes
  constexpr std::size_t kStretches = 16;  // of the clip, each by itself and told in their order
  const auto count = static_cast<std::size_t>(count_frames(clip));
  std::array<Most, kStretches> found;
  for_each_index(kStretches, count_cores(), [&](std::size_t i, int) {
    for (std::size_t frame = count * i / kStretches; frame < count * (i + 1) / kStretches; ++frame) {
      const double time_s = find_seconds(find_frame_ticks(static_cast<std::int64_t>(frame), clip.fps));
      add_frame(performance, time_s, found[i]);
      if (!clip.gaze.keys.empty()) add_looks(performance, without, time_s, found[i]);
    }
  });
  Most most;
  for (const Most& stretch : found) most.add(stretch);
  return most.list();
}

}  // namespace mien

#include "timeline/most_held.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace mien {

namespace {

constexpr double kNoise = 1e-9;  // of sums that are the same
constexpr double kSlack = 1e-6;  // what nobody can see is not told

// The key that a move goes to or rests on.
const PoseKey& find_key(const std::vector<PoseKey>& keys, double time_s) {
  const auto next = std::ranges::lower_bound(keys, time_s, {}, &PoseKey::at_s);
  return next == keys.end() ? keys.back() : *next;
}

// Who asked for a move: the last of the cues that are there and own it, else the key.
const PoseKey& find_asker(const Performance& performance, double time_s, std::size_t move) {
  const CueStack& cues = performance.layers->cues;
  const Ticks time = compute_ticks(time_s);
  const PoseKey* asker = &find_key(performance.clip.keys, time_s);
  for (std::size_t layer = 0; layer < count_layers(cues); ++layer)
    for (const Cue& cue : find_cues(cues, layer, time))
      if (time >= cue.from && time < cue.end && cue.spec.owns[move]) asker = &cue.spec.what;
  return *asker;
}

}  // namespace

void MostHeld::add_face(const Performance& performance, double time_s, const FaceState& asked) {
  const CueStack& cues = performance.layers->cues;
  const Ticks time = compute_ticks(time_s);
  add_live(find_key(performance.clip.keys, time_s), time_s);
  for (std::size_t layer = 0; layer < count_layers(cues); ++layer)
    for (const Cue& cue : find_cues(cues, layer, time))
      if (time >= cue.from && time < cue.end) add_live(cue.spec.what, time_s);
  for (std::size_t move = 0; move < kChannelCount; ++move) {
    const double value = asked.values[move], held = hold_value(move, value, asked.reach[move]);
    if (std::abs(value - held) <= kSlack) continue;
    const PoseKey& asker = find_asker(performance, time_s, move);
    add({move, value, held, asker.place, asker.label}, time_s);
  }
}

void MostHeld::add_looks(const Performance& performance, double time_s, const Moment& moment) {
  const Idle& idle = performance.idle;
  if (idle.gaze.spec.keys.empty()) return;
  for (const Held& held :
       list_held_looks(idle.gaze, idle.eyes, time_s, moment.turn, moment.camera, moment.pose))
    add(held, time_s);
}

void MostHeld::add(const MostHeld& later) {
  for (const auto& [key, found] : later.found_) add(found.held, found.time_s);
}

std::vector<Held> MostHeld::list() const {
  std::vector<Held> ledger;
  for (const auto& [key, found] : found_) {
    Held& held = ledger.emplace_back(found.held);
    held.by = fmt::format("{}{}at {:.4g}s", held.by, held.by.empty() ? "" : " ", found.time_s);
  }
  sort_ledger(ledger);
  return ledger;
}

void MostHeld::add(const Held& held, double time_s) {
  const Key key{held.place.file, held.place.line, held.place.column, held.move, held.asked < 0};
  const auto [known, is_new] = found_.try_emplace(key, Found{held, time_s});
  if (!is_new && std::abs(held.asked) > std::abs(known->second.held.asked) + kNoise)
    known->second = {held, time_s};
}

void MostHeld::add_live(const PoseKey& key, double time_s) {
  if (!key.live || !can_be_held(*key.live)) return;
  for (Held held : evaluate_pose(*key.live, time_s).held) {
    if (held.place.line == 0) held.place = key.place;
    if (held.by.empty()) held.by = key.label;
    add(held, time_s);
  }
}

}  // namespace mien

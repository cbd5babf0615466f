#include "timeline/parts.hpp"

#include <algorithm>

#include "config/words.hpp"
#include "timeline/easing.hpp"
#include "timeline/lead.hpp"
#include "timeline/most_held.hpp"
#include "timeline/track_laws.hpp"

namespace mien {

namespace {

bool is_led(const PoseKey& to) {
  return to.between == Between::ease && to.ease.kind != Easing::linear && to.ease.kind != Easing::hold;
}

// How much of the later one of two keys there is.
double compute_share(const PoseKey& from, const PoseKey& to, double time_s) {
  const double fraction = (time_s - from.at_s) / (to.at_s - from.at_s);
  return to.between == Between::ease ? ease(to.ease, fraction) : fraction;
}

// Which parts of the face a key releases by themselves, and how far they are off.
std::vector<std::pair<std::string, double>> list_released(const PoseKey& from, const PoseKey& to,
                                                          double time_s) {
  std::vector<std::pair<std::string, double>> released;
  const Ticks begin = compute_ticks(from.at_s), end = compute_ticks(to.at_s);
  for (std::size_t part = 0; part < kFacePartCount; ++part)
    if (const double part_s = from.release[part]; part_s >= 0)
      released.emplace_back(
          kReleaseKeys[part],
          ease(to.ease, compute_led_fraction(begin, std::min(begin + compute_ticks(part_s), end), 0, 0,
                                             compute_ticks(time_s))));
  return released;
}

bool is_endless(const CueSpec& cue) { return cue.layer == Layer::cue && cue.end_s == kForever_s; }

double compute_most_weight(const CueStack& stack, const Cue& cue, Ticks time) {
  double most = 0;
  for (std::size_t move = 0; move < kChannelCount; ++move)
    if (cue.spec.owns[move]) most = std::max(most, compute_weight(stack, cue, move, time));
  return most;
}

}  // namespace

std::vector<MomentPart> list_parts(const Performance& performance, double time_s) {
  std::vector<MomentPart> parts;
  const auto add = [&](const PoseKey& key, double share) {
    if (share > 0) parts.push_back({key.label, key.at_s, share, false, false, key.reach, key.held});
  };
  const std::vector<PoseKey>& keys = performance.clip.keys;
  const auto next = std::ranges::upper_bound(keys, time_s, {}, &PoseKey::at_s);
  if (next == keys.begin() || next == keys.end()) {
    add(next == keys.begin() ? keys.front() : keys.back(), 1);
  } else {
    const double share = compute_share(*(next - 1), *next, time_s);
    add(*(next - 1), 1 - share);
    if (!parts.empty()) parts.back().released = list_released(*(next - 1), *next, time_s);
    add(*next, share);
    if (const WayKind* kind = find_way_kind(performance.clip.lead, (next - 1)->pose, next->pose);
        kind != nullptr && share > 0 && is_led(*next))
      parts.back().order = kind->what;
  }
  const CueStack& stack = performance.layers->cues;
  for (const Cue& cue : stack.cues)
    if (const double share = compute_most_weight(stack, cue, compute_ticks(time_s)); share > 0)
      parts.push_back({cue.spec.what.label, cue.spec.from_s, share, true, is_endless(cue.spec),
                       cue.spec.what.reach, cue.spec.what.held});
  const std::vector<TrackLaw>& laws = performance.layers->laws;
  for (const TrackLaw& law : laws)
    if (const double share = compute_law_weight(laws, law, compute_ticks(time_s)); share > 0)
      parts.push_back({law.label, law.from_s, share, true, false, 1, {}});
  return parts;
}

std::vector<Held> list_held_at(const Performance& performance, double time_s) {
  const FaceState asked = sample_layers(*performance.layers, compute_ticks(time_s));
  MostHeld most;
  most.add_face(performance, time_s, asked);
  most.add_looks(performance, time_s, sample_unlooking(performance, time_s, asked));
  std::vector<Held> ledger = most.list();
  for (const MomentPart& part : list_parts(performance, time_s))
    ledger.insert(ledger.end(), part.held.begin(), part.held.end());
  sort_ledger(ledger);
  return ledger;
}

}  // namespace mien

#include "timeline/cues.hpp"

#include <algorithm>
#include <cmath>

#include "config/pose_mix.hpp"
#include "timeline/easing.hpp"
#include "timeline/layers.hpp"

namespace mien {

namespace {

bool covers(const Cue& cue) {
  return cue.spec.rule == Rule::over && cue.full > cue.from && cue.ebb >= cue.full;
}

// Until when each cue, move by move, is still coming over what lies below: longer than its own attack if yet
// another one comes over it meanwhile.
using Covers = std::vector<std::array<Ticks, kChannelCount>>;

Covers compute_covers(std::span<const Cue> cues) {
  Covers until(cues.size());
  for (std::size_t i = cues.size(); i-- > 0;) {
    until[i].fill(cues[i].full);
    for (std::size_t later = i + 1; later < cues.size(); ++later) {
      const Cue& other = cues[later];
      if (other.from >= *std::ranges::max_element(until[i])) break;
      const auto shared = cues[i].spec.owns & other.spec.owns;
      for (std::size_t move = 0; move < kChannelCount && covers(other); ++move)
        if (shared[move] && other.from < until[i][move])
          until[i][move] = std::max(until[i][move], until[later][move]);
    }
  }
  return until;
}

// The cues of one layer, by their times.
void freeze_cues(std::span<Cue> cues) {
  const Covers covered = compute_covers(cues);
  for (std::size_t i = 0; i < cues.size(); ++i) {
    Cue& cue = cues[i];
    cue.gone = cue.end;
    if (cue.spec.rule != Rule::over) continue;
    // Until when each move is still. What comes over it meanwhile has an end that is not later
    // (compute_covers).
    std::array<Ticks, kChannelCount> still{};
    still.fill(-kEndless);
    const auto is_still = [&](Ticks time) {
      for (std::size_t move = 0; move < kChannelCount; ++move)
        if (cue.spec.owns[move] && still[move] < time) return false;
      return true;
    };
    for (std::size_t later = i + 1; later < cues.size() && cues[later].from < cue.end; ++later) {
      const Cue& other = cues[later];
      const auto shared = cue.spec.owns & other.spec.owns;
      if (!covers(other) || shared.none()) continue;
      if (is_still(cue.end)) break;
      for (std::size_t move = 0; move < kChannelCount; ++move) {
        if (!shared[move] || other.from < still[move]) continue;
        const Ticks until = covered[later][move];
        if (cue.full <= other.from && until <= cue.ebb) continue;  // all there meanwhile anyhow
        still[move] = until;
        if (cue.freezes.empty() || cue.freezes.back().from != other.from || cue.freezes.back().until != until)
          cue.freezes.push_back({other.from, until, {}});
        cue.freezes.back().moves.set(move);
        cue.gone = std::max(cue.gone, until);
      }
    }
  }
}

// What a cue shows now, of some moves.
FaceState show(const Cue& cue, Ticks time, const Moves& only) {
  if (cue.script) return sample_layers(*cue.script, compute_script_time(cue, time), only);
  FaceState shown;
  if (cue.table) {
    std::array<double, kMaxChannels> row;
    const auto& moves = cue.spec.table->moves;
    sample_track(*cue.table, time - cue.start, std::span(row).first(moves.size()));
    for (std::size_t i = 0; i < moves.size(); ++i) shown.values[moves[i]] = row[i];
    shown.reach.fill(cue.spec.what.reach);
  } else if (cue.spec.what.live) {
    shown.reach.fill(evaluate_pose(*cue.spec.what.live, compute_seconds(time), only, shown.values));
  } else {
    shown.values = cue.spec.what.pose.values;
    shown.reach.fill(cue.spec.what.reach);
  }
  return shown;
}

Ticks compute_after(const Lead& lead, std::size_t move) { return lead.after.empty() ? 0 : lead.after[move]; }

double compute_envelope(const CueStack& stack, const Cue& cue, std::size_t move, Ticks time) {
  if (time < cue.from || time >= cue.end) return 0;
  const auto sample = [&](Ticks begin, Ticks end, const Lead& lead) {
    return ease(Easing::in_out, compute_led_fraction(begin, end, compute_after(lead, move), lead.widest, time,
                                                     lead.most_share));
  };
  const double come = sample(cue.from, cue.full, stack.leads[cue.come]);
  const double gone = time <= cue.ebb ? 0 : sample(cue.ebb, cue.end, stack.leads[cue.go]);
  return cue.spec.amount * come * (1 - gone);
}

void lay(Rule rule, std::size_t move, double weight, const FaceState& shown, FaceState& face) {
  double &value = face.values[move], &reach = face.reach[move];
  const double asked = shown.values[move], part = weight * asked;
  if (rule == Rule::over) {
    value = std::lerp(value, asked, weight);
    reach = std::lerp(reach, shown.reach[move], weight);
    return;
  }
  reach = std::max(reach, std::lerp(1.0, shown.reach[move], weight));
  if (rule == Rule::max)
    // The furthest of each way, so that nothing jumps when one way becomes the further one.
    value = std::max({value, part, 0.0}) + std::min({value, part, 0.0});
  else if (kIsUpperLid[move] && value < 0 && part < 0)
    value = std::min(value, part);  // two that close do not close twice (pose_mix.hpp)
  else
    value += part;
}

// Those that share an area, by their weights; what lies below has the rest.
struct Shares {
  std::array<double, kChannelCount> weights{}, values{}, reach{};

  void add(std::size_t move, double weight, const FaceState& shown) {
    weights[move] += weight;
    values[move] += weight * shown.values[move];
    reach[move] += weight * shown.reach[move];
  }
  void lay(FaceState& face) const {
    for (std::size_t i = 0; i < kChannelCount; ++i) {
      const double all = std::max(weights[i], 1.0), below = 1 - std::min(weights[i], 1.0);
      if (weights[i] == 0) continue;
      face.values[i] = below * face.values[i] + values[i] / all;
      face.reach[i] = below * face.reach[i] + reach[i] / all;
    }
  }
};

void apply_cue(const CueStack& stack, const Cue& cue, Ticks time, const Moves& only, FaceState& face,
               Shares& shares) {
  const Moves moves = cue.spec.owns & only;
  const bool turns = cue.script != nullptr && is_whole(only);
  if (moves.none() && !turns) return;
  const FaceState shown = show(cue, time, turns ? only : moves);
  for (std::size_t i = 0; turns && i < shown.turn_deg.size(); ++i)
    face.turn_deg[i] += compute_envelope(stack, cue, 0, time) * shown.turn_deg[i];
  // Most cues come and go with all their moves, or with a few together.
  const bool is_even = cue.freezes.empty();
  std::pair<Ticks, Ticks> known_after{-1, -1};
  double weight = 0;
  for_each_move(moves, [&](std::size_t move) {
    const std::pair after(compute_after(stack.leads[cue.come], move),
                          compute_after(stack.leads[cue.go], move));
    if (!is_even || after != known_after) weight = compute_weight(stack, cue, move, time);
    known_after = after;
    if (weight == 0) return;
    if (cue.spec.rule == Rule::share)
      shares.add(move, weight, shown);
    else
      lay(cue.spec.rule, move, weight, shown, face);
  });
}

// The cues of one layer that are there at a time: first those that share, then the others upon them.
void apply_layer(const CueStack& stack, std::size_t layer, Ticks time, const Moves& only, FaceState& face) {
  const std::span<const Cue> cues = find_cues(stack, layer, time);
  Shares shares;
  bool is_shared = false;
  for (const Cue& cue : cues)
    if (cue.spec.rule == Rule::share && time < cue.gone) {
      apply_cue(stack, cue, time, only, face, shares);
      is_shared = true;
    }
  if (is_shared) shares.lay(face);
  for (const Cue& cue : cues)
    if (cue.spec.rule != Rule::share && time < cue.gone) apply_cue(stack, cue, time, only, face, shares);
}

}  // namespace

CueStack build_cue_stack(const ClipSpec& clip, LayerStore& store) {
  CueStack stack;
  stack.leads.emplace_back();
  for (const CueSpec& spec : clip.cues) {
    Cue cue{spec,
            compute_ticks(spec.from_s),
            compute_ticks(spec.full_s),
            compute_ticks(spec.ebb_s),
            compute_ticks(spec.end_s),
            compute_ticks(spec.start_s),
            share_script(spec.script, store),
            share_table(spec.table, store),
            {},
            0};
    if (spec.has_lead) {
      cue.come = take_lead(clip.lead, Pose{}, spec.what.pose, stack.leads);
      cue.go = take_lead(clip.lead, spec.what.pose, Pose{}, stack.leads);
    }
    stack.cues.push_back(std::move(cue));
  }
  std::ranges::stable_sort(stack.cues, [](const Cue& a, const Cue& b) {
    return std::pair(a.spec.layer, a.from) < std::pair(b.spec.layer, b.from);
  });
  for (std::size_t i = 0; i < stack.cues.size(); ++i)
    if (i == 0 || stack.cues[i - 1].spec.layer != stack.cues[i].spec.layer) stack.layer_begins.push_back(i);
  stack.layer_begins.push_back(stack.cues.size());
  for (std::size_t i = 0; i + 1 < stack.layer_begins.size(); ++i) {
    const std::size_t begin = stack.layer_begins[i], end = stack.layer_begins[i + 1];
    freeze_cues(std::span(stack.cues).subspan(begin, end - begin));
    Moves& moves = stack.layer_moves.emplace_back();
    for (std::size_t cue = begin; cue < end; ++cue) moves |= stack.cues[cue].spec.owns;
    for (std::size_t cue = begin; cue < end; ++cue)
      stack.latest_end.push_back(
          std::max(stack.cues[cue].gone, cue == begin ? stack.cues[cue].gone : stack.latest_end.back()));
  }
  return stack;
}

void apply_cues(const CueStack& stack, Ticks time, FaceState& face) {
  apply_cues(stack, time, Moves().set(), face);
}

void apply_cues(const CueStack& stack, Ticks time, const Moves& only, FaceState& face) {
  for (std::size_t layer = 0; layer < count_layers(stack); ++layer)
    if (is_whole(only) || (only & stack.layer_moves[layer]).any())
      apply_layer(stack, layer, time, only, face);
}

std::size_t count_layers(const CueStack& stack) { return stack.layer_begins.size() - 1; }

std::span<const Cue> find_cues(const CueStack& stack, std::size_t layer, Ticks time) {
  const std::size_t begin = stack.layer_begins[layer], end = stack.layer_begins[layer + 1];
  const auto here = std::span(stack.cues).subspan(begin, end - begin);
  const auto after = std::ranges::upper_bound(here, time, {}, &Cue::from);
  const auto last = static_cast<std::size_t>(after - here.begin());
  std::size_t first = last;
  while (first > 0 && stack.latest_end[begin + first - 1] > time) --first;
  return here.subspan(first, last - first);
}

double compute_weight(const CueStack& stack, const Cue& cue, std::size_t move, Ticks time) {
  for (const Freeze& freeze : cue.freezes)
    if (freeze.moves[move] && freeze.from <= time && time < freeze.until) {
      time = freeze.from;  // the first one is the earliest
      break;
    }
  return compute_envelope(stack, cue, move, time);
}

Ticks compute_script_time(const Cue& cue, Ticks time) {
  const Ticks since = std::max<Ticks>(time - cue.start, 0), length = cue.script->length;
  if (length == 0) return 0;
  return cue.spec.is_repeated ? since % length : std::min(since, length);
}

}  // namespace mien

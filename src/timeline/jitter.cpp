// Motion needs more than two samples a cycle to keep its form, and animators count four drawings at least to
// a shake: R. Williams, "The Animator's Survival Kit" (2001), "vibrations": on ones, dying away.
#include "timeline/jitter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

#include "config/law_numbers.hpp"
#include "config/quantity.hpp"
#include "core/ticks.hpp"
#include "timeline/layers.hpp"

namespace mien {

namespace {

constexpr int kSteps = 8;            // in a frame: a swing of two frames still has sixteen
constexpr int kMostSteps = 200'000;  // of one number; a longer time is looked at more coarsely
constexpr double kLeastMove = 0.04;  // of a limit, from end to end: a smaller tremble is not seen
constexpr double kLeastTurn_deg = 0.5;
constexpr double kTolerance = 0.125;  // of the drawings of a swing: one that dies away turns a little sooner

// The ends of a number's swings, in time: where it turned round and then came back by `least`.
struct Ends {
  double least = 0;
  std::vector<double> at_s = {};
  bool is_begun = false, is_upward = true;
  double high = 0, high_s = 0, low = 0, low_s = 0;  // since the last end

  void add(double time_s, double value) {
    if (!is_begun || value >= high) high = value, high_s = time_s;
    if (!is_begun || value <= low) low = value, low_s = time_s;
    is_begun = true;
    if ((at_s.empty() || is_upward) && high - value >= least)
      turn(high_s, false, time_s, value);
    else if ((at_s.empty() || !is_upward) && value - low >= least)
      turn(low_s, true, time_s, value);
  }

  void turn(double end_s, bool upward, double time_s, double value) {
    at_s.push_back(end_s);
    is_upward = upward;
    high = low = value;
    high_s = low_s = time_s;
  }
};

std::string name_draw(int draw) {
  constexpr std::array<std::string_view, 3> kNames{"ones", "twos", "threes"};
  return draw <= 3 ? std::string(kNames[static_cast<std::size_t>(draw - 1)])
                   : fmt::format("drawings of {} frames", draw);
}

// Something that may swing, and how it is spoken of.
struct Swinger {
  std::string what;
  Place place;
  double from_s = 0, to_s = 0, least = 0;
  std::function<double(double)> value;
};

// One swinger after another: a clip may have as many as it has laws, and each would keep what it plays.
using Judge = std::function<void(const Swinger&)>;

std::string name_move(std::size_t move) {
  const MoveInfo& info = kChannels[move];
  return fmt::format("{}.{}", info.area, info.move);
}

// Of a key or a cue whose numbers are formulas, a number in time.
using MoveValue = std::function<double(std::size_t, double)>;

// What formulas move: those of single values, and all that a live share or strength takes along.
Moves list_moved(const LivePose& live) {
  Moves moves;
  for (const LivePose::Value& each : live.values) moves.set(each.move);
  bool is_whole = live.strength.formula != nullptr;
  for (const LivePose::Share& share : live.shares) is_whole |= share.weight.formula != nullptr;
  if (is_whole)
    for (const LivePose::Share& share : live.shares)
      for (std::size_t i = 0; i < kChannelCount; ++i)
        if (share.pose.values[i] != 0) moves.set(i);
  return moves;
}

// Of both sides that one formula moves alike the left one alone: the right one would be told in the same
// words.
Moves leave_out_twins(const LivePose& live, Moves moves) {
  if (!live.shares.empty()) return moves;
  for (std::size_t i = 0; i + 1 < live.values.size(); ++i) {
    const LivePose::Value &one = live.values[i], &next = live.values[i + 1];
    const MoveInfo &left = kChannels[one.move], &right = kChannels[next.move];
    const bool is_same = one.formula == next.formula && one.low == next.low && one.high == next.high &&
                         left.low == right.low && left.high == right.high;
    if (is_same && left.area == right.area && left.move == right.move)
      moves.reset(std::max(one.move, next.move));
  }
  return moves;
}

void judge_moves(const Moves& moves, const Place& place, const std::string& of, double from_s, double to_s,
                 const MoveValue& value, const Judge& judge) {
  for_each_move(moves, [&](std::size_t move) {
    judge({fmt::format("{} of {}", name_move(move), of), place, from_s, to_s, kLeastMove,
           [&value, move](double t) { return value(move, t); }});
  });
}

// The formulas of a law or a cue by themselves.
MoveValue build_value(const PoseKey& what) {
  return [live = what.live](std::size_t move, double time_s) {
    std::array<double, kChannelCount> values{};
    evaluate_pose(*live, time_s, Moves().set(move), values);
    return values[move];
  };
}

// A key is there from the one before it to the one after it.
template <typename Key, typename Add>
void add_keys(const std::vector<Key>& keys, double end_s, const Add& add) {
  for (std::size_t i = 0; i < keys.size(); ++i)
    add(keys[i], i == 0 ? 0 : keys[i - 1].at_s, i + 1 == keys.size() ? end_s : keys[i + 1].at_s);
}

// A script's own time, at a time of its cue.
double compute_script_s(const CueSpec& cue, double time_s) {
  const double since_s = std::max(time_s - cue.start_s, 0.0), length_s = cue.script->length_s;
  return cue.is_repeated && length_s > 0 ? std::fmod(since_s, length_s) : std::min(since_s, length_s);
}

// Whether a channel of a track is ever anything else than at its beginning.
bool has_moves(const KeyTrack& track, std::size_t channel) {
  return std::ranges::any_of(track.keys, [&](const TrackKey& key) {
    return key.law || key.values[channel] != track.keys.front().values[channel];
  });
}

// The head's turning in a script, and what trembles in it, as its cue plays it.
void judge_script(const CueSpec& cue, double to_s, LayerStore& store, const Judge& judge) {
  const auto layers = share_script(cue.script, store);
  constexpr std::array<std::string_view, 3> kNames{"turn", "nod", "tilt"};
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (has_moves(layers->turn, i))
      judge({fmt::format("the {} of '{}'", kNames[i], cue.what.label), cue.what.place, cue.from_s, to_s,
             kLeastTurn_deg, [&](double t) {
               std::array<double, 3> turn{};
               sample_track(layers->turn, compute_ticks(compute_script_s(cue, t)), turn);
               return turn[i];
             }});
  for (const CueSpec& inner : cue.script->cues) {
    if (!inner.what.live) continue;
    judge_moves(
        leave_out_twins(*inner.what.live, list_moved(*inner.what.live)), cue.what.place,
        fmt::format("'{}'", cue.what.label), cue.from_s, to_s,
        [value = build_value(inner.what), &cue](std::size_t move, double t) {
          return value(move, compute_script_s(cue, t));
        },
        judge);
  }
}

// Keys are judged as they are drawn, mixed with those around them.
void judge_swingers(const ClipSpec& clip, const Judge& judge) {
  LayerStore store;
  const Layers layers = build_layers(clip, store);
  const MoveValue pose = [&](std::size_t move, double time_s) {
    std::array<double, kChannelCount> values{};
    sample_track(layers.pose, compute_ticks(time_s), Moves().set(move), values);
    return values[move];
  };
  add_keys(clip.keys, clip.length_s, [&](const PoseKey& key, double from_s, double to_s) {
    if (key.live)
      judge_moves(list_moved(*key.live), key.place, fmt::format("'{}'", key.label), from_s, to_s, pose,
                  judge);
  });
  add_keys(clip.turn, clip.length_s, [&](const TurnKey& key, double from_s, double to_s) {
    constexpr std::array<std::string_view, 3> kNames{"the head's turn", "the head's nod", "the head's tilt"};
    for (std::size_t i = 0; i < kNames.size(); ++i)
      if (key.live[i])
        judge({std::string(kNames[i]), key.place, from_s, to_s, kLeastTurn_deg, [&](double t) {
                 std::array<double, 3> turn{};
                 sample_track(layers.turn, compute_ticks(t), turn);
                 return turn[i];
               }});
  });
  for (const TrackLaw& law : clip.laws)
    if (law.track == LawTrack::turn && law.value.formula)
      judge({fmt::format("the head's {} of a law", list_law_numbers(law.track)[law.number].name), law.place,
             law.from_s, std::min(law.end_s, clip.length_s), kLeastTurn_deg,
             [&law](double t) { return std::clamp(evaluate(law.value, t), law.range.low, law.range.high); }});
  for (const CueSpec& cue : clip.cues) {
    const double to_s = std::min(cue.end_s, clip.length_s);
    if (cue.script)
      judge_script(cue, to_s, store, judge);
    else if (cue.what.live)
      judge_moves(leave_out_twins(*cue.what.live, list_moved(*cue.what.live)), cue.what.place,
                  cue.layer == Layer::law ? "a law" : fmt::format("the cue '{}'", cue.what.label), cue.from_s,
                  to_s, build_value(cue.what), judge);
  }
}

std::string advise(const ClipSpec& clip, const Swing& swing) {
  const double most_ones = static_cast<double>(clip.fps) / kLeastDrawings;
  const double most = most_ones / swing.draw;
  const std::string slower = fmt::format("{:.3g} times a second and die away", std::floor(10 * most) / 10);
  if (swing.draw == 1 || swing.per_second > most_ones) return "let it swing " + slower;
  return "draw it on ones, or let it swing " + slower;
}

}  // namespace

Swing compute_quickest_swing(const ClipSpec& clip, double from_s, double to_s, double least,
                             const std::function<double(double)>& value) {
  Swing quickest;
  if (to_s <= from_s) return quickest;
  const double wanted = std::ceil((to_s - from_s) * clip.fps * kSteps);
  const int steps = static_cast<int>(std::clamp<double>(wanted, 1, kMostSteps));
  Ends ends{.least = least};
  for (int i = 0; i <= steps; ++i) {
    const double time_s = from_s + (to_s - from_s) * i / steps;
    ends.add(time_s, value(time_s));
  }
  // The first of the ends is where it set out from, and no turning.
  for (std::size_t i = 3; i < ends.at_s.size(); ++i) {
    const double begin_s = ends.at_s[i - 2], whole_s = ends.at_s[i] - begin_s;
    const int draw = find_draw(clip, static_cast<int>((begin_s + whole_s / 2) * clip.fps));
    const double drawings = whole_s * clip.fps / draw;
    const double same = 2.0 / (kSteps * draw);  // a step at each end: of equal swings the first one is told
    if (quickest.per_second == 0 || drawings < quickest.drawings - same)
      quickest = {begin_s, 1 / whole_s, drawings, draw};
  }
  return quickest;
}

std::vector<Diagnostic> list_jitter(const ClipSpec& clip) {
  std::vector<Diagnostic> warnings;
  std::set<std::string> told;
  judge_swingers(clip, [&](const Swinger& each) {
    const Swing swing = compute_quickest_swing(clip, each.from_s, each.to_s, each.least, each.value);
    if (swing.per_second == 0 || swing.drawings >= kLeastDrawings * (1 - kTolerance)) return;
    std::string message = fmt::format(
        "{} swings {:.1f} times a second (at {}), {:.1f} drawings each time on {}; fewer than {} jitter: {}",
        each.what, swing.per_second,
        format_quantity(std::round(swing.at_s * 1000) / 1000, build_time_measure(clip.fps)), swing.drawings,
        name_draw(swing.draw), kLeastDrawings, advise(clip, swing));
    if (told.insert(message).second) warnings.push_back({each.place, std::move(message), "", true});
  });
  return warnings;
}

}  // namespace mien

#include "timeline/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "config/load_areas.hpp"
#include "config/quantity.hpp"
#include "config/words.hpp"
#include "timeline/easing.hpp"
#include "timeline/jitter.hpp"
#include "timeline/lead.hpp"
#include "timeline/speech_advice.hpp"

namespace mien {
namespace {

constexpr double kReached = 0.9;      // of a face: less is another face
constexpr double kLeastChange = 0.1;  // of a limit: a smaller change has no apex to miss
constexpr double kSameTime_s = 1e-6;

// The frames of the clip, by time, and what each asks for.
struct Frames {
  const std::vector<double>& drawn_s;
  const std::vector<Pose>& poses;

  std::size_t count() const { return poses.size(); }
  // The first at a time or later, and the first that is later.
  std::size_t find_at(double time_s) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(drawn_s, time_s) - drawn_s.begin());
  }
  std::size_t compute_after(double time_s) const {
    return static_cast<std::size_t>(std::ranges::upper_bound(drawn_s, time_s) - drawn_s.begin());
  }
};

// The moves of one area of one side lie side by side.
struct Group {
  std::size_t begin = 0, end = 0;
};

std::vector<Group> list_groups() {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    const bool is_new =
        i == 0 || kMoves[i].area != kMoves[i - 1].area || kMoves[i].side != kMoves[i - 1].side;
    if (is_new) groups.push_back({i, i});
    groups.back().end = i + 1;
  }
  std::erase_if(groups, [](const Group& group) { return find_area(kMoves[group.begin].of).is_quick; });
  return groups;
}

std::string show_time(const ClipSpec& clip, double time_s) {
  return format_quantity(std::round(time_s * 1000) / 1000, build_time_measure(clip.fps));
}

void add_advice(const PoseKey& key, std::string message, std::vector<Diagnostic>& advice) {
  advice.push_back({key.place, std::move(message), "", true});
}

void judge_hold(const ClipSpec& clip, std::size_t i, std::vector<Diagnostic>& advice) {
  const std::vector<PoseKey>& keys = clip.keys;
  if (i < 2 || i + 1 >= keys.size()) return;  // the clip may begin late in a hold and end early in one
  const PoseKey &from = keys[i - 1], &to = keys[i];
  if (from.pose != to.pose || keys[i - 2].pose == from.pose || keys[i + 1].pose == to.pose) return;
  const double frames = (to.at_s - from.at_s) * clip.fps;
  if (frames > kLeastHold_frames - 0.5) return;
  add_advice(
      to,
      fmt::format("'{}' is held for {:.3g} frames; a hold is read from {} on (until {})", to.label, frames,
                  kLeastHold_frames, show_time(clip, from.at_s + kLeastHold_frames / double(clip.fps))),
      advice);
}

// The move of one area of one side, mm, combined over its moves.
double compute_step_mm(const Pose& from, const Pose& to, const MoveReach& reach, const Group& group) {
  double squares = 0;
  for (std::size_t i = group.begin; i < group.end; ++i) {
    const auto place_mm = [&](double value) {
      return value * (value > 0 ? reach.plus_mm[i] : reach.minus_mm[i]);
    };
    const double step_mm = place_mm(to.values[i]) - place_mm(from.values[i]);
    squares += step_mm * step_mm;
  }
  return std::sqrt(squares);
}

void judge_speed(const ClipSpec& clip, std::size_t key, const Frames& frames, const MoveReach& reach,
                 std::vector<Diagnostic>& advice) {
  if (key == 0) return;
  static const std::vector<Group> groups = list_groups();
  const PoseKey &from = clip.keys[key - 1], &to = clip.keys[key];
  double worst_mm = kFastest_mm, worst_s = 0;
  std::string_view area;
  for (std::size_t f = std::max<std::size_t>(frames.find_at(from.at_s + kSameTime_s), 1); f < frames.count();
       ++f) {
    const double before_s = frames.drawn_s[f - 1], now_s = frames.drawn_s[f];
    if (now_s <= before_s) continue;
    if (before_s > to.at_s - kSameTime_s) break;
    const double held_frames = (now_s - before_s) * clip.fps;
    for (const Group& group : groups) {
      const double step_mm =
          compute_step_mm(frames.poses[f - 1], frames.poses[f], reach, group) / held_frames;
      constexpr double kSame_mm = 1e-6;  // of two equal steps the first one is told
      if (step_mm <= worst_mm + kSame_mm) continue;
      worst_mm = step_mm;
      worst_s = now_s;
      area = kMoves[group.begin].area;
    }
  }
  if (area.empty()) return;
  add_advice(
      to,
      fmt::format("on the way to '{}' the {} moves {:.1f} mm a frame (at {}); more than {:.3g} mm is seen "
                  "as a jump",
                  to.label, area, worst_mm, show_time(clip, worst_s), kFastest_mm),
      advice);
}

double compute_distance(const Pose& a, const Pose& b) {
  double most = 0;
  for (std::size_t i = 0; i < kChannelCount; ++i) most = std::max(most, std::abs(a.values[i] - b.values[i]));
  return most;
}

void judge_apex(const ClipSpec& clip, std::size_t i, const Frames& frames, std::vector<Diagnostic>& advice) {
  const std::vector<PoseKey>& keys = clip.keys;
  const PoseKey& key = keys[i];
  const double end_s = frames.drawn_s.back();
  // The frame at the end would be the first of the next second: whoever loops a clip puts a key there.
  if (i == 0 || key.at_s > end_s - kSameTime_s) {
    if (i == 0 || key.at_s < clip.length_s + kSameTime_s) return;
    return add_advice(key,
                      fmt::format("'{}' comes at {}, after the clip's end at {}", key.label,
                                  show_time(clip, key.at_s), show_time(clip, clip.length_s)),
                      advice);
  }
  const double whole = compute_distance(keys[i - 1].pose, key.pose);
  if (whole < kLeastChange) return;
  const double until_s = i + 1 < keys.size() ? keys[i + 1].at_s : end_s;
  double nearest = whole;
  const std::size_t last = frames.compute_after(until_s + kSameTime_s);
  for (std::size_t f = frames.find_at(keys[i - 1].at_s - kSameTime_s); f < last; ++f)
    nearest = std::min(nearest, compute_distance(frames.poses[f], key.pose));
  const std::size_t next = frames.compute_after(key.at_s), here = frames.find_at(key.at_s);
  const double after_s = next == frames.count() ? end_s : frames.drawn_s[next];
  const double before_s = here == 0 ? 0 : frames.drawn_s[here - 1];
  const double share = 1 - nearest / whole;
  if (share >= kReached) return;
  add_advice(
      key,
      fmt::format("'{}' is never fully drawn, {:.0f} % of it at most; drawings near it are at {} and {}",
                  key.label, 100 * share, show_time(clip, before_s), show_time(clip, after_s)),
      advice);
}

// Of a key that names its areas: one release for the whole face may find some of them at rest.
void judge_release(const ClipSpec& clip, std::size_t i, std::vector<Diagnostic>& advice) {
  const PoseKey& key = clip.keys[i];
  const bool is_whole = std::ranges::all_of(key.release, [](double part_s) { return part_s >= 0; });
  if (i + 1 >= clip.keys.size() || is_whole || key.live || clip.keys[i + 1].live) return;
  for (std::size_t part = 0; part < kFacePartCount; ++part) {
    if (key.release[part] < 0) continue;
    bool moves = false;
    for (std::size_t move = 0; move < kChannelCount; ++move)
      moves |= static_cast<std::size_t>(find_lead_part(move)) == part &&
               key.pose.values[move] != clip.keys[i + 1].pose.values[move];
    if (!moves)
      add_advice(key,
                 fmt::format("'{}' releases its {}, of which nothing moves on the way to '{}'", key.label,
                             kReleaseKeys[part], clip.keys[i + 1].label),
                 advice);
  }
}

// How much of a cue there is at a time, whatever its areas' lead: 0..1.
double compute_presence(const CueSpec& cue, double time_s) {
  if (time_s < cue.from_s || time_s >= cue.end_s) return 0;
  const double come = time_s >= cue.full_s ? 1 : (time_s - cue.from_s) / (cue.full_s - cue.from_s);
  const double stays = time_s <= cue.ebb_s ? 1 : (cue.end_s - time_s) / (cue.end_s - cue.ebb_s);
  return ease(Easing::in_out, come) * ease(Easing::in_out, stays);
}

void judge_cue(const ClipSpec& clip, const CueSpec& cue, const Frames& frames,
               std::vector<Diagnostic>& advice) {
  const std::string begin = fmt::format("the cue '{}'", cue.what.label);
  if (cue.from_s > frames.drawn_s.back() - kSameTime_s)
    return add_advice(cue.what,
                      fmt::format("{} comes at {}, after the clip's last drawing at {}", begin,
                                  show_time(clip, cue.from_s), show_time(clip, frames.drawn_s.back())),
                      advice);
  double most = 0;
  const std::size_t last = frames.compute_after(std::min(cue.end_s, clip.length_s));
  for (std::size_t f = frames.find_at(cue.from_s); f < last && most < kReached; ++f)
    most = std::max(most, compute_presence(cue, frames.drawn_s[f]));
  if (most >= kReached) return;
  add_advice(cue.what,
             fmt::format("{} is never fully drawn, {:.0f} % of it at most; it is all there from {} {}", begin,
                         100 * most, show_time(clip, cue.full_s),
                         cue.ebb_s < kForever_s ? "to " + show_time(clip, cue.ebb_s) : "on"),
             advice);
}

// "lips, corners and chin".
std::string list_in_words(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " and ") + words[i];
  return text;
}

// The moves that a cue holds still over a key that asks for something else.
std::bitset<kChannelCount> list_hidden(const CueSpec& cue, const PoseKey& key) {
  std::bitset<kChannelCount> hidden;
  for (std::size_t i = 0; i < kChannelCount; ++i)
    hidden[i] = cue.owns[i] && std::abs(cue.what.pose.values[i] - key.pose.values[i]) >= kLeastChange;
  return hidden;
}

// Without an end a cue stays to the clip's own: easily forgotten at the last one.
void judge_end(const ClipSpec& clip, const CueSpec& cue, std::vector<Diagnostic>& advice) {
  constexpr double kLong_s = 0.5;        // what is shorter is the clip's own last breath
  constexpr std::size_t kMostKeys = 3;   // that are named
  const bool is_mood = cue.from_s <= 0;  // meant for the whole clip
  if (cue.end_s < kForever_s || cue.rule != Rule::over || is_mood || cue.what.live || cue.table) return;
  if (clip.length_s - cue.full_s < kLong_s) return;
  std::bitset<kChannelCount> hidden;
  std::vector<std::string> keys;
  for (std::size_t i = 0; i < clip.keys.size(); ++i) {
    const bool is_over = i + 1 < clip.keys.size() && clip.keys[i + 1].at_s <= cue.full_s;
    const bool is_late = clip.keys[i].at_s >= clip.length_s;
    const std::bitset<kChannelCount> here = list_hidden(cue, clip.keys[i]);
    if (is_over || (is_late && !keys.empty()) || here.none()) continue;
    hidden |= here;
    keys.push_back(fmt::format("'{}' at {}", clip.keys[i].label, show_time(clip, clip.keys[i].at_s)));
  }
  if (keys.empty()) return;
  std::vector<std::string> areas;
  for (const AreaKey& key : kAreaKeys)
    if (key.is_both || key.side == Side::none)
      if (std::ranges::any_of(list_moves_of(key), [&](std::size_t move) { return hidden[move]; }))
        areas.emplace_back(key.key);
  const std::size_t more = keys.size() - std::min(keys.size(), kMostKeys);
  keys.resize(keys.size() - more);
  if (more > 0) keys.push_back(fmt::format("{} more", more));
  add_advice(cue.what,
             fmt::format("the cue '{0}' has no end: from {1} to the clip's end at {2} it holds {3} over {4}; "
                         "give it 'hold' or 'to', 'to: {2}' if it is meant to stay",
                         cue.what.label, show_time(clip, cue.full_s), show_time(clip, clip.length_s),
                         list_in_words(areas), list_in_words(keys)),
             advice);
}

}  // namespace

std::vector<Diagnostic> advise_clip(const ClipSpec& clip, const Rehearsal& rehearsal,
                                    const MoveReach& reach) {
  const Frames frames{rehearsal.drawn_s, rehearsal.asked};
  const Frames keys_alone{rehearsal.drawn_s, rehearsal.keys.empty() ? rehearsal.asked : rehearsal.keys};
  std::vector<Diagnostic> advice;
  for (std::size_t i = 0; i < clip.keys.size(); ++i) {
    judge_hold(clip, i, advice);
    judge_speed(clip, i, frames, reach, advice);
    judge_apex(clip, i, keys_alone, advice);
    judge_release(clip, i, advice);
  }
  for (const CueSpec& cue : clip.cues)
    if (cue.layer == Layer::cue) {
      judge_cue(clip, cue, frames, advice);
      judge_end(clip, cue, advice);
    }
  std::ranges::move(list_jitter(clip), std::back_inserter(advice));
  std::ranges::move(advise_speech(clip, rehearsal.drawn_s), std::back_inserter(advice));
  return advice;
}

}  // namespace mien

#include "timeline/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "config/quantity.hpp"

namespace mien {
namespace {

constexpr double kReached = 0.9;      // of a face: less is another face
constexpr double kLeastChange = 0.1;  // of a limit: a smaller change has no apex to miss
constexpr double kSameTime_s = 1e-6;

// One frame of the clip.
struct Shown {
  double time_s = 0;  // of its drawing
  Pose pose;
};
using Frames = std::vector<Shown>;  // by time

bool is_quick_by_nature(const MoveInfo& info) { return info.area == "lid" || info.area == "eye"; }

// Without what blinks, looks and drifts, which is not what keys ask for.
Frames sample_asked(Performance performance) {
  performance.idle = {};
  Frames frames;
  for (const Moment& moment : sample_frames(performance))
    frames.push_back({find_drawing_time_s(performance.clip, static_cast<int>(frames.size())), moment.pose});
  return frames;
}

// What keys come to where no cue covers them.
Frames sample_keys(const Performance& performance) {
  ClipSpec clip = performance.clip;
  clip.cues.clear();
  return sample_asked(build_performance(clip));
}

// The frames from a time to another one.
std::span<const Shown> find_frames(const Frames& frames, double from_s, double to_s) {
  const auto first = std::ranges::lower_bound(frames, from_s, {}, &Shown::time_s);
  return {first, std::ranges::upper_bound(first, frames.end(), to_s, {}, &Shown::time_s)};
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
double find_step_mm(const Pose& from, const Pose& to, const MoveReach& reach, std::size_t first) {
  double squares = 0;
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    if (kMoves[i].area != kMoves[first].area || kMoves[i].side != kMoves[first].side) continue;
    const auto place_mm = [&](double value) {
      return value * (value > 0 ? reach.plus_mm[i] : reach.minus_mm[i]);
    };
    squares += std::pow(place_mm(to.values[i]) - place_mm(from.values[i]), 2);
  }
  return std::sqrt(squares);
}

void judge_speed(const ClipSpec& clip, std::size_t key, const Frames& frames, const MoveReach& reach,
                 std::vector<Diagnostic>& advice) {
  if (key == 0) return;
  const PoseKey &from = clip.keys[key - 1], &to = clip.keys[key];
  double worst_mm = kFastest_mm, worst_s = 0;
  std::string_view area;
  const auto on_way = std::ranges::lower_bound(frames, from.at_s + kSameTime_s, {}, &Shown::time_s);
  for (auto f = std::max(on_way, frames.begin() + 1); f < frames.end(); ++f) {
    const Shown &before = *(f - 1), &now = *f;
    if (now.time_s <= before.time_s) continue;
    if (before.time_s > to.at_s - kSameTime_s) break;
    const double held_frames = (now.time_s - before.time_s) * clip.fps;
    for (std::size_t i = 0; i < kMoveCount; ++i) {
      if (is_quick_by_nature(kMoves[i])) continue;
      const double step_mm = find_step_mm(before.pose, now.pose, reach, i) / held_frames;
      constexpr double kSame_mm = 1e-6;  // of two equal steps the first one is told
      if (step_mm <= worst_mm + kSame_mm) continue;
      worst_mm = step_mm;
      worst_s = now.time_s;
      area = kMoves[i].area;
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

double find_distance(const Pose& a, const Pose& b) {
  double most = 0;
  for (std::size_t i = 0; i < kMoveCount; ++i) most = std::max(most, std::abs(a.values[i] - b.values[i]));
  return most;
}

void judge_apex(const ClipSpec& clip, std::size_t i, const Frames& frames, std::vector<Diagnostic>& advice) {
  const std::vector<PoseKey>& keys = clip.keys;
  const PoseKey& key = keys[i];
  const double end_s = frames.back().time_s;
  // The frame at the end would be the first of the next second: whoever loops a clip puts a key there.
  if (i == 0 || key.at_s > end_s - kSameTime_s) {
    if (i == 0 || key.at_s < clip.length_s + kSameTime_s) return;
    return add_advice(key,
                      fmt::format("'{}' comes at {}, after the clip's end at {}", key.label,
                                  show_time(clip, key.at_s), show_time(clip, clip.length_s)),
                      advice);
  }
  const double whole = find_distance(keys[i - 1].pose, key.pose);
  if (whole < kLeastChange) return;
  const double until_s = i + 1 < keys.size() ? keys[i + 1].at_s : end_s;
  double nearest = whole;
  for (const Shown& shown : find_frames(frames, keys[i - 1].at_s - kSameTime_s, until_s + kSameTime_s))
    nearest = std::min(nearest, find_distance(shown.pose, key.pose));
  const auto next = std::ranges::upper_bound(frames, key.at_s, {}, &Shown::time_s);
  const auto here = std::ranges::lower_bound(frames, key.at_s, {}, &Shown::time_s);
  const double after_s = next == frames.end() ? end_s : next->time_s;
  const double before_s = here == frames.begin() ? 0 : (here - 1)->time_s;
  const double share = 1 - nearest / whole;
  if (share >= kReached) return;
  add_advice(
      key,
      fmt::format("'{}' is never fully drawn, {:.0f} % of it at most; drawings near it are at {} and {}",
                  key.label, 100 * share, show_time(clip, before_s), show_time(clip, after_s)),
      advice);
}

}  // namespace

std::vector<Diagnostic> advise_clip(const Performance& performance, const MoveReach& reach) {
  const Frames frames = sample_asked(performance);
  const Frames keys_alone = performance.clip.cues.empty() ? frames : sample_keys(performance);
  const ClipSpec& clip = performance.clip;
  std::vector<Diagnostic> advice;
  for (std::size_t i = 0; i < clip.keys.size(); ++i) {
    judge_hold(clip, i, advice);
    judge_speed(clip, i, frames, reach, advice);
    judge_apex(clip, i, keys_alone, advice);
  }
  return advice;
}

}  // namespace mien

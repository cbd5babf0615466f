#include "timeline/rehearsal.hpp"

#include <array>

#include "config/spec.hpp"
#include "core/pool.hpp"
#include "timeline/drawings.hpp"
#include "timeline/most_held.hpp"

namespace mien {

namespace {

constexpr std::size_t kStretches = 16;  // of the clip, each by itself; their ledgers are joined in order

// A frame that shows a drawing of its own.
void play_drawing(const Performance& performance, std::size_t frame, Rehearsal& into, MostHeld& most) {
  const double time_s = into.drawn_s[frame];
  const Layers& layers = *performance.layers;
  const Idle& idle = performance.idle;
  FaceState face = sample_keys(layers, compute_ticks(time_s), Moves().set());
  if (!into.keys.empty()) into.keys[frame] = hold_face(face);
  apply_cues(layers.cues, compute_ticks(time_s), face);
  into.asked[frame] = hold_face(face);
  most.add_face(performance, time_s, face);

  Moment moment = sample_unlooking(performance, time_s, face);
  most.add_looks(performance, time_s, moment);
  into.drawings[frame] = compute_drawing_key(performance, time_s, moment);
  add_looks_and_blinks(idle, idle.eyes, time_s, moment.camera, moment.turn, moment.pose);
  into.shown[frame] = {moment.pose, moment.turn.turn_deg, moment.turn.nod_deg, moment.turn.tilt_deg};
}

// A frame that holds an earlier drawing: only what its own time would ask for is looked at.
void play_held(const Performance& performance, double time_s, MostHeld& most) {
  const FaceState face = sample_layers(*performance.layers, compute_ticks(time_s));
  most.add_face(performance, time_s, face);
  if (!performance.idle.gaze.spec.keys.empty())
    most.add_looks(performance, time_s, sample_unlooking(performance, time_s, face));
}

}  // namespace

Rehearsal rehearse(const Performance& performance) {
  const ClipSpec& clip = performance.clip;
  const auto count = static_cast<std::size_t>(count_frames(clip));
  const auto find_drawn = [&](std::size_t frame) {
    return static_cast<std::size_t>(compute_drawn_frame(clip, static_cast<int>(frame)));
  };
  Rehearsal rehearsal;
  rehearsal.drawn_s.resize(count);
  rehearsal.shown.resize(count);
  rehearsal.asked.resize(count);
  rehearsal.drawings.resize(count);
  if (!clip.cues.empty()) rehearsal.keys.resize(count);
  std::array<MostHeld, kStretches> found;
  for_each_index(kStretches, count_workers(), [&](std::size_t i, int) {
    for (std::size_t frame = count * i / kStretches; frame < count * (i + 1) / kStretches; ++frame) {
      const std::size_t drawn = find_drawn(frame);
      rehearsal.drawn_s[frame] =
          compute_seconds(compute_frame_ticks(static_cast<std::int64_t>(drawn), clip.fps));
      if (drawn == frame)
        play_drawing(performance, frame, rehearsal, found[i]);
      else
        play_held(performance,
                  compute_seconds(compute_frame_ticks(static_cast<std::int64_t>(frame), clip.fps)), found[i]);
    }
  });
  for (std::size_t frame = 0; frame < count; ++frame) {
    const std::size_t drawn = find_drawn(frame);
    if (drawn == frame) continue;
    rehearsal.shown[frame] = rehearsal.shown[drawn];
    rehearsal.asked[frame] = rehearsal.asked[drawn];
    rehearsal.drawings[frame] = rehearsal.drawings[drawn];
    if (!rehearsal.keys.empty()) rehearsal.keys[frame] = rehearsal.keys[drawn];
  }
  MostHeld most;
  for (const MostHeld& stretch : found) most.add(stretch);
  rehearsal.held = most.list();
  return rehearsal;
}

std::vector<Held> list_held(const Spec& spec, const std::vector<Rehearsal>& rehearsals) {
  std::vector<Held> ledger = list_held(spec);
  for (const Rehearsal& rehearsal : rehearsals)
    ledger.insert(ledger.end(), rehearsal.held.begin(), rehearsal.held.end());
  return ledger;
}

}  // namespace mien

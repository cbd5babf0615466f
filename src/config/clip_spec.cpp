#include "config/clip_spec.hpp"

#include <algorithm>
#include <cmath>

#include "core/ticks.hpp"

namespace mien {

namespace {

// The first frame at a time or later.
int find_first_frame(double at_s, int fps) {
  int frame = static_cast<int>(std::floor(at_s * fps));
  while (compute_frame_ticks(frame, fps) < compute_ticks(at_s)) ++frame;
  return frame;
}

// How drawings are held about a frame, and since which one.
struct Pace {
  int first = 0, draw = 1;
};

Pace compute_pace(const ClipSpec& clip, int frame) {
  Pace pace{0, clip.draw};
  for (const DrawChange& change : clip.draw_changes) {
    const int at = find_first_frame(change.at_s, clip.fps);
    if (at > frame) break;
    pace = {at, change.draw};
  }
  pace.draw = std::max(pace.draw, 1);
  return pace;
}

}  // namespace

int count_frames(const ClipSpec& clip) {
  return std::max(1, static_cast<int>(std::lround(clip.length_s * clip.fps)));
}

int find_draw(const ClipSpec& clip, int frame) { return compute_pace(clip, frame).draw; }

int compute_drawn_frame(const ClipSpec& clip, int frame) {
  const auto [first, draw] = compute_pace(clip, frame);
  return frame - (frame - first) % draw;
}

}  // namespace mien

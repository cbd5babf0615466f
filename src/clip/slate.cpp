#include "clip/slate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sketch/lettering.hpp"

namespace mien {

namespace {

// The key that frame `frame` (from 0) shows or has left, and the one that it goes to; then the cues that are
// there.
std::string describe_keys(const ClipSpec& clip, int frame) {
  const double time_s = static_cast<double>(frame) / clip.fps;
  const double half_frame_s = 0.5 / clip.fps;
  const auto next =
      std::ranges::find_if(clip.keys, [&](const PoseKey& key) { return key.at_s > time_s + half_frame_s; });
  std::string from = next == clip.keys.begin() ? "" : std::prev(next)->label;
  const bool is_on_key = next != clip.keys.begin() && std::prev(next)->at_s > time_s - half_frame_s;
  if (next != clip.keys.end() && !is_on_key && next->label != from)
    from += (from.empty() ? "to " : " to ") + next->label;
  for (const CueSpec& cue : clip.cues)
    if (cue.layer == Layer::cue && !cue.what.label.empty() && cue.from_s <= time_s + half_frame_s &&
        time_s < cue.end_s)
      from += " + " + cue.what.label;
  return from;
}

}  // namespace

Slate build_slate(const Clip& clip, int frame) {
  Slate slate;
  const std::size_t digits = std::max<std::size_t>(4, std::to_string(clip.frame_count).size());
  slate.frame = fmt::format("{:0{}}/{:0{}}", frame, digits, clip.frame_count, digits);
  slate.time = fmt::format("{:.3f} s", static_cast<double>(frame - 1) / clip.spec.clip.fps);
  for (const Actor& actor : clip.actors) {
    const std::string keys = describe_keys(actor.performance.clip, frame - 1);
    if (keys.empty()) continue;
    slate.keys += fmt::format("{}{}{}{}", slate.keys.empty() ? "" : ", ", actor.name,
                              actor.name.empty() ? "" : ": ", keys);
  }
  return slate;
}

void draw_slate(Pixels& picture, const Slate& slate, const Letters& letters) {
  constexpr double kSmallest_px = 6, kDark = 0.65;
  const double width_px = picture.size.width_px;
  const double capital_px = std::max(kSmallest_px, 0.022 * std::min(width_px, 1.25 * picture.size.height_px));
  const int strip_px = static_cast<int>(std::lround(2.2 * capital_px));
  const int top_px = picture.size.height_px - strip_px;
  cover_box(picture, 0, top_px, {picture.size.width_px, strip_px}, {0, 0, 0}, kDark);
  WrittenLine line;
  line.capital_px = capital_px;
  line.base_px = top_px + 0.5 * (strip_px + capital_px);
  // Each field has its place, so that nothing moves as numbers change.
  const double edge_px = capital_px;
  const auto write = [&](const std::string& words, double from, double to, double align) {
    line.words = words;
    line.left_px = edge_px + from * (width_px - 2 * edge_px);
    line.width_px = (to - from) * (width_px - 2 * edge_px);
    line.align = align;
    write_line(picture, line, letters);
  };
  write(slate.frame, 0, 0.24, 0);
  write(slate.time, 0.25, 0.42, 0);
  write(slate.keys, 0.43, 1, 1);
}

}  // namespace mien

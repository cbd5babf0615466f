#include "render/plan.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <map>

#include "core/error.hpp"

namespace mien {

namespace {

// 7 for "f0007.pov", "f0007.png" and "h0007.inc"; nothing for other names.
std::optional<int> parse_frame_number(const std::string& file_name) {
  int number = 0;
  if (file_name.size() < 9) return std::nullopt;
  const char* end = file_name.data() + file_name.size() - 4;
  const std::string_view ending(end);
  const bool is_frame = file_name.front() == 'f' && (ending == ".pov" || ending == ".png");
  const bool is_head = file_name.front() == 'h' && ending == ".inc";
  if (!is_frame && !is_head) return std::nullopt;
  const auto [stop, error] = std::from_chars(file_name.data() + 1, end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

}  // namespace

bool is_clip_file(const std::string& name) {
  return parse_frame_number(name) || (name.starts_with("skin_") && name.ends_with(".png")) ||
         name == "head.inc" || name == "loop.pov" || name.ends_with(".ini");
}

std::string name_frame(int frame) { return fmt::format("f{:04}", frame); }
std::string name_heads(int frame) { return fmt::format("h{:04}.inc", frame); }

std::filesystem::path ClipFiles::scene(int frame) const {
  return folder / "scenes" / (name_frame(frame) + ".pov");
}
std::filesystem::path ClipFiles::picture(int frame) const {
  return folder / "frames" / (name_frame(frame) + ".png");
}

FramePlan plan_frames(const std::vector<int>& drawing_of, const std::optional<std::pair<int, int>>& range) {
  const int count = static_cast<int>(drawing_of.size());
  const auto [first, last] = range.value_or(std::pair{1, count});
  if (first < 1 || last < first || last > count)
    throw InputError(fmt::format("--frames {}-{}: the clip has {} frame{}; expected A-B within 1-{}", first,
                                 last, count, count == 1 ? "" : "s", count));
  FramePlan plan;
  std::map<int, int> drawn;  // the clip's first frame of a drawing -> the first one asked for
  for (int frame = first; frame <= last; ++frame) {
    const auto [entry, is_new] = drawn.emplace(drawing_of[frame - 1], frame);
    plan.frames.push_back(frame);
    plan.drawn_as.push_back(entry->second);
    if (is_new) plan.drawings.push_back(frame);
  }
  return plan;
}

std::vector<std::filesystem::path> find_stale_files(const ClipFiles& files, int frame_count) {
  std::vector<std::filesystem::path> stale;
  for (const char* folder : {"scenes", "frames"}) {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(files.folder / folder, ignored)) {
      const auto number = parse_frame_number(entry.path().filename().string());
      if (number && *number > frame_count && !entry.is_directory(ignored)) stale.push_back(entry.path());
    }
  }
  std::sort(stale.begin(), stale.end());
  return stale;
}

}  // namespace mien

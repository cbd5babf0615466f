#include "exchange/export_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "config/ledger.hpp"
#include "core/text.hpp"
#include "exchange/export_arkit.hpp"
#include "render/work_folder.hpp"

namespace mien {

namespace {

// All moves of the areas, and of muscles and units those that are ever moved.
std::vector<std::size_t> list_used_channels(const std::vector<Pose>& poses) {
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < kChannelCount; ++i)
    if (is_area_move(i) || std::ranges::any_of(poses, [&](const Pose& pose) { return pose.values[i] != 0; }))
      columns.push_back(i);
  return columns;
}

}  // namespace

ExportNotes export_table(const ExportWork& work, const std::filesystem::path& path) {
  if (work.options.targets == "arkit") return export_live_link(work, path);
  constexpr int kSecondsDecimals = 6, kValueDecimals = 6;
  std::vector<Pose> poses;
  for (int frame = work.first; frame <= work.last; ++frame)
    poses.push_back(sample_performance(work.performance, work.compute_time_s(frame)).pose);
  const std::vector<std::size_t> columns = list_used_channels(poses);
  std::string text = "time";
  for (const std::size_t move : columns) text += "," + name_move(move);
  text += "\n";
  for (int frame = work.first; frame <= work.last; ++frame) {
    const Pose& pose = poses[static_cast<std::size_t>(frame - work.first)];
    text += format_number(work.compute_time_s(frame) - work.compute_time_s(work.first), kSecondsDecimals);
    for (const std::size_t move : columns) text += "," + format_number(pose.values[move], kValueDecimals);
    text += "\n";
  }
  write_file(path, text);
  return {fmt::format("{} rows of {} moves", work.frame_count(), columns.size())};
}

}  // namespace mien

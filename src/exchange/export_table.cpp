#include "exchange/export_table.hpp"

#include <fmt/format.h>

#include "config/ledger.hpp"
#include "core/text.hpp"
#include "exchange/export_arkit.hpp"
#include "render/work_folder.hpp"

namespace mien {

ExportNotes export_table(const ExportWork& work, const std::filesystem::path& path) {
  if (work.options.targets == "arkit") return export_live_link(work, path);
  constexpr int kSecondsDecimals = 6, kValueDecimals = 6;
  std::string text = "time";
  for (std::size_t move = 0; move < kMoveCount; ++move) text += "," + name_move(move);
  text += "\n";
  for (int frame = work.first; frame <= work.last; ++frame) {
    const Pose pose = sample_performance(work.performance, work.compute_time_s(frame)).pose;
    text += format_number(work.compute_time_s(frame) - work.compute_time_s(work.first), kSecondsDecimals);
    for (std::size_t move = 0; move < kMoveCount; ++move)
      text += "," + format_number(pose.values[move], kValueDecimals);
    text += "\n";
  }
  write_file(path, text);
  return {fmt::format("{} rows of {} moves", work.frame_count(), kMoveCount)};
}

}  // namespace mien

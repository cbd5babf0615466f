#include "exchange/export_sequence.hpp"

#include <fmt/format.h>

#include "clip/moment.hpp"
#include "core/pool.hpp"
#include "core/text.hpp"
#include "render/work_folder.hpp"
#include "scene/mesh_files.hpp"

namespace mien {

ExportNotes export_sequence(const ExportWork& work, const std::filesystem::path& path) {
  const std::string ending = find_ending(path);
  for_each_index(work.frame_count(), count_workers(), [&](std::size_t i, int) {
    const int frame = work.first + static_cast<int>(i);
    const Drawing drawing =
        draw_moment(work.figure, sample_performance(work.performance, work.compute_time_s(frame)));
    write_file(name_frame_file(path, frame),
               build_mesh_file(ending, work.figure.model, drawing,
                               fmt::format("{}, frame {}", work.title(), frame)));
  });
  return {fmt::format("{} file{}, {} to {}", work.frame_count(), work.frame_count() == 1 ? "" : "s",
                      name_frame_file(path, work.first).filename().string(),
                      name_frame_file(path, work.last).filename().string())};
}

}  // namespace mien

#include "exchange/export_points.hpp"

#include <fmt/format.h>

#include "clip/moment.hpp"
#include "core/text.hpp"
#include "render/work_folder.hpp"
#include "scene/mesh_files.hpp"
#include "scene/point_cache.hpp"

namespace mien {

ExportNotes export_points(const ExportWork& work, const std::filesystem::path& path) {
  PointCache cache;
  cache.fps = work.fps();
  cache.first_frame = work.first;
  for (int frame = work.first; frame <= work.last; ++frame) {
    const Drawing drawing =
        draw_moment(work.figure, sample_performance(work.performance, work.compute_time_s(frame)));
    std::vector<glm::vec3>& points = cache.frames.emplace_back();
    for (std::size_t i = 0; i < drawing.parts.size(); ++i) {
      const Mesh mesh = place_part(work.figure.model.parts[i], drawing.parts[i]);
      points.insert(points.end(), mesh.positions.begin(), mesh.positions.end());
    }
  }
  write_file(path, find_ending(path) == ".pc2" ? build_pc2(cache) : build_mdd(cache));
  return {fmt::format("{} points in {} frames, in the order of `mien mesh -o face.obj`",
                      cache.frames.front().size(), cache.frames.size())};
}

}  // namespace mien

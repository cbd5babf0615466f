// Caches of points: where each vertex of a mesh lies at each frame. Sources: PC2, "Point Cache 2" as
// Blender's io_export_pc2 describes it; MDD, LightWave's "Motion Designer" data as Blender's io_shape_mdd
// does.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace mien {

struct PointCache {
  double fps = 24;
  int first_frame = 1;
  std::vector<std::vector<glm::vec3>> frames;  // at least one; as many points in each
};

// "POINTCACHE2", then numbers, little-endian: version, points, first frame, step, frames; then x, y, z.
std::string build_pc2(const PointCache& cache);

// Big-endian: frames, points, each frame's time in seconds; then x, y, z.
std::string build_mdd(const PointCache& cache);

}  // namespace mien

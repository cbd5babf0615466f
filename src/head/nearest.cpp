#include "head/nearest.hpp"

namespace mien {

SurfaceTree build_surface_tree(const Polygons& mesh) {
  std::vector<Triangle> triangles;
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    for (std::uint32_t i = mesh.first[f] + 2; i < mesh.first[f + 1]; ++i)
      triangles.push_back({mesh.corners[mesh.first[f]], mesh.corners[i - 1], mesh.corners[i]});
  return build_surface_tree(mesh.positions, std::move(triangles));
}

}  // namespace mien

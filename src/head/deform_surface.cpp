#include "head/surface.hpp"

namespace mien {

void deform_surface(const Surface& surface, const std::vector<Float4>& points,
                    std::vector<glm::vec3>& positions) {
  std::vector<Twin> paired, places;
  pair_points(points, surface.mirror, paired);
  deform_pairs(surface, paired, places);
  positions.resize(surface.vertex_count());
  unpack_pairs(surface.pairs, places, positions);
}

void update_surface_normals(const Surface& surface, const std::vector<glm::vec3>& positions,
                            std::vector<glm::vec3>& normals) {
  std::vector<Twin> places, sums;
  pack_pairs(surface.pairs, positions, places);
  update_pair_normals(surface, places, sums);
  normals.resize(positions.size());
  unpack_pairs(surface.pairs, sums, normals);
}

void pack_points(const std::vector<glm::dvec3>& points, std::vector<Float4>& packed) {
  packed.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) packed[i] = pack(glm::vec3(points[i]));
}

}  // namespace mien

#include "head/scan_nose.hpp"

namespace mien {

namespace {

constexpr double kFacing = 0.3;     // least cosine between the scan's normal and ours
constexpr double kOpenWay_mm = 12;  // a nostril's other wall is nearer than twice that, an adult's

bool find_pull(const NosePatch& patch, double reach_mm, NosePull& pull) {
  double least = reach_mm * reach_mm;
  bool is_found = false;
  for (std::uint32_t i = 0; i < patch.points.size(); ++i) {
    const glm::dvec3 way = patch.points[i] - pull.at;
    const double square = glm::dot(way, way);
    if (square >= least || glm::dot(patch.normals[i], pull.normal) < kFacing) continue;
    least = square;
    pull.vertex = i;
    is_found = true;
  }
  return is_found;
}

}  // namespace

std::vector<NosePull> compute_nose_pulls(const PlacedScan& scan, const NosePatch& patch,
                                         const glm::dvec3& middle, double radius_mm, double reach_mm) {
  std::vector<NosePull> pulls;
  for (std::size_t v = 0; v < scan.tree.positions.size(); ++v) {
    NosePull pull;
    pull.at = scan.turn * scan.tree.positions[v] + scan.shift;
    pull.normal = scan.turn * scan.tree.normals[v];
    const bool is_right = pull.at.x < 0;
    if (is_right) pull.at = mirror(pull.at), pull.normal = mirror(pull.normal);
    if (glm::distance(pull.at, middle) > radius_mm || scan.tree.is_rim[v]) continue;
    if (is_open(scan, {pull.at, pull.normal, 0, false}, kOpenWay_mm, is_right) &&
        find_pull(patch, reach_mm, pull))
      pulls.push_back(pull);
  }
  return pulls;
}

}  // namespace mien

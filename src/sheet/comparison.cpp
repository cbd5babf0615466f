#include "sheet/comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mien {

SkinDistances measure_distances(const Mesh& skin, const std::vector<glm::vec3>& other) {
  SkinDistances distances;
  const std::size_t count = std::min(skin.positions.size(), other.size());
  for (std::size_t v = 0; v < count; ++v) {
    distances.mm.push_back(glm::distance(skin.positions[v], other[v]));
    if (distances.mm[v] > distances.mm[distances.most]) distances.most = static_cast<std::uint32_t>(v);
  }
  if (count == 0) return distances;
  distances.most_mm = static_cast<double>(distances.mm[distances.most]);
  double area = 0, sum = 0;
  for (const auto& [a, b, c] : skin.triangles) {
    const glm::dvec3 p(skin.positions[a]);
    const double here =
        glm::length(glm::cross(glm::dvec3(skin.positions[b]) - p, glm::dvec3(skin.positions[c]) - p)) / 2;
    area += here;
    for (const std::uint32_t v : {a, b, c}) sum += here * static_cast<double>(distances.mm[v]) / 3;
  }
  distances.mean_mm = area > 0 ? sum / area : 0;
  return distances;
}

double find_scale_end(double most) {
  if (most <= 0) return 1;
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double step : {1.0, 2.0, 5.0})
    if (most <= step * power) return step * power;
  return 10 * power;
}

std::vector<LandmarkDistance> measure_landmark_distances(const std::map<std::string, glm::dvec3>& first,
                                                         const std::map<std::string, glm::dvec3>& second) {
  std::vector<LandmarkDistance> distances;
  for (const auto& [name, place] : first)
    if (const auto found = second.find(name); found != second.end()) {
      const glm::dvec3 way = found->second - place;
      distances.push_back({name, way, glm::length(way)});
    }
  return distances;
}

glm::vec3 find_heat(double share) {
  static constexpr std::array kStops{glm::vec3(0.95f, 0.93f, 0.86f), glm::vec3(0.97f, 0.80f, 0.42f),
                                     glm::vec3(0.91f, 0.47f, 0.20f), glm::vec3(0.70f, 0.16f, 0.20f),
                                     glm::vec3(0.29f, 0.06f, 0.31f)};
  const double at = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  return glm::mix(kStops[below], kStops[below + 1], static_cast<float>(at - static_cast<double>(below)));
}

}  // namespace mien

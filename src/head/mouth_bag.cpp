#include "head/mouth_bag.hpp"

#include <fmt/format.h>

#include "head/cage.hpp"

namespace mien {

void shape_mouth_bag(const MouthNumbers& numbers, const Cage& cage, std::vector<glm::dvec3>& points) {
  const auto at = [&](const char* ring, std::size_t column) {
    return find_point(cage, fmt::format("{}_{}", ring, column));
  };
  const double scale = points[at("M1", 6)].x / numbers.corner_mm;
  const glm::dvec3 lips = 0.5 * (points[at("M0", 0)] + points[at("M0", 12)]);
  const auto place = [&](std::uint32_t point, const glm::dvec3& p) {
    points[point] = p;
    if (cage.mirror[point] == point)
      points[point].x = 0;
    else
      points[cage.mirror[point]] = p * glm::dvec3(-1, 1, 1);
  };
  for (std::size_t column = 0; column < MouthBagNumbers::kColumns; ++column) {
    const auto& [x, y, z] = numbers.bag.front_mm[column];
    place(at("MB1", column), points[at("M0", column)] + scale * glm::dvec3(x, y, z));
    const auto& [back_x, back_y, back_z] = numbers.bag.back_mm[column];
    place(at("MB2", column), lips + scale * glm::dvec3(back_x, back_y, back_z));
  }
}

}  // namespace mien

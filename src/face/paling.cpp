#include "face/paling.hpp"

#include <fmt/format.h>

#include "head/cage.hpp"

namespace mien {

namespace {

constexpr double kSlack = 0.02;    // longer by less is nothing yet
constexpr double kFarthest = 0.4;  // a laugh's, a shout's

double measure_border_mm(const std::vector<std::uint32_t>& border, const std::vector<glm::dvec3>& points) {
  double length = 0;
  for (std::size_t i = 0; i < border.size(); ++i)
    length += glm::distance(points[border[i]], points[border[(i + 1) % border.size()]]);
  return length;
}

}  // namespace

RedBorder build_red_border(const Cage& cage) {
  constexpr int kLast = 12;  // of a ring's half: 0 the upper lip's middle, 12 the lower one's
  RedBorder border;
  for (int i = 0; i <= kLast; ++i) border.points.push_back(find_point(cage, fmt::format("M2_{}", i)));
  for (int i = kLast - 1; i > 0; --i)
    border.points.push_back(cage.mirror[find_point(cage, fmt::format("M2_{}", i))]);
  border.rest_mm = measure_border_mm(border.points, cage.points);
  return border;
}

double compute_paling(const RedBorder& border, const std::vector<glm::dvec3>& points) {
  const double longer = measure_border_mm(border.points, points) / border.rest_mm - 1;
  return glm::smoothstep(kSlack, kFarthest, longer);
}

}  // namespace mien

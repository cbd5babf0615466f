#include "head/scan_strays.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace mien {

namespace {

constexpr std::size_t kLeastPoints = 20;  // of fewer, nobody can say which are astray
constexpr double kMostShare = 0.95;       // of the points lie where the scan is
constexpr double kFar = 4;                // a body below a head goes on that far

double find_quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

glm::dvec3 compute_median(const std::vector<glm::dvec3>& points) {
  glm::dvec3 median(0);
  std::vector<double> values(points.size());
  for (int axis = 0; axis < 3; ++axis) {
    std::ranges::transform(points, values.begin(), [&](const glm::dvec3& p) { return p[axis]; });
    median[axis] = find_quantile(values, 0.5);
  }
  return median;
}

template <typename Item>
void keep(std::vector<Item>& items, const std::vector<bool>& is_kept) {
  if (items.size() != is_kept.size()) return;  // the file has none of these
  std::size_t at = 0;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (is_kept[i]) items[at++] = items[i];
  items.resize(at);
}

// The points, and of the faces those that have only such.
void keep_points(Polygons& mesh, const std::vector<bool>& is_kept) {
  std::vector<std::uint32_t> number(is_kept.size());
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < is_kept.size(); ++i) number[i] = is_kept[i] ? next++ : 0;
  std::vector<std::uint32_t> corners, first{0};
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto begin = mesh.corners.begin() + mesh.first[f], end = mesh.corners.begin() + mesh.first[f + 1];
    if (!std::all_of(begin, end, [&](std::uint32_t corner) { return is_kept[corner]; })) continue;
    for (auto corner = begin; corner != end; ++corner) corners.push_back(number[*corner]);
    first.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  mesh.corners = std::move(corners);
  mesh.first = std::move(first);
  keep(mesh.lines, is_kept);
  keep(mesh.normals, is_kept);
  keep(mesh.positions, is_kept);
}

}  // namespace

Strays leave_out_strays(Polygons& mesh) {
  Strays strays;
  if (mesh.positions.size() < kLeastPoints) return strays;
  const glm::dvec3 middle = compute_median(mesh.positions);
  std::vector<double> distances;
  for (const glm::dvec3& p : mesh.positions) distances.push_back(glm::distance(p, middle));
  strays.most_within = find_quantile(distances, kMostShare);
  std::vector<bool> is_kept;
  for (const double distance : distances) {
    is_kept.push_back(distance <= kFar * strays.most_within);
    if (is_kept.back()) continue;
    ++strays.count;
    strays.furthest = std::max(strays.furthest, distance);
  }
  if (strays.count > 0) keep_points(mesh, is_kept);
  return strays;
}

void leave_out_doubles(Polygons& cloud) {
  const auto key = [&](std::uint32_t i) {
    const glm::dvec3& p = cloud.positions[i];
    return std::tuple(p.x, p.y, p.z, i);
  };
  std::vector<std::uint32_t> order(cloud.positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, key);
  std::vector<bool> is_kept(order.size(), true);
  for (std::size_t i = 1; i < order.size(); ++i)
    is_kept[order[i]] = cloud.positions[order[i]] != cloud.positions[order[i - 1]];
  if (!std::ranges::all_of(is_kept, std::identity{})) keep_points(cloud, is_kept);
}

}  // namespace mien

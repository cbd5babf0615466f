#include <cmath>

#include "head/surface.hpp"

namespace mien {

namespace {

// A vertex of the mid-plane: mirror images are added to each other first, so that a mirrored pose gives the
// same sum.
Float4 sum_on_midline(const Surface& surface, std::size_t v, const std::vector<Float4>& points) {
  Float4 sum{};
  for (std::uint32_t k = surface.first[v]; k < surface.first[v + 1]; ++k) {
    const std::uint32_t point = surface.point[k];
    if (surface.mirror[point] == point) {
      sum += surface.weight[k] * points[point];
    } else {  // the next one is its image; see pair_row
      sum += surface.weight[k] * (points[point] + points[surface.point[k + 1]]);
      ++k;
    }
  }
  return sum;
}

}  // namespace

void deform_surface(const Surface& surface, const std::vector<Float4>& points,
                    std::vector<glm::vec3>& positions) {
  const std::size_t count = surface.vertex_count();
  positions.resize(count);
  for (std::uint32_t v = 0; v < count; ++v) {
    const std::uint32_t image = surface.mirror[v];
    if (image == v) positions[v] = unpack(sum_on_midline(surface, v, points));
    if (image <= v) continue;
    // A row and its mirror image have the same weights. Sums that do not wait for each other are quicker.
    const std::uint32_t first = surface.first[v], size = surface.first[v + 1] - first;
    const float* weight = surface.weight.data() + first;
    const std::uint32_t *here = surface.point.data() + first,
                        *there = surface.point.data() + surface.first[image];
    Float4 left{}, right{}, odd_left{}, odd_right{};
    for (std::uint32_t k = 0; k + 1 < size; k += 2) {
      left += weight[k] * points[here[k]];
      right += weight[k] * points[there[k]];
      odd_left += weight[k + 1] * points[here[k + 1]];
      odd_right += weight[k + 1] * points[there[k + 1]];
    }
    if (size % 2 != 0) {
      left += weight[size - 1] * points[here[size - 1]];
      right += weight[size - 1] * points[there[size - 1]];
    }
    positions[v] = unpack(left + odd_left);
    positions[image] = unpack(right + odd_right);
  }
}

void update_surface_normals(const Surface& surface, const std::vector<glm::vec3>& positions,
                            std::vector<glm::vec3>& normals) {
  std::vector<Float4> points(positions.size()), sums(positions.size(), Float4{});
  for (std::size_t v = 0; v < points.size(); ++v) points[v] = pack(positions[v]);
  // Twice the quad's area vector: the cross product of its diagonals.
  const auto find_area = [&](const Quad& q) {
    return cross(points[q[2]] - points[q[0]], points[q[3]] - points[q[1]]);
  };
  for (std::size_t q = 0; q < surface.quads.size(); q += 2) {
    const Quad &left = surface.quads[q], &right = surface.quads[q + 1];
    const Float4 here = find_area(left), there = find_area(right);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t v = left[i], image = right[(4 - i) % 4];
      if (v == image) {  // on the mid-plane: both at once, as a mirrored pose adds them
        sums[v] += here + there;
      } else {
        sums[v] += here;
        sums[image] += there;
      }
    }
  }
  normals.resize(positions.size());
  for (std::size_t v = 0; v < normals.size(); ++v)
    normals[v] = unpack(normalize(sums[v], 1e-20f, Float4{0, 0, 1, 0}));
}

void pack_points(const std::vector<glm::dvec3>& points, std::vector<Float4>& packed) {
  packed.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) packed[i] = pack(glm::vec3(points[i]));
}

}  // namespace mien

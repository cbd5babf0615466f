// Planes by the k nearest neighbours, and their sides by the spanning tree of what is most nearly parallel:
// Hoppe, DeRose, Duchamp, McDonald, Stuetzle, "Surface reconstruction from unorganized points" (1992). The
// ends of the cloud by the widest gap between neighbours: Bendels, Schnabel, Klein, "Detecting holes in point
// set surfaces" (2006).
#include "head/cloud.hpp"

#include <fmt/format.h>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <queue>

#include "core/error.hpp"
#include "core/pool.hpp"
#include "core/signals.hpp"

namespace mien {

namespace {

constexpr std::size_t kMostPoints = 40'000;  // a millimetre and a half apart on a head: finer is noise
constexpr double kFirstCell = 1.0 / 400, kCellGrowth = 1.25;  // of the cloud's size
constexpr int kNeighbours = 16;     // fewer take noise for form, more round the tip of a nose
constexpr int kNearest = 6;         // of them tell how far apart points are
constexpr double kRadius = 0.6;     // of that: little triangles touch each other and stand out nowhere
constexpr double kWidestGap = 2.7;  // radians; at a straight end it is 3.1, on a surface seldom over 2
constexpr std::size_t kChunk = 500;

struct Points {
  std::vector<glm::dvec3> at, hint;  // hint: the file's normal, or nothing
};

struct Extent {
  glm::dvec3 low{1e300}, high{-1e300};
};

Extent find_extent(const std::vector<glm::dvec3>& points) {
  Extent extent;
  for (const glm::dvec3& p : points) {
    extent.low = glm::min(extent.low, p);
    extent.high = glm::max(extent.high, p);
  }
  return extent;
}

// One point for all in a cell of a grid, at their mean.
Points gather_points(const Points& all, const glm::dvec3& low, double cell) {
  std::vector<std::array<std::int32_t, 3>> cells;
  for (const glm::dvec3& p : all.at) {
    const glm::dvec3 c = glm::floor((p - low) / cell);  // some hundreds at most
    cells.push_back(
        {static_cast<std::int32_t>(c.x), static_cast<std::int32_t>(c.y), static_cast<std::int32_t>(c.z)});
  }
  std::vector<std::uint32_t> order(all.at.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return cells[i]; });
  Points gathered;
  for (std::size_t i = 0; i < order.size();) {
    glm::dvec3 at(0), hint(0);
    const std::size_t first = i;
    for (; i < order.size() && cells[order[i]] == cells[order[first]]; ++i) {
      at += all.at[order[i]];
      if (!all.hint.empty()) hint += all.hint[order[i]];
    }
    gathered.at.push_back(at / static_cast<double>(i - first));
    if (!all.hint.empty()) gathered.hint.push_back(hint);
  }
  return gathered;
}

Points thin_out(const Polygons& cloud) {
  Points points{cloud.positions, cloud.normals};
  const Extent extent = find_extent(points.at);
  const double size = glm::distance(extent.low, extent.high);
  for (double cell = kFirstCell * size; points.at.size() > kMostPoints && cell < size; cell *= kCellGrowth) {
    throw_if_interrupted();  // two million points take a second
    points = gather_points({cloud.positions, cloud.normals}, extent.low, cell);
  }
  return points;
}

// A tree over the points: order[first, last) is split at its middle along the axis that the middle's node
// has.
struct PointTree {
  const std::vector<glm::dvec3>& points;
  std::vector<std::uint32_t> order;
  std::vector<char> axes;  // of each place in the order
};

void split_range(PointTree& tree, std::size_t first, std::size_t last) {
  if (last - first < 2) return;
  glm::dvec3 low(1e300), high(-1e300);
  for (std::size_t i = first; i < last; ++i) {
    low = glm::min(low, tree.points[tree.order[i]]);
    high = glm::max(high, tree.points[tree.order[i]]);
  }
  const glm::dvec3 size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t middle = (first + last) / 2;
  const auto begin = tree.order.begin();
  std::nth_element(begin + first, begin + middle, begin + last, [&](std::uint32_t a, std::uint32_t b) {
    return tree.points[a][axis] != tree.points[b][axis] ? tree.points[a][axis] < tree.points[b][axis] : a < b;
  });
  tree.axes[middle] = static_cast<char>(axis);
  split_range(tree, first, middle);
  split_range(tree, middle + 1, last);
}

PointTree build_point_tree(const std::vector<glm::dvec3>& points) {
  PointTree tree{points, std::vector<std::uint32_t>(points.size()), std::vector<char>(points.size(), 0)};
  std::iota(tree.order.begin(), tree.order.end(), 0);
  split_range(tree, 0, points.size());
  return tree;
}

// The nearest others, the nearest first, with the squares of their distances.
struct Nearest {
  std::array<std::pair<double, std::uint32_t>, kNeighbours> found;
  int count = 0;
};

void add_nearest(Nearest& nearest, double square, std::uint32_t point) {
  const std::pair item{square, point};
  int at = nearest.count;
  if (nearest.count == kNeighbours) {
    if (item >= nearest.found.back()) return;
    at = kNeighbours - 1;
  } else {
    ++nearest.count;
  }
  for (; at > 0 && item < nearest.found[at - 1]; --at) nearest.found[at] = nearest.found[at - 1];
  nearest.found[at] = item;
}

void search_range(const PointTree& tree, std::size_t first, std::size_t last, std::uint32_t of,
                  Nearest& nearest) {
  if (first >= last) return;
  const std::size_t middle = (first + last) / 2;
  const std::uint32_t here = tree.order[middle];
  const glm::dvec3 way = tree.points[here] - tree.points[of];
  if (here != of) add_nearest(nearest, glm::dot(way, way), here);
  const double beyond = -way[tree.axes[middle]];  // how far past the split we are
  const auto search = [&](bool is_high) {
    if (is_high)
      search_range(tree, middle + 1, last, of, nearest);
    else
      search_range(tree, first, middle, of, nearest);
  };
  search(beyond > 0);
  if (nearest.count < kNeighbours || beyond * beyond <= nearest.found.back().first) search(beyond <= 0);
}

// A point's little plane.
struct Disc {
  std::array<std::uint32_t, kNeighbours> neighbours{};
  glm::dvec3 normal{0, 0, 1};
  double spacing = 0;
  bool is_rim = false;
};

glm::dvec3 compute_across(const glm::dvec3& normal) {
  const glm::dvec3 axis = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(glm::cross(normal, axis));
}

Disc build_disc(const std::vector<glm::dvec3>& points, std::uint32_t of, const Nearest& nearest) {
  Disc disc;
  glm::dvec3 mean = points[of];
  for (int i = 0; i < kNeighbours; ++i) {
    disc.neighbours[i] = nearest.found[i].second;
    mean += points[disc.neighbours[i]];
    if (i < kNearest) disc.spacing += std::sqrt(nearest.found[i].first) / kNearest;
  }
  mean /= kNeighbours + 1;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  const auto add = [&](const glm::dvec3& p) {
    const Eigen::Vector3d way(p.x - mean.x, p.y - mean.y, p.z - mean.z);
    spread += way * way.transpose();
  };
  add(points[of]);
  for (const std::uint32_t n : disc.neighbours) add(points[n]);
  const Eigen::Vector3d normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
  disc.normal = {normal(0), normal(1), normal(2)};

  const glm::dvec3 across = compute_across(disc.normal), along = glm::cross(disc.normal, across);
  std::array<double, kNeighbours> angles{};
  for (int i = 0; i < kNeighbours; ++i) {
    const glm::dvec3 way = points[disc.neighbours[i]] - points[of];
    angles[i] = std::atan2(glm::dot(way, along), glm::dot(way, across));
  }
  std::ranges::sort(angles);
  double widest = angles.front() + 2 * std::numbers::pi - angles.back();
  for (int i = 1; i < kNeighbours; ++i) widest = std::max(widest, angles[i] - angles[i - 1]);
  disc.is_rim = widest > kWidestGap;
  return disc;
}

std::vector<Disc> build_discs(const std::vector<glm::dvec3>& points) {
  const PointTree tree = build_point_tree(points);
  std::vector<Disc> discs(points.size());
  for_each_index((points.size() + kChunk - 1) / kChunk, count_workers(), [&](std::size_t chunk, int) {
    for (std::size_t i = chunk * kChunk; i < std::min(points.size(), (chunk + 1) * kChunk); ++i) {
      Nearest nearest;
      search_range(tree, 0, points.size(), static_cast<std::uint32_t>(i), nearest);
      discs[i] = build_disc(points, static_cast<std::uint32_t>(i), nearest);
    }
  });
  return discs;
}

// Whoever is a neighbour of whom.
std::vector<std::vector<std::uint32_t>> compute_both_ways(const std::vector<Disc>& discs) {
  std::vector<std::vector<std::uint32_t>> both(discs.size());
  for (std::uint32_t i = 0; i < discs.size(); ++i)
    for (const std::uint32_t n : discs[i].neighbours) {
      both[i].push_back(n);
      both[n].push_back(i);
    }
  return both;
}

// Turns all normals the same way: outward at the point of each piece that is furthest from the middle, from
// there on like the neighbour that is most nearly parallel.
void agree_on_sides(const std::vector<glm::dvec3>& points, std::vector<Disc>& discs) {
  glm::dvec3 middle(0);
  for (const glm::dvec3& p : points) middle += p / static_cast<double>(points.size());
  std::vector<std::uint32_t> seeds(points.size());
  std::iota(seeds.begin(), seeds.end(), 0);
  std::ranges::stable_sort(seeds, std::greater{},
                           [&](std::uint32_t i) { return glm::distance(points[i], middle); });
  const auto both = compute_both_ways(discs);
  std::vector<bool> is_done(points.size(), false);
  struct Link {
    double parallel = 0;
    std::uint32_t from = 0, to = 0;
    bool operator<(const Link& other) const {
      return std::tie(parallel, other.from, other.to) < std::tie(other.parallel, from, to);
    }
  };
  std::priority_queue<Link> links;
  const auto settle = [&](std::uint32_t i) {
    is_done[i] = true;
    for (const std::uint32_t n : both[i])
      if (!is_done[n]) links.push({std::abs(glm::dot(discs[i].normal, discs[n].normal)), i, n});
  };
  for (const std::uint32_t seed : seeds) {
    if (is_done[seed]) continue;
    if (glm::dot(discs[seed].normal, points[seed] - middle) < 0) discs[seed].normal = -discs[seed].normal;
    settle(seed);
    while (!links.empty()) {
      const Link link = links.top();
      links.pop();
      if (is_done[link.to]) continue;
      if (glm::dot(discs[link.from].normal, discs[link.to].normal) < 0)
        discs[link.to].normal = -discs[link.to].normal;
      settle(link.to);
    }
  }
}

void add_triangle(CloudSurface& surface, const glm::dvec3& middle, const Disc& disc) {
  const glm::dvec3 across = compute_across(disc.normal), along = glm::cross(disc.normal, across);
  for (int i = 0; i < 3; ++i) {
    const double angle = 2 * std::numbers::pi * i / 3;
    surface.mesh.corners.push_back(static_cast<std::uint32_t>(surface.mesh.positions.size()));
    surface.mesh.positions.push_back(middle + kRadius * disc.spacing *
                                                  (std::cos(angle) * across + std::sin(angle) * along));
    surface.rims.push_back(disc.is_rim);
  }
  surface.mesh.first.push_back(static_cast<std::uint32_t>(surface.mesh.corners.size()));
}

}  // namespace

void check_cloud_size(const Polygons& mesh, std::string_view points) {
  if (mesh.face_count() > 0 || mesh.positions.size() >= kLeastCloudPoints) return;
  throw InputError(std::vector<Diagnostic>{
      {{mesh.file, 0, 0},
       fmt::format("has {} {} and no faces; expected a surface, or a cloud of {} points at least",
                   mesh.positions.size(), points, kLeastCloudPoints),
       "",
       false}});
}

CloudSurface build_cloud_surface(const Polygons& cloud) {
  const Points points = thin_out(cloud);
  CloudSurface surface;
  surface.mesh.file = cloud.file;
  std::vector<Disc> discs = build_discs(points.at);
  if (points.hint.empty()) {
    agree_on_sides(points.at, discs);
  } else {
    for (std::size_t i = 0; i < discs.size(); ++i)
      if (glm::dot(discs[i].normal, points.hint[i]) < 0) discs[i].normal = -discs[i].normal;
  }
  for (std::size_t i = 0; i < discs.size(); ++i) add_triangle(surface, points.at[i], discs[i]);
  return surface;
}

}  // namespace mien

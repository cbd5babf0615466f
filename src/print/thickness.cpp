#include "print/thickness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/pool.hpp"
#include "print/solid_tree.hpp"

namespace mien {

namespace {

constexpr int kWays = 6;            // around the middle ray; even, so that a mirrored cone is the same one
constexpr double kSlope = 0.3;      // of the cone: 17 degrees; wider, and round things look thinner
constexpr double kOpposite = 0.5;   // the cosine of the most that the other side may be turned
constexpr double kStart_mm = 1e-4;  // beyond the surface itself
constexpr double kPatch_mm2 = 1;    // of a sample
constexpr int kMostSteps = 24;      // of a triangle's side

// Calls `visit` with the middles of steps^2 equal parts of the triangle.
template <typename Visit>
void visit_parts(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, int steps,
                 const Visit& visit) {
  for (int i = 0; i < steps; ++i)
    for (int j = 0; i + j < steps; ++j)
      for (const double third : {1.0, 2.0}) {
        if (third == 2 && i + j + 1 >= steps) continue;
        const double u = (i + third / 3) / steps, v = (j + third / 3) / steps;
        visit(a + u * (b - a) + v * (c - a));
      }
}

}  // namespace

double measure_thickness_mm(const SurfaceTree& tree, const glm::dvec3& place, const glm::dvec3& normal,
                            double reach_mm) {
  const glm::dvec3 axis = std::abs(normal.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
  const glm::dvec3 side = glm::normalize(glm::cross(normal, axis)), up = glm::cross(normal, side);
  std::array<double, kWays + 1> found;
  for (int i = 0; i <= kWays; ++i) {
    glm::dvec3 way = -normal;
    if (i < kWays) {
      const double turn = 2 * std::numbers::pi * i / kWays;
      way += kSlope * (std::cos(turn) * side + std::sin(turn) * up);
    }
    way = glm::normalize(way);
    const RayHit hit = find_hit(tree, place, way, kStart_mm, 1.1 * reach_mm);
    const bool leaves = hit.distance < 1e9 && glm::dot(hit.normal, -normal) > kOpposite;
    found[i] = leaves ? std::min(reach_mm, hit.distance * -glm::dot(way, normal)) : reach_mm;
  }
  std::nth_element(found.begin(), found.begin() + kWays / 2, found.end());
  return found[kWays / 2];
}

std::vector<ThicknessSample> list_thicknesses(const Mesh& mesh, const SurfaceTree& tree, double reach_mm,
                                              double patch_mm2) {
  struct Place {
    ThicknessSample sample;
    glm::dvec3 normal{0};
  };
  std::vector<Place> places;
  double owed = 0;  // surface that no sample stands for yet
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::dvec3 p(mesh.positions[a]), q(mesh.positions[b]), r(mesh.positions[c]);
    const glm::dvec3 cross = glm::cross(q - p, r - p);
    const double area = glm::length(cross) / 2;
    if (!(area > 0)) continue;
    owed += area;
    if (owed < patch_mm2) continue;
    const double patch = patch_mm2 > 0 ? patch_mm2 : kPatch_mm2;
    const int steps = std::clamp(int(std::ceil(std::sqrt(area / patch))), 1, kMostSteps);
    const double share = owed / (double(steps) * steps);
    visit_parts(p, q, r, steps, [&](const glm::dvec3& place) {
      places.push_back({{place, 0, share}, cross / (2 * area)});
    });
    owed = 0;
  }
  for_each_index(places.size(), count_workers(), [&](std::size_t i, int) {
    places[i].sample.thickness_mm =
        measure_thickness_mm(tree, places[i].sample.place, places[i].normal, reach_mm);
  });
  std::vector<ThicknessSample> samples;
  for (const Place& place : places) samples.push_back(place.sample);
  std::stable_sort(samples.begin(), samples.end(), [](const ThicknessSample& a, const ThicknessSample& b) {
    return a.thickness_mm < b.thickness_mm;
  });
  return samples;
}

}  // namespace mien

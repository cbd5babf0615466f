#include "print/opening.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "core/pool.hpp"

namespace mien {

namespace {

constexpr double kFits = 0.97;  // of the radius must be free around a ball's centre: facets are not round
constexpr double kCoarse = 1;   // of the size: between samples of a first look
constexpr double kFine = 0.2;   // and of a second one, where balls seemed to come nowhere near
constexpr int kMostSteps = 60;  // of a triangle's side

// A place of the surface with the centre of the ball that touches it from inside.
struct Sample {
  FinePatch patch;
  glm::dvec3 centre{0};
  bool fits = false;
};

// Points in cells of an edge length, to be found from places within it.
class Cells {
 public:
  explicit Cells(double cell_mm) : cell_mm_(cell_mm) {}

  void add(const glm::dvec3& p, std::uint32_t value) { cells_[find_key(find_cell(p))].push_back(value); }

  // Whether `is_wanted` holds for any value in the 27 cells around p.
  template <typename IsWanted>
  bool any_around(const glm::dvec3& p, const IsWanted& is_wanted) const {
    const glm::ivec3 cell = find_cell(p);
    for (int i = 0; i < 27; ++i) {
      const auto found = cells_.find(find_key(cell + glm::ivec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)));
      if (found != cells_.end() && std::any_of(found->second.begin(), found->second.end(), is_wanted))
        return true;
    }
    return false;
  }

 private:
  glm::ivec3 find_cell(const glm::dvec3& p) const { return glm::ivec3(glm::floor(p / cell_mm_)); }
  static std::uint64_t find_key(const glm::ivec3& c) {
    constexpr int kHalf = 1 << 20;  // a print of a million cells would not fit any printer
    return std::uint64_t(c.x + kHalf) << 42 | std::uint64_t(c.y + kHalf) << 21 | std::uint64_t(c.z + kHalf);
  }
  double cell_mm_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

void append_samples(const Mesh& mesh, const SurfaceTree& tree, std::uint32_t triangle, double size_mm,
                    double step_mm, std::vector<Sample>& samples) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const glm::dvec3 p(mesh.positions[a]), u = glm::dvec3(mesh.positions[b]) - p,
                                         v = glm::dvec3(mesh.positions[c]) - p;
  const glm::dvec3 cross = glm::cross(u, v);
  const double area = glm::length(cross) / 2;
  if (!(area > 0)) return;
  const glm::dvec3 normal = cross / (2 * area);
  const int steps = std::clamp(int(std::ceil(std::sqrt(area) / step_mm)), 1, kMostSteps);
  for (int i = 0; i < steps; ++i)
    for (int j = 0; i + j < steps; ++j)
      for (int third = 1; third <= 2; ++third) {
        if (third == 2 && i + j + 1 >= steps) continue;
        Sample sample;
        sample.patch.place = p + (i + third / 3.0) / steps * u + (j + third / 3.0) / steps * v;
        sample.patch.normal = normal;
        sample.patch.area_mm2 = area / (double(steps) * steps);
        sample.patch.triangle = triangle;
        sample.centre = sample.patch.place - size_mm / 2 * normal;
        sample.fits = !is_within(tree, sample.centre, kFits * size_mm / 2);
        samples.push_back(sample);
      }
}

// The samples of the triangles named, in their order.
std::vector<Sample> list_samples(const Mesh& mesh, const SurfaceTree& tree,
                                 const std::vector<std::uint32_t>& triangles, double size_mm,
                                 double step_mm) {
  constexpr std::size_t kChunk = 64;
  std::vector<std::vector<Sample>> chunks((triangles.size() + kChunk - 1) / kChunk);
  for_each_index(chunks.size(), count_workers(), [&](std::size_t chunk, int) {
    for (std::size_t i = chunk * kChunk; i < std::min(triangles.size(), (chunk + 1) * kChunk); ++i)
      append_samples(mesh, tree, triangles[i], size_mm, step_mm, chunks[chunk]);
  });
  std::vector<Sample> samples;
  for (const auto& chunk : chunks) samples.insert(samples.end(), chunk.begin(), chunk.end());
  return samples;
}

std::vector<std::uint32_t> list_all(const Mesh& mesh) {
  std::vector<std::uint32_t> all(mesh.triangles.size());
  for (std::uint32_t t = 0; t < all.size(); ++t) all[t] = t;
  return all;
}

// Those of `triangles` with a corner near any of the places.
std::vector<std::uint32_t> list_near(const Mesh& mesh, const std::vector<std::uint32_t>& triangles,
                                     const std::vector<glm::dvec3>& places, double size_mm) {
  Cells cells(size_mm);
  glm::dvec3 low(1e300), high(-1e300);
  for (const glm::dvec3& place : places) {
    cells.add(place, 0);
    low = glm::min(low, place - 2 * size_mm);
    high = glm::max(high, place + 2 * size_mm);
  }
  std::vector<std::optional<bool>> is_near(mesh.positions.size());  // asked for once
  const auto ask = [&](std::uint32_t v) {
    if (is_near[v]) return *is_near[v];
    const glm::dvec3 at(mesh.positions[v]);
    const bool is_out = glm::any(glm::lessThan(at, low)) || glm::any(glm::greaterThan(at, high));
    return *(is_near[v] = !is_out && cells.any_around(at, [](std::uint32_t) { return true; }));
  };
  std::vector<std::uint32_t> near;
  for (const std::uint32_t t : triangles)
    if (std::any_of(mesh.triangles[t].begin(), mesh.triangles[t].end(), ask)) near.push_back(t);
  return near;
}

// Those of the samples that no ball that fits comes near to.
std::vector<FinePatch> list_unreached(const std::vector<Sample>& samples, double size_mm, double blunt) {
  const double reach = (0.5 + blunt) * size_mm;  // from a ball's centre
  Cells fitting(reach);
  for (std::uint32_t i = 0; i < samples.size(); ++i)
    if (samples[i].fits) fitting.add(samples[i].centre, i);
  std::vector<FinePatch> patches;
  for (const Sample& sample : samples) {
    if (sample.fits) continue;
    const auto is_reached = [&](std::uint32_t i) {
      return glm::distance(samples[i].centre, sample.patch.place) <= reach;
    };
    if (!fitting.any_around(sample.patch.place, is_reached)) patches.push_back(sample.patch);
  }
  return patches;
}

// The patches in groups that lie within `apart_mm` of each other.
std::vector<std::vector<FinePatch>> group_patches(const std::vector<FinePatch>& patches, double apart_mm) {
  Cells cells(apart_mm);
  for (std::uint32_t i = 0; i < patches.size(); ++i) cells.add(patches[i].place, i);
  std::vector<bool> is_taken(patches.size(), false);
  std::vector<std::vector<FinePatch>> groups;
  for (std::uint32_t first = 0; first < patches.size(); ++first) {
    if (is_taken[first]) continue;
    std::vector<FinePatch>& group = groups.emplace_back();
    std::vector<std::uint32_t> open{first};
    is_taken[first] = true;
    while (!open.empty()) {
      const std::uint32_t at = open.back();
      open.pop_back();
      group.push_back(patches[at]);
      cells.any_around(patches[at].place, [&](std::uint32_t i) {
        if (is_taken[i] || glm::distance(patches[i].place, patches[at].place) > apart_mm) return false;
        is_taken[i] = true;
        open.push_back(i);
        return false;
      });
    }
  }
  return groups;
}

double sum_area_mm2(const std::vector<FinePatch>& patches) {
  double area = 0;
  for (const FinePatch& patch : patches) area += patch.area_mm2;
  return area;
}

FineDetail build_detail(const std::vector<FinePatch>& group) {
  FineDetail detail;
  detail.area_mm2 = sum_area_mm2(group);
  for (const FinePatch& patch : group) detail.place += patch.area_mm2 / detail.area_mm2 * patch.place;
  return detail;
}

}  // namespace

// Looks twice: coarsely everywhere, then finely where no ball came near at first.
std::vector<FinePatch> list_fine_patches(const Mesh& mesh, const SurfaceTree& tree,
                                         const std::vector<std::uint32_t>& triangles, double size_mm,
                                         double blunt) {
  std::vector<glm::dvec3> places;
  for (const FinePatch& patch :
       list_unreached(list_samples(mesh, tree, triangles, size_mm, kCoarse * size_mm), size_mm, blunt))
    places.push_back(patch.place);
  if (places.empty()) return {};
  const std::vector<std::uint32_t> near = list_near(mesh, triangles, places, size_mm);
  return list_unreached(list_samples(mesh, tree, near, size_mm, kFine * size_mm), size_mm, blunt);
}

std::vector<FinePatch> list_fine_patches(const Mesh& mesh, const SurfaceTree& tree, double size_mm,
                                         double blunt) {
  return list_fine_patches(mesh, tree, list_all(mesh), size_mm, blunt);
}

std::vector<std::uint32_t> list_thin_triangles(const Mesh& mesh, const SurfaceTree& tree, double size_mm,
                                               double speck_mm2) {
  std::vector<glm::dvec3> places;
  for (const std::vector<FinePatch>& group :
       group_patches(list_fine_patches(mesh, tree, size_mm), size_mm / 2))
    if (sum_area_mm2(group) > speck_mm2)
      for (const FinePatch& patch : group) places.push_back(patch.place);
  if (places.empty()) return {};
  return list_near(mesh, list_all(mesh), places, size_mm);
}

std::vector<FineDetail> list_fine_details(const Mesh& mesh, const SurfaceTree& tree, double size_mm,
                                          double speck_mm2) {
  constexpr int kHalvings = 5;  // to a fortieth of a millimetre
  std::vector<FineDetail> details;
  for (const std::vector<FinePatch>& group :
       group_patches(list_fine_patches(mesh, tree, size_mm), size_mm / 2)) {
    if (sum_area_mm2(group) <= speck_mm2) continue;
    FineDetail detail = build_detail(group);
    std::vector<glm::dvec3> places;
    for (const FinePatch& patch : group) places.push_back(patch.place);
    const std::vector<std::uint32_t> near = list_near(mesh, list_all(mesh), places, size_mm);
    double low = 0, high = size_mm;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (low + high) / 2;
      double area = 0;
      Cells own(size_mm);
      for (const glm::dvec3& place : places) own.add(place, 0);
      for (const FinePatch& patch : list_fine_patches(mesh, tree, near, middle, kBlunt))
        if (own.any_around(patch.place, [](std::uint32_t) { return true; })) area += patch.area_mm2;
      (area > speck_mm2 ? high : low) = middle;
    }
    detail.finest_mm = low;
    if (high < size_mm) details.push_back(detail);  // nearer to the size than one can tell
  }
  std::stable_sort(details.begin(), details.end(),
                   [](const FineDetail& a, const FineDetail& b) { return a.finest_mm < b.finest_mm; });
  return details;
}

}  // namespace mien

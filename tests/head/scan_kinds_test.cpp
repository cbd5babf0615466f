// Our own head as others would hand it over: patches with control points, a digitiser's points, slices. What
// comes back is compared with what went in.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>

#include "core/error.hpp"
#include "core/text.hpp"
#include "head/binding.hpp"
#include "head/eye_fit.hpp"
#include "head/form.hpp"
#include "head/landmarks.hpp"
#include "head/nearest.hpp"
#include "head/scan.hpp"
#include "head/surface.hpp"
#include "import/mesh_faults.hpp"
#include "import/slices.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;

const NeutralHead& sitter() {
  static const NeutralHead head = build_neutral_head(shipped().heads, HeadSpec{});
  return head;
}

fs::path find_file(const std::string& name) { return fs::path(testing::TempDir()) / "mien_kinds" / name; }

std::string build_landmarks() {
  std::string text = "landmarks:\n";
  for (const char* name : {"n", "prn", "sn", "gn", "en", "ex", "ch", "t"}) {
    const SkinSpot spot = find_place(sitter(), name);
    const glm::vec3 p = sitter().skin.positions[spot.vertices.front()];
    if (std::abs(p.x) < 1e-3f) {
      text += fmt::format("  {}: [0, {:.4f}, {:.4f}]\n", name, p.y, p.z);
      continue;
    }
    for (const bool is_right : {false, true})
      text += fmt::format("  {}{}: [{:.4f}, {:.4f}, {:.4f}]\n", name, is_right ? "_r" : "_l",
                          is_right ? -p.x : p.x, p.y, p.z);
  }
  return text;
}

// What nobody reaches from outside.
std::vector<bool> find_hidden() {
  std::vector<bool> is_hidden;
  for (std::size_t v = 0; v < sitter().skin.positions.size(); ++v) {
    double share = 0;
    for (const auto& [point, weight] : compute_limit_row(*shipped().heads.surface, v))
      for (const char* prefix : {"na_", "nr_", "ni_", "nd_", "EB_", "E0_", "M0_", "MB"})
        if (has_prefix(shipped().heads.adult.names[point], prefix)) share += weight;
    is_hidden.push_back(share > 0.02);
  }
  return is_hidden;
}

Polygons build_seen_skin() {
  const std::vector<bool> is_hidden = find_hidden();
  Polygons mesh;
  for (const glm::vec3& p : sitter().skin.positions) mesh.positions.emplace_back(p);
  for (const Quad& q : sitter().surface->quads) {
    if (std::ranges::any_of(q, [&](std::uint32_t v) { return is_hidden[v]; })) continue;
    mesh.corners.insert(mesh.corners.end(), q.begin(), q.end());
    mesh.first.push_back(mesh.first.back() + 4);
  }
  return mesh;
}

// How far the face of the head that is made of the file lies from the sitter's, on the whole, in millimetres.
double measure_face(const std::string& name) {
  write_file(find_file(name).replace_extension(".yaml"), "unit: mm\n" + build_landmarks());
  HeadSpec spec;
  spec.scan = FileReference{find_file(name), {}};
  const NeutralHead head = build_neutral_head(shipped().heads, spec);
  const SurfaceTree tree = build_surface_tree(build_seen_skin());
  const std::vector<bool> is_hidden = find_hidden();
  std::vector<glm::dvec3> face, nearest;
  for (std::size_t v = 0; v < head.skin.positions.size(); ++v) {
    const glm::vec3& p = sitter().skin.positions[v];
    if (p.z < 30 || p.y < -90 || is_hidden[v]) continue;
    face.emplace_back(head.skin.positions[v]);
    nearest.emplace_back(p);
  }
  // Where a head stands is its eyes' affair: the two are laid on each other first.
  Similarity same = fit_similarity(face, nearest);
  double sum = 0;
  for (int round = 0; round < 20; ++round) {
    sum = 0;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const NearestPlace place = find_nearest(tree, apply_similarity(same, face[i]), 50);
      nearest[i] = place.point;
      sum += place.distance;
    }
    same = fit_similarity(face, nearest);
  }
  return sum / static_cast<double>(face.size());
}

// The 5 by 5 points of the skin in a quad of the cage, from the 16 quads that it is cut into.
std::array<std::array<glm::dvec3, 5>, 5> list_grid(const std::vector<Quad>& quads) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, const Quad*> by_edge;
  std::map<std::uint32_t, int> uses;
  for (const Quad& q : quads)
    for (std::size_t i = 0; i < 4; ++i) {
      by_edge[{q[i], q[(i + 1) % 4]}] = &q;
      ++uses[q[i]];
    }
  const auto follow = [](const Quad& q, std::uint32_t v) {
    return q[(static_cast<std::size_t>(std::ranges::find(q, v) - q.begin()) + 1) % 4];
  };
  std::uint32_t corner = 0;
  for (const auto& [v, count] : uses)
    if (count == 1) corner = v;
  const Quad* first =
      &*std::ranges::find_if(quads, [&](const Quad& q) { return std::ranges::find(q, corner) != q.end(); });
  std::array<std::array<glm::dvec3, 5>, 5> grid{};
  const auto at = [](std::uint32_t v) { return glm::dvec3(sitter().skin.positions[v]); };
  for (std::size_t row = 0; row < 4; ++row) {
    // Corners in turn: here, along the row, across, back.
    std::uint32_t here = corner;
    const Quad* quad = first;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t next = follow(*quad, here), across = follow(*quad, next),
                          back = follow(*quad, across);
      grid[row][i] = at(here), grid[row][i + 1] = at(next);
      grid[row + 1][i] = at(back), grid[row + 1][i + 1] = at(across);
      if (i == 0 && row < 3) {
        corner = back;
        first = by_edge.at({back, across});
      }
      if (i < 3) quad = by_edge.at({across, next});
      here = next;
    }
  }
  return grid;
}

// Control points of the curve of degree 4 that goes through five points at 0, 1/4, 1/2, 3/4 and 1.
std::array<glm::dvec3, 5> fit_curve(const std::array<glm::dvec3, 5>& p) {
  return {p[0], (-13.0 * p[0] + 48.0 * p[1] - 36.0 * p[2] + 16.0 * p[3] - 3.0 * p[4]) / 12.0,
          (13.0 * p[0] - 64.0 * p[1] + 120.0 * p[2] - 64.0 * p[3] + 13.0 * p[4]) / 18.0,
          (-3.0 * p[0] + 16.0 * p[1] - 36.0 * p[2] + 48.0 * p[3] - 13.0 * p[4]) / 12.0, p[4]};
}

// The quads of the skin in one quad of the cage, of those that are seen at least in part.
std::vector<std::vector<Quad>> list_seen_patches() {
  const std::vector<Quad>& quads = sitter().surface->quads;
  const std::vector<bool> is_hidden = find_hidden();
  std::vector<std::vector<Quad>> patches;
  for (std::size_t first = 0; first < quads.size(); first += 32)
    for (const std::size_t side : {0u, 1u}) {
      std::vector<Quad> own;
      bool is_seen = false;
      for (std::size_t i = side; i < 32; i += 2) {
        own.push_back(quads[first + i]);
        for (const std::uint32_t v : own.back()) is_seen = is_seen || !is_hidden[v];
      }
      if (is_seen) patches.push_back(std::move(own));
    }
  return patches;
}

// The skin as patches of degree 4, each with points of its own; every other one as a B-spline, and every
// third one facing inward.
std::string build_patches_obj(const std::vector<std::vector<Quad>>& patches) {
  std::string text = "# patches\n";
  std::size_t count = 0;
  for (const std::vector<Quad>& own : patches) {
    auto grid = list_grid(own);
    for (auto& row : grid) row = fit_curve(row);
    for (std::size_t i = 0; i < 5; ++i) {
      const auto column = fit_curve({grid[0][i], grid[1][i], grid[2][i], grid[3][i], grid[4][i]});
      for (std::size_t j = 0; j < 5; ++j) grid[j][i] = column[j];
    }
    if (++count % 3 == 0)
      for (auto& row : grid) std::ranges::reverse(row);
    for (const auto& row : grid)
      for (const glm::dvec3& p : row) text += fmt::format("v {:.6f} {:.6f} {:.6f}\n", p.x, p.y, p.z);
    const bool is_spline = count % 2 == 0;
    text += fmt::format("cstype {}\ndeg 4 4\nsurf 0 1 0 1", is_spline ? "bspline" : "bezier");
    for (int i = -25; i < 0; ++i) text += fmt::format("{} {}", i % 5 == 0 ? " \\\n" : "", i);
    for (const char way : {'u', 'v'})
      text += fmt::format("\nparm {} {}", way, is_spline ? "0 0 0 0 0 1 1 1 1 1" : "0 1");
    text += "\nend\n";
  }
  return text;
}

TEST(scan_kinds, patches_come_back_as_the_skin_that_they_are) {
  const auto patches = list_seen_patches();
  write_file(find_file("patches.obj"), build_patches_obj(patches));
  const Polygons mesh = load_polygons(find_file("patches.obj"));
  EXPECT_EQ(mesh.surfaces, patches.size());
  const SurfaceTree tree = build_surface_tree(mesh);
  double most = 0;
  const Polygons seen = build_seen_skin();
  for (const std::uint32_t v : seen.corners)
    most = std::max(most, find_nearest(tree, seen.positions[v], 50).distance);
  EXPECT_LT(most, 0.2);
  // Closed and open where the skin is, all of it one way round.
  Polygons same;
  for (const glm::vec3& p : sitter().skin.positions) same.positions.emplace_back(p);
  for (const std::vector<Quad>& own : patches)
    for (const Quad& q : own) {
      same.corners.insert(same.corners.end(), q.begin(), q.end());
      same.first.push_back(same.first.back() + 4);
    }
  const MeshReport report = find_mesh_faults(mesh);
  EXPECT_EQ(report.rims, find_mesh_faults(same).rims);
  for (const MeshFault& fault : report.faults) EXPECT_TRUE(fault.is_warning) << fault.message;
  const double miss_mm = measure_face("patches.obj");
  EXPECT_LT(miss_mm, 0.05);
  RecordProperty("patches", fmt::format("{:.3f} mm", miss_mm));
}

// Control points lie beside the surface; and what is passed over is said by whoever makes the head.
TEST(scan_kinds, landmarks_on_patches_are_places_and_trims_are_told) {
  std::string text = build_patches_obj(list_seen_patches());
  text.insert(text.rfind("end\n"), "trim 0 1 1\n");
  write_file(find_file("trimmed.obj"), text);
  write_file(find_file("trimmed.yaml"), build_landmarks());
  const Scan scan = load_scan_files(shipped().heads, find_file("trimmed.obj"), false);
  ASSERT_EQ(scan.warnings.size(), 1u);
  EXPECT_NE(scan.warnings[0].message.find("has 'trim' or 'hole': taken whole"), std::string::npos);
  write_file(find_file("trimmed.yaml"), "landmarks: {prn: 12}\n");
  try {
    load_scan_files(shipped().heads, find_file("trimmed.obj"), false);
    ADD_FAILURE() << "a control point was taken for a place on the skin";
  } catch (const InputError& e) {
    EXPECT_EQ(e.diagnostics.at(0).message,
              "'landmarks.prn' is '12'; expected a place such as [0, -30.5, 112]");
  }
}

// Points anywhere on the skin, as near to it as a digitiser is.
std::string build_cloud(std::size_t count, double noise_mm) {
  const Polygons mesh = build_seen_skin();
  std::vector<double> sums{0};
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto at = [&](std::size_t i) { return mesh.positions[mesh.corners[mesh.first[f] + i]]; };
    sums.push_back(sums.back() + glm::length(glm::cross(at(1) - at(0), at(3) - at(0))));
  }
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  std::normal_distribution<double> noise(0, noise_mm);
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    const auto f = static_cast<std::size_t>(std::ranges::upper_bound(sums, share(random) * sums.back()) -
                                            sums.begin() - 1);
    const auto at = [&](std::size_t j) { return mesh.positions[mesh.corners[mesh.first[f] + j]]; };
    const double u = share(random), v = share(random);
    const glm::dvec3 p = glm::mix(glm::mix(at(0), at(1), u), glm::mix(at(3), at(2), u), v) +
                         glm::dvec3(noise(random), noise(random), noise(random));
    text += fmt::format("{:.3f} {:.3f} {:.3f}\n", p.x, p.y, p.z);
  }
  return text;
}

TEST(scan_kinds, a_digitisers_points_come_back_as_the_face) {
  for (const auto& [count, most_mm] : {std::pair{3'000, 0.6}, {10'000, 0.25}, {30'000, 0.15}}) {
    write_file(find_file("cloud.xyz"), build_cloud(static_cast<std::size_t>(count), 0.1));
    const double miss_mm = measure_face("cloud.xyz");
    EXPECT_LT(miss_mm, most_mm) << count;
    RecordProperty(fmt::format("points_{}", count), fmt::format("{:.3f} mm", miss_mm));
  }
}

// Where planes across `axis`, `way_mm` apart, cut the skin: lines, each a list of points.
std::vector<Slice> cut_skin(int axis, double way_mm) {
  const Polygons mesh = build_seen_skin();
  std::vector<Slice> slices;
  double low = 1e9, high = -1e9;
  for (const glm::dvec3& p : mesh.positions) low = std::min(low, p[axis]), high = std::max(high, p[axis]);
  for (double height = low + 0.37; height < high; height += way_mm) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
    std::vector<glm::dvec3> places;
    std::vector<std::vector<std::uint32_t>> steps;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      std::vector<std::uint32_t> cut;
      for (std::size_t i = 0; i < 4; ++i) {
        const std::uint32_t a = mesh.corners[mesh.first[f] + i],
                            b = mesh.corners[mesh.first[f] + (i + 1) % 4];
        const double from = mesh.positions[a][axis] - height, to = mesh.positions[b][axis] - height;
        if ((from < 0) == (to < 0)) continue;
        const auto [found, is_new] =
            numbers.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(places.size()));
        if (is_new) places.push_back(glm::mix(mesh.positions[a], mesh.positions[b], from / (from - to)));
        cut.push_back(found->second);
      }
      if (cut.size() == 2) steps.push_back(cut);
    }
    for (const auto& chain : chain_lines(steps)) {
      Slice& slice = slices.emplace_back();
      for (const std::uint32_t i : chain) slice.push_back(places[i]);
    }
  }
  return slices;
}

std::string build_slices(const std::vector<Slice>& slices, const char* behind) {
  std::string text;
  for (const Slice& slice : slices) {
    for (const glm::dvec3& p : slice) text += fmt::format("{:.3f} {:.3f} {:.3f}\n", p.x, p.y, p.z);
    text += behind;
  }
  return text;
}

TEST(scan_kinds, slices_come_back_as_the_face) {
  for (const auto& [axis, way_mm] : {std::pair{0, 4.0}, {1, 4.0}, {1, 3.0}, {2, 4.0}}) {
    const std::vector<Slice> slices = cut_skin(axis, way_mm);
    write_file(find_file("slices.asc"), build_slices(slices, "\n"));
    EXPECT_EQ(load_polygons(find_file("slices.asc"), Faces::optional).slices, slices.size());
    const double miss_mm = measure_face("slices.asc");
    EXPECT_LT(miss_mm, 0.3) << "xyz"[axis];
    RecordProperty(fmt::format("slices_across_{}_{}", "xyz"[axis], way_mm),
                   fmt::format("{:.3f} mm", miss_mm));
  }
}

// Why room between slices is filled: a digitiser's tip leaves points so near to each other that they lie in
// rows, and of a row no plane is known.
TEST(scan_kinds, slices_far_apart_are_more_than_their_points) {
  std::vector<Slice> slices = cut_skin(0, 9);
  for (Slice& slice : slices) {
    Slice dense;
    for (std::size_t i = 0; i + 1 < slice.size(); ++i)
      for (int j = 0; j < 8; ++j) dense.push_back(glm::mix(slice[i], slice[i + 1], j / 8.0));
    dense.push_back(slice.back());
    slice = dense;
  }
  write_file(find_file("slices.asc"), build_slices(slices, "\n"));
  write_file(find_file("rows.asc"), build_slices(slices, ""));
  EXPECT_LT(measure_face("slices.asc"), 0.3);
  EXPECT_THROW(measure_face("rows.asc"), InputError) << "no longer better: may they be taken as they are?";
}

}  // namespace
}  // namespace mien

#include <algorithm>

#include "frames/pose_soundness.hpp"
#include "head/binding.hpp"
#include "head/cage.hpp"
#include "head/patterns.hpp"
#include "head/soundness.hpp"
#include "head/surface.hpp"
#include "shipped.hpp"

namespace mien {

namespace {

// Triangles of the skin in the cage's quads whose corners are all among the points of `patterns`.
std::vector<Triangle> find_triangles(const NeutralHead& head, const std::vector<std::string>& patterns) {
  std::vector<bool> wanted = find_points(head.cage, patterns);
  for (std::uint32_t i = 0; i < wanted.size(); ++i)
    if (wanted[i]) wanted[head.cage.mirror[i]] = true;
  std::vector<Triangle> triangles;
  for (std::size_t q = 0; q < head.cage.quads.size() / 2; ++q) {
    const Quad& quad = head.cage.quads[q];
    if (!std::all_of(quad.begin(), quad.end(), [&](std::uint32_t p) { return wanted[p]; })) continue;
    triangles.insert(triangles.end(), head.skin.triangles.begin() + static_cast<std::ptrdiff_t>(64 * q),
                     head.skin.triangles.begin() + static_cast<std::ptrdiff_t>(64 * (q + 1)));
  }
  return triangles;
}

void add_patches(const NeutralHead& head, PoseProbe& probe) {
  std::vector<bool> visible = find_visible(head);
  // Beside the corner of the mouth the lips' line is one shut fold too, as long as no jaw opens it.
  for (const std::vector<std::string>& rings :
       {std::vector<std::string>{"M0_4..8", "M1_4..8"}, {"M1_5..7", "M2_5..7"}})
    for (const Triangle& t : find_triangles(head, rings))
      for (const std::uint32_t v : t) visible[v] = false;
  for (std::size_t q = 0; q < head.cage.quads.size() / 2; ++q)
    for (std::size_t side = 0; side < 2; ++side) {
      std::vector<std::uint32_t> vertices;
      std::vector<Triangle> triangles;
      for (std::size_t i = side; i < 32; i += 2) {
        const Quad& quad = head.surface->quads[32 * q + i];
        vertices.insert(vertices.end(), quad.begin(), quad.end());
        for (std::size_t t = 2 * (32 * q + i); t < 2 * (32 * q + i) + 2; ++t)
          if (const Triangle& tri = head.skin.triangles[t];
              visible[tri[0]] && visible[tri[1]] && visible[tri[2]])
            triangles.push_back(tri);
      }
      if (triangles.empty()) continue;
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
      std::array<std::uint32_t, 25> patch{};
      std::copy_n(vertices.begin(), 25, patch.begin());
      probe.patches.push_back(patch);
      probe.patch_triangles.push_back(std::move(triangles));
    }
}

LidLine build_lid_line(const std::vector<MarginVertex>& ring) {
  LidLine line;
  std::vector<MarginVertex> sorted = ring;
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
  for (const MarginVertex& m : sorted) {
    if (m.at < 8.01) line.upper.push_back(m.vertex);
    if (m.at > 7.99) line.lower.insert(line.lower.begin(), m.vertex);
  }
  line.lower.insert(line.lower.begin(), sorted.front().vertex);
  return line;
}

void add_hairs(const Figure& figure, PoseProbe& probe) {
  const Mesh& skin = figure.head.skin;
  for (std::size_t part = 0; part < figure.parts.size(); ++part) {
    if (!figure.model.parts[part].name.starts_with("brow_")) continue;
    const Mesh& rest = figure.model.parts[part].rest;
    Box box = compute_bounds(rest.positions);
    const SkinPatch patch = build_skin_patch(skin, {box.low - 4.0f, box.high + 4.0f});
    for (const Binding& binding : figure.parts[part].bindings)
      if (binding.count > 0) {  // rings have the same height all round: one vertex tells
        const std::uint32_t v = binding.first + binding.count - 1;
        const SkinPlace place = find_nearest_place(patch, rest.positions[v]);
        probe.hairs.push_back({part, v, place.triangle, place.barycentric});
      }
  }
}

}  // namespace

PoseProbe build_pose_probe(const Figure& figure) {
  const NeutralHead& head = figure.head;
  PoseProbe probe;
  probe.figure = &figure;
  probe.eye = shipped().stock.head->parts.eye;
  add_patches(head, probe);
  for (const Triangle& t : find_triangles(head, {"E0_*", "E1_*", "E2_*", "E3_*"}))
    for (const std::uint32_t v : t)
      if (head.skin.positions[v].x > 0) probe.lid_skin.push_back(v);
  std::sort(probe.lid_skin.begin(), probe.lid_skin.end());
  probe.lid_skin.erase(std::unique(probe.lid_skin.begin(), probe.lid_skin.end()), probe.lid_skin.end());
  probe.rims = {build_lid_line(compute_lid_ring(*head.surface, head.cage, {"EB_", "E0_", "E1_"})),
                build_lid_line(compute_lid_ring(*head.surface, head.cage, {"E0_", "E1_", "E2_"}))};
  probe.lips = {find_triangles(head, {"M0_0..6", "M1_0..6", "M2_0..6"}),
                find_triangles(head, {"M0_6..12", "M1_6..12", "M2_6..12"})};
  probe.outside = find_triangles(
      head, {"M1_*", "M2_*", "M3_*", "M4_*", "MA_*", "M5_*", "M6_*", "q*_C*", "m*_D*", "q*_D*"});
  for (std::size_t i = 0; i < figure.model.parts.size(); ++i) {
    const std::string& name = figure.model.parts[i].name;
    if (name == "teeth_upper" || name == "gum_upper") probe.bites[0].push_back(i);
    if (name == "teeth_lower" || name == "gum_lower") probe.bites[1].push_back(i);
    if (name == "tongue") probe.bites[2].push_back(i);
  }
  add_hairs(figure, probe);
  return probe;
}

}  // namespace mien

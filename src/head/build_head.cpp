#include "core/holes.hpp"
#include "head/cage.hpp"
#include "head/head.hpp"
#include "head/shapes.hpp"
#include "head/solve.hpp"
#include "head/surface.hpp"

namespace mien {

namespace {

// The mouth bag's back is woven of quads, which leave a slit at each corner of the mouth: an open mouth would
// show the light behind the head. Caps them, left and right alike.
void close_slits(const Surface& surface, Mesh& skin) {
  constexpr std::size_t kLongestSlit = 16;  // edges; the eyes' loops have 64, the chest's more
  const std::size_t open = skin.triangles.size();
  for (const Loop& loop : find_boundary_loops(skin.triangles))
    if (loop.size() <= kLongestSlit && skin.positions[loop.front()].x > 0) append_ear_cap(skin, loop);
  for (std::size_t i = open, end = skin.triangles.size(); i < end; ++i) {
    const auto [a, b, c] = skin.triangles[i];
    skin.triangles.push_back({surface.mirror[a], surface.mirror[c], surface.mirror[b]});
  }
}

}  // namespace

NeutralHead build_neutral_head(const HeadSpec& spec, const std::filesystem::path& data_folder) {
  const std::filesystem::path folder = data_folder / "templates/head";
  const HalfHead half = load_half_head(folder);
  NeutralHead head;
  head.cage = build_cage(half);
  solve_cage(half, head.cage);
  head.adult_points = head.cage.points;
  shape_head(load_head_shapes(folder), spec, head.cage, head.eye);

  head.surface = std::make_shared<const Surface>(build_surface(head.cage));
  std::vector<glm::vec4> packed;
  pack_points(head.cage.points, packed);
  deform_surface(*head.surface, packed, head.skin.positions);
  head.skin.triangles = split_quads(*head.surface, head.skin.positions);
  close_slits(*head.surface, head.skin);
  update_surface_normals(*head.surface, head.skin.positions, head.skin.normals);
  return head;
}

}  // namespace mien

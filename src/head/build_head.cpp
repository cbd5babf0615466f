#include "head/cage.hpp"
#include "head/head.hpp"
#include "head/shapes.hpp"
#include "head/solve.hpp"
#include "head/surface.hpp"

namespace mien {

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
  update_surface_normals(*head.surface, head.skin.positions, head.skin.normals);
  head.skin.triangles = split_quads(*head.surface, head.skin.positions);
  return head;
}

}  // namespace mien

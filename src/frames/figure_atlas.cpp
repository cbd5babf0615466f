#include "frames/figure_atlas.hpp"

#include "head/skin_atlas.hpp"
#include "head/skin_texture.hpp"
#include "head/stock_things.hpp"
#include "head/surface.hpp"

namespace mien {

Atlas build_figure_atlas(const Figure& figure) {
  const FineSkin& fine = figure.folds.skin;
  std::vector<Float4> points;
  std::vector<glm::vec3> positions, normals;
  pack_points(figure.head.adult_points, points);
  deform_surface(*figure.head.surface, points, positions);
  update_surface_normals(*figure.head.surface, positions, normals);
  append_fine_points(fine, positions, normals);
  return build_skin_atlas(positions, fine.triangles, fine.mirror);
}

void paint_figure(const HeadStock& stock, const HeadSpec& spec, Figure& figure) {
  if (!spec.look.texture) return;
  const auto atlas = share_stock_thing(stock, "skin atlas", [&] { return build_figure_atlas(figure); });
  paint_skin(atlas, *spec.look.texture, figure.model.parts.front());
}

}  // namespace mien

#include "config/part_numbers.hpp"
#include "core/holes.hpp"
#include "head/design.hpp"
#include "head/form.hpp"
#include "head/mouth_bag.hpp"
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

NeutralHead build_neutral_head(const HeadStock& stock, const HeadSpec& spec) {
  HeadForm form = build_form(stock, spec);
  NeutralHead head;
  head.data = stock.data;
  head.adult_points = stock.adult.points;
  head.cage = stock.adult;
  head.cage.points = std::move(form.points);
  head.eye = form.eye;
  head.surface = stock.surface;
  head.hairline = form.hairline;
  head.brow_thickness = form.brow_thickness;
  head.shortened_mm = form.shortened_mm;
  head.design = compute_design(stock, spec);
  head.ages = compute_ages(spec);
  const MouthNumbers mouth = stock.data->parts.mouth;
  shape_mouth_bag(mouth, head.cage, head.adult_points);
  shape_mouth_bag(mouth, head.cage, head.cage.points);

  // The adult decides how quads are cut, so that all heads have the same triangles: an age can change in a
  // clip.
  std::vector<Float4> packed;
  pack_points(head.adult_points, packed);
  deform_surface(*head.surface, packed, head.skin.positions);
  head.skin.triangles = split_quads(*head.surface, head.skin.positions);
  close_slits(*head.surface, head.skin);
  pack_points(head.cage.points, packed);
  deform_surface(*head.surface, packed, head.skin.positions);
  update_surface_normals(*head.surface, head.skin.positions, head.skin.normals);
  return head;
}

}  // namespace mien

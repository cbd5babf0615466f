// A surface of which only some vertices are asked for.
#include "head/surface.hpp"

#include <gtest/gtest.h>

#include <random>

#include "config/head_spec.hpp"
#include "core/data.hpp"
#include "head/head.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

TEST(surface, selected_vertices_are_placed_as_on_the_whole_surface) {
  const NeutralHead head = build_neutral_head(shipped().heads, HeadSpec{});
  const Surface& whole = *head.surface;
  std::vector<Float4> points;
  pack_points(head.cage.points, points);
  std::vector<glm::vec3> places, normals;
  deform_surface(whole, points, places);
  update_surface_normals(whole, places, normals);

  std::mt19937 random(7);
  std::vector<bool> is_wanted(whole.vertex_count()), has_normal(whole.vertex_count());
  for (std::size_t v = 0; v < is_wanted.size(); ++v) {
    is_wanted[v] = random() % 20 == 0;
    has_normal[v] = random() % 100 == 0;
  }
  const Surface selected = select_vertices(whole, is_wanted, has_normal);
  EXPECT_LT(selected.weight.size(), whole.weight.size() / 2);
  EXPECT_LT(selected.quads.size(), whole.quads.size() / 4);
  ASSERT_EQ(selected.vertex_count(), whole.vertex_count());
  std::vector<glm::vec3> own, own_normals;
  deform_surface(selected, points, own);
  update_surface_normals(selected, own, own_normals);
  for (std::size_t v = 0; v < is_wanted.size(); ++v)
    for (const std::uint32_t w : {static_cast<std::uint32_t>(v), whole.mirror[v]}) {
      EXPECT_TRUE(own[w] == places[w] || !(is_wanted[v] || has_normal[v])) << w;
      EXPECT_TRUE(own_normals[w] == normals[w] || !has_normal[v]) << w;
    }
}

TEST(surface, nothing_selected_is_nothing) {
  const NeutralHead head = build_neutral_head(shipped().heads, HeadSpec{});
  const std::vector<bool> none(head.surface->vertex_count(), false);
  const Surface selected = select_vertices(*head.surface, none, none);
  EXPECT_TRUE(selected.weight.empty());
  EXPECT_TRUE(selected.quads.empty());
  std::vector<Float4> points;
  pack_points(head.cage.points, points);
  std::vector<glm::vec3> places;
  deform_surface(selected, points, places);
  EXPECT_EQ(places, std::vector<glm::vec3>(none.size(), glm::vec3(0)));
}

}  // namespace
}  // namespace mien

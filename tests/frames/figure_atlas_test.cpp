#include "frames/figure_atlas.hpp"

#include <gtest/gtest.h>

#include "shipped.hpp"

namespace mien {
namespace {

double compute_area(const Atlas& atlas, const Triangle& triangle) {
  const glm::dvec2 a(atlas.places[triangle[0]]), b(atlas.places[triangle[1]]), c(atlas.places[triangle[2]]);
  return 0.5 * ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
}

TEST(figure_atlas, lays_the_skin_flat_without_an_overlap) {
  const Figure figure = build_figure(shipped().heads, HeadSpec{});
  const Atlas atlas = build_figure_atlas(figure);
  const Mesh& skin = figure.model.parts.front().rest;
  ASSERT_EQ(atlas.triangles.size(), skin.triangles.size());
  double sum = 0;
  for (std::size_t t = 0; t < atlas.triangles.size(); ++t) {
    // All one way round within a square: none lies on another.
    const double area = compute_area(atlas, atlas.triangles[t]);
    ASSERT_GT(area, 0) << t;
    sum += area;
    for (int k = 0; k < 3; ++k) EXPECT_EQ(atlas.vertices[atlas.triangles[t][k]], skin.triangles[t][k]);
  }
  EXPECT_LE(sum, 1 + 1e-6);
  EXPECT_GT(sum, 0.99) << "nothing but the eyes is open";
  for (const glm::vec2& place : atlas.places)
    EXPECT_TRUE(place.x >= 0 && place.x <= 1 && place.y >= 0 && place.y <= 1) << place.x << " " << place.y;
}

TEST(figure_atlas, has_the_halves_apart_and_alike) {
  const Figure figure = build_figure(shipped().heads, HeadSpec{});
  const Atlas atlas = build_figure_atlas(figure);
  const std::vector<std::uint32_t>& mirror = figure.folds.skin.mirror;
  const std::vector<glm::vec3>& positions = figure.model.parts.front().rest.positions;
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    const glm::vec2 place = atlas.places[v];
    if (mirror[v] == v) continue;
    EXPECT_NEAR(place.x, 1 - atlas.places[mirror[v]].x, 1e-6);
    EXPECT_NEAR(place.y, atlas.places[mirror[v]].y, 1e-6);
    EXPECT_EQ(place.x > 0.5, positions[v].x > 0) << "the character's left is on the right";
  }
}

TEST(figure_atlas, is_the_same_on_every_head) {
  const Atlas adult = build_figure_atlas(build_figure(shipped().heads, HeadSpec{}));
  HeadSpec infant;
  infant.age = {{"infant", 1.0}};
  infant.hair = "crop";
  const Atlas other = build_figure_atlas(build_figure(shipped().heads, infant));
  EXPECT_EQ(other.vertices, adult.vertices);
  EXPECT_EQ(other.triangles, adult.triangles);
  EXPECT_EQ(other.places, adult.places);
}

}  // namespace
}  // namespace mien

#include "core/simplify.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/holes.hpp"
#include "core/refine.hpp"
#include "solids.hpp"

namespace mien {
namespace {

TEST(simplify, stays_closed_and_near_where_it_was) {
  const Mesh before = build_ball({1, 2, 3}, 10, 40);
  Mesh after = before;
  simplify_mesh(after, 0.05);
  EXPECT_EQ(count_open_edges(after.triangles), 0U);
  EXPECT_LT(after.triangles.size(), before.triangles.size() * 2 / 3);
  EXPECT_NEAR(compute_volume_mm3(after), compute_volume_mm3(before), 0.005 * compute_volume_mm3(before));
  for (const glm::vec3& p : after.positions) EXPECT_NEAR(glm::length(p - glm::vec3(1, 2, 3)), 10, 0.1);
}

TEST(simplify, leaves_facets_within_its_tolerance_and_rims_where_they_were) {
  const glm::vec3 centre(1, 2, 3);
  Mesh mesh = build_ball(centre, 10, 40);
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return mesh.positions[v].y > 8; });
  });
  const std::vector<Loop> rims = find_boundary_loops(mesh.triangles);
  ASSERT_EQ(rims.size(), 1u);
  Mesh after = mesh;
  simplify_mesh(after, 0.02);
  EXPECT_LT(after.triangles.size(), mesh.triangles.size());
  for (const std::uint32_t v : rims[0])
    EXPECT_NE(std::ranges::find(after.positions, mesh.positions[v]), after.positions.end()) << v;
  for (const auto& [a, b, c] : after.triangles) {
    const glm::vec3 middle = (after.positions[a] + after.positions[b] + after.positions[c]) / 3.0f;
    EXPECT_NEAR(glm::distance(middle, centre), 10, 0.05);
  }
}

TEST(simplify, of_a_micrometre_leaves_a_ball_as_it_was) {
  const Mesh before = build_ball({0, 0, 0}, 10, 40);
  Mesh after = before;
  simplify_mesh(after, 0.001);
  EXPECT_GT(after.triangles.size(), before.triangles.size() * 95 / 100);
}

TEST(simplify, gives_the_same_mesh_each_time) {
  Mesh one = build_ball({0, 0, 0}, 5, 20), two = one;
  simplify_mesh(one, 0.1);
  simplify_mesh(two, 0.1);
  EXPECT_EQ(one.triangles, two.triangles);
  EXPECT_EQ(one.positions, two.positions);
}

TEST(simplify, keeps_corners_and_the_last_tetrahedron) {
  Mesh box = build_box({0, 0, 0}, {4, 4, 4});
  simplify_mesh(box, 0.01);
  EXPECT_EQ(box.triangles.size(), 12U);
  Mesh ball = build_ball({0, 0, 0}, 1, 4);
  simplify_mesh(ball, 100);  // anything goes, but not the surface itself
  EXPECT_EQ(count_open_edges(ball.triangles), 0U);
  EXPECT_GE(ball.triangles.size(), 4U);
  Mesh nothing;
  simplify_mesh(nothing, 1);
  EXPECT_TRUE(nothing.triangles.empty());
}

TEST(refine, splits_only_what_is_marked_and_leaves_no_crack) {
  Mesh ball = build_ball({0, 0, 0}, 10, 10);
  update_normals(ball);
  const std::size_t vertices = ball.positions.size(), triangles = ball.triangles.size();
  std::vector<bool> marks(vertices, false);
  marks[0] = true;  // the pole: 20 triangles become four each, 20 neighbours two each
  refine_marked(ball, marks);
  EXPECT_EQ(count_open_edges(ball.triangles), 0U);
  EXPECT_EQ(ball.triangles.size(), triangles + 20 * 3 + 20);
  EXPECT_EQ(ball.positions.size(), vertices + 40);
  EXPECT_EQ(marks.size(), ball.positions.size());
  EXPECT_EQ(ball.normals.size(), ball.positions.size());
}

TEST(refine, comes_nearer_to_the_round_shape) {
  Mesh ball = build_ball({0, 0, 0}, 10, 10);
  const double exact = 4.0 / 3 * std::numbers::pi * 1000;
  const double shortfall = exact - compute_volume_mm3(ball);
  update_normals(ball);
  std::vector<bool> marks(ball.positions.size(), true);
  refine_marked(ball, marks);
  EXPECT_EQ(count_open_edges(ball.triangles), 0U);
  EXPECT_LT(std::abs(exact - compute_volume_mm3(ball)), shortfall / 3);
  EXPECT_TRUE(std::all_of(marks.begin(), marks.end(), [](bool mark) { return mark; }));
}

}  // namespace
}  // namespace mien

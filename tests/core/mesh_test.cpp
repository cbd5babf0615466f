#include "core/mesh.hpp"

#include <gtest/gtest.h>

#include "solids.hpp"

namespace mien {
namespace {

TEST(mesh, bounds_hold_every_vertex) {
  const Box box = compute_bounds({{1, -2, 3}, {-4, 5, 0}, {0, 0, 6}});
  EXPECT_EQ(box.low, glm::vec3(-4, -2, 0));
  EXPECT_EQ(box.high, glm::vec3(1, 5, 6));
  EXPECT_EQ(compute_bounds({}).high, glm::vec3(0));
}

TEST(mesh, normals_point_out_and_weigh_by_area) {
  Mesh square;
  square.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {9, 9, 9}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  update_normals(square);
  for (const glm::vec3& n : square.normals) EXPECT_EQ(n, glm::vec3(0, 0, 1));  // the lonely vertex as well

  Mesh ball = build_ball({5, 5, 5}, 2, 12);
  update_normals(ball);
  for (std::size_t i = 0; i < ball.positions.size(); ++i)
    EXPECT_GT(glm::dot(ball.normals[i], (ball.positions[i] - glm::vec3(5)) / 2.0f), 0.99f);
}

TEST(mesh, counts_open_flipped_and_doubled_edges) {
  Mesh box = build_box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(count_open_edges(box.triangles), 0U);
  std::vector<Triangle> open = box.triangles;
  open.pop_back();
  EXPECT_EQ(count_open_edges(open), 3U);
  std::vector<Triangle> flipped = box.triangles;
  std::swap(flipped[0][1], flipped[0][2]);
  EXPECT_EQ(count_open_edges(flipped), 6U);  // its three edges and those of its neighbours
  std::vector<Triangle> doubled = box.triangles;
  doubled.push_back(doubled.front());
  EXPECT_EQ(count_open_edges(doubled), 6U);
  EXPECT_EQ(count_open_edges({}), 0U);
}

TEST(mesh, volume_is_signed_by_the_winding) {
  Mesh box = build_box({1, 2, 3}, {3, 5, 7});
  EXPECT_DOUBLE_EQ(compute_volume_mm3(box), 24);
  for (Triangle& t : box.triangles) std::swap(t[1], t[2]);
  EXPECT_DOUBLE_EQ(compute_volume_mm3(box), -24);
}

TEST(mesh, appends_behind_what_is_there) {
  Mesh both = build_box({0, 0, 0}, {1, 1, 1});
  append_mesh(both, build_box({5, 0, 0}, {6, 1, 2}));
  EXPECT_EQ(both.positions.size(), 16U);
  EXPECT_EQ(both.triangles[12], (Triangle{8, 10, 11}));
  EXPECT_DOUBLE_EQ(compute_volume_mm3(both), 3);
}

}  // namespace
}  // namespace mien

#include "head/tubes.hpp"

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(tubes, a_hair_is_closed_and_wound_outward) {
  Mesh mesh;
  append_hair(mesh, {{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0.5f, 3}}, {0.1f, 0.1f, 0.05f, 0}, 3, {1, 0, 0});
  EXPECT_EQ(mesh.positions.size(), 10u);
  EXPECT_EQ(count_open_edges(mesh.triangles), 0u);
  EXPECT_GT(compute_volume_mm3(mesh), 0);
}

TEST(tubes, a_curve_passes_its_points_and_goes_straight_on) {
  const std::vector<glm::vec3> points{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}};
  for (int i = 0; i < 3; ++i) EXPECT_EQ(sample_curve(points, i), points[i]);
  EXPECT_EQ(sample_curve(points, 3, true), points[0]);
  EXPECT_LT(sample_curve(points, -1).x, -0.5f);
  EXPECT_GT(sample_curve(points, 3).x, 2.5f);
}

TEST(tubes, stations_never_overshoot) {
  const std::vector<double> at{0, 1, 3}, values{2, 5, 4};
  EXPECT_EQ(sample_stations(at, values, -1), 2);
  EXPECT_EQ(sample_stations(at, values, 1), 5);
  EXPECT_EQ(sample_stations(at, values, 9), 4);
  for (double t = 0; t <= 3; t += 0.01) EXPECT_LE(sample_stations(at, values, t), 5);
}

TEST(tubes, scattered_numbers_fill_the_unit_evenly) {
  double sum = 0;
  for (std::uint32_t i = 0; i < 4000; ++i) sum += scatter(1, i, 2);
  EXPECT_NEAR(sum / 4000, 0.5, 0.02);
  EXPECT_NE(scatter(1, 2, 3), scatter(1, 3, 2));
}

}  // namespace
}  // namespace mien

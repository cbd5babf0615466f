#include "core/nearest_point.hpp"

#include <gtest/gtest.h>

#include <random>

namespace mien {
namespace {

TEST(nearest_point, nothing_of_the_triangle_is_nearer) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(-1, 1), share(0, 1);
  const auto draw = [&] { return glm::dvec3(place(random), place(random), place(random)); };
  for (int round = 0; round < 300; ++round) {
    const glm::dvec3 a = draw(), b = draw(), c = draw(), p = 2.0 * draw();
    const glm::dvec3 at = compute_nearest_barycentric(p, a, b, c);
    EXPECT_NEAR(at.x + at.y + at.z, 1, 1e-12);
    for (int i = 0; i < 3; ++i) EXPECT_GE(at[i], -1e-12);
    const double nearest = glm::distance(p, at.x * a + at.y * b + at.z * c);
    for (int other = 0; other < 100; ++other) {
      double u = share(random), v = share(random);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      EXPECT_LE(nearest, glm::distance(p, (1 - u - v) * a + u * b + v * c) + 1e-12);
    }
  }
}

TEST(nearest_point, finds_a_corner_of_what_has_no_area) {
  const glm::vec3 a(1, 2, 3);
  EXPECT_EQ(compute_nearest_barycentric(glm::vec3(5, 5, 5), a, a, a), glm::vec3(1, 0, 0));
}

}  // namespace
}  // namespace mien

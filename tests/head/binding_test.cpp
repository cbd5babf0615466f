#include "head/binding.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace mien {
namespace {

TEST(skin_frame, turns_and_moves_with_the_skin) {
  const Triangle triangle{0, 1, 2};
  const std::vector<glm::vec3> flat{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, up(3, glm::vec3(0, 0, 1));
  const SkinFrame rest = compute_skin_frame(flat, up, triangle, {0.5f, 0.25f, 0.25f});
  EXPECT_EQ(rest.origin, glm::vec3(0.5f, 0.5f, 0));
  EXPECT_EQ(rest.axes, glm::mat3(1));

  // A quarter turn about x, and 5 mm up.
  const std::vector<glm::vec3> turned{{0, 0, 5}, {2, 0, 5}, {0, 0, 7}}, back(3, glm::vec3(0, -1, 0));
  const SkinFrame now = compute_skin_frame(turned, back, triangle, {0.5f, 0.25f, 0.25f});
  EXPECT_EQ(now.origin, glm::vec3(0.5f, 0, 5.5f));
  EXPECT_EQ(now.axes, glm::mat3(glm::vec3(1, 0, 0), glm::vec3(0, 0, 1), glm::vec3(0, -1, 0)));
}

TEST(skin_frame, is_whole_on_a_collapsed_triangle) {
  const std::vector<glm::vec3> point(3, glm::vec3(1, 2, 3)), normals(3, glm::vec3(0));
  const SkinFrame frame = compute_skin_frame(point, normals, {0, 1, 2}, {1, 0, 0});
  EXPECT_EQ(frame.origin, glm::vec3(1, 2, 3));
  EXPECT_NEAR(glm::determinant(frame.axes), 1, 1e-5);
}

TEST(skin_patch, finds_the_nearest_place_of_a_square) {
  Mesh square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
              std::vector<glm::vec3>(4, {0, 0, 1}),
              {{0, 1, 2}, {0, 2, 3}}};
  const SkinPatch patch = build_skin_patch(square, compute_bounds(square.positions));
  EXPECT_EQ(find_nearest_place(patch, {0.75f, 0.25f, 3}).point, glm::vec3(0.75f, 0.25f, 0));
  EXPECT_EQ(find_nearest_place(patch, {0.75f, 0.25f, 3}).triangle, 0u);
  EXPECT_EQ(find_nearest_place(patch, {-2, 2, 0}).point, glm::vec3(0, 1, 0));       // beyond a corner
  EXPECT_EQ(find_nearest_place(patch, {2, 0.5f, 0}).point, glm::vec3(1, 0.5f, 0));  // beyond an edge
}

TEST(mirror_parts, refuses_a_skin_that_is_not_its_own_mirror_image) {
  Mesh half{{{1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, std::vector<glm::vec3>(3, {0, 0, 1}), {{0, 1, 2}}};
  HeadPart part;
  part.bindings = {{0, {1, 0, 0}, 0, 0}};
  try {
    mirror_parts({part}, half);
    FAIL() << "expected a RunError";
  } catch (const RunError& error) {
    EXPECT_STREQ(error.what(), "the skin is not the mirror image of itself");
  }
}

}  // namespace
}  // namespace mien

#include "core/holes.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/error.hpp"
#include "solids.hpp"

namespace mien {
namespace {

// A box without the two triangles of its upper side (y high).
Mesh build_open_box() {
  Mesh box = build_box({0, 0, 0}, {2, 3, 4});
  std::erase_if(box.triangles, [](const Triangle& t) {
    return t == Triangle{2, 6, 7} || t == Triangle{2, 7, 3};
  });
  return box;
}

// A prism over an L, open above.        3---2
//   y is up; the L lies in x and z.     |   |      z
// Its notch at vertex 4 is what a       |   4--5   ^
// fan from the middle would cross.      0------1   +> x   (seen from above, z up the page)
Mesh build_open_l() {
  const std::vector<glm::vec2> outline{{0, 0}, {0, 4}, {1, 4},
                                       {1, 1}, {4, 1}, {4, 0}};  // clockwise in (x, z)
  Mesh mesh;
  for (const float y : {0.0f, 2.0f})
    for (const glm::vec2& p : outline) mesh.positions.emplace_back(p.x, y, p.y);
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    mesh.triangles.push_back({i, j, j + 6});
    mesh.triangles.push_back({i, j + 6, i + 6});
  }
  return mesh;
}

TEST(holes, finds_no_loop_in_a_closed_mesh) {
  EXPECT_TRUE(find_boundary_loops(build_box({0, 0, 0}, {1, 1, 1}).triangles).empty());
  EXPECT_TRUE(find_boundary_loops({}).empty());
}

TEST(holes, walks_each_loop_once_against_the_mesh) {
  const Mesh box = build_open_box();
  const std::vector<Loop> loops = find_boundary_loops(box.triangles);
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(loops[0], (Loop{2, 6, 7, 3}));
  EXPECT_EQ(compute_loop_centre(box.positions, loops[0]), glm::vec3(1, 3, 2));
}

TEST(holes, refuses_what_is_not_a_surface) {
  // Two triangles that meet in vertex 0 only: two loops through one vertex.
  for (const auto& [triangles, message] :
       {std::pair{std::vector<Triangle>{{0, 1, 2}, {0, 3, 4}}, "mesh is not a surface at vertex 0"},
        std::pair{std::vector<Triangle>{{0, 1, 2}, {0, 1, 3}}, "mesh is not a surface at vertex 0"}}) {
    try {
      find_boundary_loops(triangles);
      FAIL() << message;
    } catch (const RunError& e) {
      EXPECT_STREQ(e.what(), message);
    }
  }
}

TEST(holes, fan_closes_and_keeps_the_winding) {
  Mesh box = build_open_box();
  append_fan_cap(box, find_boundary_loops(box.triangles).front(), {1, 6, 2});
  EXPECT_EQ(count_open_edges(box.triangles), 0U);
  EXPECT_NEAR(compute_volume_mm3(box), 24 + 8, 1e-5);  // the box and a pyramid of height 3
}

TEST(holes, ears_fill_a_loop_with_a_notch) {
  Mesh mesh = build_open_l();
  EXPECT_EQ(close_holes(mesh), 2U);
  EXPECT_EQ(count_open_edges(mesh.triangles), 0U);
  EXPECT_EQ(mesh.positions.size(), 12U);  // none are new
  EXPECT_NEAR(compute_volume_mm3(mesh), 14, 1e-5);
  for (const auto& [a, b, c] : mesh.triangles)
    EXPECT_GT(
        glm::length(glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a])),
        0.1f);
}

TEST(holes, band_carries_the_edge_on) {
  Mesh box = build_open_box();
  const Loop loop = find_boundary_loops(box.triangles).front();
  Loop next;
  for (const std::uint32_t v : loop) {
    next.push_back(static_cast<std::uint32_t>(box.positions.size()));
    box.positions.push_back(box.positions[v] + glm::vec3(0, 2, 0));
  }
  append_band(box, loop, next);
  EXPECT_EQ(find_boundary_loops(box.triangles), (std::vector<Loop>{next}));
  append_ear_cap(box, next);
  EXPECT_EQ(count_open_edges(box.triangles), 0U);
  EXPECT_NEAR(compute_volume_mm3(box), 40, 1e-5);
}

TEST(holes, punctured_balls_close_again) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    Mesh ball = build_ball({3, -4, 5}, 10, 16);
    const double whole = compute_volume_mm3(ball);
    std::mt19937 random(seed);
    std::uniform_int_distribution<std::uint32_t> any_vertex(
        0, static_cast<std::uint32_t>(ball.positions.size()) - 1);
    std::vector<glm::vec3> holes;
    for (int tries = 0; tries < 12; ++tries) {
      const glm::vec3 p = ball.positions[any_vertex(random)];
      const bool is_apart =
          std::all_of(holes.begin(), holes.end(), [&](const glm::vec3& q) { return glm::length(p - q) > 9; });
      if (is_apart) holes.push_back(p);
    }
    std::erase_if(ball.triangles, [&](const Triangle& t) {
      return std::any_of(holes.begin(), holes.end(), [&](const glm::vec3& p) {
        return std::any_of(t.begin(), t.end(),
                           [&](std::uint32_t v) { return glm::length(ball.positions[v] - p) < 2; });
      });
    });
    ASSERT_EQ(close_holes(ball), holes.size()) << seed;
    EXPECT_EQ(count_open_edges(ball.triangles), 0U) << seed;
    const double volume = compute_volume_mm3(ball);
    EXPECT_LT(volume, whole);  // a cap is flatter than the ball
    EXPECT_GT(volume, whole * (1 - 0.012 * double(holes.size()))) << seed;
  }
}

TEST(holes, takes_a_mesh_into_its_pieces) {
  Mesh mesh = build_box({0, 0, 0}, {1, 1, 1});
  mesh.positions.emplace_back(50, 50, 50);  // belongs to no triangle
  append_mesh(mesh, build_box({4, 0, 0}, {6, 1, 1}));
  const std::vector<Mesh> pieces = split_pieces(mesh);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_DOUBLE_EQ(compute_volume_mm3(pieces[0]), 1);
  EXPECT_DOUBLE_EQ(compute_volume_mm3(pieces[1]), 2);
  EXPECT_EQ(pieces[1].positions.front(), glm::vec3(4, 0, 0));
  EXPECT_TRUE(split_pieces(Mesh{}).empty());
  const std::vector<Mesh> alone = split_pieces({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {{0, 1, 2}}});
  ASSERT_EQ(alone.size(), 1U);
  EXPECT_EQ(alone[0].positions.size(), 3U);
}

}  // namespace
}  // namespace mien

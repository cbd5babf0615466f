// Thin parts become thick enough; the rest stays.
#include "print/thicken.hpp"

#include <gtest/gtest.h>

#include "core/crossings.hpp"
#include "print/shapes.hpp"
#include "print/solid_tree.hpp"
#include "print/thickness.hpp"
#include "solids.hpp"

namespace mien {
namespace {

// A ball of 20 mm with a flat ear of `ear_mm` on each side: the ball's own vertices drawn out to a plate.
Mesh build_eared(double ear_mm) {
  Mesh mesh = build_ball({0, 0, 30}, 20, 48);
  for (glm::vec3& p : mesh.positions) {
    const float reach = std::abs(p.x);
    if (reach < 12) continue;
    const float out = (reach - 12) / 8;  // 0..1
    const float round = std::sqrt(std::max(0.0f, 400 - reach * reach));
    const float flat = std::min(round, std::max(float(ear_mm) / 2, round * (1 - 3 * out)));
    if (round > 0) p.y *= flat / round;
    p.x += (p.x < 0 ? -1.0f : 1.0f) * 8 * out * out;
  }
  return mesh;
}

double find_thinnest(const Mesh& mesh) {
  double area = 0;
  for (const ThicknessSample& sample : list_thicknesses(mesh, build_solid_tree(mesh), 5)) {
    area += sample.area_mm2;
    if (area >= 0.3) return sample.thickness_mm;
  }
  return 0;
}

Mesh move(Mesh mesh, const std::vector<glm::vec3>& moves) {
  for (std::size_t v = 0; v < moves.size(); ++v) mesh.positions[v] += moves[v];
  return mesh;
}

TEST(thicken, ears_become_as_thick_as_asked) {
  for (const double ear : {0.3, 0.5, 0.7}) {
    const Mesh mesh = build_eared(ear);
    ASSERT_LT(find_thinnest(mesh), 0.78) << ear;
    const Mesh thick = move(mesh, compute_thickening(mesh, 0.8));
    EXPECT_GE(find_thinnest(thick), 0.76) << ear;
    EXPECT_TRUE(find_crossings(thick.positions, thick.triangles).empty()) << ear;
  }
}

TEST(thicken, what_is_thick_stays) {
  const Mesh ball = build_ball({0, 0, 30}, 20, 24);
  for (const glm::vec3& move : compute_thickening(ball, 0.8)) EXPECT_EQ(move, glm::vec3(0));
  const Mesh eared = build_eared(0.4);
  const std::vector<glm::vec3> moves = compute_thickening(eared, 0.8);
  for (std::size_t v = 0; v < moves.size(); ++v) {
    EXPECT_LT(glm::length(moves[v]), 0.6);
    EXPECT_TRUE(std::abs(eared.positions[v].x) >= 6 || moves[v] == glm::vec3(0)) << v;
  }
}

TEST(thicken, mirrored_bodies_move_alike) {
  Mesh mesh = build_eared(0.4), mirrored = mesh;
  for (glm::vec3& p : mirrored.positions) p.x = -p.x;
  for (Triangle& t : mirrored.triangles) std::swap(t[1], t[2]);
  const std::vector<glm::vec3> moves = compute_thickening(mesh, 0.8),
                               others = compute_thickening(mirrored, 0.8);
  for (std::size_t v = 0; v < moves.size(); ++v) {
    EXPECT_NEAR(moves[v].x, -others[v].x, 1e-4);
    EXPECT_NEAR(moves[v].y, others[v].y, 1e-4);
    EXPECT_NEAR(moves[v].z, others[v].z, 1e-4);
  }
}

TEST(thicken, a_slit_is_not_closed) {
  // Two thin lids, 0.2 mm apart, of one body: a block with a slit would do, two plates are the same to a ray.
  Mesh mesh = build_box({-10, -0.4f, 5}, {10, -0.1f, 20});
  append_mesh(mesh, build_box({-10, 0.1f, 5}, {10, 0.4f, 20}));
  const Mesh thick = move(mesh, compute_thickening(mesh, 0.8));
  EXPECT_TRUE(find_crossings(thick.positions, thick.triangles).empty());
}

TEST(thicken, open_edges_and_the_bed_stay) {
  const Mesh mesh = build_turned({{0.2f, 20}, {0.3f, 15}, {0.3f, 10}, {0.3f, 5}, {0.3f, 2}}, 21, 16);
  const std::vector<glm::vec3> moves = compute_thickening(mesh, 0.8);
  for (const Loop& loop : find_boundary_loops(mesh.triangles))
    for (const std::uint32_t v : loop) EXPECT_EQ(moves[v], glm::vec3(0));
  EXPECT_GT(glm::length(moves[20]), 0.01f);
}

}  // namespace
}  // namespace mien

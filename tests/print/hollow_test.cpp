// Cavities: an even wall, open at the bed alone, and a solid again once they are joined to their body.
#include "print/hollow.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>

#include "core/error.hpp"
#include "crossings.hpp"
#include "print/base.hpp"
#include "print/shapes.hpp"

namespace mien {
namespace {

struct Figure {
  Mesh open;  // at its foot
  Loop foot;
  Base base;

  Mesh build_solid() const {
    Mesh solid = open;
    append_base(solid, foot, base, {});
    return solid;
  }
  Mesh build_hollow(const Cavity& cavity) const {
    Mesh mesh = open;
    append_base(mesh, foot, base, append_cavity(mesh, cavity));
    return mesh;
  }
};

Figure build_figure(const Base& base, float radius = 30, float squash = 0.9f) {
  Figure figure{
      build_ball_on_neck(radius, 0.45f * radius, float(base.height_mm), 0.4f * radius, 64, squash), {}, base};
  figure.foot = find_boundary_loops(figure.open.triangles).front();
  return figure;
}

Base build_base(BaseShape shape, double height, double radius) {
  Base base;
  base.shape = shape;
  base.height_mm = height;
  base.radius_mm = radius;
  return base;
}

void expect_hollow(const Figure& figure, const Hollow& hollow, const std::string& what) {
  const Mesh solid = figure.build_solid();
  const Cavity cavity = build_cavity(solid, hollow);
  EXPECT_GE(measure_wall_mm(solid, cavity, hollow), 0.95 * hollow.wall_mm) << what;
  EXPECT_EQ(cavity.drains.size(), std::size_t(hollow.drains)) << what;
  EXPECT_EQ(cavity.holes.size(), cavity.drains.size()) << what;
  EXPECT_LT(cavity.wall.triangles.size(), 6000u) << what;
  for (const Loop& hole : cavity.holes)
    for (const std::uint32_t v : hole) EXPECT_EQ(cavity.wall.positions[v].z, 0) << what;
  const Mesh mesh = figure.build_hollow(cavity);
  EXPECT_EQ(count_open_edges(mesh.triangles), 0u) << what;
  EXPECT_EQ(split_pieces(mesh).size(), 1u) << what;
  EXPECT_EQ(find_crossings(mesh.positions, mesh.triangles).size(), 0u) << what;
  EXPECT_LT(compute_volume_mm3(mesh), 0.75 * compute_volume_mm3(solid)) << what;
}

TEST(hollow, wall_is_as_thick_as_asked_on_every_base) {
  for (const BaseShape shape : {BaseShape::none, BaseShape::round, BaseShape::square, BaseShape::plinth})
    for (const double wall : {1.2, 3.0})
      expect_hollow(build_figure(build_base(shape, 8, 18)), {wall}, fmt::format("{} {}", int(shape), wall));
}

TEST(hollow, small_and_large_figures_are_hollowed_too) {
  expect_hollow(build_figure(build_base(BaseShape::round, 5, 14), 14), {1.2}, "40 mm");
  expect_hollow(build_figure(build_base(BaseShape::round, 15, 40), 55), {3.0, 3, 5}, "150 mm");
}

TEST(hollow, keeps_away_from_the_magnet) {
  Base base = build_base(BaseShape::round, 8, 22);
  base.magnet_diameter_mm = 8;
  base.magnet_depth_mm = 3;
  expect_hollow(build_figure(base), {2.0}, "magnet");
}

TEST(hollow, drains_are_low_apart_and_wide) {
  const Figure figure = build_figure(build_base(BaseShape::round, 8, 20));
  const Cavity cavity = build_cavity(figure.build_solid(), {});
  ASSERT_EQ(cavity.drains.size(), 2u);
  EXPECT_NEAR(cavity.drains[0].at.x, -cavity.drains[1].at.x, 1e-9);
  EXPECT_EQ(cavity.drains[0].at.y, cavity.drains[1].at.y);
  EXPECT_GT(cavity.drains[0].at.x, 8);
  for (const Loop& hole : cavity.holes) {
    const glm::vec3 centre = find_loop_centre(cavity.wall.positions, hole);
    for (std::size_t i = 0; i < hole.size(); ++i) {
      const glm::vec3 a = cavity.wall.positions[hole[i]],
                      b = cavity.wall.positions[hole[(i + 1) % hole.size()]];
      EXPECT_GT(glm::distance((a + b) * 0.5f, centre), 1.85);
      EXPECT_LT(glm::distance(a, centre), 2.2);
    }
  }
}

TEST(hollow, a_sealed_cavity_is_closed) {
  const Figure figure = build_figure(build_base(BaseShape::round, 8, 20));
  const Mesh solid = figure.build_solid();
  for (const Hollow& hollow : {Hollow{2, 0}, Hollow{2, 2, 4, false}}) {
    const Cavity cavity = build_cavity(solid, hollow);
    EXPECT_EQ(count_open_edges(cavity.wall.triangles), 0u);
    EXPECT_EQ(split_pieces(cavity.wall).size(), 1u);
    EXPECT_TRUE(cavity.holes.empty());
    EXPECT_EQ(cavity.drains.size(), std::size_t(hollow.drains));
    EXPECT_LT(compute_volume_mm3(cavity.wall), -0.4 * compute_volume_mm3(solid));
    EXPECT_GE(measure_wall_mm(solid, cavity, hollow), 0.95 * 2);
  }
}

TEST(hollow, what_does_not_drain_stays_solid) {
  // A second ball beside the head that only a thin rod joins would make a cavity without a hole.
  Mesh mesh = build_turned(
      {{8, 58}, {14, 50}, {8, 41}, {1.9f, 40}, {1.9f, 36}, {14, 30}, {20, 20}, {20, 8}, {20, 0}}, 60, 48);
  Base base;
  base.shape = BaseShape::none;
  base.height_mm = 0;
  append_base(mesh, find_boundary_loops(mesh.triangles).front(), base, {});
  const Cavity cavity = build_cavity(mesh, {});
  EXPECT_LT(find_bounds(cavity.wall.positions).high.z, 36);
  EXPECT_EQ(cavity.holes.size(), 2u);
}

TEST(hollow, says_what_cannot_be) {
  const Mesh solid = build_figure(build_base(BaseShape::round, 8, 20)).build_solid();
  const auto complaint = [&](const Hollow& hollow) -> std::string {
    try {
      build_cavity(solid, hollow);
    } catch (const RunError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(complaint({35}), "a wall of 35 mm leaves nothing to hollow");
  EXPECT_EQ(complaint({0}), "a wall of 0 mm is not above 0");
  EXPECT_EQ(complaint({2, 2, 38}), "a wall of 2 mm leaves no room for a drain of 38 mm");
}

TEST(hollow, is_always_the_same) {
  const Mesh solid = build_figure(build_base(BaseShape::square, 8, 20)).build_solid();
  const Cavity one = build_cavity(solid, {}), two = build_cavity(solid, {});
  EXPECT_EQ(one.wall.positions, two.wall.positions);
  EXPECT_EQ(one.wall.triangles, two.wall.triangles);
}

}  // namespace
}  // namespace mien

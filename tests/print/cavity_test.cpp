// Cavities: a wall as thick as asked in every pose, a drain through the base, and a solid again at the end.
#include "print/cavity.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/crossings.hpp"
#include "core/error.hpp"
#include "print/base.hpp"
#include "print/cavity_plan.hpp"
#include "print/shapes.hpp"

namespace mien {
namespace {

struct Figure {
  Mesh open;  // at its foot, which is `lift` above the bed
  Loop foot;
  Base base;

  Mesh build_solid() const {
    Mesh solid = open;
    append_base(solid, foot, base);
    return solid;
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

Mesh lower(Mesh mesh, double lift_mm) {
  for (glm::vec3& p : mesh.positions) p.z -= static_cast<float>(lift_mm);
  return mesh;
}

CavityPlan build_plan(const Figure& figure, std::vector<double> walls_mm) {
  CavityRequest request;
  for (std::size_t i = 0; i < figure.foot.size(); i += 2)
    request.directions.push_back(glm::normalize(glm::dvec2(figure.open.positions[figure.foot[i]])));
  request.straight_mm = 4;
  request.walls_mm = std::move(walls_mm);
  return plan_cavity(lower(figure.open, figure.base.height_mm), request);
}

Hollow build_hollow(const Figure& figure, double wall_mm, double drain_mm = 4) {
  return {wall_mm, drain_mm, figure.base.height_mm, figure.base.magnet_depth_mm,
          figure.base.magnet_diameter_mm};
}

void expect_hollow(const Figure& figure, double wall_mm, double drain_mm, const std::string& what) {
  const Mesh solid = figure.build_solid();
  const Cavity cavity = build_cavity(build_plan(figure, {wall_mm}), build_hollow(figure, wall_mm, drain_mm));
  const double least_mm = measure_wall_mm(solid, cavity);
  EXPECT_GE(least_mm, 0.97 * wall_mm) << what;
  EXPECT_LE(least_mm, 1.03 * wall_mm) << what;
  EXPECT_NEAR(cavity.drain_mm, drain_mm, 1e-9) << what;
  Mesh mesh = figure.open;
  const Loop drain = append_base(mesh, figure.foot, figure.base, {}, cavity.drain_mm);
  append_cavity(mesh, cavity, drain);
  EXPECT_EQ(count_open_edges(mesh.triangles), 0u) << what;
  EXPECT_EQ(split_pieces(mesh).size(), drain_mm > 0 ? 1u : 2u) << what;
  EXPECT_EQ(find_crossings(mesh.positions, mesh.triangles).size(), 0u) << what;
  EXPECT_LT(compute_volume_mm3(mesh), 0.75 * compute_volume_mm3(solid)) << what;
}

TEST(cavity, a_drain_wider_than_the_foot_is_narrowed_and_crosses_nothing) {
  for (const double drain_mm : {22.0, 30.0, 38.0}) {
    const Figure figure = build_figure(build_base(BaseShape::plinth, 6, 18));
    const Cavity cavity = build_cavity(build_plan(figure, {2}), build_hollow(figure, 2, drain_mm));
    EXPECT_LT(cavity.drain_mm, drain_mm);
    EXPECT_GT(cavity.drain_mm, 2);
    Mesh mesh = figure.open;
    append_cavity(mesh, cavity, append_base(mesh, figure.foot, figure.base, {}, cavity.drain_mm));
    EXPECT_EQ(count_open_edges(mesh.triangles), 0u);
    EXPECT_EQ(find_crossings(mesh.positions, mesh.triangles).size(), 0u) << drain_mm;
  }
}

TEST(cavity, wall_is_as_thick_as_asked_on_every_base) {
  for (const BaseShape shape : {BaseShape::none, BaseShape::round, BaseShape::square, BaseShape::plinth})
    for (const double wall : {1.2, 3.0})
      for (const double drain : {0.0, 4.0})
        expect_hollow(build_figure(build_base(shape, shape == BaseShape::none ? 0 : 8, 18)), wall, drain,
                      fmt::format("{} {} {}", int(shape), wall, drain));
}

TEST(cavity, small_and_large_figures_are_hollowed_too) {
  expect_hollow(build_figure(build_base(BaseShape::round, 5, 14), 14), 1.2, 4, "40 mm");
  expect_hollow(build_figure(build_base(BaseShape::round, 15, 40), 55), 3, 5, "150 mm");
}

TEST(cavity, drains_through_the_magnets_pocket) {
  Base base = build_base(BaseShape::round, 8, 22);
  base.magnet_diameter_mm = 8;
  base.magnet_depth_mm = 3;
  const Figure figure = build_figure(base);
  expect_hollow(figure, 2, 4, "magnet");
  const CavityPlan plan = build_plan(figure, {2});
  EXPECT_DOUBLE_EQ(build_cavity(plan, build_hollow(figure, 2, 8)).drain_mm, 6.4);  // a ledge is left
  base.magnet_depth_mm = 7;  // the floor rises with the pocket
  const Figure deep = build_figure(base);
  EXPECT_NEAR(build_cavity(plan, build_hollow(deep, 2)).rings[0][0].z, 9, 1e-5);
}

// Whether the middle of the base's back is open, at a height.
bool is_open_behind(const Mesh& mesh, double radius_mm, double z_mm) {
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::dvec3 p(mesh.positions[a]), q(mesh.positions[b]), r(mesh.positions[c]);
    // Seen along y: does the triangle cover (0, z) and lie beyond half of the radius?
    const auto cross = [&](const glm::dvec3& s, const glm::dvec3& t) {
      return (t.x - s.x) * (z_mm - s.z) - (t.z - s.z) * (0 - s.x);
    };
    const double one = cross(p, q), two = cross(q, r), three = cross(r, p);
    const bool is_within = (one > 0 && two > 0 && three > 0) || (one < 0 && two < 0 && three < 0);
    if (is_within && std::min({p.y, q.y, r.y}) > radius_mm / 2) return false;
  }
  return true;
}

TEST(cavity, is_vented_through_the_back_of_its_base) {
  for (const BaseShape shape : {BaseShape::round, BaseShape::square, BaseShape::plinth})
    for (const double height : {5.0, 8.0, 14.0})
      for (const double magnet : {0.0, 6.0}) {
        Base base = build_base(shape, height, 18);
        base.magnet_diameter_mm = magnet;
        base.magnet_depth_mm = 2;
        const Figure figure = build_figure(base);
        const std::string what = fmt::format("{} {} {}", int(shape), height, magnet);
        const Cavity cavity = build_cavity(build_plan(figure, {2}), build_hollow(figure, 2));
        Mesh closed = figure.open, mesh = figure.open;
        append_cavity(closed, cavity, append_base(closed, figure.foot, base, {}, cavity.drain_mm));
        VentMouth vent{find_vent(base, cavity.drain_mm), {}, {}};
        if (vent.vent.width_mm == 0) {
          EXPECT_TRUE(magnet > 0 && height == 5) << what;  // the pocket takes the room
          continue;
        }
        const Loop drain = append_base(mesh, figure.foot, base, {}, cavity.drain_mm, &vent);
        append_cavity(mesh, cavity, drain, vent);
        EXPECT_EQ(count_open_edges(mesh.triangles), 0u) << what;
        EXPECT_EQ(split_pieces(mesh).size(), 1u) << what;
        EXPECT_EQ(find_crossings(mesh.positions, mesh.triangles).size(), 0u) << what;
        // The tunnel's volume, from the drain's wall to the back: an eighth of a drain's width for the round
        // ends.
        const auto [width, low, high] = vent.vent;
        const double way = 18 - cavity.drain_mm / 2;
        EXPECT_NEAR(compute_volume_mm3(closed) - compute_volume_mm3(mesh), width * (high - low) * way,
                    0.12 * width * (high - low) * way)
            << what;
        EXPECT_TRUE(is_open_behind(mesh, 18, (low + high) / 2 + 0.01)) << what;
        EXPECT_FALSE(is_open_behind(mesh, 18, low - 0.1)) << what;
        EXPECT_FALSE(is_open_behind(mesh, 18, high + 0.1)) << what;
        EXPECT_FALSE(is_open_behind(closed, 18, (low + high) / 2 + 0.01)) << what;
        EXPECT_GE(high - low, 1) << what;
        EXPECT_GE(low, magnet > 0 ? 2.8 : 0.8) << what;  // a floor that prints, and a ledge above a magnet
      }
}

TEST(cavity, a_vent_needs_an_upright_base_and_a_drain) {
  EXPECT_EQ(find_vent(build_base(BaseShape::none, 0, 18), 4).width_mm, 0);
  EXPECT_EQ(find_vent(build_base(BaseShape::round, 8, 18), 0).width_mm, 0);
  EXPECT_EQ(find_vent(build_base(BaseShape::round, 8, 18), 1.2).width_mm, 0);  // 0.96 mm: nothing runs
  EXPECT_EQ(find_vent(build_base(BaseShape::round, 3, 18), 4).width_mm, 0);    // too low a base
  EXPECT_NEAR(find_vent(build_base(BaseShape::round, 8, 18), 4).width_mm, 3.2, 1e-9);
}

TEST(cavity, is_the_same_in_every_pose_and_inside_all) {
  const Figure figure = build_figure(build_base(BaseShape::round, 8, 18));
  Figure dented = figure;  // on one side, by 6 mm
  for (glm::vec3& p : dented.open.positions)
    if (p.y < 0 && p.z > 40) p.y += 6 * std::exp(-(p.x * p.x + (p.z - 50) * (p.z - 50)) / 60);
  CavityRequest request;
  for (const std::uint32_t v : figure.foot)
    request.directions.push_back(glm::normalize(glm::dvec2(figure.open.positions[v])));
  request.walls_mm = {2};
  const Mesh both =
      lower(join_poses(figure.open.triangles, {figure.open.positions, dented.open.positions}), 8);
  EXPECT_LT(both.triangles.size(), 1.5 * double(figure.open.triangles.size()));  // what stays is there once
  const Cavity cavity = build_cavity(plan_cavity(both, request), build_hollow(figure, 2));
  EXPECT_GE(measure_wall_mm(figure.build_solid(), cavity), 0.97 * 2);
  EXPECT_GE(measure_wall_mm(dented.build_solid(), cavity), 0.97 * 2);
}

TEST(cavity, what_does_not_drain_stays_solid) {
  // A second ball beside the head that only a thin rod joins would make a cavity without a hole.
  const Mesh mesh = build_turned(
      {{8, 58}, {14, 50}, {8, 41}, {1.9f, 40}, {1.9f, 36}, {14, 30}, {20, 20}, {20, 8}, {20, 0}}, 60, 48);
  Figure figure{mesh, find_boundary_loops(mesh.triangles).front(), build_base(BaseShape::none, 0, 0)};
  try {
    build_cavity(build_plan(figure, {2}), build_hollow(figure, 2));
    FAIL();
  } catch (const RunError& e) {
    EXPECT_STREQ(e.what(),
                 "a wall of 2 mm leaves no room for a drain; a thinner wall, base: none or a greater height "
                 "have it, and drain: 0mm does without");
  }
}

TEST(cavity, says_what_cannot_be) {
  const Figure figure = build_figure(build_base(BaseShape::round, 8, 20));
  const CavityPlan plan = build_plan(figure, {2, 35});
  ASSERT_EQ(plan.walls.size(), 1u);
  const auto complaint = [&](double wall_mm) -> std::string {
    try {
      build_cavity(plan, build_hollow(figure, wall_mm));
    } catch (const RunError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(complaint(2), "");
  EXPECT_EQ(complaint(35), "a wall of 35 mm leaves nothing to hollow");
  EXPECT_EQ(complaint(0), "a wall of 0 mm is not above 0");
  // A drain is never wider than the wall at the foot allows.
  EXPECT_NEAR(build_cavity(plan, build_hollow(figure, 2, 38)).drain_mm, 1.9 * (0.9 * 13.5 - 2), 0.4);
}

TEST(cavity, is_always_the_same) {
  const Figure figure = build_figure(build_base(BaseShape::square, 8, 20));
  EXPECT_EQ(build_plan(figure, {2}).walls[0].reaches_mm, build_plan(figure, {2}).walls[0].reaches_mm);
}

}  // namespace
}  // namespace mien

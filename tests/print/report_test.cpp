// The report tells what was built: known boxes and balls, and each fault in words.
#include "print/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "print/base.hpp"
#include "print/cavity.hpp"
#include "print/cavity_plan.hpp"
#include "print/shapes.hpp"
#include "solids.hpp"

namespace mien {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

// solids.hpp has z toward the viewer; prints stand on z.
Mesh build_block(const glm::vec3& low, const glm::vec3& high) { return build_box(low, high); }

TEST(report, a_block_is_what_it_is) {
  const PrintReport report = measure_print(build_block({-10, -5, 0}, {10, 5, 30}));
  EXPECT_EQ(report.size_mm, glm::dvec3(20, 10, 30));
  EXPECT_NEAR(report.volume_mm3, 6000, 1e-6);
  EXPECT_NEAR(report.pla_g, 7.44, 1e-6);
  EXPECT_NEAR(report.resin_g, 6.9, 1e-6);
  EXPECT_TRUE(report.fine.empty());
  EXPECT_EQ(report.crossings, 0u);
  EXPECT_NEAR(report.least_wall_mm, 10, 1e-4);
  EXPECT_EQ(report.overhang_mm2, 0);
  EXPECT_NEAR(report.bed_mm2, 200, 1e-6);
  EXPECT_EQ(report.triangles, 12u);
  EXPECT_EQ(report.parts, 1u);
  EXPECT_TRUE(report.islands.empty());
  EXPECT_TRUE(report.warnings.empty());
  EXPECT_TRUE(is_printable(report));
}

TEST(report, a_thin_plate_is_found_and_placed) {
  Mesh mesh = build_block({-10, -5, 0}, {10, 5, 30});
  append_mesh(mesh, build_block({-5, 20, 0}, {5, 20.5, 8}));
  const PrintReport report = measure_print(mesh);
  ASSERT_EQ(report.fine.size(), 1u);
  EXPECT_NEAR(report.fine[0].finest_mm, 0.5, 0.03);
  EXPECT_NEAR(report.fine[0].place.y, 20.25, 0.1);
  EXPECT_NEAR(report.fine[0].place.z, 4, 0.3);
  EXPECT_EQ(report.parts, 2u);
  EXPECT_FALSE(is_printable(report));
  EXPECT_THAT(report.warnings, Contains("It falls into 2 parts."));
  EXPECT_THAT(report.warnings, Contains(HasSubstr("A detail of it is 0.5 mm thick")));
}

TEST(report, a_wall_of_a_tube_is_measured) {
  // 1.5 mm between a ball and the ball in it.
  Mesh mesh = build_ball({0, 0, 20}, 20, 24);
  Mesh inner = build_ball({0, 0, 20}, 18.5f, 24);
  for (Triangle& t : inner.triangles) std::swap(t[1], t[2]);
  append_mesh(mesh, inner);
  const PrintReport report = measure_print(mesh);
  EXPECT_NEAR(report.least_wall_mm, 1.5, 0.1);
  EXPECT_EQ(report.parts, 1u);
  EXPECT_EQ(report.sealed_cavities, 1u);
  EXPECT_THAT(report.warnings, Contains(HasSubstr("1 cavity without a hole")));
}

TEST(report, overhang_is_what_is_steeper_than_45_degrees) {
  // A ball hangs over below 45 degrees south: 2 pi r^2 (1 - cos 45).
  const PrintReport report = measure_print(build_ball({0, 0, 20}, 20, 90));
  EXPECT_NEAR(report.overhang_mm2, 2 * 3.14159265 * 400 * (1 - 0.70711), 15);
  Mesh cone = build_turned({{10, 20}, {10.1f, 20}, {0.5f, 10.2f}, {0.5f, 0}}, 20, 32);
  Base none;
  none.shape = BaseShape::none;
  none.height_mm = 0;
  append_base(cone, find_boundary_loops(cone.triangles).front(), none);
  EXPECT_LT(measure_print(cone).overhang_mm2, 1);  // 44.4 degrees
}

TEST(report, the_cavity_is_told_apart) {
  Mesh solid = build_ball_on_neck(30, 14, 8, 12);
  Mesh mesh = solid, figure = solid;
  const Loop foot = find_boundary_loops(solid.triangles).front();
  Base base;
  base.radius_mm = 20;
  append_base(solid, foot, base);
  CavityRequest request;
  for (const std::uint32_t v : foot)
    request.directions.push_back(glm::normalize(glm::dvec2(mesh.positions[v])));
  request.walls_mm = {2};
  for (glm::vec3& p : figure.positions) p.z -= 8;
  const Cavity cavity = build_cavity(plan_cavity(figure, request), {2, 4, 8});
  const std::size_t first = append_cavity(mesh, cavity, append_base(mesh, foot, base, {}, cavity.drain_mm));
  const PrintReport report = measure_print(mesh, first, mesh.triangles.size() - first);
  EXPECT_EQ(report.sealed_cavities, 0u);
  EXPECT_EQ(report.parts, 1u);
  EXPECT_NEAR(report.least_wall_mm, 2, 0.1);
  EXPECT_GT(report.inner_overhang_mm2, 500);
  EXPECT_NEAR(report.overhang_mm2, measure_print(solid).overhang_mm2, 1);
  EXPECT_TRUE(report.islands.empty());
  EXPECT_TRUE(is_printable(report));
}

TEST(report, what_begins_in_the_air_is_found) {
  // A hook: a post, an arm on top, a drop that hangs from its end down to z = 10; closed boxes that overlap.
  Mesh hook = build_block({-2, -2, 0}, {2, 2, 30});
  append_mesh(hook, build_block({-2.1f, -2.1f, 26}, {20, 2.1f, 29}));
  append_mesh(hook, build_block({16, -1.9f, 10}, {19, 1.9f, 27}));
  const std::vector<Island> islands = find_islands(hook, 0.3);
  ASSERT_EQ(islands.size(), 1u);
  EXPECT_NEAR(islands[0].lowest.z, 10, 1e-4);
  EXPECT_NEAR(islands[0].height_mm, 16, 1e-4);
  EXPECT_GT(islands[0].lowest.x, 15);
}

TEST(report, floating_parts_are_islands_and_balls_are_not_many) {
  Mesh mesh = build_block({-10, -5, 0}, {10, 5, 10});
  append_mesh(mesh, build_ball({0, 0, 20}, 5, 16));
  EXPECT_EQ(find_islands(mesh, 0.3).size(), 1u);
  EXPECT_TRUE(find_islands(build_block({-10, -5, 0}, {10, 5, 10}), 0.3).empty());
}

TEST(report, faults_are_told_in_words) {
  Mesh open = build_block({-10, -5, 0}, {10, 5, 30});
  open.triangles.pop_back();
  PrintReport report = measure_print(open);
  EXPECT_FALSE(is_printable(report));
  EXPECT_THAT(report.warnings, Contains("It is not a solid: its surface has 3 open edges."));
  Mesh turned = build_block({-10, -5, 0}, {10, 5, 30});
  for (Triangle& t : turned.triangles) std::swap(t[1], t[2]);
  report = measure_print(turned);
  EXPECT_FALSE(is_printable(report));
  EXPECT_THAT(report.warnings, Contains("It is inside out."));
  report = measure_print(build_block({-10, -5, 1}, {10, 5, 30}));
  EXPECT_FALSE(is_printable(report));
  EXPECT_THAT(report.warnings, Contains("Nothing of it lies on the bed."));
}

TEST(report, what_stands_on_too_little_may_topple) {
  PrintReport report = measure_print(build_block({-10, -5, 0}, {10, 5, 30}));
  EXPECT_TRUE(report.warnings.empty());
  report.bed_mm2 = 7;  // of a print 20 mm broad and 10 mm deep
  update_warnings(report);
  EXPECT_THAT(report.warnings, Contains("It stands on 7 mm2 only and may topple."));
  report.bed_mm2 = 9;
  update_warnings(report);
  EXPECT_TRUE(report.warnings.empty());
}

TEST(report, a_surface_through_itself_is_told) {
  Mesh mesh = build_block({-10, -5, 0}, {10, 5, 30});
  append_mesh(mesh, build_block({9, -3, 4}, {14, 3, 8}));
  const PrintReport report = measure_print(mesh);
  EXPECT_GT(report.crossings, 0u);
  EXPECT_NEAR(report.crossing_at.x, 10, 1);
  EXPECT_THAT(report.warnings, Contains(HasSubstr("Its surface passes through itself at ")));
  EXPECT_FALSE(is_printable(report));
  PrintReport crossed = measure_print(build_block({-10, -5, 0}, {10, 5, 30}));
  EXPECT_TRUE(is_printable(crossed));
  crossed.crossings = 1;  // though it is one closed part on the bed
  EXPECT_FALSE(is_printable(crossed));
}

TEST(report, a_hollow_with_one_hole_on_the_bed_is_a_cup) {
  PrintReport report = measure_print(build_block({-10, -5, 0}, {10, 5, 30}));
  report.drain_mm = 4;
  update_warnings(report);
  EXPECT_THAT(
      report.warnings,
      ElementsAre("Its only hole lies on the bed: on a resin printer the hollow is a cup that sucks at the "
                  "film. Print it tilted on supports, or drill a second hole near the bed."));
  EXPECT_THAT(describe_report(report), HasSubstr("\ndrain           4 mm, in the underside\noverhang "));
  report.vent_mm = {3.2, 2.94};
  update_warnings(report);
  EXPECT_TRUE(report.warnings.empty());
  EXPECT_THAT(describe_report(report),
              HasSubstr("\ndrain           4 mm, in the underside\n"
                        "vent            3.2 x 2.9 mm, from the drain to the base's back\n"));
  EXPECT_TRUE(is_printable(report));
}

TEST(report, is_a_table_and_sentences) {
  const std::string text = describe_report(measure_print(build_block({-10, -5, 0}, {10, 5, 30})));
  EXPECT_THAT(text, HasSubstr("size            20 x 10 x 30 mm\n"));
  EXPECT_THAT(text, HasSubstr("volume          6 cm3\n"));
  EXPECT_THAT(text, HasSubstr("mass            7.4 g of PLA, 6.9 g of resin\n"));
  EXPECT_THAT(text, HasSubstr("finest detail   0.8 mm or more\n"));
  EXPECT_THAT(text, Not(HasSubstr("warning")));
}

TEST(report, nothing_is_no_print) {
  const PrintReport report = measure_print({});
  EXPECT_FALSE(is_printable(report));
  EXPECT_FALSE(report.warnings.empty());
}

}  // namespace
}  // namespace mien

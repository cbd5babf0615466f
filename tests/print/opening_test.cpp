// What is finer than a ball that rolls inside: plates and threads, but neither blunt edges nor thick things.
#include "print/opening.hpp"

#include <gtest/gtest.h>

#include "print/shapes.hpp"
#include "print/solid_tree.hpp"
#include "solids.hpp"

namespace mien {
namespace {

double sum_fine_mm2(const Mesh& mesh, double size_mm, double blunt = kBlunt) {
  double area = 0;
  for (const FinePatch& patch : list_fine_patches(mesh, build_solid_tree(mesh), size_mm, blunt))
    area += patch.area_mm2;
  return area;
}

TEST(opening, a_plate_is_fine_below_its_thickness) {
  const Mesh plate = build_box({-10, -0.25f, 0}, {10, 0.25f, 20});
  EXPECT_NEAR(sum_fine_mm2(plate, 0.6), 2 * (400 + 10 + 10), 1e-3);  // all of it
  EXPECT_EQ(sum_fine_mm2(plate, 0.48), 0);
}

TEST(opening, edges_of_60_degrees_are_no_detail_and_sharper_ones_are) {
  EXPECT_EQ(sum_fine_mm2(build_box({-10, -5, 0}, {10, 5, 20}), 0.8), 0);
  const auto build_wedge = [](double angle_deg) {  // its edge upward, along x
    Mesh wedge = build_box({-10, -1, 0}, {10, 1, 10});
    const auto half = float(10 * std::tan(angle_deg / 2 * 3.14159265 / 180));
    for (glm::vec3& p : wedge.positions) p.y = p.z > 5 ? p.y * 1e-4f : p.y * half;
    return wedge;
  };
  EXPECT_LT(sum_fine_mm2(build_wedge(64), 0.8), 0.5);  // its ends, where three faces meet
  // What is left out lies further than a radius and a half from the balls' line: 0.4 / sin(20) - 0.8 along
  // the middle, and the ends of the edge.
  EXPECT_NEAR(sum_fine_mm2(build_wedge(40), 0.8), 2 * 20 * 0.42, 4);
  EXPECT_GT(sum_fine_mm2(build_wedge(64), 0.8, 0.2), 5);
}

TEST(opening, a_rib_is_told_with_its_thickness_and_a_ball_is_not) {
  Mesh mesh = build_ball({0, 0, 20}, 10, 48);
  append_mesh(mesh, build_box({-0.3f, -2, 34}, {0.3f, 2, 39}));
  const std::vector<FineDetail> details = list_fine_details(mesh, build_solid_tree(mesh), 0.8, 0.3);
  ASSERT_EQ(details.size(), 1u);
  EXPECT_NEAR(details[0].finest_mm, 0.6, 0.04);
  EXPECT_NEAR(details[0].place.x, 0, 0.1);
  EXPECT_NEAR(details[0].place.z, 36.5, 0.1);
  EXPECT_NEAR(details[0].area_mm2, 2 * 20 + 0.6 * 18, 0.01);
}

TEST(opening, the_finest_is_told_first) {
  Mesh mesh = build_box({-0.3f, -2, 0}, {0.3f, 2, 5});
  append_mesh(mesh, build_box({9.8f, -2, 0}, {10.2f, 2, 5}));
  append_mesh(mesh, build_box({19.75f, -2, 0}, {20.25f, 2, 5}));
  const std::vector<FineDetail> details = list_fine_details(mesh, build_solid_tree(mesh), 0.8, 0.3);
  ASSERT_EQ(details.size(), 3u);
  EXPECT_NEAR(details[0].finest_mm, 0.4, 0.04);
  EXPECT_NEAR(details[1].finest_mm, 0.5, 0.04);
  EXPECT_NEAR(details[2].finest_mm, 0.6, 0.04);
}

TEST(opening, specks_are_left_out) {
  Mesh mesh = build_box({-10, -5, 0}, {10, 5, 20});
  append_mesh(mesh, build_box({-0.1f, -0.1f, 19}, {0.1f, 0.1f, 20.8f}));
  EXPECT_TRUE(list_fine_details(mesh, build_solid_tree(mesh), 0.8, 1.5).empty());
  EXPECT_FALSE(list_fine_details(mesh, build_solid_tree(mesh), 0.8, 0.3).empty());
}

TEST(opening, nothing_has_no_details) { EXPECT_EQ(sum_fine_mm2({}, 0.8), 0); }

}  // namespace
}  // namespace mien

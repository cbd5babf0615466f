// Bases: joined to the figure by construction, closed, nowhere through themselves; OpenSCAD makes the same.
#include "print/base.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <charconv>
#include <cstdlib>

#include "core/crossings.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "places.hpp"
#include "print/shapes.hpp"
#include "scene/openscad_numbers.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

using testing::HasSubstr;

constexpr BaseShape kShapes[] = {BaseShape::none, BaseShape::round, BaseShape::square, BaseShape::plinth};
constexpr const char* kNames[] = {"none", "round", "square", "plinth"};

void expect_solid(const Mesh& mesh, const std::string& what) {
  EXPECT_EQ(count_open_edges(mesh.triangles), 0u) << what;
  EXPECT_EQ(split_pieces(mesh).size(), 1u) << what;
  EXPECT_GT(compute_volume_mm3(mesh), 0) << what;
  EXPECT_TRUE(find_crossings(mesh.positions, mesh.triangles).empty()) << what;
  EXPECT_NEAR(compute_bounds(mesh.positions).low.z, 0, 1e-6) << what;
}

TEST(base, every_shape_closes_the_figure) {
  for (int shape = 0; shape < 4; ++shape)
    for (const float squash : {1.0f, 0.8f})
      for (const int sides : {24, 63})
        for (const bool has_pocket : {false, true})
          for (const double drain : {0.0, 3.0}) {
            Mesh mesh = build_ball_on_neck(14, 8, 8, 6, sides, squash);
            const Loop foot = find_boundary_loops(mesh.triangles).front();
            Base base{kShapes[shape]};
            if (has_pocket) base.magnet_diameter_mm = 5, base.magnet_depth_mm = 2;
            const Loop hole = append_base(mesh, foot, base, {}, drain);
            const std::string what =
                fmt::format("{} {} {} {} {}", kNames[shape], squash, sides, has_pocket, drain);
            ASSERT_EQ(hole.size(), drain > 0 ? foot.size() : 0) << what;
            for (const std::uint32_t v : hole) {
              EXPECT_GE(glm::length(glm::vec2(mesh.positions[v])), 1.5) << what;
              EXPECT_EQ(mesh.positions[v].z, has_pocket ? 2 : 0) << what;
            }
            if (drain > 0) append_fan_cap(mesh, hole, {0, 0, 5});  // a funnel
            expect_solid(mesh, what);
          }
}

TEST(base, stands_as_broad_as_asked) {
  for (const BaseShape shape : {BaseShape::round, BaseShape::square, BaseShape::plinth}) {
    Mesh mesh = build_ball_on_neck(14, 8, 10, 6);
    Base base{shape, 10, 15};
    append_base(mesh, find_boundary_loops(mesh.triangles).front(), base);
    Box low = {{1e9f, 1e9f, 1e9f}, {-1e9f, -1e9f, -1e9f}};
    for (const glm::vec3& p : mesh.positions)
      if (p.z < 9) low = {glm::min(low.low, p), glm::max(low.high, p)};
    EXPECT_NEAR(low.high.x, 15, 0.05);
    EXPECT_NEAR(low.low.y, -15, 0.05);
  }
}

TEST(base, is_wider_than_any_foot) {
  Mesh mesh = build_ball_on_neck(30, 20, 8, 6);
  const std::vector<glm::vec3> foot = list_points(mesh, find_boundary_loops(mesh.triangles).front());
  for (const auto& ring : list_base_rings({BaseShape::round, 8, 2}, foot))
    for (std::size_t i = 0; i < foot.size(); ++i)
      EXPECT_GE(glm::length(glm::vec2(ring[i])), 0.999f * glm::length(glm::vec2(foot[i]))) << i;
  append_base(mesh, find_boundary_loops(mesh.triangles).front(), {BaseShape::round, 8, 2});
  expect_solid(mesh, "wide foot");
}

TEST(base, without_a_shape_goes_straight_down_or_nowhere) {
  Mesh mesh = build_ball_on_neck(14, 8, 3, 6);
  const std::vector<glm::vec3> foot = list_points(mesh, find_boundary_loops(mesh.triangles).front());
  const auto rings = list_base_rings({BaseShape::none, 3}, foot);
  ASSERT_EQ(rings.size(), 1u);
  for (std::size_t i = 0; i < foot.size(); ++i) EXPECT_EQ(rings[0][i], glm::vec3(foot[i].x, foot[i].y, 0));
  EXPECT_TRUE(list_base_rings({BaseShape::none, 0}, foot).empty());
}

TEST(base, says_what_cannot_be) {
  const auto complaint = [](const Base& base) -> std::string {
    Mesh mesh = build_ball_on_neck(14, 8, float(base.height_mm), 6);
    try {
      append_base(mesh, find_boundary_loops(mesh.triangles).front(), base);
    } catch (const RunError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(complaint({BaseShape::round, 0}), "the base's height of 0 mm is not above 0");
  EXPECT_EQ(complaint({BaseShape::square, 8, -1}), "the base's radius of -1 mm is not above 0");
  Base deep{BaseShape::round, 8};
  deep.magnet_diameter_mm = 5;
  deep.magnet_depth_mm = 7.5;
  EXPECT_EQ(complaint(deep), "the magnet's pocket of 5 x 7.5 mm does not fit the base");
  Base broad{BaseShape::round, 8};
  broad.magnet_diameter_mm = 40;
  broad.magnet_depth_mm = 2;
  EXPECT_EQ(complaint(broad), "the magnet's pocket of 40 x 2 mm does not fit the base");
  // A foot that runs back on itself, and one of two points.
  for (const std::vector<glm::vec3>& foot :
       {std::vector<glm::vec3>{{5, 0, 8}, {0, 5, 8}, {4, 3, 8}, {-5, 0, 8}, {0, -5, 8}},
        std::vector<glm::vec3>{{5, 0, 8}, {-5, 1, 8}}})
    EXPECT_THROW(list_base_rings({BaseShape::round, 8}, foot), RunError);
}

// All numbers after "ECHO:" in OpenSCAD's output for `source`.
std::vector<double> echo_openscad(const std::string& source) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "mien_base";
  write_file(folder / "base.scad", source);
  const std::string command = fmt::format(
      "openscad --hardwarnings -o '{0}/base.echo' '{0}/base.scad' > '{0}/log' 2>&1", folder.string());
  EXPECT_EQ(std::system(command.c_str()), 0) << read_file(folder / "log");
  const std::string text = read_file(folder / "base.echo");
  std::vector<double> numbers;
  for (const char *at = text.data(), *end = at + text.size(); at < end;) {
    double value = 0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error == std::errc()) numbers.push_back(value);
    at = error == std::errc() ? next : at + 1;
  }
  return numbers;
}

TEST(base, openscad_makes_the_same_rings) {
  const Mesh mesh = build_ball_on_neck(14, 7, 9, 6, 24, 0.8f);
  const std::vector<glm::vec3> foot = list_points(mesh, find_boundary_loops(mesh.triangles).front());
  ScadValues values = list_scad_base();
  values["letters"] =
      build_openscad_letters(build_letters(find_template(shipped_stock().templates, "openscad/letters.csv")));
  const std::string functions = fill_template(shipped_stock().templates, "openscad/base.scad", values);
  std::string points;
  for (const glm::vec3& p : foot)
    points +=
        fmt::format("[{}, {}, {}],", format_number(p.x, 6), format_number(p.y, 6), format_number(p.z, 6));
  for (int shape = 0; shape < 4; ++shape) {
    const std::vector<double> numbers = echo_openscad(
        functions + fmt::format("echo(base_rings([{}], \"{}\", 9, 16));\n", points, kNames[shape]));
    std::vector<double> ours;
    for (const auto& ring : list_base_rings({kShapes[shape], 9, 16}, foot))
      for (const glm::vec3& p : ring) ours.insert(ours.end(), {p.x, p.y, p.z});
    ASSERT_EQ(numbers.size(), ours.size()) << kNames[shape];
    for (std::size_t i = 0; i < ours.size(); ++i)
      ASSERT_NEAR(numbers[i], ours[i], 1e-3) << kNames[shape] << i;
  }
}

}  // namespace
}  // namespace mien

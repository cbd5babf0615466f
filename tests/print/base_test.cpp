// Bases: joined to the figure by construction, closed, nowhere through themselves; OpenSCAD makes the same.
#include "print/base.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <charconv>
#include <cstdlib>

#include "core/error.hpp"
#include "core/text.hpp"
#include "crossings.hpp"
#include "places.hpp"
#include "print/flat_cap.hpp"
#include "print/shapes.hpp"

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
  EXPECT_NEAR(find_bounds(mesh.positions).low.z, 0, 1e-6) << what;
}

// A tube of the drain's wall, as a cavity has it: open at z = 0, closed above, wound as an inner wall.
Loop append_drain(Mesh& mesh, double x, double y, double radius, float top) {
  Mesh tube = build_turned({{float(radius), top}, {float(radius), 0}}, top, 16);
  for (glm::vec3& p : tube.positions) p += glm::vec3(x, y, 0);
  for (Triangle& t : tube.triangles) std::swap(t[1], t[2]);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  append_mesh(mesh, tube);
  for (Loop& loop : find_boundary_loops(tube.triangles)) {
    for (std::uint32_t& v : loop) v += first;
    return loop;
  }
  return {};
}

TEST(base, every_shape_closes_the_figure) {
  for (int shape = 0; shape < 4; ++shape)
    for (const float squash : {1.0f, 0.8f})
      for (const int sides : {24, 63})
        for (const bool has_pocket : {false, true})
          for (const int drains : {0, 1, 3}) {
            Mesh mesh = build_ball_on_neck(14, 8, 8, 6, sides, squash);
            const Loop foot = find_boundary_loops(mesh.triangles).front();
            Base base{kShapes[shape]};
            if (has_pocket) base.magnet_diameter_mm = 5, base.magnet_depth_mm = 2;
            std::vector<Loop> holes;
            for (int i = 0; i < drains; ++i)
              holes.push_back(append_drain(mesh, i == 2 ? 0 : 4.5 - 9 * i, i == 2 ? 4.6 : 0, 1.2, 3));
            append_base(mesh, foot, base, holes);
            expect_solid(mesh,
                         fmt::format("{} {} {} {} {}", kNames[shape], squash, sides, has_pocket, drains));
          }
}

TEST(base, stands_as_broad_as_asked) {
  for (const BaseShape shape : {BaseShape::round, BaseShape::square, BaseShape::plinth}) {
    Mesh mesh = build_ball_on_neck(14, 8, 10, 6);
    Base base{shape, 10, 15};
    append_base(mesh, find_boundary_loops(mesh.triangles).front(), base, {});
    Box low = {{1e9f, 1e9f, 1e9f}, {-1e9f, -1e9f, -1e9f}};
    for (const glm::vec3& p : mesh.positions)
      if (p.z < 9) low = {glm::min(low.low, p), glm::max(low.high, p)};
    EXPECT_NEAR(low.high.x, 15, 0.05);
    EXPECT_NEAR(low.low.y, -15, 0.05);
  }
}

TEST(base, is_wider_than_any_foot) {
  Mesh mesh = build_ball_on_neck(30, 20, 8, 6);
  append_base(mesh, find_boundary_loops(mesh.triangles).front(), {BaseShape::round, 8, 2}, {});
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
      append_base(mesh, find_boundary_loops(mesh.triangles).front(), base, {});
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
}

TEST(base, a_drain_outside_the_underside_is_told) {
  Mesh mesh = build_ball_on_neck(14, 8, 8, 6);
  const Loop foot = find_boundary_loops(mesh.triangles).front();
  const Loop hole = append_drain(mesh, 14, 0, 2, 3);
  EXPECT_THROW(append_base(mesh, foot, {BaseShape::round, 8}, {hole}), RunError);
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
  const std::filesystem::path scad = std::filesystem::path(source_folder()) / "templates/openscad/base.scad";
  const std::string functions = fill_template(
      read_file(scad), {{"letters", build_openscad_letters(load_letters(source_folder()))}}, "base");
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

TEST(flat_cap, fills_any_outline_around_its_holes) {
  // A star with a hole in each arm.
  Mesh mesh;
  Loop outline;
  for (int i = 0; i < 40; ++i) {
    const double turn = 2 * std::numbers::pi * i / 40, radius = 10 + 6 * std::cos(5 * turn);
    outline.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.emplace_back(radius * std::cos(turn), -radius * std::sin(turn), 0);
  }
  std::vector<Loop> holes;
  for (int k = 0; k < 5; ++k) {
    Loop& hole = holes.emplace_back();
    for (int i = 0; i < 8; ++i) {
      const double turn = 2 * std::numbers::pi * i / 8, to = 2 * std::numbers::pi * k / 5;
      hole.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.emplace_back(11 * std::cos(to) + std::cos(turn), 11 * std::sin(to) + std::sin(turn), 0);
    }
  }
  append_flat_cap(mesh, outline, holes);
  EXPECT_EQ(mesh.triangles.size(), 40u + 5 * 8 + 2 * 5 - 2);
  for (const auto& [a, b, c] : mesh.triangles)
    EXPECT_LT(glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]).z, 0);
  EXPECT_EQ(find_boundary_loops(mesh.triangles).size(), 6u);
}

}  // namespace
}  // namespace mien

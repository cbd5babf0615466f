#include "import/mesh_faults.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mien {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// A cube of quads, wound outwards; each point has a line of its own.
Polygons build_cube() {
  Polygons cube;
  for (int i = 0; i < 8; ++i) cube.positions.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  for (std::uint32_t line = 1; line <= 8; ++line) cube.lines.push_back(line);
  cube.corners = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  cube.first = {0, 4, 8, 12, 16, 20, 24};
  return cube;
}

void add_face(Polygons& mesh, const std::vector<std::uint32_t>& corners) {
  mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
  mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
}

std::vector<std::string> list_messages(const Polygons& mesh) {
  std::vector<std::string> messages;
  for (const MeshFault& fault : find_mesh_faults(mesh).faults) messages.push_back(fault.message);
  return messages;
}

TEST(mesh_faults, a_closed_box_has_none) {
  const MeshReport report = find_mesh_faults(build_cube());
  EXPECT_THAT(report.faults, IsEmpty());
  EXPECT_EQ(report.rims, 0u);
  EXPECT_EQ(report.pieces, 1u);
}

TEST(mesh_faults, an_open_end_is_a_rim_and_no_fault) {
  Polygons box = build_cube();
  box.first.pop_back();
  box.corners.resize(20);
  const MeshReport report = find_mesh_faults(box);
  EXPECT_THAT(report.faults, IsEmpty());
  EXPECT_EQ(report.rims, 1u);
  EXPECT_EQ(report.open_edges, 4u);
}

TEST(mesh_faults, tells_each_kind_with_its_place) {
  Polygons crowded = build_cube();
  add_face(crowded, {0, 1, 7});
  EXPECT_THAT(
      list_messages(crowded),
      ElementsAre("the edge from (0, 0, 0) to (1, 0, 0) is used by 3 polygons; expected two at most"));
  EXPECT_EQ(find_mesh_faults(crowded).faults[0].line, 1);
  EXPECT_THAT(find_mesh_faults(crowded).faults[0].faces, testing::UnorderedElementsAre(0, 2, 6));

  Polygons turned = build_cube();
  std::swap(turned.corners[1], turned.corners[3]);
  EXPECT_EQ(list_messages(turned).size(), 4u) << "its four edges";
  EXPECT_EQ(list_messages(turned)[0],
            "the polygons on both sides of the edge from (0, 0, 0) to (1, 0, 0) face opposite ways; expected "
            "one outside");

  Polygons bent = build_cube();
  bent.positions[7] = {1, 1, 2.2};
  EXPECT_THAT(
      list_messages(bent),
      testing::Contains(testing::StartsWith("polygon 1 at (0.5, 0.5, 1.3) is not flat: a corner lies ")));

  Polygons alone = build_cube();
  alone.positions.emplace_back(9, 9, 9);
  alone.lines.push_back(12);
  EXPECT_THAT(list_messages(alone),
              ElementsAre("point 8 at (9, 9, 9) is on no edge; expected two edges at least"));
  EXPECT_EQ(find_mesh_faults(alone).faults[0].line, 12);

  Polygons folded = build_cube();
  add_face(folded, {0, 0, 1});
  EXPECT_THAT(list_messages(folded),
              testing::Contains("polygon 6 at (0.3333, 0, 0) has a corner twice; expected each once"));

  Polygons twice = build_cube();
  add_face(twice, {0, 2, 3, 1});
  EXPECT_THAT(list_messages(twice),
              testing::Contains("polygon 6 at (0, 0, 0) is polygon 0 again; expected each once"));
}

TEST(mesh_faults, tells_loose_pieces_and_points_that_are_there_again) {
  Polygons two = build_cube();
  const std::uint32_t first = 8;
  for (int i = 0; i < 3; ++i) two.positions.emplace_back(5 + (i == 1), (i == 2), 0);
  two.positions.emplace_back(5, 0, 0);
  two.lines.resize(12, 20);
  add_face(two, {first, first + 1, first + 2});
  EXPECT_THAT(list_messages(two),
              ElementsAre("point 11 at (5, 0, 0) is on no edge; expected two edges at least",
                          "point 11 at (5, 0, 0) is point 8 again; expected each place once",
                          "1 polygons at (5, 0, 0) hang on nothing else; expected one piece"));
  EXPECT_EQ(find_mesh_faults(two).pieces, 2u);
  EXPECT_FALSE(find_mesh_faults(two).faults[0].is_warning);
  EXPECT_TRUE(find_mesh_faults(two).faults[1].is_warning);
  EXPECT_TRUE(find_mesh_faults(two).faults[2].is_warning);
}

TEST(mesh_faults, tells_some_and_counts_the_rest) {
  Polygons many = build_cube();
  for (int i = 0; i < 9; ++i) many.positions.emplace_back(20 + i, 0, 0);
  many.lines.resize(17, 30);
  const MeshReport report = find_mesh_faults(many, 2);
  ASSERT_EQ(report.faults.size(), 3u);
  EXPECT_EQ(report.faults[2].message, "and 7 more points on fewer than two edges");
}

TEST(mesh_faults, draws_what_is_wrong_in_red) {
  Polygons twice = build_cube();
  add_face(twice, {0, 2, 3, 1});
  const std::string ply = draw_mesh_faults(twice, find_mesh_faults(twice));
  EXPECT_NE(ply.find("element face 7\n"), ply.npos);
  EXPECT_NE(ply.find("4 0 2 3 1 230 40 30\n"), ply.npos);
  EXPECT_NE(ply.find("4 4 5 7 6 190 190 190\n"), ply.npos);
}

}  // namespace
}  // namespace mien

#include "head/hair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "config/words.hpp"
#include "core/data.hpp"
#include "core/error.hpp"
#include "core/holes.hpp"
#include "frames/figure.hpp"
#include "head/cage.hpp"
#include "head/hair_chart.hpp"
#include "head/random_heads.hpp"

namespace mien {
namespace {

std::filesystem::path file() { return find_data_folder() / "templates/head/hair.yaml"; }

NeutralHead build(const char* age, const char* skull = "average") {
  HeadSpec spec;
  spec.age = {{age, 1.0}};
  spec.skull = {{skull, 1.0}};
  return build_neutral_head(spec, find_data_folder());
}

const Mesh& mesh_of(const std::vector<HeadPart>& parts) { return parts.front().part.rest; }

TEST(hair, words_are_the_cuts_of_the_file_and_none) {
  Names names{"none"};
  for (const auto& [name, cut] : load_hair_cuts(file())) names.push_back(name);
  Names words = kHairs;
  std::sort(words.begin(), words.end());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(words, names);
}

TEST(hair, is_none_unless_asked_for) {
  const NeutralHead head = build("adult");
  EXPECT_TRUE(build_hair(head, HeadSpec{}.hair, Look{}).empty());
  try {
    build_hair(head, "mohawk", Look{});
    FAIL();
  } catch (const RunError& e) {
    EXPECT_STREQ(e.what(), "templates/head/hair.yaml has no cut 'mohawk'");
  }
}

TEST(hair, is_closed_and_bound_to_the_skin_vertex_by_vertex) {
  for (const char* age : {"infant", "child", "adult"}) {
    const NeutralHead head = build(age);
    for (const auto& [name, cut] : load_hair_cuts(file())) {
      const std::vector<HeadPart> parts = build_hair(head, name, Look{});
      ASSERT_EQ(parts.size(), 1u);
      EXPECT_EQ(parts[0].part.name, "hair");
      EXPECT_EQ(parts[0].mount, Mount::strands);
      EXPECT_FALSE(parts[0].part.is_printed);  // busts stay bald
      const Mesh& mesh = mesh_of(parts);
      EXPECT_EQ(count_open_edges(mesh.triangles), 0u) << age << " " << name;
      for (const Mesh& piece : split_pieces(mesh))
        EXPECT_GT(compute_volume_mm3(piece), 1000) << age << " " << name;
      ASSERT_EQ(parts[0].bindings.size(), mesh.positions.size());
      ASSERT_EQ(parts[0].part.shade.size(), mesh.positions.size());
      for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
        const Binding& binding = parts[0].bindings[v];
        ASSERT_TRUE(binding.first == v && binding.count == 1);
        ASSERT_LT(binding.triangle, head.skin.triangles.size());
        ASSERT_LT(parts[0].part.shade[v], parts[0].part.palette.size());
        ASSERT_NEAR(glm::length(mesh.normals[v]), 1, 1e-4);
        ASSERT_TRUE(std::isfinite(mesh.positions[v].x + mesh.positions[v].y + mesh.positions[v].z));
      }
    }
  }
}

// How far out along a ray the hair reaches; 0 if the ray misses it.
double find_reach(const Mesh& mesh, const glm::dvec3& origin, const glm::dvec3& way) {
  double reach = 0;
  for (const Triangle& t : mesh.triangles) {  // Moeller and Trumbore 1997
    const glm::dvec3 a(mesh.positions[t[0]]);
    const glm::dvec3 ab = glm::dvec3(mesh.positions[t[1]]) - a, ac = glm::dvec3(mesh.positions[t[2]]) - a;
    const glm::dvec3 p = glm::cross(way, ac), s = origin - a, q = glm::cross(s, ab);
    const double determinant = glm::dot(ab, p), u = glm::dot(s, p) / determinant,
                 v = glm::dot(way, q) / determinant;
    if (u >= 0 && v >= 0 && u + v <= 1) reach = std::max(reach, glm::dot(ac, q) / determinant);
  }
  return reach;
}

TEST(hair, covers_the_scalp_with_no_skin_showing_through) {
  const HeadShapes shapes = load_head_shapes(find_data_folder() / "templates/head");
  for (const unsigned seed : {0u, 1u, 2u, 3u}) {
    HeadSpec spec = seed == 0 ? HeadSpec{} : build_random_spec(seed, shapes);
    const NeutralHead head = build_neutral_head(spec, find_data_folder());
    for (const auto& [name, cut] : load_hair_cuts(file())) {
      const std::vector<HeadPart> parts = build_hair(head, name, Look{});
      const HairChart chart = build_hair_chart(head, cut.whorl_deg, cut.centre_mm);
      int covered = 0;
      for (std::uint32_t v = 0; v < head.cage.points.size(); ++v) {
        const std::string_view point = strip_side(head.cage.names[v]);
        const bool is_scalp = point.starts_with("cap") || point.find("_F") != point.npos;
        if (!is_scalp) continue;
        const glm::dvec3 skin(head.skin.positions[v]);
        const HairPlace place = find_hair_place(chart, skin);
        const glm::dvec3 origin = find_hair_point(chart, place, 0), way = find_hair_direction(chart, place);
        const double reach = find_reach(mesh_of(parts), origin, way);
        if (reach == 0) continue;  // beyond the hairline
        ++covered;
        EXPECT_GT(reach, glm::distance(skin, origin)) << seed << " " << name << " " << point;
      }
      EXPECT_GT(covered, 60) << name;
    }
  }
}

TEST(hair, rides_on_the_skin) {
  HeadSpec spec;
  spec.hair = "crop";
  const Figure figure = build_figure(spec, find_data_folder());
  Pose pose;
  for (const char* side : {"left", "right"})
    pose.values[*find_move("brow", std::string_view(side) == "left" ? Side::left : Side::right, "up")] = 1;
  DeformBuffers buffers;
  Drawing drawing;
  deform_figure(figure, pose, TurnKey{}, buffers, drawing);
  const auto at = std::find_if(figure.model.parts.begin(), figure.model.parts.end(),
                               [](const Part& part) { return part.name == "hair"; });
  ASSERT_NE(at, figure.model.parts.end());
  const PartShape& shape = drawing.parts[static_cast<std::size_t>(at - figure.model.parts.begin())];
  double most = 0;
  for (std::size_t v = 0; v < shape.positions.size(); ++v)
    most = std::max<double>(most, glm::distance(shape.positions[v], at->rest.positions[v]));
  EXPECT_GT(most, 0.02);  // the scalp moves a little with the brows, and the hair with it
  EXPECT_LT(most, 6);
}

}  // namespace
}  // namespace mien

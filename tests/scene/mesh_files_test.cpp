#include "scene/mesh_files.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <sstream>

#include "core/error.hpp"
#include "core/text.hpp"
#include "render/scratch.hpp"
#include "scene/stl.hpp"
#include "solids.hpp"

namespace mien {
namespace {

// A ball of two shades, a rigid box without normals that is drawn 20 mm aside.
Model build_model() {
  Model model;
  model.parts.resize(2);
  model.parts[0].name = "skin";
  model.parts[0].rest = build_ball({0, 0, 0}, 10, 8);
  update_normals(model.parts[0].rest);
  model.parts[0].palette = {{{1, 0.5f, 0}, 0}, {{0, 0, 1}, 1}};
  model.parts[0].shade.assign(model.parts[0].rest.positions.size(), 0);
  model.parts[0].shade[3] = 1;
  model.parts[1].name = "teeth_upper";
  model.parts[1].rest = build_box({-1, -1, -1}, {1, 1, 1});
  model.parts[1].is_rigid = true;
  model.parts[1].palette = {{{0.2f, 0.4f, 0.6f}, 0}};
  return model;
}

Drawing build_drawing(const Model& model) {
  Drawing drawing;
  drawing.parts.resize(2);
  drawing.parts[0].positions = model.parts[0].rest.positions;
  drawing.parts[0].normals = model.parts[0].rest.normals;
  drawing.parts[1].world_from_rest[3] = {20, 0, 0, 1};
  return drawing;
}

// What a reader takes off the front of the bytes.
template <typename Value>
Value take(std::string_view& bytes) {
  Value value;
  std::memcpy(&value, bytes.data(), sizeof value);
  bytes.remove_prefix(sizeof value);
  return value;
}

TEST(mesh_files, ply_reads_back_with_normals_colours_and_parts) {
  const Model model = build_model();
  const Drawing drawing = build_drawing(model);
  const std::string ply = build_ply(model, drawing, "A\nhead");
  const std::size_t end = ply.find("end_header\n") + 11;
  const std::size_t balls = model.parts[0].rest.positions.size();
  const std::size_t faces = model.parts[0].rest.triangles.size() + 12;
  EXPECT_EQ(
      ply.substr(0, end),
      "ply\nformat binary_little_endian 1.0\ncomment A head\n"
      "comment millimetres; x to the character's left, y up, z forward\n"
      "comment part 0 skin\ncomment part 1 teeth_upper\nelement vertex " +
          std::to_string(balls + 8) +
          "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\n"
          "property float nz\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face " +
          std::to_string(faces) +
          "\nproperty list uchar uint vertex_indices\nproperty int part\nend_header\n");
  std::string_view bytes = std::string_view(ply).substr(end);
  Mesh mesh, box = model.parts[1].rest;
  update_normals(box);  // it is moved and not turned
  for (std::size_t v = 0; v < balls + 8; ++v) {
    mesh.positions.push_back(take<glm::vec3>(bytes));
    const auto normal = take<glm::vec3>(bytes);
    EXPECT_LT(glm::distance(normal, v < balls ? drawing.parts[0].normals[v] : box.normals[v - balls]), 1e-5f)
        << v;
    const auto colour = take<std::array<unsigned char, 3>>(bytes);
    const std::array<unsigned char, 3> wanted = v >= balls ? std::array<unsigned char, 3>{51, 102, 153}
                                                : v == 3   ? std::array<unsigned char, 3>{0, 0, 255}
                                                           : std::array<unsigned char, 3>{255, 128, 0};
    EXPECT_EQ(colour, wanted) << v;
    EXPECT_LT(glm::distance(mesh.positions[v],
                            v < balls ? drawing.parts[0].positions[v]
                                      : model.parts[1].rest.positions[v - balls] + glm::vec3(20, 0, 0)),
              1e-5f);
  }
  for (std::size_t f = 0; f < faces; ++f) {
    EXPECT_EQ(take<unsigned char>(bytes), 3);
    mesh.triangles.push_back(take<Triangle>(bytes));
    EXPECT_EQ(take<std::int32_t>(bytes), f < faces - 12 ? 0 : 1);
  }
  EXPECT_TRUE(bytes.empty());
  EXPECT_EQ(count_open_edges(mesh.triangles), 0u);
  EXPECT_GT(compute_volume_mm3(mesh), 0);
}

TEST(mesh_files, stl_reads_back_as_its_parts) {
  const Model model = build_model();
  const Scratch scratch;
  const std::string stl = build_stl(model, build_drawing(model), "solid " + std::string(100, 'x'));
  EXPECT_FALSE(stl.starts_with("solid"));
  write_file(scratch.path / "a.stl", stl);
  const StlFacts facts = check_stl(scratch.path / "a.stl");
  EXPECT_EQ(facts.triangles, model.parts[0].rest.triangles.size() + 12);
  EXPECT_EQ(facts.parts, 2u);
  EXPECT_EQ(facts.open_edges, 0u);
  EXPECT_NEAR(facts.volume_mm3, compute_volume_mm3(model.parts[0].rest) + 8, 0.01);
  EXPECT_NEAR(facts.box.high.x, 21, 1e-5);
  // Each facet's normal is of unit length and looks the way from which its corners run left about.
  for (std::size_t facet = 0; facet < facts.triangles; ++facet) {
    std::array<glm::vec3, 4> read;  // the normal, three corners
    std::memcpy(read.data(), stl.data() + 84 + 50 * facet, sizeof read);
    EXPECT_LT(glm::distance(read[0], glm::normalize(glm::cross(read[2] - read[1], read[3] - read[1]))), 1e-4f)
        << facet;
  }
}

TEST(mesh_files, refuse_what_is_no_drawing_of_the_model) {
  const Model model = build_model();
  EXPECT_EQ(find_message<RunError>([&] { build_ply(model, Drawing{}, ""); }),
            "internal: a drawing of 0 parts for a model of 2");
  EXPECT_EQ(find_message<RunError>([&] { build_stl(model, Drawing{}, ""); }),
            "internal: a drawing of 0 parts for a model of 2");
  Drawing drawing = build_drawing(model);
  drawing.parts[0].positions[2].x = std::numeric_limits<float>::infinity();
  EXPECT_EQ(find_message<RunError>([&] { build_ply(model, drawing, ""); }),
            "internal: a mesh holds a number that is not finite");
}

TEST(mesh_files, write_what_each_ending_says) {
  const Model model = build_model();
  const auto build = [&](const std::string& ending) {
    return build_mesh_file(ending, model, build_drawing(model), "T");
  };
  EXPECT_TRUE(build(".obj").starts_with("# T\n"));
  EXPECT_TRUE(build(".ply").starts_with("ply\n"));
  EXPECT_TRUE(build(".stl").starts_with("mien, millimetres: T"));
  for (const std::string& ending : list_mesh_endings()) EXPECT_NE(build(ending), "") << ending;
  for (const char* ending : {"", ".fbx", ".OBJ", "obj"})
    EXPECT_EQ(find_message<RunError>([&] { build(ending); }),
              std::string("internal: no mesh is written as '") + ending + "'");
}

}  // namespace
}  // namespace mien

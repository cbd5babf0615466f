#include "scene/stl.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "core/error.hpp"
#include "core/text.hpp"
#include "render/scratch.hpp"
#include "solids.hpp"

namespace mien {
namespace {

std::string write_binary(const Mesh& mesh) {
  std::string bytes(80, 'x');
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  for (const Triangle& t : mesh.triangles) {
    bytes.append(12, '\0');
    for (const std::uint32_t v : t)
      bytes.append(reinterpret_cast<const char*>(&mesh.positions[v]), sizeof(glm::vec3));
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string write_ascii(const Mesh& mesh) {
  std::string text = "solid facet vertex\n";  // a name that means nothing
  for (const Triangle& t : mesh.triangles) {
    text += "  facet normal 0 0 0\n    outer loop\n";
    for (const std::uint32_t v : t) {
      text += "      vertex";
      for (int axis = 0; axis < 3; ++axis) {
        text += ' ';
        append_number(text, mesh.positions[v][axis], 5);
      }
      text += '\n';
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid facet vertex\n";
}

std::string fail_to_read(const std::filesystem::path& path) {
  try {
    read_stl(path);
  } catch (const RunError& e) {
    return e.what();
  }
  return "nothing was thrown";
}

TEST(stl, measures_binary_and_ascii_alike) {
  const Scratch scratch;
  Mesh mesh = build_box({-1, 0, 0}, {1, 3, 4});
  append_mesh(mesh, build_ball({10, 0, 0}, 2, 16));
  write_file(scratch.path / "b.stl", write_binary(mesh));
  write_file(scratch.path / "a.stl", write_ascii(mesh));
  for (const char* name : {"a.stl", "b.stl"}) {
    const StlFacts facts = check_stl(scratch.path / name);
    EXPECT_EQ(facts.triangles, mesh.triangles.size()) << name;
    EXPECT_EQ(facts.parts, 2U) << name;
    EXPECT_EQ(facts.open_edges, 0U) << name;
    EXPECT_NEAR(facts.volume_mm3, compute_volume_mm3(mesh), 1e-3) << name;
    EXPECT_EQ(facts.box.low, glm::vec3(-1, -2, -2)) << name;
    EXPECT_EQ(facts.box.high, glm::vec3(12, 3, 4)) << name;
  }
}

TEST(stl, tells_open_and_inverted_and_empty) {
  Mesh box = build_box({0, 0, 0}, {1, 1, 1});
  box.triangles.pop_back();
  EXPECT_EQ(measure_stl(box).open_edges, 3U);
  Mesh turned = build_box({0, 0, 0}, {1, 1, 1});
  for (Triangle& t : turned.triangles) std::swap(t[1], t[2]);
  EXPECT_DOUBLE_EQ(measure_stl(turned).volume_mm3, -1);
  EXPECT_EQ(measure_stl(Mesh{}).parts, 0U);
}

TEST(stl, leaves_out_triangles_that_rounding_closed) {
  const Scratch scratch;
  Mesh mesh = build_box({0, 0, 0}, {1, 1, 1});
  mesh.triangles.push_back({0, 0, 1});
  write_file(scratch.path / "b.stl", write_binary(mesh));
  EXPECT_EQ(read_stl(scratch.path / "b.stl").triangles.size(), 12U);
}

TEST(stl, says_what_is_wrong_with_a_file) {
  const Scratch scratch;
  const std::filesystem::path path = scratch.path / "x.stl";
  const std::string name = path.string();
  EXPECT_EQ(fail_to_read(path), "cannot read " + name + ": No such file or directory");
  write_file(path, "");
  EXPECT_EQ(fail_to_read(path), name + ": not an STL file");
  write_file(path, "v 1 2 3\n");
  EXPECT_EQ(fail_to_read(path), name + ": not an STL file");

  const std::string binary = write_binary(build_box({0, 0, 0}, {1, 1, 1}));
  write_file(path, binary.substr(0, 400));
  EXPECT_EQ(fail_to_read(path), name + ": cut short");
  std::string broken = binary;
  const float infinite = std::numeric_limits<float>::infinity();
  std::memcpy(broken.data() + 84 + 12, &infinite, sizeof infinite);
  write_file(path, broken);
  EXPECT_EQ(fail_to_read(path), name + ": not finite");

  const std::string ascii = write_ascii(build_box({0, 0, 0}, {1, 1, 1}));
  write_file(path, ascii.substr(0, ascii.size() / 2));
  EXPECT_EQ(fail_to_read(path), name + ": cut short");
  write_file(path, "solid x\n facet normal 0 0 1\n outer loop\n vertex 1 2 three\n");
  EXPECT_EQ(fail_to_read(path), name + ": not an STL file");
  write_file(path, "solid x\n facet normal 0 0 1\n outer loop\n vertex 1 2 nan\n");
  EXPECT_EQ(fail_to_read(path), name + ": not finite");
  write_file(path, "solid x\n vertex 1 2 3\n endfacet\nendsolid x\n");
  EXPECT_EQ(fail_to_read(path), name + ": not an STL file");
}

}  // namespace
}  // namespace mien

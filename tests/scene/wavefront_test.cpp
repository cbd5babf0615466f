#include "scene/wavefront.hpp"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "core/error.hpp"
#include "solids.hpp"

namespace mien {
namespace {

// What a reader makes of the text: one mesh a group, with indices of its own.
struct ReadBack {
  std::vector<std::string> names;
  std::map<std::string, Mesh> groups;
  std::string first_line;
};

ReadBack read_back(const std::string& text) {
  ReadBack read;
  std::istringstream lines(text);
  std::getline(lines, read.first_line);
  std::vector<std::size_t> group_of_vertex;  // its first vertex's number
  std::size_t vertices = 0, normals = 0, first_vertex = 0, first_normal = 0;
  std::string line;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "g") {
      words >> key;
      read.names.push_back(key);
      first_vertex = vertices;
      first_normal = normals;
    } else if (key == "v" || key == "vn") {
      glm::vec3 p;
      words >> p.x >> p.y >> p.z;
      Mesh& mesh = read.groups[read.names.back()];
      (key == "v" ? mesh.positions : mesh.normals).push_back(p);
      ++(key == "v" ? vertices : normals);
    } else if (key == "f") {
      Triangle t{};
      for (std::uint32_t& corner : t) {
        std::string word;
        words >> word;
        corner = static_cast<std::uint32_t>(std::stoul(word) - 1 - first_vertex);
        const std::size_t slashes = word.find("//");
        if (slashes != std::string::npos) {
          EXPECT_EQ(std::stoul(word.substr(slashes + 2)) - 1 - first_normal, corner) << line;
        }
      }
      read.groups[read.names.back()].triangles.push_back(t);
    }
  }
  return read;
}

Model build_model() {
  Model model;
  model.parts.resize(3);
  model.parts[0].name = "skin";
  model.parts[0].rest = build_ball({0, 0, 0}, 10, 8);
  model.parts[1].name = "eye_left";
  model.parts[1].rest = build_ball({3, 0, 9}, 1, 4);
  model.parts[1].is_rigid = true;
  model.parts[2].name = "teeth_upper";
  model.parts[2].rest = build_box({-2, -5, 8}, {2, -4, 9});
  update_normals(model.parts[0].rest);
  update_normals(model.parts[1].rest);  // the teeth have none and get their surface's
  return model;
}

Drawing build_drawing(const Model& model) {
  Drawing drawing;
  drawing.parts.resize(3);
  drawing.parts[0].positions = model.parts[0].rest.positions;
  drawing.parts[0].normals = model.parts[0].rest.normals;
  drawing.parts[1].world_from_rest[3] = {1, 2, 3, 1};
  drawing.parts[2].positions = model.parts[2].rest.positions;
  return drawing;
}

TEST(wavefront, reads_back_as_it_was) {
  const Model model = build_model();
  Drawing drawing = build_drawing(model);
  drawing.parts[0].positions[5] += glm::vec3(0.5, 0, 0);
  std::string text;
  append_wavefront(text, model, drawing, "A head");
  const ReadBack read = read_back(text);
  EXPECT_EQ(read.first_line, "# A head");
  EXPECT_EQ(read.names, (std::vector<std::string>{"skin", "eye_left", "teeth_upper"}));
  for (std::size_t i = 0; i < 3; ++i) {
    const Mesh& mesh = read.groups.at(model.parts[i].name);
    EXPECT_EQ(mesh.triangles, model.parts[i].rest.triangles);
    EXPECT_EQ(count_open_edges(mesh.triangles), 0U);
    ASSERT_EQ(mesh.positions.size(), model.parts[i].rest.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      const glm::vec3 expected =
          i == 1 ? model.parts[1].rest.positions[v] + glm::vec3(1, 2, 3) : drawing.parts[i].positions[v];
      EXPECT_LT(glm::length(mesh.positions[v] - expected), 1e-4f);
    }
    EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
    for (const glm::vec3& n : mesh.normals) EXPECT_NEAR(glm::length(n), 1, 1e-4);
  }
}

TEST(wavefront, title_stays_in_its_line) {
  const Model model = build_model();
  std::string text;
  append_wavefront(text, model, build_drawing(model), "A\nmtllib /etc/passwd\r\\\n\"head\" é");
  EXPECT_EQ(text.substr(0, text.find('\n')), "# A mtllib /etc/passwd   \"head\" é");
}

TEST(wavefront, refuses_a_drawing_of_another_model) {
  std::string text;
  try {
    append_wavefront(text, build_model(), Drawing{}, "x");
    FAIL();
  } catch (const RunError& e) {
    EXPECT_STREQ(e.what(), "internal: a drawing of 0 parts for a model of 3");
  }
}

}  // namespace
}  // namespace mien

#include "sketch/casters.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "scene/povray.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

constexpr std::uint32_t kAround = 72, kDown = 36;

// A ball of `radius` mm about `middle`, closed, into one part with what is there.
void add_ball(Part& part, float radius, const glm::vec3& middle) {
  const auto first = static_cast<std::uint32_t>(part.rest.positions.size());
  const auto add = [&](const glm::vec3& normal) {
    part.rest.positions.push_back(middle + radius * normal);
    part.rest.normals.push_back(normal);
  };
  add({0, 1, 0});
  for (std::uint32_t row = 1; row < kDown; ++row)
    for (std::uint32_t column = 0; column < kAround; ++column) {
      const double a = 2 * M_PI * column / kAround, b = M_PI * row / kDown;
      add({std::sin(b) * std::sin(a), std::cos(b), std::sin(b) * std::cos(a)});
    }
  add({0, -1, 0});
  const std::uint32_t last = first + (kDown - 1) * kAround + 1;
  for (std::uint32_t column = 0; column < kAround; ++column) {
    const std::uint32_t next = (column + 1) % kAround, low = last - kAround;
    part.rest.triangles.push_back({first, first + 1 + column, first + 1 + next});
    part.rest.triangles.push_back({last, low + next, low + column});
    for (std::uint32_t row = 0; row + 2 < kDown; ++row) {
      const std::uint32_t a = first + 1 + row * kAround + column, b = first + 1 + row * kAround + next;
      part.rest.triangles.push_back({a, a + kAround, b + kAround});
      part.rest.triangles.push_back({a, b + kAround, b});
    }
  }
}

// A head with a nose that throws a shadow on it.
Model build_two_balls(const char* material) {
  Part part;
  part.name = "balls";
  part.material = material;
  part.palette = {{{0.6f, 0.6f, 0.6f}, 0}};
  add_ball(part, 80, glm::vec3(0));
  add_ball(part, 20, {0, 0, 84});
  return {{part}};
}

// Millimetres above the balls' skin; less than none inside either.
float compute_height_above(const glm::vec3& p) {
  return std::min(glm::length(p) - 80, glm::distance(p, glm::vec3(0, 0, 84)) - 20);
}

Drawing draw_at_rest(const Model& model) {
  return {{{model.parts[0].rest.positions, model.parts[0].rest.normals, {}, glm::mat4(1)}}};
}

SketchStage build_stage(const std::string& lights = "studio") {
  std::string start;
  append_povray_start(start, {{}, {{lights, 1, 0}}, {}, {}});
  const StageSets sets{{lights}, {}};
  return build_sketch_stage(build_povray_stage("", {}, shipped_stock().templates, sets), start, 480, 600);
}

// The light sets of the shipped templates, but the lamp of a style.
std::vector<std::string> list_light_sets() {
  const std::string prefix = "povray/light_";
  std::vector<std::string> names;
  for (const auto& [path, text] : shipped_stock().templates)
    if (path.starts_with(prefix) && path != prefix + "ink.inc")
      names.push_back(path.substr(prefix.size(), path.size() - prefix.size() - 4));
  return names;
}

bool is_met(const glm::vec3& from, const glm::vec3& way, const Mesh& mesh) {
  for (const Triangle& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t[0]]), ab = glm::dvec3(mesh.positions[t[1]]) - a,
                                              ac = glm::dvec3(mesh.positions[t[2]]) - a, d(way), p(from);
    const glm::dvec3 h = glm::cross(d, ac);
    const double determinant = glm::dot(ab, h);
    if (determinant == 0) continue;
    const double u = glm::dot(p - a, h) / determinant;
    const glm::dvec3 q = glm::cross(p - a, ab);
    const double v = glm::dot(d, q) / determinant, along = glm::dot(ac, q) / determinant;
    if (u >= 0 && v >= 0 && u + v <= 1 && along > 0 && along < 1) return true;
  }
  return false;
}

// Places a little above the balls and inside neither, and any place of any lamp that throws a shadow.
TEST(casters, hide_from_each_lamp_what_the_whole_part_hides) {
  const Model model = build_two_balls("skin");
  const Mesh& whole = model.parts[0].rest;
  std::mt19937 random(7);
  const auto draw = [&] { return static_cast<float>(random() % 10000) / 10000.0f; };
  int asked = 0, hidden = 0, wrong = 0;
  for (const std::string& lights : list_light_sets()) {
    const SketchStage stage = build_stage(lights);
    const std::vector<Mesh> casters = build_casters(stage, model, draw_at_rest(model), list_castable(model));
    ASSERT_EQ(casters.size(), 1u) << lights;
    ASSERT_FALSE(casters[0].triangles.empty()) << lights;
    EXPECT_LT(casters[0].triangles.size(), whole.triangles.size() * 9 / 10) << lights;
    for (const SketchLamp& lamp : stage.lamps) {
      if (!lamp.has_shadow) continue;
      for (int i = 0; i < 1000; ++i) {
        const std::size_t v = random() % whole.positions.size();
        const glm::vec3 from = whole.positions[v] + 0.03f * whole.normals[v];
        const glm::vec3 place = lamp.at + (draw() - 0.5f) * lamp.side + (draw() - 0.5f) * lamp.other_side;
        const glm::vec3 way = glm::vec3(place.x, place.y, -place.z) - from;
        if (compute_height_above(from) < 0 || glm::dot(way, whole.normals[v]) <= 0) continue;  // no light
        const bool is_hidden = is_met(from, way, whole);
        ++asked;
        hidden += is_hidden ? 1 : 0;
        wrong += is_hidden != is_met(from, way, casters[0]) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(asked, 4000);
  EXPECT_GT(hidden, 500);
  EXPECT_LE(wrong, asked / 1000);  // those that graze an edge
}

TEST(casters, lie_nowhere_above_the_part) {
  const Model model = build_two_balls("skin");
  const std::vector<Mesh> casters =
      build_casters(build_stage(), model, draw_at_rest(model), list_castable(model));
  for (const glm::vec3& p : casters[0].positions) EXPECT_LT(compute_height_above(p), -0.04f);
}

TEST(casters, stand_for_no_part_that_is_open_or_throws_no_shadow) {
  Model open = build_two_balls("skin");
  open.parts[0].rest.triangles.resize(open.parts[0].rest.triangles.size() / 2 + 500);
  EXPECT_TRUE(
      build_casters(build_stage(), open, draw_at_rest(open), list_castable(open))[0].triangles.empty());
  const Model hairs = build_two_balls("brow");
  EXPECT_TRUE(
      build_casters(build_stage(), hairs, draw_at_rest(hairs), list_castable(hairs))[0].triangles.empty());
}

TEST(casters, are_seen_by_rays_to_lamps_alone) {
  const Model model = build_two_balls("skin");
  const Drawing drawing = draw_at_rest(model);
  const std::vector<Mesh> casters = build_casters(build_stage(), model, drawing, list_castable(model));
  std::string text;
  append_povray_figure(text, model, drawing, &casters);
  EXPECT_NE(text.find("surface_of_balls() no_shadow }\nmesh2 {"), std::string::npos);
  EXPECT_TRUE(text.ends_with("no_image no_reflection }\n")) << text.substr(text.size() - 200);
}

}  // namespace
}  // namespace mien

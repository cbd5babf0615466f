#include "sketch/sketch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "scene/povray.hpp"
#include "shipped.hpp"
#include "sketch/noise.hpp"
#include "sketch/overlay.hpp"

namespace mien {
namespace {

// A ball of `radius` mm about `middle`, with normals.
Part make_ball(const std::string& material, float radius, const glm::vec3& middle, const glm::vec3& srgb) {
  constexpr int kAround = 48, kDown = 24;
  Part part;
  part.name = material + std::to_string(static_cast<int>(radius));
  part.material = material;
  part.palette = {{srgb, 0}};
  for (int row = 0; row <= kDown; ++row)
    for (int column = 0; column < kAround; ++column) {
      const double a = 2 * M_PI * column / kAround, b = M_PI * row / kDown;
      const glm::vec3 n(std::sin(b) * std::sin(a), std::cos(b), std::sin(b) * std::cos(a));
      part.rest.positions.push_back(middle + radius * n);
      part.rest.normals.push_back(n);
    }
  for (std::uint32_t row = 0; row < kDown; ++row)
    for (std::uint32_t column = 0; column < kAround; ++column) {
      const std::uint32_t a = row * kAround + column, b = row * kAround + (column + 1) % kAround;
      part.rest.triangles.push_back({a, a + kAround, b + kAround});
      part.rest.triangles.push_back({a, b + kAround, b});
    }
  return part;
}

Drawing draw_at_rest(const Model& model) {
  Drawing drawing;
  for (const Part& part : model.parts)
    drawing.parts.push_back({part.rest.positions, part.rest.normals, {}, glm::mat4(1)});
  return drawing;
}

SketchStage build_stage(const RenderSpec& render, const CameraView& view) {
  std::string start;
  append_povray_start(start, {{}, {}, {}, view});
  return build_sketch_stage(build_povray_stage("", render, shipped_stock().templates), start, render.width_px,
                            render.height_px);
}

struct Sketched {
  Pixels picture;
  glm::ivec3 at(int x, int y) const {
    const std::size_t i = 3 * static_cast<std::size_t>(y * picture.size.width_px + x);
    return {picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]};
  }
};

RenderSpec build_render(const char* background) {
  RenderSpec render;
  render.width_px = 100;
  render.height_px = 125;
  render.background = background;
  return render;
}

Sketched sketch(const Model& model, const RenderSpec& render, CameraView view = {}) {
  view.look_at = glm::vec3(0);
  SketchDesk desk;
  set_stage(desk, build_stage(render, view));
  const SketchLook look = build_sketch_look(model, desk.stage.names);
  const Drawing drawing = draw_at_rest(model);
  return {trace_sketch(desk, {{&model, &look, &drawing}}, {render.width_px, render.height_px})};
}

constexpr glm::vec3 kGrey{0.6f, 0.6f, 0.6f};

// The box is 240 x 300 mm in 100 x 125 pixels: 2.4 mm each, seen from 900 mm.
TEST(sketch, shows_a_ball_where_it_is_and_as_large_as_it_is) {
  Model model{{make_ball("plain", 60, {30, -20, 0}, kGrey)}};
  CameraView view;
  view.is_orthographic = true;
  const Sketched sketched = sketch(model, build_render("sun"), view);
  const glm::ivec3 ground = sketched.at(0, 0);
  int left = 100, right = -1, top = 125, bottom = -1;
  for (int y = 0; y < 125; ++y)
    for (int x = 0; x < 100; ++x) {
      const glm::ivec3 apart = glm::abs(sketched.at(x, y) - ground);
      if (std::max({apart.r, apart.g, apart.b}) < 3) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  EXPECT_NEAR(left, 50 + (30 - 60) / 2.4, 1) << "the character's left is the picture's right";
  EXPECT_NEAR(right, 50 + (30 + 60) / 2.4 - 1, 1);
  EXPECT_NEAR(top, 62.5 + (20 - 60) / 2.4, 1);
  EXPECT_NEAR(bottom, 62.5 + (20 + 60) / 2.4 - 1, 1);
}

TEST(sketch, is_bright_on_the_picture_s_left_where_the_key_is) {
  Model model{{make_ball("plain", 80, {0, 0, 0}, kGrey)}};
  const Sketched sketched = sketch(model, build_render("dark"));
  EXPECT_GT(sketched.at(35, 50).g, sketched.at(65, 50).g + 20);
}

TEST(sketch, throws_shadows_unless_a_material_throws_none) {
  const auto measure = [](const char* material) {
    Model model{{make_ball("plain", 80, {0, 0, 0}, kGrey), make_ball(material, 16, {-46, 41, 159}, kGrey)}};
    const Sketched sketched = sketch(model, build_render("dark"));
    int sum = 0;
    for (int y = 45; y < 75; ++y)
      for (int x = 35; x < 65; ++x) sum += sketched.at(x, y).g;
    return sum / 900.0;
  };
  EXPECT_LT(measure("plain"), measure("hair") - 2);
}

TEST(sketch, lets_through_what_is_clear) {
  Model model{
      {make_ball("plain", 40, {0, 0, 0}, {0.8f, 0.1f, 0.1f}), make_ball("cornea", 60, {0, 0, 0}, {1, 1, 1})}};
  const Sketched behind = sketch(model, build_render("sun"));
  EXPECT_GT(behind.at(50, 62).r, 3 * behind.at(50, 62).g) << "the red ball within";
  const glm::ivec3 ground = behind.at(0, 0), beside = behind.at(50 + 21, 62);
  EXPECT_LT(std::abs(ground.r - beside.r), 12) << "the ground behind the glass alone";
}

TEST(sketch, has_smooth_edges) {
  Model model{{make_ball("ink_flat", 80, {0, 0, 0}, {0, 0, 0})}};
  RenderSpec render = build_render("sun");
  render.style = Style::ink;
  const Sketched sketched = sketch(model, render);
  int between = 0;
  for (int y = 40; y < 90; ++y)
    for (int x = 0; x < 100; ++x) {
      const int red = sketched.at(x, y).r;
      between += red > 20 && red < 240 ? 1 : 0;
    }
  EXPECT_GE(between, 60) << "half-covered pixels are neither black nor yellow";
  EXPECT_EQ(sketched.at(50, 62), glm::ivec3(0));
  EXPECT_NEAR(sketched.at(0, 0).r, 250, 1) << "sun is srgb .98";
}

TEST(sketch, gives_the_same_pixels_again_whatever_the_desk_did_before) {
  Model model{{make_ball("skin", 80, {0, 0, 0}, kGrey), make_ball("brow", 20, {-30, 20, 70}, kGrey)}};
  Model other{{make_ball("plain", 30, {0, 0, 0}, kGrey)}};
  const RenderSpec render = build_render("studio");
  SketchDesk desk;
  set_stage(desk, build_stage(render, {}));
  const SketchLook look = build_sketch_look(model, desk.stage.names),
                   other_look = build_sketch_look(other, desk.stage.names);
  const Drawing drawing = draw_at_rest(model), other_drawing = draw_at_rest(other);
  const PictureSize size{render.width_px, render.height_px};
  const Pixels first = trace_sketch(desk, {{&model, &look, &drawing}}, size);
  trace_sketch(desk, {{&other, &other_look, &other_drawing}}, size);
  EXPECT_EQ(trace_sketch(desk, {{&model, &look, &drawing}}, size).rgb, first.rgb);
}

TEST(sketch, shows_the_ground_alone_where_nobody_is) {
  RenderSpec render = build_render("paper");
  SketchDesk desk;
  set_stage(desk, build_stage(render, {}));
  const Pixels empty = trace_sketch(desk, {}, {render.width_px, render.height_px});
  for (std::size_t i = 0; i < empty.rgb.size(); i += 3) {
    EXPECT_NEAR(empty.rgb[i], 226, 1);
    EXPECT_NEAR(empty.rgb[i + 2], 213, 1);
  }
}

TEST(sketch, refuses_a_drawing_that_does_not_fit) {
  Model model{{make_ball("plain", 30, {0, 0, 0}, kGrey)}};
  SketchDesk desk;
  set_stage(desk, build_stage(build_render("sun"), {}));
  const SketchLook look = build_sketch_look(model, desk.stage.names);
  Drawing drawing = draw_at_rest(model);
  drawing.parts[0].positions.pop_back();
  const auto find_error = [&] {
    try {
      trace_sketch(desk, {{&model, &look, &drawing}}, {100, 125});
    } catch (const RunError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(find_error(), "internal: part 'plain30' is drawn with another number of vertices");
  drawing.parts.clear();
  EXPECT_EQ(find_error(), "internal: a drawing has not the model's parts");
}

TEST(sketch, draws_lines_and_words_over_all) {
  Overlay overlay;
  overlay.lines = {{{{glm::vec3(-100, 50, 200), glm::vec3(100, 50, 200)}}, {}, 3, {1, 0, 0}}};
  overlay.words = {{"Brow", {-100, -100, 200}, 30, {0, 0, 1}, 0}};
  CameraView view;
  view.is_orthographic = true;
  view.look_at = glm::vec3(0);
  const RenderSpec render = build_render("paper");
  SketchDesk desk;
  set_stage(desk, build_stage(render, view));
  const SketchOverlay built = build_sketch_overlay(
      overlay, view, build_letters(find_template(shipped_stock().templates, "openscad/letters.csv")));
  const Sketched sketched{trace_sketch(desk, {find_figure(built)}, {render.width_px, render.height_px})};
  const int y = static_cast<int>(62.5 - 50 / 2.4);
  EXPECT_EQ(sketched.at(50, y), glm::ivec3(255, 0, 0));
  EXPECT_GT(sketched.at(4, y).g, 200) << "left of the line";
  int blue = 0;
  for (int py = 62 + 25; py < 62 + 43; ++py)
    for (int px = 5; px < 60; ++px) blue += sketched.at(px, py).b > sketched.at(px, py).r + 60 ? 1 : 0;
  EXPECT_GT(blue, 40);
}

TEST(noise, is_smooth_and_about_the_middle) {
  double sum = 0, steepest = 0;
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    const glm::vec3 at(0.37f * static_cast<float>(i % 211), 0.61f * static_cast<float>(i % 97),
                       0.13f * static_cast<float>(i % 31));
    const float here = compute_noise(at), near = compute_noise(at + glm::vec3(0.01f, 0, 0));
    EXPECT_GE(here, 0);
    EXPECT_LE(here, 1);
    sum += here;
    steepest = std::max(steepest, static_cast<double>(std::abs(here - near)));
  }
  EXPECT_NEAR(sum / kCount, 0.5, 0.02);
  EXPECT_LT(steepest, 0.03);
}

}  // namespace
}  // namespace mien

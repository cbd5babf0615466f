#include "sketch/stage.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "config/words.hpp"
#include "core/error.hpp"
#include "scene/povray.hpp"
#include "shipped.hpp"
#include "sketch/look.hpp"

namespace mien {
namespace {

SketchStage build_stage(const RenderSpec& render, const CameraView& view, const StageSets& sets = {},
                        const std::vector<LightShare>& lights = {},
                        const std::vector<BackgroundShare>& backgrounds = {}) {
  std::string start;
  append_povray_start(start, {{}, lights, backgrounds, view});
  return build_sketch_stage(build_povray_stage("", render, shipped_stock().templates, sets), start,
                            render.width_px, render.height_px);
}

TEST(sketch_stage, has_the_studio_of_povray) {
  const SketchStage stage = build_stage({}, {});
  ASSERT_EQ(stage.lamps.size(), 15u);  // key, its white walls, fill, blood, bounce, five rims on either side
  EXPECT_EQ(stage.cards.size(), 2u);
  std::size_t with_shadow = 0, cloths = 0;
  for (const SketchLamp& lamp : stage.lamps) {
    with_shadow += lamp.has_shadow ? 1 : 0;
    cloths += glm::length(lamp.side) > 0 ? 1 : 0;
    EXPECT_NEAR(glm::length(lamp.at), 1100, 0.01);
  }
  EXPECT_EQ(with_shadow, 1u);
  EXPECT_EQ(cloths, 1u);
  EXPECT_NEAR(glm::length(stage.lamps[0].side), 300, 0.01);
  EXPECT_LT(stage.lamps[0].at.x, 0) << "on the picture's left";
  EXPECT_LT(stage.lamps[0].at.z, 0) << "before the face";
}

TEST(sketch_stage, fits_the_box_of_the_view_whatever_the_shape) {
  CameraView view;
  view.angle_deg = 30;
  for (const auto& [width, height] : {std::pair(480, 600), std::pair(600, 300), std::pair(100, 400)}) {
    RenderSpec render;
    render.width_px = width;
    render.height_px = height;
    const SketchCamera camera = build_stage(render, view).camera;
    EXPECT_NEAR(glm::length(camera.right) / glm::length(camera.up), static_cast<double>(width) / height,
                1e-4);
    EXPECT_GE(glm::length(camera.right), view.frame_width_mm - 0.01);
    EXPECT_GE(glm::length(camera.up), view.frame_height_mm - 0.01);
    EXPECT_NEAR(glm::dot(camera.right, camera.up), 0, 0.01);
    EXPECT_NEAR(glm::dot(camera.right, camera.forward), 0, 1);
    EXPECT_NEAR(glm::length(camera.forward), compute_camera_distance_mm(view), 0.01);
  }
}

TEST(sketch_stage, understands_every_light_set_and_background) {
  const std::string prefix = "povray/light_";
  for (const auto& [path, text] : shipped_stock().templates) {
    if (!path.starts_with(prefix)) continue;
    const std::string name = path.substr(prefix.size(), path.size() - prefix.size() - 4);
    if (name == "ink") continue;  // the lamp of a style, whose materials say what it is like
    const SketchStage stage = build_stage({}, {}, {{name}, {}}, {{name, 0.5, 20}});
    EXPECT_FALSE(stage.lamps.empty()) << name;
  }
  for (const std::string& name : kBackgrounds) {
    RenderSpec render;
    render.background = name;
    const SketchStage stage = build_stage(render, {});
    const glm::vec4 ahead = sample_sky(stage, stage.camera.forward);
    EXPECT_GT(ahead.r + ahead.g + ahead.b, 0.001) << name;
    EXPECT_LE(std::max({ahead.r, ahead.g, ahead.b}), 1.0f) << name;
  }
}

TEST(sketch_stage, lights_strands_by_points_where_the_face_has_cloths) {
  const std::string prefix = "povray/light_";
  std::size_t cloths = 0, cards = 0, bloods = 0;
  for (const auto& [path, text] : shipped_stock().templates) {
    if (!path.starts_with(prefix)) continue;
    const std::string name = path.substr(prefix.size(), path.size() - prefix.size() - 4);
    if (name == "ink") continue;
    std::string start;
    append_povray_start(start, {{}, {{name, 0.5, 20}}, {}, {}});
    const RenderSpec render;
    const std::string include = build_povray_stage("", render, shipped_stock().templates, {{name}, {}});
    const auto build = [&](const std::string& frame) {
      return build_sketch_stage(include, frame, render.width_px, render.height_px);
    };
    const SketchStage face = build(start), both = build(start + "strand_lamps()\n"),
                      again = build(start + "strand_lamps()\nframe_lights(Lights_turn)\n");
    const std::size_t count = face.lamps.size();
    ASSERT_EQ(both.lamps.size(), 2 * count) << name;
    EXPECT_EQ(both.cards.size(), face.cards.size()) << name;
    EXPECT_EQ(again.cards.size(), 2 * face.cards.size()) << name << ": only strands have none";
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(both.lamps[count + i].at, face.lamps[i].at) << name;
      // Of blood there is none in hair: that lamp is grey there, and as bright.
      const glm::vec3 &on_face = face.lamps[i].colour, &on_hair = both.lamps[count + i].colour;
      if (on_hair != on_face) {
        EXPECT_EQ(on_hair, glm::vec3(on_hair.r)) << name;
        EXPECT_NEAR(on_hair.r, glm::dot(on_face, glm::vec3(0.2126, 0.7152, 0.0722)), 0.2f * on_hair.r)
            << name;
        ++bloods;
      }
      EXPECT_EQ(both.lamps[count + i].has_shadow, face.lamps[i].has_shadow) << name;
      EXPECT_EQ(both.lamps[count + i].side, glm::vec3(0)) << name;
      cloths += face.lamps[i].side != glm::vec3(0) ? 1 : 0;
    }
    cards += face.cards.size();
  }
  EXPECT_GE(cloths, 5u);
  EXPECT_GE(cards, 5u);
  EXPECT_GE(bloods, 1u);
}

TEST(sketch_stage, mixes_lights_and_backgrounds_by_their_shares) {
  const std::vector<BackgroundShare> grounds{{"", glm::vec3(1, 0, 0), 0.25}, {"", glm::vec3(0, 1, 0), 0.75}};
  const SketchStage stage = build_stage({}, {}, {}, {}, grounds);
  const glm::vec4 sky = sample_sky(stage, {0, 0, 1});
  EXPECT_NEAR(sky.r, 0.25, 1e-5);
  EXPECT_NEAR(sky.g, 0.75, 1e-5);
  const SketchStage whole = build_stage({}, {}),
                    half = build_stage({}, {}, {}, {{"studio", 1, 0}, {"studio", 1, 0}});
  EXPECT_EQ(half.lamps.size(), 2 * whole.lamps.size());
}

TEST(sketch_stage, mirrors_its_cards) {
  const SketchStage stage = build_stage({}, {});
  const glm::vec3 toward = glm::normalize(stage.lamps[0].at);
  // The key's stands beside it, ten degrees farther aside and up: off the pupils.
  const glm::vec3 aside = glm::normalize(glm::cross(glm::vec3(0, 1, 0), toward)),
                  up = glm::cross(toward, aside);
  const auto sample = [&](float right) {
    return sample_cards(stage, glm::vec3(0), glm::normalize(toward + right * aside + 0.17f * up)).r;
  };
  EXPECT_GT(sample(0.17f), 10);
  EXPECT_EQ(sample(-0.17f), 0);
  EXPECT_EQ(sample_cards(stage, glm::vec3(0), toward).r, 0);
  EXPECT_EQ(sample_cards(stage, glm::vec3(0), -toward), glm::vec3(0));
}

TEST(sketch_look, knows_every_material_that_heads_are_made_of) {
  for (const Style style : {Style::studio, Style::ink, Style::plaster}) {
    RenderSpec render;
    render.style = style;
    const SketchStage stage = build_stage(render, {});
    std::size_t count = 0;
    for (const auto& [name, macro] : stage.names.macros) {
      if (!name.ends_with("_texture")) continue;
      Model model;
      Part part;
      part.name = "part";
      part.material = name.substr(0, name.size() - 8);
      part.palette = {{{0.5f, 0.4f, 0.3f}, 0.5f}, {{0.1f, 0.2f, 0.3f}, 0}};
      model.parts = {part};
      EXPECT_EQ(build_sketch_look(model, stage.names).parts[0].textures.size(), 2u) << name;
      ++count;
    }
    EXPECT_GT(count, 10u);
  }
}

TEST(sketch_look, keeps_what_materials_say_of_shadows_and_of_what_shines_through) {
  const SketchStage stage = build_stage({}, {});
  Model model;
  for (const char* material : {"skin", "brow", "lock", "cornea", "teeth"}) {
    Part part;
    part.name = part.material = material;
    part.palette = {{{0.5f, 0.5f, 0.5f}, 0.5f}};
    model.parts.push_back(part);
  }
  const std::vector<SketchPart> parts = build_sketch_look(model, stage.names).parts;
  const std::vector<bool> shadows{true, false, false, false, true}, clear{false, true, true, true, false},
      veil{false, true, false, true, false};  // a lock's root is dense
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_EQ(parts[i].has_shadow, shadows[i]) << i;
    EXPECT_EQ(parts[i].is_clear, clear[i]) << i;
    EXPECT_EQ(parts[i].is_veil, veil[i]) << i;
  }
  EXPECT_FLOAT_EQ(parts[0].textures[0].finish.diffuse, 0.72f);
  EXPECT_FLOAT_EQ(parts[2].textures[0].finish.brilliance, 0.8f);
  EXPECT_FLOAT_EQ(parts[3].textures[0].finish.reflection, 0.022f);
}

TEST(sketch_look, tells_a_material_that_is_not_there) {
  Model model;
  Part part;
  part.name = "hat";
  part.material = "felt";
  part.palette = {{}};
  model.parts = {part};
  try {
    build_sketch_look(model, build_stage({}, {}).names);
    FAIL();
  } catch (const RunError& error) {
    EXPECT_EQ(std::string(error.what()), "part 'hat': unknown material 'felt'");
  }
}

}  // namespace
}  // namespace mien

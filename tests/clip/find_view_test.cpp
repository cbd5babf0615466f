// What the camera takes in, for every head from every side.
#include <gtest/gtest.h>

#include <cmath>

#include "clip/view.hpp"
#include "core/conventions.hpp"
#include "places.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

Figure build_head(const char* age) {
  HeadSpec spec;
  spec.age = {{age, 1.0}};
  return build_figure(shipped().heads, spec);
}

CameraView find_view_at(const Figure& figure, double angle_deg, double height_deg = 0) {
  CameraKey camera;
  camera.angle_deg = angle_deg;
  camera.height_deg = height_deg;
  return compute_view(figure, camera, RenderSpec{});
}

// How far from the middle to the edge of the picture (1) the head's skin reaches, to the left and to the
// right.
glm::dvec2 find_reach(const Figure& figure, const CameraView& view) {
  const double angle = view.angle_deg * kRadiansPerDegree;
  const glm::dvec3 right(std::cos(angle), 0, -std::sin(angle)), toward(std::sin(angle), 0, std::cos(angle));
  const RenderSpec render;
  const double width =
      std::max(view.frame_width_mm, view.frame_height_mm * render.width_px / render.height_px);
  const double distance = compute_camera_distance_mm(view);
  glm::dvec2 reach(0);
  for (const glm::vec3& vertex : figure.head.skin.positions) {
    const glm::dvec3 p = glm::dvec3(vertex) - glm::dvec3(view.look_at);
    const bool is_head = vertex.y > figure.head.skin.positions[figure.head.cage.index.at("m12_D1")].y;
    const double x = glm::dot(p, right) * distance / (distance - glm::dot(p, toward)) / (width / 2);
    if (is_head) reach = {std::max(reach.x, -x), std::max(reach.y, x)};
  }
  return reach;
}

TEST(compute_view, takes_in_all_of_the_hair_above) {
  for (const char* cut : {"curls", "bun", "pixie", "wavy"}) {
    HeadSpec spec;
    spec.hair = cut;
    const Figure figure = build_figure(shipped().heads, spec);
    for (const double angle_deg : {0.0, 30.0, 90.0, 180.0}) {
      const CameraView view = find_view_at(figure, angle_deg);
      const double angle = view.angle_deg * kRadiansPerDegree, distance = compute_camera_distance_mm(view);
      const glm::dvec3 toward(std::sin(angle), 0, std::cos(angle));
      double highest = 0;
      for (const Part& part : figure.model.parts)
        for (const glm::vec3& vertex : part.rest.positions) {
          const glm::dvec3 p = glm::dvec3(vertex) - glm::dvec3(view.look_at);
          highest = std::max(highest, p.y * distance / (distance - glm::dot(p, toward)));
        }
      EXPECT_LT(highest, 0.49 * view.frame_height_mm) << cut << " " << angle_deg;
    }
  }
}

TEST(compute_view, holds_every_head_from_every_side) {
  for (const char* age : {"infant", "child", "adult"}) {
    const Figure figure = build_head(age);
    for (double angle = -180; angle <= 180; angle += 15) {
      const glm::dvec2 reach = find_reach(figure, find_view_at(figure, angle));
      EXPECT_LT(std::max(reach.x, reach.y), 0.97) << age << " at " << angle;
      EXPECT_NEAR(reach.x, reach.y, 0.01) << "it stands in the middle: " << age << " at " << angle;
    }
  }
}

TEST(compute_view, frames_an_adults_face_by_its_height_alone) {
  const Figure figure = build_head("adult");
  const CameraView view = find_view_at(figure, 0);
  const Box skin = compute_bounds(figure.head.skin.positions);
  const double chin = figure.head.skin.positions[figure.head.cage.index.at("m12_D1")].y;
  const double height = skin.high.y - chin;
  EXPECT_DOUBLE_EQ(view.frame_width_mm, height * 1.08);
  EXPECT_DOUBLE_EQ(view.frame_height_mm, height * 1.35);
  EXPECT_NEAR(view.look_at.x, 0, 0.02);
  EXPECT_NEAR(view.look_at.y, skin.high.y + height * (0.10 - 1.35 / 2), 1e-3);
  EXPECT_EQ(view.look_at.z, 0);
}

TEST(compute_resting_place, has_the_side_that_its_name_says) {
  const NeutralHead head = build_neutral_head(shipped().heads, HeadSpec{});
  const glm::dvec3 left = compute_resting_place(head, "mouth_corner_l"),
                   right = compute_resting_place(head, "mouth_corner_r"),
                   middle = compute_resting_place(head, "nose_tip");
  EXPECT_GT(left.x, 15) << "the character's left is +x";
  EXPECT_EQ(right, left * glm::dvec3(-1, 1, 1));
  EXPECT_EQ(middle.x, 0);
  EXPECT_GT(middle.z, left.z + 10);
}

TEST(compute_view, does_not_jump_while_the_camera_moves) {
  const Figure figure = build_head("infant");
  CameraView before = find_view_at(figure, -180);
  for (double angle = -179.5; angle <= 180; angle += 0.5) {
    const CameraView view = find_view_at(figure, angle, 10 * std::sin(angle));
    const CameraView level = find_view_at(figure, angle);
    EXPECT_LT(std::abs(level.frame_width_mm - before.frame_width_mm), 1.5) << angle;
    EXPECT_LT(glm::distance(level.look_at, before.look_at), 1.5f) << angle;
    EXPECT_LT(view.frame_width_mm, 300);
    before = level;
  }
}

}  // namespace
}  // namespace mien

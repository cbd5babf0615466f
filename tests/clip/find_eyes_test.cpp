// What the gaze knows of a figure agrees with what is drawn.
#include <gtest/gtest.h>

#include <cmath>

#include "clip/clip.hpp"
#include "clip/view.hpp"
#include "core/conventions.hpp"
#include "core/data.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

glm::dvec3 find_toward(double angle_deg, double height_deg) {
  const double angle = angle_deg * kRadiansPerDegree, height = height_deg * kRadiansPerDegree;
  return {std::sin(angle) * std::cos(height), std::sin(height), std::cos(angle) * std::cos(height)};
}

// Eyes that are off by less than two degrees look at one (Gamer and Hecht, 2007, find some four to either
// side).
TEST(compute_eyes, meets_the_camera_on_every_head) {
  for (const char* age : {"infant", "adult"}) {
    HeadSpec head;
    head.age = {{age, 1.0}};
    const Figure figure = build_figure(shipped().heads, head);
    const EyeRig rig = compute_eyes(figure, {});
    EXPECT_NEAR(rig.left.up_deg, 25, 1e-9);
    EXPECT_NEAR(rig.right.down_deg, 30, 1e-9);
    for (const double angle_deg : {-60.0, -20.0, 0.0, 35.0}) {
      CameraKey camera;
      camera.angle_deg = angle_deg;
      camera.height_deg = 10;
      camera.distance = 0.8;
      const CameraView view = compute_view(figure, camera, {});
      const glm::dvec3 toward = find_toward(angle_deg, 10);
      const glm::dvec3 real =
          glm::dvec3(view.look_at) + compute_camera_distance_mm(view) * view.distance * toward;
      const glm::dvec3 meant = rig.camera_target_mm + rig.camera_mm * camera.distance * toward;
      const glm::dvec3 a = glm::normalize(real - rig.left_mm), b = glm::normalize(meant - rig.left_mm);
      EXPECT_LT(std::acos(std::min(1.0, glm::dot(a, b))) / kRadiansPerDegree, 2) << age << angle_deg;
    }
  }
}

TEST(compute_eyes, takes_the_limits_of_the_head) {
  HeadSpec head;
  head.limits = {{"eye.left.up", 0.5}};
  const EyeRig rig = compute_eyes(build_figure(shipped().heads, head), {});
  EXPECT_NEAR(rig.left.up_deg, 12.5, 1e-9);
  EXPECT_NEAR(rig.right.up_deg, 25, 1e-9);
}

}  // namespace
}  // namespace mien

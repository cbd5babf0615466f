// What only one half of a drawn face has, by how its head is turned: the front of an eye, waves of the
// forehead.
#include "frames/ink_cornea.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_subject.hpp"

namespace mien {
namespace {

glm::dvec3 find_camera(double turn_deg) {
  const double turn = glm::radians(turn_deg);
  return {900 * std::sin(turn), 0, 900 * std::cos(turn)};
}

// The last of the lines.
std::vector<glm::vec3> find_cornea(const Subject& subject, const Drawing& drawing) {
  const std::vector<glm::vec3>& p = drawing.parts[find_part(subject.ink.model, "lines")].positions;
  return {p.end() - static_cast<std::ptrdiff_t>(kStrokeVertices), p.end()};
}

// An iris that nothing closes before it looks cut off.
TEST(ink_turned, closes_an_eye_that_is_seen_from_the_side) {
  for (const char* age : {"infant", "child", "adult"}) {
    const Subject subject = build_of_age(age);
    for (const double turn_deg : {-90, 90}) {
      const glm::dvec3 camera_mm = find_camera(turn_deg);
      const Drawing drawing = draw(subject, Pose{}, TurnKey{}, {camera_mm, {0, 0.6, 0.8}, 1});
      const std::vector<glm::vec3> line = find_cornea(subject, drawing);
      EXPECT_GT(measure_width(line), 0.6) << age;
      // It goes from lid to lid, and stands as far forth as anything of the ball.
      float low_mm = 1e9f, high_mm = -1e9f, front_mm = -1e9f, ball_mm = -1e9f;
      for (const glm::vec3& p : line) {
        low_mm = std::min(low_mm, p.y);
        high_mm = std::max(high_mm, p.y);
        front_mm = std::max(front_mm, p.z);
        EXPECT_GT(p.x * turn_deg, 0) << "of the nearer eye " << age;
      }
      for (const std::size_t part : subject.ink.balls)
        for (const glm::vec3& p : drawing.parts[part].positions)
          if (p.x * turn_deg > 0 && p.y > low_mm && p.y < high_mm) ball_mm = std::max(ball_mm, p.z);
      EXPECT_NEAR(front_mm, ball_mm, 1.5) << age;
      const auto& lids = subject.ink.lids[turn_deg > 0 ? 0 : 1];
      const std::vector<glm::vec3>& skin = drawing.parts.front().positions;
      EXPECT_NEAR(high_mm, skin[lids[0]].y, 1) << age;
      EXPECT_NEAR(low_mm, skin[lids[1]].y, 1) << age;
    }
    for (const double turn_deg : {0, -35, 50})
      EXPECT_LT(measure_width(find_cornea(
                    subject, draw(subject, Pose{}, TurnKey{}, {find_camera(turn_deg), {0, 0.6, 0.8}, 1}))),
                0.05)
          << age << ' ' << turn_deg;
  }
}

// Where they run up the far half they meet in a knot at the outline.
TEST(ink_turned, waves_of_the_forehead_are_of_the_nearer_half_of_a_head_that_is_turned) {
  const Pose raised = make_pose({{"brow.up", 1}});
  const auto measure_mm = [&](double turn_deg) {  // of the left half
    return measure_width(find_stroke(
        comic(), draw(comic(), raised, TurnKey{}, {find_camera(turn_deg), {0, 0.6, 0.8}, 1}), "forehead"));
  };
  EXPECT_GT(measure_mm(0), 0.2);
  EXPECT_GT(measure_mm(50), 0.2);
  EXPECT_GT(measure_mm(-20), 0.2);
  EXPECT_LT(measure_mm(-50), 0.05);
}

// Else the outline of a far cheek has a gap there.
TEST(ink_turned, the_outline_goes_on_beside_the_far_corner_of_a_mouth) {
  const Pose angry = make_pose({{"corner.up", -0.5}, {"lips.press", 0.6}});
  for (const char* age : {"infant", "child"}) {
    const Subject subject = build_of_age(age);
    const auto measure = [&](const char* side, double turn_deg) {
      double most = 0;
      for (const char* name : {"M3_6", "M4_6", "M5_6", "M6_6"})
        most = std::max(most, measure_outline_mm(subject, (std::string(side) + name).c_str(), 3,
                                                 {find_camera(turn_deg), {0, 0.6, 0.8}, 1}, angry));
      return most;
    };
    EXPECT_GT(measure("R:", 35), 0.3) << age;
    EXPECT_GT(measure("", -35), 0.3) << age;
    EXPECT_LT(measure("", 35), 0.1) << "the nearer one " << age;
    EXPECT_LT(measure("R:", 0), 0.1) << age;
  }
}

}  // namespace
}  // namespace mien

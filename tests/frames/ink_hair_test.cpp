// Hair of a drawn head that is turned.
#include "frames/ink_hair.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/conventions.hpp"
#include "drawn_subject.hpp"

namespace mien {
namespace {

Subject build_hanging() {
  HeadSpec spec = make_spec("comic");
  spec.hair = "long";
  spec.character = -1;
  return build_subject(spec);
}

InkView look_from(double turn_deg) {
  constexpr double kAway_mm = 900;
  const double turn = turn_deg * kRadiansPerDegree;
  return {{kAway_mm * std::sin(turn), 0, kAway_mm * std::cos(turn)}, {0, 0, 1}, 1};
}

// How far forward hair below the mouth on the left comes.
double measure_front_mm(const Subject& subject, const InkView& view) {
  constexpr float kBelow_mm = 25, kBeside_mm = 30;
  const Drawing drawing = draw(subject, Pose{}, TurnKey{}, view);
  const glm::vec3 lip = drawing.parts.front().positions[subject.ink.lips[1]];
  double front_mm = -1e9;
  for (const glm::vec3& p : drawing.parts[find_part(subject.ink.model, "hair_mass")].positions)
    if (p.y < lip.y - kBelow_mm && p.x > kBeside_mm) front_mm = std::max(front_mm, double(p.z));
  return front_mm;
}

TEST(ink_hair, no_scrap_of_it_shows_beyond_the_chin) {
  constexpr double kTucked_mm = 20;
  const Subject subject = build_hanging();
  for (const double turn_deg : {35.0, 50.0}) {  // the left is near, then far
    const double near = measure_front_mm(subject, look_from(turn_deg));
    EXPECT_LT(measure_front_mm(subject, look_from(-turn_deg)), near - kTucked_mm) << turn_deg;
  }
  EXPECT_NEAR(measure_front_mm(subject, look_from(90)), measure_front_mm(subject, look_from(-90)), 1);
  const double faced = measure_front_mm(subject, look_from(0));
  EXPECT_NEAR(measure_front_mm(subject, look_from(5)), faced, 3);
  EXPECT_NEAR(measure_front_mm(subject, look_from(-5)), faced, 3);
}

}  // namespace
}  // namespace mien

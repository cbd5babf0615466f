// What a drawn head is that is seen from below, and how thick its brows are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_subject.hpp"
#include "head/cage.hpp"

namespace mien {
namespace {

constexpr glm::dvec3 kBefore_mm{0, 0, 900}, kBelow_mm{0, -450, 780};

TEST(ink_below, a_throat_is_in_the_shade_along_the_jaw) {
  constexpr float kTerminator = 0.12f;  // as materials_drawn.inc has it: cosine
  constexpr float kDarker = 0.2f;
  for (const char* age : {"infant", "child", "adult"}) {
    const Subject subject = build_of_age(age);
    const Cage& cage = subject.figure.head.cage;
    for (const double side : {-1.0, 1.0}) {
      const glm::dvec3 to_light = glm::normalize(glm::dvec3(side * 0.46, 0.6, 0.66));
      const auto measure = [&](const char* name, const glm::dvec3& camera_mm) {
        const Drawing drawing = draw(subject, Pose{}, TurnKey{}, {camera_mm, to_light, 1});
        const std::uint32_t left = find_point(cage, name), right = cage.mirror[left];
        const std::vector<glm::vec3>& tones = drawing.parts.front().normals;
        return std::max(glm::dot(tones[left], glm::vec3(to_light)),
                        glm::dot(tones[right], glm::vec3(to_light)));
      };
      for (const char* name : {"m12_N0", "m10_N0", "m8_N0", "q11_N0"})
        EXPECT_LT(measure(name, kBelow_mm), kTerminator) << age << ' ' << name;
      EXPECT_GT(measure("q11_N0", kBefore_mm), measure("q11_N0", kBelow_mm) + kDarker) << age;
      for (const char* name : {"E5_12", "q12_C4"})
        EXPECT_GT(measure(name, kBelow_mm), kTerminator) << age << ' ' << name;
    }
  }
}

// POV-Ray turns round a direction that looks the other way than its triangle does.
TEST(ink_below, what_is_turned_into_the_shade_looks_where_the_skin_does) {
  const Subject& subject = comic();
  const Drawing drawing =
      draw(subject, Pose{}, TurnKey{}, {kBelow_mm, glm::normalize(glm::dvec3(-0.46, 0.6, 0.66)), 1});
  const PartShape& skin = drawing.parts.front();
  const std::vector<Triangle>& triangles = subject.ink.model.parts.front().rest.triangles;
  int count = 0;
  for (const Triangle& t : triangles) {
    if (std::max({t[0], t[1], t[2]}) >= subject.ink.throat.size()) continue;
    const glm::vec3 &a = skin.positions[t[0]], &b = skin.positions[t[1]], &c = skin.positions[t[2]];
    const glm::vec3 out = glm::cross(b - a, c - a);
    for (const std::uint32_t v : t) {
      if (subject.ink.throat[v] < 0.9f || glm::dot(out, glm::vec3(kBelow_mm) - a) < 0) continue;
      EXPECT_GT(glm::dot(skin.normals[v], out), 0);
      ++count;
    }
  }
  EXPECT_GT(count, 100);
}

// Its shade would swallow a chin that is pushed up.
TEST(ink_below, a_chin_is_lit_unless_it_is_seen_from_there) {
  constexpr float kTerminator = 0.12f;  // as materials_drawn.inc has it: cosine
  const glm::dvec3 to_light = glm::normalize(glm::dvec3(-0.46, 0.6, 0.66));
  const Pose pushed = make_pose({{"chin.up", 0.8}, {"corner.up", -0.5}});
  for (const char* age : {"infant", "child", "adult"}) {
    const Subject subject = build_of_age(age);
    const std::uint32_t chin = find_point(subject.figure.head.cage, "M6_12");
    const auto measure = [&](const glm::dvec3& camera_mm) {
      const Drawing drawing = draw(subject, pushed, TurnKey{}, {camera_mm, to_light, 1});
      return glm::dot(drawing.parts.front().normals[chin], glm::vec3(to_light));
    };
    EXPECT_GT(measure(kBefore_mm), kTerminator) << age;
    EXPECT_GT(measure({500, 0, 750}), kTerminator) << age;
    EXPECT_LT(measure(kBelow_mm), measure(kBefore_mm)) << age;
  }
}

TEST(ink_below, brows_are_as_thick_as_those_of_the_head) {
  const auto measure = [](const Subject& subject) {
    double most = 0;
    for (const InkStroke& stroke : subject.ink.strokes)
      if (stroke.rule.is_brow)
        for (const StrokeWidth& width : stroke.rule.widths) most = std::max(most, width.width);
    return most / subject.figure.head.brow_thickness;
  };
  const double adult = measure(comic());
  for (const char* age : {"infant", "child", "old"})
    EXPECT_NEAR(measure(build_of_age(age)), adult, 1e-6) << age;
  EXPECT_LT(build_of_age("infant").figure.head.brow_thickness, 0.8);
}

}  // namespace
}  // namespace mien

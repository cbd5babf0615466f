// Sculpting by strokes, and heads mixed of heads.
#include "head/sculpt.hpp"

#include <gtest/gtest.h>

#include <random>

#include "config/head_words.hpp"
#include "core/data.hpp"
#include "head/landmarks.hpp"
#include "head/surface.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

glm::dvec3 find_at(const NeutralHead& head, const SkinSpot& place) {
  glm::dvec3 sum{0};
  for (std::size_t i = 0; i < place.vertices.size(); ++i)
    sum += place.shares[i] * glm::dvec3(head.skin.positions[place.vertices[i]]);
  return sum;
}

NeutralHead build(const HeadSpec& spec) { return build_neutral_head(shipped().heads, spec); }

const NeutralHead& adult() {
  static const NeutralHead head = build(HeadSpec{});
  return head;
}

TEST(sculpt, every_place_goes_where_it_was_told) {
  const HeadWords& words = shipped().stock.head->words;
  EXPECT_GT(words.middle.size() + words.sided.size(), 50u);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> move(-4, 4), radius(10, 60);
  const auto check = [&](const std::string& name, bool is_middle) {
    HeadSpec spec;
    spec.sculpt = {{name, {is_middle ? 0 : move(random), move(random), move(random)}, radius(random)}};
    const SkinSpot place = find_place(adult(), name);
    const glm::dvec3 moved = find_at(build(spec), place) - find_at(adult(), place);
    // Lids are lifted off the ball if they were pushed into it.
    const bool is_lid =
        name.find("lid") != name.npos || name.find("eye") != name.npos || name == "en" || name == "ex";
    EXPECT_LT(glm::distance(moved, spec.sculpt[0].move_mm), is_lid ? 4 : 1e-3) << name;
  };
  for (const std::string& name : words.middle) check(name, true);
  for (const std::string& name : words.sided) check(name, false);
}

TEST(sculpt, reaches_no_further_than_its_radius_and_keeps_the_mirror) {
  HeadSpec spec;
  spec.sculpt = {{"mouth_corner", {3, 2, 1}, 25}, {"chin", {0, -3, 4}, 30}};
  const NeutralHead head = build(spec);
  for (std::size_t v = 0; v < head.skin.positions.size(); ++v) {
    const glm::vec3 now = head.skin.positions[v], then = adult().skin.positions[v];
    const glm::vec3 image = head.skin.positions[head.surface->mirror[v]];
    if (head.surface->mirror[v] != v) {
      ASSERT_EQ(now, image * glm::vec3(-1, 1, 1));
    }
    if (then.y > -35 || then.z < 20) {
      ASSERT_EQ(now, then) << "the eyes and the back of the head";
    }
  }
}

TEST(sculpt, scales_about_the_place) {
  for (const char* name : {"nose_tip", "cheek"}) {
    HeadSpec spec;
    spec.sculpt = {{name, {0, 0, 0}, 30, 1.3}};
    const NeutralHead head = build(spec);
    const SkinSpot place = find_place(adult(), name);
    const glm::dvec3 at = find_at(adult(), place);
    EXPECT_LT(glm::distance(find_at(head, place), at), 0.3) << name;
    double least = 10, most = 0;
    for (std::size_t v = 0; v < head.skin.positions.size(); ++v) {
      const glm::dvec3 then(adult().skin.positions[v]), now(head.skin.positions[v]);
      const double far = glm::distance(then, at);
      if (far > 8 || far < 3) continue;
      least = std::min(least, glm::distance(now, at) / far);
      most = std::max(most, glm::distance(now, at) / far);
    }
    EXPECT_GT(least, 1.05) << name;  // all around it everything has grown, never by more than was said
    EXPECT_LT(most, 1.35) << name;
  }
}

TEST(sculpt, turns_about_the_place_and_its_mirror_image_the_other_way) {
  HeadSpec spec;
  spec.sculpt = {{"brow_mid", {0, 0, 0}, 40, 1, 20, "z"}};
  const NeutralHead head = build(spec);
  const auto way = [&](const char* name) {
    const SkinSpot place = find_place(adult(), name);
    return find_at(head, place) - find_at(adult(), place);
  };
  // Counter-clockwise for who sees the face: of the character's left brow the outer end goes up.
  EXPECT_GT(way("brow_outer").y, 1);
  EXPECT_LT(way("brow_inner").y, -1);
  for (std::size_t v = 0; v < head.skin.positions.size(); ++v) {
    const glm::vec3 now = head.skin.positions[v], image = head.skin.positions[head.surface->mirror[v]];
    if (head.surface->mirror[v] != v) {
      ASSERT_EQ(now, image * glm::vec3(-1, 1, 1));
    }
  }
}

TEST(sculpt, one_lip_does_not_drag_the_other) {
  HeadSpec spec;
  spec.sculpt = {{"lower_lip", {0, -3, 2}, 20}};
  const NeutralHead head = build(spec);
  const auto move = [&](const char* name) {
    const std::uint32_t v = find_point(head.cage, name);
    return glm::distance(head.skin.positions[v], adult().skin.positions[v]);
  };
  EXPECT_GT(move("M1_12"), 1);
  EXPECT_LT(move("M1_0"), 0.05);
  EXPECT_LT(move("M0_0"), 0.05);
}

TEST(mix, is_the_mean_of_its_heads) {
  HeadSpec child, narrow, mixed;
  child.age = {{"child", 1.0}};
  narrow.skull = {{"narrow", 1.0}};
  narrow.sculpt = {{"chin", {0, 0, 5}, 30}};
  mixed.mix = {{child, 0.25}, {narrow, 0.75}};
  const NeutralHead a = build(child), b = build(narrow), c = build(mixed);
  const auto settled_mm = [&](std::size_t i) {
    const char ring = strip_side(c.cage.names[i])[0];
    return ring == 'E' || ring == 'M' ? 0.1 : 1e-6;  // lids and lips touch anew
  };
  for (std::size_t i = 0; i < c.cage.points.size(); ++i) {
    ASSERT_LT(glm::distance(c.cage.points[i], 0.25 * a.cage.points[i] + 0.75 * b.cage.points[i]),
              settled_mm(i));
  }
  EXPECT_NEAR(c.eye.radius_mm, 0.25 * a.eye.radius_mm + 0.75 * b.eye.radius_mm, 1e-9);
  EXPECT_EQ(c.ages, (Mix{{"child", 0.25}, {"adult", 0.75}}));  // teeth and lines are those of its ages

  HeadSpec alone;
  alone.mix = {{child, 1.0}};
  const NeutralHead same = build(alone);
  EXPECT_EQ(same.ages, child.age);
  for (std::size_t i = 0; i < c.cage.points.size(); ++i)
    ASSERT_LT(glm::distance(same.cage.points[i], a.cage.points[i]), settled_mm(i));
  alone.features = {{"nose_length", 1.0}};
  EXPECT_LT(build(alone).cage.points[find_point(a.cage, "p_tip")].y,
            a.cage.points[find_point(a.cage, "p_tip")].y - 1);
}

}  // namespace
}  // namespace mien

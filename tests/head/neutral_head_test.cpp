#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

#include "core/data.hpp"
#include "core/error.hpp"
#include "core/monotone.hpp"
#include "head/cage.hpp"
#include "head/head.hpp"
#include "head/patterns.hpp"
#include "head/shapes.hpp"
#include "head/solve.hpp"
#include "head/surface.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

NeutralHead build(const std::string& age = "adult", const std::string& skull = "average") {
  HeadSpec spec;
  spec.age = {{age, 1.0}};
  spec.skull = {{skull, 1.0}};
  return build_neutral_head(shipped().heads, spec);
}

const NeutralHead& adult() {
  static const NeutralHead head = build();
  return head;
}

TEST(cage, mirrors_the_half_with_the_middle_once) {
  const HalfHead half = shipped().stock.head->half;
  const Cage cage = build_cage(half);
  EXPECT_EQ(half.points.size(), 887u);
  EXPECT_EQ(cage.points.size(), 1700u);
  EXPECT_EQ(cage.quads.size(), 1668u);
  for (std::uint32_t i = 0; i < cage.points.size(); ++i) {
    EXPECT_EQ(cage.mirror[cage.mirror[i]], i);
    EXPECT_EQ(cage.mirror[i] == i, cage.points[i].x == 0) << cage.names[i];
  }
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Quad& quad : cage.quads)
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(edges.insert({quad[i], quad[(i + 1) % 4]}).second);
}

TEST(cage, passes_its_skin_points) {
  const HalfHead half = shipped().stock.head->half;
  double square_sum = 0, eye_sum = 0;
  int count = 0, eye_count = 0;
  for (std::size_t i = 0; i < half.points.size(); ++i) {
    const SkinPoint& p = half.points[i];
    if (!p.skin || p.is_hard) continue;
    const double miss = glm::length(glm::dvec3(adult().skin.positions[i]) - *p.skin);
    square_sum += miss * miss;
    ++count;
    if (!p.name.starts_with("E0_") && !p.name.starts_with("E1_") && !p.name.starts_with("M1_")) continue;
    eye_sum += miss * miss;
    ++eye_count;
  }
  EXPECT_LT(std::sqrt(square_sum / count), 1.5);    // mm; fairness is meant to overrule the skull's points
  EXPECT_LT(std::sqrt(eye_sum / eye_count), 0.25);  // lid margins and the lips' contact are exact
}

TEST(surface, is_an_exact_mirror_image_of_itself) {
  const Surface& surface = *adult().surface;
  const auto& p = adult().skin.positions;
  for (std::uint32_t v = 0; v < p.size(); ++v) {
    const std::uint32_t m = surface.mirror[v];
    ASSERT_EQ(surface.mirror[m], v);
    if (m == v)
      EXPECT_NEAR(p[v].x, 0, 1e-5);
    else
      EXPECT_TRUE(p[m].x == -p[v].x && p[m].y == p[v].y && p[m].z == p[v].z) << v;
  }
}

TEST(surface, weights_sum_to_one_and_spread_keeps_constants) {
  const Surface& surface = *adult().surface;
  const std::vector<float> ones =
      spread_over_surface(surface, std::vector<double>(adult().cage.points.size(), 1.0));
  for (const float one : ones) ASSERT_NEAR(one, 1, 1e-5);
  for (const float weight : surface.weight) ASSERT_GE(weight, 0);
}

TEST(head, is_open_only_at_neck_eyes_and_the_back_of_the_mouth) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const Triangle& t : adult().skin.triangles)
    for (int i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    if (edges.contains({edge.second, edge.first})) continue;
    const glm::vec3 p = adult().skin.positions[edge.first];
    const bool is_neck = p.y < -180;
    const bool is_eye = glm::distance(glm::abs(p), glm::vec3(adult().eye.centre)) < 16;
    const bool is_throat = p.y < -60 && p.y > -100 && p.z < 60 && std::abs(p.x) < 25;
    EXPECT_TRUE(is_neck || is_eye || is_throat) << p.x << " " << p.y << " " << p.z;
  }
}

TEST(head, has_an_adults_size) {
  const Box box = compute_bounds(adult().skin.positions);
  const auto at = [](const char* name) {
    return adult().skin.positions[adult().cage.index.find(name)->second];
  };
  EXPECT_NEAR(box.high.y - at("m12_D1").y, 228, 3);                         // chin to crown
  EXPECT_NEAR(2 * adult().eye.centre.x, 63, 0.5);                           // between the pupils
  EXPECT_NEAR(-at("m12_D1").y / (box.high.y - at("m12_D1").y), 0.5, 0.01);  // eyes at half the height
}

TEST(head, lids_lie_on_the_ball_on_every_head) {
  for (const char* age : {"infant", "child", "teenager", "young_adult", "adult", "old"})
    for (const char* skull : {"average", "square", "round", "wide", "narrow"}) {
      const NeutralHead head = build(age, skull);
      for (int i = 0; i < 16; ++i)
        for (const char* ring : {"E0_", "E1_", "E2_"}) {
          const std::uint32_t v = head.cage.index.find(ring + std::to_string(i))->second;
          const double gap =
              glm::length(glm::dvec3(head.skin.positions[v]) - head.eye.centre) - head.eye.radius_mm;
          EXPECT_GT(gap, 0) << age << " " << skull << " " << ring << i;
          if (ring == std::string("E0_")) {
            EXPECT_LT(gap, 2.6) << age << " " << skull << " " << i;
          }
        }
    }
}

TEST(head, mixes_ages_without_a_jump) {
  HeadSpec spec;
  const auto at = [&](double share) {
    spec.age = share == 0 ? Mix{{"infant", 1.0}} : Mix{{"adult", share}, {"infant", 1 - share}};
    return build_neutral_head(shipped().heads, spec).cage.points;
  };
  const auto a = at(0.25), b = at(0.5), c = at(0.75);
  for (std::size_t i = 0; i < a.size(); ++i) {  // ages mix linearly, but for what is kept clear of each other
    const char ring = strip_side(adult().cage.names[i])[0];
    const bool is_settled = ring == 'E' || ring == 'M' || ring == 'n';  // lids, lips, nostrils
    EXPECT_LT(glm::length(a[i] + c[i] - 2.0 * b[i]), is_settled ? 0.2 : 1e-9) << adult().cage.names[i];
  }
}

TEST(head, random_heads_are_finite_and_not_folded) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0.05, 1), sign(-1, 1);
  for (int round = 0; round < 20; ++round) {
    HeadSpec spec;
    spec.age = {{"infant", share(random)}, {"child", share(random)}, {"adult", share(random)}};
    double sum = 0;
    for (const auto& [name, weight] : spec.age) sum += weight;
    for (auto& [name, weight] : spec.age) weight /= sum;
    const double k = share(random);
    spec.skull = {{"square", k}, {"narrow", 1 - k}};
    spec.character = sign(random);
    for (const auto& [name, feature] : shipped().stock.head->shapes.heads.features)
      spec.features[name] = sign(random);
    const NeutralHead head = build_neutral_head(shipped().heads, spec);
    std::size_t flipped = 0;
    for (std::size_t f = 0; f < head.surface->quads.size(); ++f) {
      const auto& quad = head.surface->quads[f];
      const auto area = [&](const std::vector<glm::vec3>& p) {
        return glm::cross(p[quad[2]] - p[quad[0]], p[quad[3]] - p[quad[1]]);
      };
      const glm::vec3 now = area(head.skin.positions);
      ASSERT_TRUE(std::isfinite(now.x + now.y + now.z));
      const glm::vec3 then = area(adult().skin.positions);
      if (glm::dot(now, then) < 0) ++flipped;
    }
    EXPECT_LT(flipped, 40u);  // of 26,688; hidden ones inside nostril and ear turn a little
  }
}

TEST(shapes, moves_the_guide_line_that_was_asked_for) {
  const HeadShapes shapes = shipped().stock.head->shapes.heads;
  const HalfHead half = shipped().stock.head->half;
  Cage cage = build_cage(half);
  solve_cage(half, cage);
  const auto guides = compute_guides(shapes, HeadSpec{}, cage, Eye{});
  EXPECT_NEAR(guides.at("eye_line"), 0.5, 0.01);
  EXPECT_NEAR(guides.at("nose_base"), 1 / 3.5, 0.02);
  EXPECT_NEAR(guides.at("brow_line"), 2 / 3.5, 0.02);
  EXPECT_NEAR(guides.at("hairline"), 3 / 3.5, 0.02);

  HeadSpec spec;
  spec.guides = {{"nose_base", 0.30}};
  const NeutralHead moved = build_neutral_head(shipped().heads, spec);
  const auto y = [&](const NeutralHead& head) {
    return head.skin.positions[head.cage.index.find("p_cb")->second].y;
  };
  EXPECT_NEAR(y(moved) - y(adult()), (0.30 - guides.at("nose_base")) * 228.3, 0.6);
}

TEST(shapes, refuses_guide_lines_that_cross) {
  HeadSpec spec;
  spec.guides = {{"eye_line", 0.25}};
  try {
    build_neutral_head(shipped().heads, spec);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(
        e.what(),
        "guide line 'eye_line' meets the one below it; expected the order mouth_line, nose_base, eye_line, "
        "brow_line, hairline from chin to crown on this head");
  }
}

TEST(monotone, passes_its_knots_and_never_overshoots) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> step(0.1, 2), any(-5, 5);
  for (int round = 0; round < 50; ++round) {
    std::vector<glm::dvec2> knots{{0, any(random)}};
    for (int i = 0; i < 6; ++i) knots.emplace_back(knots.back().x + step(random), any(random));
    const MonotoneCurve curve = build_monotone_curve(knots);
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      EXPECT_NEAR(sample_curve(curve, knots[i].x), knots[i].y, 1e-12);
      const double low = std::min(knots[i].y, knots[i + 1].y), high = std::max(knots[i].y, knots[i + 1].y);
      for (double t = 0; t <= 1; t += 0.05) {
        const double value = sample_curve(curve, glm::mix(knots[i].x, knots[i + 1].x, t));
        EXPECT_GE(value, low - 1e-9);
        EXPECT_LE(value, high + 1e-9);
      }
    }
  }
  EXPECT_THROW(build_monotone_curve({{0, 0}}), RunError);
  EXPECT_THROW(build_monotone_curve({{0, 0}, {0, 1}}), RunError);
}

TEST(patterns, name_points_by_stars_and_ranges) {
  EXPECT_TRUE(is_match("E5_9..15", "E5_12"));
  EXPECT_FALSE(is_match("E5_9..15", "E5_8"));
  EXPECT_TRUE(is_match("s3..9_L*", "s4_L10"));
  EXPECT_FALSE(is_match("s3..9_L*", "s2_L10"));
  EXPECT_TRUE(is_match("*_C7..9", "q12_C8"));
  EXPECT_FALSE(is_match("*_C7..9", "q12_C8x"));
  EXPECT_TRUE(is_match("M*_6..12", "MB2_7"));
  try {
    find_points(adult().cage, {"nothing_*"});
    FAIL();
  } catch (const RunError& e) {
    EXPECT_STREQ(e.what(), "pattern 'nothing_*' fits no point of the head");
  }
}

}  // namespace
}  // namespace mien

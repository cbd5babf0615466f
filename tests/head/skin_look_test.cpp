#include "head/skin_look.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "head/occlusion.hpp"
#include "head/skin_masks.hpp"
#include "head/surface.hpp"
#include "places.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

const NeutralHead& average_head() {
  static const NeutralHead head = build_neutral_head(shipped().heads, HeadSpec{});
  return head;
}

Shade find_shade(const Part& skin, const char* point) {
  return skin.palette[skin.shade[average_head().cage.index.at(point)]];
}

// A grid of n x n quads in the plane z = 0, and the same with a wall of height 20 mm along x = 0 to its
// right.
Mesh build_floor(int n, bool has_wall) {
  Mesh mesh;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) mesh.positions.emplace_back(2 * i - n, 2 * j - n, 0);
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  if (has_wall) {
    const auto v = static_cast<std::uint32_t>(mesh.positions.size());
    const auto x = static_cast<float>(n);
    for (const glm::vec3 p : {glm::vec3(x, -x, 0), {x, x, 0}, {x, x, 40}, {x, -x, 40}})
      mesh.positions.push_back(p);
    mesh.triangles.push_back({v, v + 1, v + 2});
    mesh.triangles.push_back({v, v + 2, v + 3});
  }
  update_normals(mesh);
  return mesh;
}

std::vector<std::uint32_t> mirror_none(const Mesh& mesh) {
  std::vector<std::uint32_t> mirror(mesh.positions.size());
  for (std::size_t i = 0; i < mirror.size(); ++i) mirror[i] = static_cast<std::uint32_t>(i);
  return mirror;
}

TEST(occlusion, leaves_a_floor_open_and_shuts_the_sky_beside_a_wall) {
  const Mesh floor = build_floor(20, false), walled = build_floor(20, true);
  for (const float share : measure_openness(floor, mirror_none(floor))) ASSERT_GT(share, 0.98f);
  const std::vector<float> open = measure_openness(walled, mirror_none(walled));
  const std::size_t beside_wall = 10 * 21 + 19, far_away = 10 * 21;
  // Each vertex is its own mirror image here, so only the half of the sky on the wall's side is asked for.
  EXPECT_LT(open[beside_wall], 0.3f);
  EXPECT_GT(open[far_away], 0.8f);
}

// Of a colour over the skin between the mouth and the brows: how unlike its places are.
double find_unevenness(const NeutralHead& head, const Part& skin) {
  double sum = 0, squares = 0, count = 0;
  for (const char* point :
       {"q12_C5", "q11_C5", "q10_C5", "q12_C6", "q11_C6", "q10_C6", "q11_C7", "q10_C7", "s1_C4", "s1_C5",
        "s1_C6", "s1_C7", "s1_F1", "s2_F1", "s3_F1", "s1_F2", "s2_F2"}) {
    const double value = skin.palette[skin.shade[head.cage.index.at(point)]].srgb.b;
    sum += value;
    squares += value * value;
    ++count;
  }
  return std::sqrt(squares / count - sum * sum / count / count);
}

TEST(skin_look, wears_and_grows_uneven_with_age_and_pales_the_lips) {
  HeadSpec spec;
  const auto build = [&](const Mix& age) {
    spec.age = age;
    return build_neutral_head(shipped().heads, spec);
  };
  const Part adult = build_skin_part(average_head(), Look{});
  const NeutralHead half_head = build({{"adult", 0.5}, {"old", 0.5}}), old_head = build({{"old", 1.0}});
  const Part half = build_skin_part(half_head, Look{}), old = build_skin_part(old_head, Look{});
  EXPECT_EQ(adult.wear, 0);
  EXPECT_NEAR(half.wear, 0.5, 1e-6);
  EXPECT_EQ(old.wear, 1);
  EXPECT_GT(find_unevenness(old_head, old), 1.15 * find_unevenness(average_head(), adult));
  const glm::vec3 young_lip = find_shade(adult, "M2_10").srgb, old_lip = find_shade(old, "M2_10").srgb;
  EXPECT_LT(old_lip.r / old_lip.g, 0.97f * young_lip.r / young_lip.g);
  Look painted;
  painted.lips = glm::vec3(0.6f, 0.1f, 0.2f);
  EXPECT_NEAR(find_shade(build_skin_part(old_head, painted), "M2_10").srgb.r,
              find_shade(build_skin_part(average_head(), painted), "M2_10").srgb.r, 0.08);
}

TEST(skin_look, shades_mirror_images_alike) {
  const Part skin = build_skin_part(average_head(), Look{});
  ASSERT_EQ(skin.shade.size(), average_head().skin.positions.size());
  for (std::size_t i = 0; i < skin.shade.size(); ++i) {
    ASSERT_LT(skin.shade[i], skin.palette.size());
    ASSERT_EQ(skin.shade[i], skin.shade[average_head().surface->mirror[i]]);
  }
}

TEST(skin_look, lays_the_grain_flat_without_tearing_it) {
  const Part skin = build_skin_part(average_head(), Look{});
  ASSERT_EQ(skin.grain.size(), skin.rest.positions.size());
  for (const Triangle& triangle : skin.rest.triangles)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
      const float length_mm = glm::distance(skin.rest.positions[a], skin.rest.positions[b]);
      ASSERT_LT(glm::distance(skin.grain[a], skin.grain[b]), 4 * length_mm + 1);
    }
}

// A pattern that met its mirror image in the middle would look like an ink blot.
TEST(skin_look, slants_the_grain_so_that_the_halves_differ) {
  const Part skin = build_skin_part(average_head(), Look{});
  const auto& mirror = average_head().surface->mirror;
  for (std::size_t v = 0; v < skin.grain.size(); v += 101) {
    if (average_head().skin.positions[v].x < 5) continue;
    EXPECT_GT(glm::distance(skin.grain[v], skin.grain[mirror[v]]), 2) << v;
  }
}

TEST(skin_look, keeps_each_pore_at_its_place_of_the_skin_whatever_the_head) {
  const Part grown = build_skin_part(average_head(), Look{});
  HeadSpec young;
  young.age = {{"child", 0.5}, {"infant", 0.5}};
  const Part skin = build_skin_part(build_neutral_head(shipped().heads, young), Look{});
  EXPECT_EQ(skin.grain, grown.grain);
  EXPECT_NE(skin.rest.positions, grown.rest.positions);
}

TEST(skin_masks, stay_between_nothing_and_all) {
  for (const std::vector<float>& mask : paint_skin_masks(average_head()))
    for (const float value : mask) {
      ASSERT_GE(value, 0);
      ASSERT_LE(value, 1);
    }
}

TEST(skin_look, takes_any_skin_from_very_light_to_very_dark) {
  for (const glm::vec3 colour : {glm::vec3(0), {0.18f, 0.11f, 0.08f}, {0.97f, 0.89f, 0.83f}, glm::vec3(1)}) {
    Look look;
    look.skin = colour;
    const Part skin = build_skin_part(average_head(), look);
    EXPECT_LT(skin.palette.size(), 4000u);
    for (const Shade& shade : skin.palette)
      for (const float value : {shade.srgb.x, shade.srgb.y, shade.srgb.z, shade.gloss}) {
        ASSERT_GE(value, 0);
        ASSERT_LE(value, 1);
      }
  }
}

TEST(skin_look, reddens_lips_and_darkens_the_mouth) {
  const Part skin = build_skin_part(average_head(), Look{});
  const auto redness = [&](const char* point) {
    const Shade shade = find_shade(skin, point);
    return shade.srgb.x / shade.srgb.y;
  };
  EXPECT_GT(redness("M2_0"), 1.2f * redness("p_F2"));
  EXPECT_GT(redness("p_tip"), 1.05f * redness("p_F2"));
  EXPECT_LT(find_shade(skin, "MB1_0").srgb.x, 0.6f * find_shade(skin, "p_F2").srgb.x);
  EXPECT_LT(find_shade(skin, "nd_0").srgb.x, 0.5f * find_shade(skin, "p_F2").srgb.x);
  EXPECT_GT(find_shade(skin, "M2_12").gloss, find_shade(skin, "q12_C4").gloss);
}

TEST(skin_look, lets_lips_fade_into_the_skin_and_darken_inward) {
  const Part skin = build_skin_part(average_head(), Look{});
  const auto redness = [&](const std::string& point) {
    const Shade shade = find_shade(skin, point.c_str());
    return shade.srgb.x / shade.srgb.y;
  };
  const auto brightness = [&](const std::string& point) {
    const Shade shade = find_shade(skin, point.c_str());
    return shade.srgb.x + shade.srgb.y + shade.srgb.z;
  };
  for (const char* column : {"_0", "_12"}) {  // from the mouth's line out to the skin
    EXPECT_LT(brightness("M0" + std::string(column)), 0.9f * brightness("M2" + std::string(column)));
    EXPECT_LT(redness("M3" + std::string(column)), redness("M2" + std::string(column)));
  }
  EXPECT_LT(redness("M2_6"), redness("M2_12")) << "corners are paler";
}

TEST(skin_look, shows_blood_on_light_skin_more_than_on_dark) {
  Look dark;
  dark.skin = {0.34f, 0.23f, 0.18f};
  const auto blush = [&](const Look& look) {
    const Part skin = build_skin_part(average_head(), look);
    const auto redness = [&](const char* point) {
      const Shade shade = find_shade(skin, point);
      return shade.srgb.x / shade.srgb.y;
    };
    return redness("q12_C2") / redness("p_F2");
  };
  EXPECT_GT(blush(Look{}), 1.04f);
  EXPECT_LT(blush(dark), 0.7f * (blush(Look{}) - 1) + 1);
}

TEST(skin_look, gives_dark_skin_the_stronger_sheen) {
  Look dark;
  dark.skin = {0.34f, 0.23f, 0.18f};
  EXPECT_GT(compute_lightness(Look{}.skin), 0.9f);
  EXPECT_LT(compute_lightness(dark.skin), 0.2f);
  EXPECT_GT(find_shade(build_skin_part(average_head(), dark), "p_F1").gloss,
            find_shade(build_skin_part(average_head(), Look{}), "p_F1").gloss);
}

TEST(skin_look, paints_lips_in_the_colour_that_was_asked_for) {
  Look look;
  look.lips = glm::vec3(0.2f, 0.2f, 0.8f);
  const Shade lip = find_shade(build_skin_part(average_head(), look), "M2_12");
  EXPECT_GT(lip.srgb.z, 0.6f);
  EXPECT_LT(lip.srgb.x, 0.3f);
}

}  // namespace
}  // namespace mien

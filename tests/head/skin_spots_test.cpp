#include "head/skin_spots.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "places.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

constexpr std::size_t kSpotVertices = 19;  // its middle and two rings of nine

const NeutralHead& adult() {
  static const NeutralHead head = build_neutral_head(shipped().heads, HeadSpec{});
  return head;
}

NeutralHead build_infant() {
  HeadSpec spec;
  spec.age = {{"infant", 1.0}};
  return build_neutral_head(shipped().heads, spec);
}

HeadPart build(const NeutralHead& head, double freckles, double age_spots) {
  Look look;
  look.freckles = freckles;
  look.age_spots = age_spots;
  const std::vector<HeadPart> parts = build_skin_spots(head, look);
  return parts.empty() ? HeadPart{} : parts.front();
}

TEST(skin_spots, are_none_unless_asked_for) { EXPECT_TRUE(build_skin_spots(adult(), Look{}).empty()); }

TEST(skin_spots, lie_at_the_same_places_of_every_head) {
  Look look;
  look.freckles = 0.2;
  look.age_spots = 0.5;
  HeadSpec spec;
  spec.age = {{"child", 1.0}};
  const NeutralHead child = build_neutral_head(shipped().heads, spec);
  const std::vector<HeadPart> own = build_skin_spots(child, look);
  const std::vector<HeadPart> shared =
      build_skin_spots(list_spot_places(adult(), look, false), child, look, false);
  EXPECT_EQ(own.at(0).part.rest.positions, shared.at(0).part.rest.positions);
  EXPECT_EQ(own.at(0).part.shade, shared.at(0).part.shade);
  EXPECT_NE(name_spot_places(look, false), name_spot_places(look, true));
  look.freckles = 0.21;
  EXPECT_NE(name_spot_places(look, false), "spots 0.2 0.5");
}

TEST(skin_spots, are_each_bound_to_the_skin_under_them) {
  const HeadPart spots = build(adult(), 1, 1);
  const Mesh& mesh = spots.part.rest;
  ASSERT_EQ(spots.bindings.size(), mesh.positions.size());
  ASSERT_EQ(spots.part.shade.size(), mesh.positions.size());
  ASSERT_EQ(mesh.positions.size() % kSpotVertices, 0u);
  EXPECT_GT(mesh.positions.size() / kSpotVertices, 200u);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Binding& bound = spots.bindings[i];
    ASSERT_EQ(bound.first, i);
    ASSERT_EQ(bound.count, 1u);
    const auto& [a, b, c] = adult().skin.triangles[bound.triangle];
    const auto& p = adult().skin.positions;
    const glm::vec3 on_skin =
        bound.barycentric.x * p[a] + bound.barycentric.y * p[b] + bound.barycentric.z * p[c];
    ASSERT_NEAR(glm::distance(mesh.positions[i], on_skin), kSpotLift_mm, 1e-3f);
  }
}

TEST(skin_spots, have_one_shade_each_that_fades_outward_and_never_brightens) {
  const Part spots = build(adult(), 1, 1).part;
  ASSERT_EQ(spots.grain.size(), spots.shade.size());
  for (std::size_t s = 0; s < spots.shade.size(); s += kSpotVertices) {
    EXPECT_EQ(spots.grain[s], glm::vec2(0));
    for (std::size_t i = 1; i < kSpotVertices; ++i) {
      ASSERT_EQ(spots.shade[s + i], spots.shade[s]);
      ASSERT_NEAR(glm::length(spots.grain[s + i]), i < 10 ? 0.55f : 1.0f, 1e-5f);
    }
  }
  for (const Shade& shade : spots.palette)
    for (const float channel : {shade.srgb.x, shade.srgb.y, shade.srgb.z}) {
      ASSERT_GT(channel, 0);
      ASSERT_LT(channel, 1);
    }
}

TEST(skin_spots, of_a_higher_dial_are_those_of_a_lower_one_and_more) {
  const HeadPart few = build(adult(), 0.3, 0), many = build(adult(), 0.9, 0);
  ASSERT_GT(many.part.rest.positions.size(), 2 * few.part.rest.positions.size());
  for (std::size_t i = 0; i < few.part.rest.positions.size(); ++i)
    ASSERT_EQ(few.part.rest.positions[i], many.part.rest.positions[i]);
}

TEST(skin_spots, stay_at_their_place_of_the_skin_whatever_the_head) {
  const NeutralHead infant = build_infant();
  const HeadPart grown = build(adult(), 1, 1), young = build(infant, 1, 1);
  ASSERT_EQ(grown.bindings.size(), young.bindings.size());
  for (std::size_t i = 0; i < grown.bindings.size(); ++i) {
    ASSERT_EQ(grown.bindings[i].triangle, young.bindings[i].triangle);
    ASSERT_EQ(grown.bindings[i].barycentric, young.bindings[i].barycentric);
  }
  EXPECT_NE(grown.part.rest.positions, young.part.rest.positions);
}

// No spot lies where a mirrored one would: its nearest neighbour across is hardly ever a double.
TEST(skin_spots, are_not_mirrored) {
  const HeadPart spots = build(adult(), 1, 0);
  const auto& p = spots.part.rest.positions;
  std::size_t doubles = 0, count = 0;
  for (std::size_t i = 0; i < p.size(); i += kSpotVertices, ++count) {
    const glm::vec3 across = p[i] * glm::vec3(-1, 1, 1);
    for (std::size_t j = 0; j < p.size(); j += kSpotVertices)
      if (j != i && glm::distance(p[j], across) < 0.3f) {
        ++doubles;
        break;
      }
  }
  EXPECT_LT(doubles, count / 20);
}

TEST(skin_spots, leave_lips_and_lids_alone) {
  const HeadPart spots = build(adult(), 1, 1);
  for (const char* name : {"M1_0", "M1_12", "M1_4", "E1_4", "E1_12", "E2_4", "nd_0"}) {
    const glm::vec3 place = adult().skin.positions[adult().cage.index.at(name)];
    for (std::size_t i = 0; i < spots.part.rest.positions.size(); i += kSpotVertices)
      ASSERT_GT(glm::distance(spots.part.rest.positions[i], place), 1.0f) << name;
  }
}

}  // namespace
}  // namespace mien

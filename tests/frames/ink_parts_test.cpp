#include "frames/ink_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "drawn_subject.hpp"

namespace mien {
namespace {

constexpr InkView kBefore{{0, 0, 900}, {0, 0, 1}, 1};

const Part& find(const Subject& subject, const char* name) {
  return subject.ink.model.parts[find_part(subject.ink.model, name)];
}

bool is_used(const Part& part, std::uint16_t shade) {
  return std::ranges::find(part.triangle_shade, shade) != part.triangle_shade.end();
}

TEST(ink_parts, a_part_that_is_not_there_is_told) {
  EXPECT_THROW(find_model_part(comic().ink.model, "antlers"), RunError);
}

// The gum's scallops would leave the row in pieces; backs and palate are mouth.
TEST(ink_parts, teeth_and_gum_are_one_white_band) {
  const InkColours colours;
  for (const char* name : {"teeth_upper", "gum_upper"}) {
    const Part& part = find(comic(), name);
    EXPECT_EQ(part.palette[0].srgb, colours.bone) << name;
    EXPECT_EQ(part.palette[1].srgb, colours.cavity) << name;
    EXPECT_TRUE(is_used(part, 0) && is_used(part, 1)) << name;
  }
  EXPECT_EQ(find(comic(), "tooth_strip").palette[0].srgb, colours.bone);
}

// Molars, which are seen from below, would be hooks at the row's ends.
TEST(ink_parts, the_row_of_teeth_ends_before_it_turns_back) {
  for (const char* name : {"teeth_upper", "gum_upper"}) {
    const Part& part = find(comic(), name);
    const Box box = compute_bounds(find(comic(), "teeth_upper").rest.positions);
    for (std::size_t i = 0; i < part.rest.triangles.size(); ++i) {
      if (part.triangle_shade[i] != 0) continue;
      float front_mm = -INFINITY;
      for (int k = 0; k < 3; ++k)
        front_mm = std::max(front_mm, part.rest.positions[part.rest.triangles[i][k]].z);
      EXPECT_GT(front_mm, std::lerp(box.high.z, box.low.z, 0.6f)) << name;
    }
  }
}

// Their edges would be dots.
TEST(ink_parts, the_first_teeth_of_an_infant_are_not_seen) {
  const Subject infant = build_of_age("infant");
  for (const char* name : {"teeth_upper", "gum_upper"})
    for (const Shade& shade : find(infant, name).palette) EXPECT_EQ(shade.srgb, InkColours{}.cavity) << name;
  EXPECT_EQ(find(infant, "tooth_strip").palette[0].srgb, InkColours{}.flesh);
}

// Shade in the dark would be a stain, and light on the lids' edge a chip beside a far eye: over 1 the
// material has one tone.
TEST(ink_parts, the_inside_of_the_mouth_and_the_edge_of_the_lids_have_one_tone) {
  const Part& skin = comic().ink.model.parts.front();
  std::size_t dark = 0, edge = 0;
  for (const Shade& shade : skin.palette) {
    dark += shade.gloss > 1 && shade.srgb == InkColours{}.cavity ? 1 : 0;
    edge += shade.gloss > 1 && shade.srgb != InkColours{}.cavity ? 1 : 0;
  }
  EXPECT_EQ(dark, 1U);
  EXPECT_EQ(edge, 1U);
  const std::uint32_t lid = find_point(comic().figure.head.cage, "E0_4");
  for (std::size_t i = 0; i < skin.rest.triangles.size(); ++i) {
    const Triangle& t = skin.rest.triangles[i];
    const bool is_of_lid = t[0] == lid || t[1] == lid || t[2] == lid;
    EXPECT_TRUE(!is_of_lid || skin.palette[skin.triangle_shade[i]].gloss > 1);
  }
}

// Its shade beside a nostril would be a third one.
TEST(ink_parts, a_button_of_a_nose_has_no_shade) {
  constexpr double kLit = 0.3;  // well over where shade begins: cosine
  constexpr float kNose_mm = 10, kBelow_mm = 5;
  const glm::dvec3 to_light = glm::normalize(glm::dvec3(-0.46, 0.6, 0.66));
  const Subject child = build_of_age("child");
  const Drawing drawing = draw(child, Pose{}, TurnKey{}, {kBefore.camera_mm, to_light, 1});
  const PartShape& skin = drawing.parts.front();
  const glm::vec3 tip = skin.positions[find_point(child.figure.head.cage, "p_tip")];
  std::size_t near = 0, dark = 0;
  for (std::size_t v = 0; v < skin.positions.size(); ++v) {
    if (glm::distance(tip, skin.positions[v]) > kNose_mm * child.ink.eye_size ||
        skin.positions[v].y < tip.y - kBelow_mm)
      continue;
    ++near;
    dark += glm::dot(glm::dvec3(skin.normals[v]), to_light) < kLit ? 1 : 0;
  }
  EXPECT_GT(near, 100U);
  EXPECT_EQ(dark, 0U);
}

TEST(ink_parts, no_hair_comes_through_an_ear) {
  bool is_any_hidden = false;  // or this tells nothing
  for (const char* cut : {"side_part", "crop", "pixie", "curls", "bob", "wavy"}) {
    HeadSpec spec = make_spec("comic");
    spec.hair = cut;
    spec.character = 1;
    const Subject subject = build_subject(spec);
    const Part& mass = find(subject, "hair_mass");
    const std::vector<glm::vec3> bowls = list_ear_bowls(subject.figure.head);
    const auto is_hidden = [&](const glm::vec3& p) { return is_in_ear(bowls, p, subject.ink.eye_size); };
    is_any_hidden = is_any_hidden || std::ranges::any_of(mass.rest.positions, is_hidden);
    for (const Triangle& t : mass.rest.triangles)
      for (int i = 0; i < 3; ++i) EXPECT_FALSE(is_hidden(mass.rest.positions[t[i]])) << cut;
    EXPECT_EQ(mass.rest.triangles.size(), mass.triangle_shade.size()) << cut;
    for (const InkStroke& stroke : subject.ink.strokes)
      for (const StrokePoint& point : stroke.points) {
        if (!stroke.rule.is_on_hair) continue;
        glm::vec3 at(0);
        for (int i = 0; i < 3; ++i) at += point.shares[i] * mass.rest.positions[point.vertices[i]];
        EXPECT_FALSE(is_hidden(at)) << cut;
      }
  }
  EXPECT_TRUE(is_any_hidden);
}

// In the shade it would be a bruise: under 0 the material makes it paler there.
TEST(ink_parts, a_blush_is_paler_in_the_shade) {
  const std::vector<Shade>& palette = build_of_age("child").ink.model.parts.front().palette;
  const std::size_t plain = palette.size() - 1, reddest = plain - 10;
  EXPECT_EQ(palette[reddest].gloss, -1);
  for (std::size_t step = reddest; step < plain; ++step) {
    EXPECT_LT(palette[step].gloss, palette[step + 1].gloss);
    EXPECT_LT(palette[step].srgb.g, palette[step + 1].srgb.g);
  }
  EXPECT_EQ(palette[plain].gloss, 0);
}

}  // namespace
}  // namespace mien

// The parts of the head: closed where solid, mirrored to the bit, seated where they belong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/holes.hpp"
#include "head/binding.hpp"
#include "head/head.hpp"
#include "places.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

const NeutralHead& average_head() {
  static const NeutralHead head = build_neutral_head(shipped().heads, HeadSpec{});
  return head;
}

const NeutralHead& infant_head() {
  static const NeutralHead head = [] {
    HeadSpec spec;
    spec.age = {{"infant", 1.0}};
    return build_neutral_head(shipped().heads, spec);
  }();
  return head;
}

std::vector<HeadPart> build_all(const NeutralHead& head) {
  std::vector<HeadPart> parts;
  for (auto& built : {build_eyes(head, Look{}), build_mouth(head, Look{}), build_hairs(head, Look{})})
    parts.insert(parts.end(), built.begin(), built.end());
  return parts;
}

const std::vector<HeadPart>& average_parts() {
  static const std::vector<HeadPart> parts = build_all(average_head());
  return parts;
}

const HeadPart& find_part(const std::vector<HeadPart>& parts, const std::string& name) {
  for (const HeadPart& part : parts)
    if (part.part.name == name) return part;
  throw std::runtime_error("no part " + name);
}

std::vector<std::string> list_names(const std::vector<HeadPart>& parts) {
  std::vector<std::string> names;
  for (const HeadPart& part : parts) names.push_back(part.part.name);
  return names;
}

TEST(parts, have_the_names_the_model_promises) {
  EXPECT_THAT(
      list_names(build_eyes(average_head(), Look{})),
      testing::ElementsAre("eye_left", "iris_left", "cornea_left", "tear_left", "caruncle_left", "eye_right",
                           "iris_right", "cornea_right", "tear_right", "caruncle_right"));
  EXPECT_THAT(
      list_names(build_mouth(average_head(), Look{})),
      testing::ElementsAre("teeth_upper", "gum_upper", "teeth_lower", "gum_lower", "tongue", "lip_veil"));
  EXPECT_THAT(list_names(build_hairs(average_head(), Look{})),
              testing::ElementsAre("brow_left", "lash_left", "brow_right", "lash_right"));
}

TEST(parts, are_solid_but_for_the_cornea) {
  for (const HeadPart& part : average_parts()) {
    if (part.part.material == "cornea") continue;
    EXPECT_EQ(count_open_edges(part.part.rest.triangles), 0u) << part.part.name;
    EXPECT_GT(compute_volume_mm3(part.part.rest), 0) << part.part.name;
  }
}

TEST(parts, are_finite_with_unit_normals_and_known_shades) {
  for (const HeadPart& part : average_parts()) {
    const Mesh& mesh = part.part.rest;
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size()) << part.part.name;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      ASSERT_TRUE(std::isfinite(mesh.positions[i].x + mesh.positions[i].y + mesh.positions[i].z))
          << part.part.name;
      ASSERT_NEAR(glm::length(mesh.normals[i]), 1, 1e-4) << part.part.name;
    }
    for (const Triangle& triangle : mesh.triangles)
      for (const std::uint32_t v : triangle) ASSERT_LT(v, mesh.positions.size()) << part.part.name;
    ASSERT_TRUE(part.part.shade.empty() || part.part.shade.size() == mesh.positions.size()) << part.part.name;
    for (const std::uint16_t shade : part.part.shade)
      ASSERT_LT(shade, part.part.palette.size()) << part.part.name;
  }
}

TEST(parts, keep_within_their_share_of_the_frame) {
  const auto count = [](const char* name) {
    return find_part(average_parts(), name).part.rest.positions.size();
  };
  EXPECT_LE(count("brow_left"), 4500u);
  EXPECT_LE(count("lash_left"), 1500u);
  EXPECT_LE(
      count("teeth_upper") + count("teeth_lower") + count("gum_upper") + count("gum_lower") + count("tongue"),
      4200u);
  EXPECT_LE(count("lip_veil"), 120u);
  EXPECT_LE(count("eye_left") + count("iris_left") + count("cornea_left") + count("tear_left") +
                count("caruncle_left"),
            4000u);
}

TEST(parts, are_the_same_in_every_run) {
  const std::vector<HeadPart> again = build_all(average_head());
  for (std::size_t i = 0; i < again.size(); ++i) {
    EXPECT_EQ(again[i].part.rest.positions, average_parts()[i].part.rest.positions) << again[i].part.name;
    EXPECT_EQ(again[i].part.shade, average_parts()[i].part.shade) << again[i].part.name;
  }
}

TEST(parts, of_the_right_mirror_those_of_the_left_to_the_bit) {
  for (const char* name : {"eye", "iris", "cornea", "tear", "caruncle", "brow", "lash"}) {
    const HeadPart& left = find_part(average_parts(), std::string(name) + "_left");
    const HeadPart& right = find_part(average_parts(), std::string(name) + "_right");
    ASSERT_EQ(left.part.rest.positions.size(), right.part.rest.positions.size());
    for (std::size_t i = 0; i < left.part.rest.positions.size(); ++i) {
      const glm::vec3 &p = left.part.rest.positions[i], &q = right.part.rest.positions[i];
      ASSERT_TRUE(p.x == -q.x && p.y == q.y && p.z == q.z) << name << " vertex " << i;
    }
    EXPECT_EQ(left.part.shade, right.part.shade);
    EXPECT_GT(glm::dot(left.part.rest.normals[0], left.part.rest.normals[0]), 0.9f);
  }
}

TEST(parts, of_the_mouth_mirror_themselves_to_the_bit) {
  for (const HeadPart& part : build_mouth(average_head(), Look{})) {
    std::vector<std::array<float, 3>> here, mirrored;
    for (const glm::vec3& p : part.part.rest.positions) {
      here.push_back({p.x + 0.0f, p.y, p.z});
      mirrored.push_back({-p.x + 0.0f, p.y, p.z});  // + 0: no negative zero
    }
    std::sort(here.begin(), here.end());
    std::sort(mirrored.begin(), mirrored.end());
    EXPECT_EQ(here, mirrored) << part.part.name;
  }
}

TEST(parts, ride_where_they_belong) {
  for (const HeadPart& part : average_parts()) {
    const std::string& name = part.part.name;
    const bool is_rigid = part.mount != Mount::strands;
    EXPECT_EQ(part.part.is_rigid, is_rigid) << name;
    EXPECT_EQ(part.bindings.empty(), is_rigid) << name;
    const bool is_fine = name.starts_with("cornea") || name.starts_with("tear") || name.starts_with("lash") ||
                         name == "lip_veil";
    EXPECT_EQ(part.part.is_printed, !is_fine) << name;
  }
  EXPECT_EQ(find_part(average_parts(), "iris_left").mount, Mount::eye_left);
  EXPECT_EQ(find_part(average_parts(), "iris_right").mount, Mount::eye_right);
  EXPECT_EQ(find_part(average_parts(), "teeth_upper").mount, Mount::skull);
  for (const char* name : {"teeth_lower", "gum_lower", "tongue"})
    EXPECT_EQ(find_part(average_parts(), name).mount, Mount::jaw) << name;
}

TEST(parts, bindings_cover_every_vertex_once_in_order) {
  for (const HeadPart& part : average_parts()) {
    std::uint32_t next = 0;
    for (const Binding& binding : part.bindings) {
      ASSERT_EQ(binding.first, next) << part.part.name;
      next += binding.count;
      ASSERT_LT(binding.triangle, average_head().skin.triangles.size()) << part.part.name;
      ASSERT_NEAR(binding.barycentric.x + binding.barycentric.y + binding.barycentric.z, 1, 1e-5)
          << part.part.name;
    }
    if (part.mount != Mount::strands) continue;
    EXPECT_EQ(next, part.part.rest.positions.size()) << part.part.name;
  }
}

TEST(parts, hairs_stand_on_the_skin_they_are_bound_to) {
  const Mesh& skin = average_head().skin;
  for (const char* name : {"brow_left", "brow_right", "lash_left", "lash_right"}) {
    const HeadPart& part = find_part(average_parts(), name);
    for (const Binding& binding : part.bindings) {
      const SkinFrame frame = compute_skin_frame(skin.positions, skin.normals,
                                                 skin.triangles[binding.triangle], binding.barycentric);
      ASSERT_LT(glm::distance(frame.origin, part.part.rest.positions[binding.first]), 1.0f) << name;
      ASSERT_EQ(frame.origin.x > 0, std::string(name).ends_with("left")) << name;
    }
  }
}

// A rake of like wires is what lashes must not be: old ones stand beside new ones, and each is thin soon
// after its root.
TEST(parts, lashes_taper_and_are_of_unequal_length) {
  constexpr std::size_t kVertices = 13, kFirst = 24,
                        kLast = 48;  // of a lash; the middle ones of 72 upper ones
  const std::vector<glm::vec3>& points = find_part(average_parts(), "lash_left").part.rest.positions;
  const auto girth_mm = [&](std::size_t ring) { return glm::distance(points[ring], points[ring + 1]); };
  double shortest_mm = 1e9, longest_mm = 0;
  for (std::size_t lash = kFirst; lash < kLast; ++lash) {
    const std::size_t root = kVertices * lash;
    const double length_mm = glm::distance(points[root], points[root + kVertices - 1]);
    shortest_mm = std::min(shortest_mm, length_mm);
    longest_mm = std::max(longest_mm, length_mm);
    EXPECT_LT(girth_mm(root + 6), 0.55f * girth_mm(root)) << lash;  // half way
  }
  EXPECT_LT(shortest_mm, 0.75 * longest_mm);
}

TEST(parts, brow_hairs_lie_along_the_skin) {
  const HeadPart& brow = find_part(average_parts(), "brow_left");
  const SkinPatch patch = build_skin_patch(average_head().skin, compute_bounds(brow.part.rest.positions));
  for (const glm::vec3& p : brow.part.rest.positions)
    ASSERT_LT(glm::distance(find_nearest_place(patch, p).point, p), 0.6f);
}

// The lids' inner sides rest on the ball; only the hidden back edge (EB) lies inside it.
TEST(parts, balls_stay_behind_the_lids) {
  for (const NeutralHead* head : {&average_head(), &infant_head()})
    for (const char* ring : {"E0_", "E1_", "E2_", "E3_", "E4_"})
      for (int i = 0; i < 16; ++i) {
        const glm::vec3 p = head->skin.positions[head->cage.index.at(ring + std::to_string(i))];
        EXPECT_GT(glm::distance(p, glm::vec3(head->eye.centre)), head->eye.radius_mm + 0.1) << ring << i;
      }
}

TEST(parts, irises_look_ahead_or_a_little_outward) {
  const HeadPart& iris = find_part(average_parts(), "iris_left");
  const glm::vec3 axis = iris.part.rest.positions.front() - glm::vec3(average_head().eye.centre);
  const double outward_deg = std::atan2(axis.x, axis.z) * 180 / 3.14159265;
  EXPECT_GT(outward_deg, 0.5);
  EXPECT_LT(outward_deg, 4);
  EXPECT_NEAR(axis.y, 0, 0.01);
}

// What the upper lid keeps off, and the dark rim: an iris as bright above as below is a painted disc.
TEST(parts, irises_are_darker_below_the_upper_lid_and_at_their_rim) {
  const EyeNumbers& eye = average_head().data->parts.eye;
  const Part& iris = find_part(average_parts(), "iris_left").part;
  const glm::vec3 axis = iris.rest.positions.front();
  struct Mean {
    double sum = 0;
    int count = 0;
  } above, below, middle, rim;
  const auto add = [](Mean& mean, double value) { mean.sum += value, ++mean.count; };
  for (std::size_t i = 0; i < iris.rest.positions.size(); ++i) {
    const glm::vec3 from = iris.rest.positions[i] - axis;
    const double radius = std::hypot(from.x, from.y);
    if (radius < eye.iris_inner_mm[0] + 0.1) continue;
    const glm::vec3 colour = iris.palette[iris.shade[i]].srgb;
    const double light = colour.r + colour.g + colour.b;
    if (std::abs(from.y) > 2.5) add(from.y > 0 ? above : below, light);
    if (from.y < 0 && radius > eye.limbus_mm - 0.5) add(rim, light);
    if (from.y < 0 && radius > 3 && radius < 4) add(middle, light);
  }
  const auto mean = [](const Mean& of) { return of.sum / of.count; };
  EXPECT_LT(mean(above), 0.75 * mean(below));
  EXPECT_LT(mean(rim), 0.6 * mean(middle));
}

// Bare teeth, right behind the lips: no vertex comes nearer than half a millimetre to the flesh, or into it.
TEST(parts, teeth_stay_behind_the_lips) {
  for (const NeutralHead* head : {&average_head(), &infant_head()}) {
    const glm::vec3 lips = head->skin.positions[head->cage.index.at("M1_0")];
    const double scale = head->skin.positions[head->cage.index.at("M1_6")].x / 24.24;
    const auto reach = static_cast<float>(30 * scale);
    const SkinPatch patch = build_skin_patch(head->skin, {lips - reach, lips + reach});
    for (const HeadPart& part : build_mouth(*head, Look{})) {
      if (!part.part.name.starts_with("teeth")) continue;
      double nearest = 1e9;
      for (const glm::vec3& p : part.part.rest.positions) {
        if (std::abs(p.x) > 15 * scale || std::abs(p.y - lips.y) > 4 * scale) continue;
        const SkinPlace place = find_nearest_place(patch, p);
        nearest = std::min(nearest, static_cast<double>(glm::dot(p - place.point, place.normal)));
      }
      EXPECT_GT(nearest, 0.5 * scale) << part.part.name;
    }
  }
}

// Anywhere, teeth and gums are deep in the mouth: at least 2 mm of flesh before the face's outside.
TEST(parts, mouth_never_shows_through_the_cheeks) {
  const NeutralHead& head = average_head();
  for (const char* ring : {"M2_", "M3_", "M4_", "MA_", "M5_", "M6_"})
    for (int i = 0; i <= 12; ++i) {
      const glm::vec3 p = head.skin.positions[head.cage.index.at(ring + std::to_string(i))];
      for (const HeadPart& part : build_mouth(head, Look{}))
        for (const glm::vec3& q : part.part.rest.positions)
          ASSERT_GT(glm::distance(p, q), 2.0f) << part.part.name;
    }
}

// An open mouth must not show the light behind the head.
TEST(parts, the_mouth_behind_them_has_no_slits) {
  const std::vector<Loop> loops = find_boundary_loops(average_head().skin.triangles);
  EXPECT_EQ(loops.size(), 3u);  // two eyes and the chest
  for (const Loop& loop : loops) EXPECT_GE(loop.size(), 64u);
}

TEST(parts, fit_an_infant_as_they_fit_an_adult) {
  for (const HeadPart& part : build_all(infant_head()))
    for (const Binding& binding : part.bindings) {
      const Mesh& skin = infant_head().skin;
      const SkinFrame frame = compute_skin_frame(skin.positions, skin.normals,
                                                 skin.triangles[binding.triangle], binding.barycentric);
      ASSERT_LT(glm::distance(frame.origin, part.part.rest.positions[binding.first]), 4.0f) << part.part.name;
    }
}

}  // namespace
}  // namespace mien

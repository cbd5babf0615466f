// Teeth, gums and tongue of heads of all ages: how many, how large, where.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "head/binding.hpp"
#include "head/dental_arch.hpp"
#include "head/head.hpp"
#include "places.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

NeutralHead build_aged(const Mix& age) {
  HeadSpec spec;
  spec.age = age;
  return build_neutral_head(shipped().heads, spec);
}

const std::vector<HeadPart>& mouth_of(const std::string& age) {
  static std::map<std::string, std::vector<HeadPart>> mouths;
  auto& mouth = mouths[age];
  if (mouth.empty()) mouth = build_mouth(build_aged({{age, 1.0}}), Look{});
  return mouth;
}

const Part& find_part(const std::vector<HeadPart>& parts, const std::string& name) {
  for (const HeadPart& part : parts)
    if (part.part.name == name) return part.part;
  throw std::runtime_error("no part " + name);
}

// The bodies of a mesh: sets of vertices that triangles join.
std::vector<std::vector<std::uint32_t>> split_bodies(const Mesh& mesh) {
  std::vector<std::uint32_t> root(mesh.positions.size());
  std::iota(root.begin(), root.end(), 0u);
  const auto find = [&](std::uint32_t v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for (const auto& [a, b, c] : mesh.triangles) root[find(a)] = root[find(b)] = find(c);
  std::map<std::uint32_t, std::vector<std::uint32_t>> bodies;
  for (std::uint32_t v = 0; v < root.size(); ++v) bodies[find(v)].push_back(v);
  std::vector<std::vector<std::uint32_t>> list;
  for (auto& [first, body] : bodies) list.push_back(std::move(body));
  return list;
}

// The teeth of a row that stand out of the gum by more than a millimetre: over or under all gum within their
// width.
int count_teeth(const std::vector<HeadPart>& mouth, const std::string& row) {
  const Mesh& teeth = find_part(mouth, "teeth_" + row).rest;
  const Mesh& gum = find_part(mouth, "gum_" + row).rest;
  const float sign = row == "upper" ? -1 : 1;
  int count = 0;
  for (const auto& body : split_bodies(teeth)) {
    std::vector<glm::vec3> points;
    for (const std::uint32_t v : body) points.push_back(teeth.positions[v]);
    const Box box = compute_bounds(points);
    const glm::vec3 middle = 0.5f * (box.low + box.high);
    float edge = -1e9f, margin = -1e9f;
    for (const glm::vec3& p : points) edge = std::max(edge, sign * p.y);
    for (const glm::vec3& p : gum.positions)
      if (glm::distance(glm::vec2(p.x, p.z), glm::vec2(middle.x, middle.z)) < 6)
        margin = std::max(margin, sign * p.y);
    count += edge > margin + 0.6f;
  }
  return count;
}

double find_width_mm(const std::string& age) {  // of the first upper incisor of the left
  const Mesh& teeth = find_part(mouth_of(age), "teeth_upper").rest;
  const auto body = split_bodies(teeth).front();
  std::vector<glm::vec3> points;
  for (const std::uint32_t v : body) points.push_back(teeth.positions[v]);
  const Box box = compute_bounds(points);
  return box.high.x - box.low.x;
}

TEST(mouth, has_the_teeth_of_its_age) {
  EXPECT_EQ(count_teeth(mouth_of("infant"), "upper"), 4);  // at one year: incisors
  EXPECT_EQ(count_teeth(mouth_of("infant"), "lower"), 2);
  for (const char* row : {"upper", "lower"}) {
    EXPECT_EQ(count_teeth(mouth_of("child"), row), 10) << row;  // all milk teeth
    EXPECT_EQ(count_teeth(mouth_of("teenager"), row), 14) << row;
    EXPECT_EQ(count_teeth(mouth_of("adult"), row), 14) << row;
  }
}

TEST(mouth, loses_its_front_teeth_between_child_and_teenager) {
  const std::vector<HeadPart> seven = build_mouth(build_aged({{"child", 0.83}, {"teenager", 0.17}}), Look{});
  const Mesh& teeth = find_part(seven, "teeth_upper").rest;
  const Mesh& gum = find_part(seven, "gum_upper").rest;
  const auto lowest = [](const Mesh& mesh, float reach_mm) {
    float low = 1e9f;
    for (const glm::vec3& p : mesh.positions)
      if (std::abs(p.x) < reach_mm) low = std::min(low, p.y);
    return low;
  };
  EXPECT_GT(lowest(teeth, 4), lowest(gum, 4) - 1);  // the middle ones have fallen
  EXPECT_LT(lowest(teeth, 9), lowest(gum, 9) - 2);  // their neighbours have not
}

TEST(mouth, has_smaller_and_whiter_teeth_as_a_child) {
  EXPECT_LT(find_width_mm("child"), 0.8 * find_width_mm("adult"));
  const auto find_white = [](const std::string& age) {
    const Part& teeth = find_part(mouth_of(age), "teeth_upper");
    float blue = 0;
    for (const std::uint16_t s : teeth.shade) blue = std::max(blue, teeth.palette[s].srgb.z);
    return blue;
  };
  EXPECT_GT(find_white("child"), find_white("adult") + 0.03f);
}

TEST(mouth, of_an_adult_has_arches_as_deep_as_people_have) {
  for (const char* row : {"teeth_upper", "teeth_lower"}) {
    const Box box = compute_bounds(find_part(mouth_of("adult"), row).rest.positions);
    EXPECT_GE(box.high.z - box.low.z, 33) << row;
    EXPECT_LE(box.high.z - box.low.z, 37) << row;
    EXPECT_GE(box.high.x, 24) << row;
    EXPECT_LE(box.high.x, 33) << row;
  }
}

// The cavity's skin lies around the teeth, not before them.
TEST(mouth, has_its_teeth_inside_the_cavity) {
  for (const char* age : {"infant", "child", "adult"}) {
    const NeutralHead head = build_aged({{age, 1.0}});
    const auto at = [&](const char* name) { return head.skin.positions[head.cage.index.at(name)]; };
    const glm::vec3 reach(60, 40, 60);
    const SkinPatch patch =
        build_skin_patch(head.skin, {at("M1_0") - reach, at("M1_0") + glm::vec3(60, 40, 2)});
    for (const HeadPart& part : build_mouth(head, Look{})) {
      if (!part.part.name.starts_with("teeth")) continue;
      const float edge = part.mount == Mount::skull ? compute_bounds(part.part.rest.positions).low.y
                                                    : compute_bounds(part.part.rest.positions).high.y;
      for (const glm::vec3& p : part.part.rest.positions) {
        if (std::abs(p.y - edge) > 2) continue;  // the crowns' ends: what an open mouth shows
        const SkinPlace place = find_nearest_place(patch, p);
        ASSERT_GT(glm::dot(p - place.point, place.normal), 0) << age << " " << part.part.name << " " << p.x;
      }
    }
  }
}

TEST(mouth, is_darker_toward_the_back) {
  for (const char* name : {"teeth_upper", "teeth_lower", "gum_upper", "gum_lower", "tongue"}) {
    const Part& part = find_part(mouth_of("adult"), name);
    const Box box = compute_bounds(part.rest.positions);
    std::array<double, 2> light{}, count{};  // of the front and of the back third
    for (std::size_t i = 0; i < part.shade.size(); ++i) {
      const float back = (box.high.z - part.rest.positions[i].z) / (box.high.z - box.low.z);
      if (back > 0.33f && back < 0.67f) continue;
      light[back > 0.5f] += part.palette[part.shade[i]].srgb.y;
      ++count[back > 0.5f];
    }
    EXPECT_LT(light[1] / count[1], 0.7 * light[0] / count[0]) << name;
  }
}

TEST(mouth, has_a_scalloped_gum) {
  const MouthNumbers numbers = shipped().stock.head->parts.mouth;
  const Mesh& gum = find_part(mouth_of("adult"), "gum_upper").rest;
  // Between the two first incisors the gum comes down; over the middle of one it does not.
  const auto lowest_at = [&](float x) {
    float low = 1e9f, nearest = 1e9f;
    for (const glm::vec3& p : gum.positions) nearest = std::min(nearest, std::abs(p.x - x));
    for (const glm::vec3& p : gum.positions)
      if (std::abs(p.x - x) < nearest + 0.3f) low = std::min(low, p.y);
    return low;
  };
  EXPECT_GT(lowest_at(4) - lowest_at(0), 0.7 * numbers.scallop_mm);
}

TEST(mouth, tongue_rests_behind_the_lower_teeth_and_between_them) {
  for (const char* age : {"infant", "child", "adult"}) {
    const Mesh& tongue = find_part(mouth_of(age), "tongue").rest;
    const Mesh& teeth = find_part(mouth_of(age), "teeth_lower").rest;
    float tip = -1e9f, front = 1e9f;
    for (const glm::vec3& p : tongue.positions) tip = std::max(tip, p.z);
    for (const glm::vec3& p : teeth.positions)
      if (std::abs(p.x) < 1) front = std::min(front, p.z);
    EXPECT_LT(tip, front) << age;
    const float wide = compute_bounds(tongue.positions).high.x;
    EXPECT_LT(wide, compute_bounds(teeth.positions).high.x) << age;
    // The groove: along the middle it is lower than beside it.
    float middle = -1e9f, beside = -1e9f;
    const Box box = compute_bounds(tongue.positions);
    for (const glm::vec3& p : tongue.positions) {
      if (std::abs(p.z - 0.5f * (box.low.z + box.high.z)) > 4) continue;
      if (std::abs(p.x) < 0.2f) middle = std::max(middle, p.y);
      if (std::abs(p.x) > 0.2f * wide) beside = std::max(beside, p.y);
    }
    EXPECT_LT(middle, beside) << age;
  }
}

TEST(mouth, takes_the_age_of_a_scan_from_its_size) {
  NeutralHead head = build_aged({{"child", 1.0}});
  head.ages.clear();
  EXPECT_EQ(count_teeth(build_mouth(head, Look{}), "upper"), 10);
  head = build_aged({{"adult", 1.0}});
  head.ages.clear();
  EXPECT_EQ(count_teeth(build_mouth(head, Look{}), "upper"), 14);
}

}  // namespace
}  // namespace mien

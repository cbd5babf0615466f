// Where drawn hair ends beside the face and at the nape.
#include "head/hair_edge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "head/hair.hpp"
#include "head/landmarks.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

constexpr std::array kHanging{"bob", "long", "wavy"};

NeutralHead make_drawn(const char* age, const char* design = "comic") {
  HeadSpec spec;
  spec.age = {{age, 1.0}};
  spec.design = {{design, 1.0}};
  return build_neutral_head(shipped().heads, spec);
}

Mesh make_drawn_mass(const NeutralHead& head, const char* cut) {
  return build_hair(head, cut, Look{}, true)[0].part.rest;
}

// The mean of some vertices of the skin.
glm::dvec3 find_spot(const NeutralHead& head, const char* name) {
  const SkinSpot spot = find_place(head, name);
  glm::dvec3 at(0);
  for (std::size_t i = 0; i < spot.vertices.size(); ++i)
    at += spot.shares[i] * glm::dvec3(head.skin.positions[spot.vertices[i]]);
  return at;
}

TEST(hair_edge, leaves_the_eye_free_in_profile) {
  constexpr double kHigh_mm = 4;
  for (const char* design : {"comic", "manga"})
    for (const char* age : {"infant", "child", "teenager", "adult", "old"}) {
      const NeutralHead head = make_drawn(age, design);
      const glm::dvec3 corner = find_spot(head, "ex");
      for (const char* cut : kHanging) {
        double front_mm = -1e9;
        for (const glm::vec3& p : make_drawn_mass(head, cut).positions)
          if (std::abs(p.y - corner.y) < kHigh_mm) front_mm = std::max(front_mm, double(p.z));
        EXPECT_LT(front_mm, corner.z) << design << ' ' << age << ' ' << cut;
      }
    }
}

TEST(hair_edge, is_shorter_at_the_nape_than_beside_the_face) {
  constexpr double kShorter_mm = 4;
  const NeutralHead head = make_drawn("adult");
  for (const char* cut : kHanging) {
    const Mesh mass = make_drawn_mass(head, cut);
    double back = 1e9, beside = 1e9, hind = 1e9, fore = -1e9;
    for (const glm::vec3& p : mass.positions) {
      hind = std::min(hind, double(p.z));
      fore = std::max(fore, double(p.z));
    }
    for (const glm::vec3& p : mass.positions) {
      const double share = (p.z - hind) / (fore - hind);
      if (share < 0.2) back = std::min(back, double(p.y));
      if (share > 0.5) beside = std::min(beside, double(p.y));
    }
    EXPECT_GT(back, beside + kShorter_mm) << cut;
  }
}

// A step or a tooth at the temple looks torn.
TEST(hair_edge, comes_down_in_one_line_from_the_fringe_to_before_an_ear) {
  constexpr double kLeastFall_mm = 0.01;
  for (const char* age : {"infant", "child", "adult", "old"}) {
    const NeutralHead head = make_drawn(age);
    for (const char* name : {"crop", "side_part", "pixie", "curls"}) {
      HairCut cut = shipped().stock.head->hair.cuts.at(name);
      cut.is_drawn = true;
      const HairScene scene = build_hair_scene(head, cut);
      std::vector<std::pair<double, double>> left, right;  // azimuth and way, from the temple to the tip
      double tip_deg = 0;
      for (const DrawnLock& lock : list_drawn_locks(scene))
        if (lock.lean == 0 && lock.tip_deg < 180) tip_deg = lock.tip_deg;
      ASSERT_GT(tip_deg, 50) << name;
      for (const DrawnEdge& at : trace_drawn_edge(scene)) {
        const double azimuth = wrap_azimuth(at.turn_deg);
        if (std::abs(azimuth) < 48 || std::abs(azimuth) > tip_deg) continue;
        (azimuth > 0 ? left : right).emplace_back(std::abs(azimuth), at.way * scene.chart.drop_mm);
      }
      for (auto* side : {&left, &right}) {
        std::ranges::sort(*side);
        ASSERT_GT(side->size(), 6u) << age << ' ' << name;
        double steepness = 0;
        for (std::size_t i = 1; i < side->size(); ++i) {
          const double down_mm = (*side)[i].second - (*side)[i - 1].second,
                       aside_deg = (*side)[i].first - (*side)[i - 1].first;
          EXPECT_GT(down_mm, kLeastFall_mm) << age << ' ' << name << ' ' << (*side)[i].first;
          EXPECT_GT(down_mm / aside_deg, 0.9 * steepness) << "and ever steeper " << age << ' ' << name;
          steepness = down_mm / aside_deg;
        }
      }
    }
  }
}

}  // namespace
}  // namespace mien

#include "head/hair_strand.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/conventions.hpp"
#include "head/hair.hpp"
#include "head/hair_comb.hpp"
#include "head/hair_locks.hpp"
#include "head/hair_mass.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

const NeutralHead& adult() {
  static const NeutralHead head = build_neutral_head(shipped().heads, HeadSpec{});
  return head;
}

HairScene build_scene(const char* cut) {
  return build_hair_scene(adult(), shipped().stock.head->hair.cuts.at(cut));
}

double measure_high_mm(const HairScene& scene, const glm::dvec3& point) {
  const HairPlace place = compute_hair_place(scene.chart, point);
  return glm::distance(point, compute_hair_point(scene.chart, place, compute_ground_mm(scene, place)));
}

// Else locks that lay over each other pass through one another where they meet.
TEST(hair_strand, keeps_its_height_where_it_falls_in) {
  for (const char* name : {"bob", "long"}) {
    const HairScene scene = build_scene(name);
    const std::vector<HairStrand> families = grow_families(scene);
    double moved_mm = 0;
    for (std::uint32_t i = 0; i < 60; ++i) {
      const HairPlace root{-170 + 5.6 * i, 0.5};
      const HairStrand before = grow_strand(scene, root, i, i);
      if (before.points.empty()) continue;
      HairStrand after = before;
      fall_in(scene, *find_family(scene, families, root), after);
      for (std::size_t k = 0; k < before.points.size(); ++k) {
        EXPECT_NEAR(measure_high_mm(scene, after.points[k]), measure_high_mm(scene, before.points[k]), 0.02)
            << name << " " << i;
        moved_mm = std::max(moved_mm, glm::distance(after.points[k], before.points[k]));
      }
    }
    EXPECT_GT(moved_mm, 2) << name;
  }
}

// Long pieces over a round crown cut through the locks beside them.
TEST(hair_strand, turns_little_between_two_of_its_rings) {
  const HairScene scene = build_scene("long");
  double worst_mm = 0;
  for (std::uint32_t i = 0; i < 60; ++i) {
    const HairStrand strand = grow_strand(scene, trace_to_part(scene, {-170 + 5.6 * i, 0.5}, i), i, i);
    for (std::size_t k = 3; k < strand.points.size(); ++k) {
      // How far the middle of a piece lies below an arc that is tangent at its ends.
      const glm::dvec3 way = strand.points[k] - strand.points[k - 1];
      const double turn = std::acos(std::clamp(glm::dot(strand.outs[k], strand.outs[k - 1]), -1.0, 1.0));
      worst_mm = std::max(worst_mm, glm::length(way) * turn / 8);
    }
  }
  EXPECT_LT(worst_mm, 1.1);
}

// Else one straight piece dips under its neighbour's corner and out again: a row of chips.
TEST(hair_strand, has_its_rings_where_its_neighbours_have_theirs) {
  for (const char* name : {"bob", "long", "wavy"}) {
    HairScene scene = build_scene(name);
    scene.cut.locks.wave_mm = 0;  // which moves them aside
    ASSERT_GT(scene.ring_stations.size(), 10u) << name;
    ASSERT_TRUE(std::ranges::is_sorted(scene.ring_stations)) << name;
    int inner = 0;
    for (std::uint32_t i = 0; i < 90; ++i) {
      const HairStrand strand = grow_strand(scene, {-175 + 3.9 * i, 0.2 + 0.006 * i}, i, i);
      for (std::size_t k = 1; k + 2 < strand.points.size(); ++k, ++inner) {
        const double gone_mm = compute_combed_mm(scene, compute_hair_place(scene.chart, strand.points[k]));
        double off_mm = 1e9;
        for (const double station : scene.ring_stations)
          off_mm = std::min(off_mm, std::abs(station - gone_mm));
        ASSERT_LT(off_mm, 0.4) << name << " " << i << " " << k;
      }
    }
    EXPECT_GT(inner, 400) << name;
  }
}

// Else the mass beside it is bare, a board between two rows of tufts.
TEST(hair_locks, of_short_hair_begin_at_its_part) {
  constexpr double kBeside_mm = 6;
  for (const char* name : {"crop", "side_part", "pixie"}) {
    const HairScene scene = build_scene(name);
    HeadPart part;
    append_locks(part, scene);
    int beside = 0;
    for (const Binding& lock : part.bindings) {
      const glm::dvec3 root(part.part.rest.positions[lock.first]);
      const HairPlace place = compute_hair_place(scene.chart, root);
      if (compute_part_distance_mm(scene, place) > kBeside_mm) continue;
      beside += measure_high_mm(scene, root) > compute_mass_height_mm(scene, place) ? 1 : 0;
    }
    EXPECT_GT(beside, 100) << name;
  }
}

// As the mass below them waves, else some rise through others.
TEST(hair_strand, waves_outward_as_all_do) {
  HairScene scene = build_scene("wavy"), straight = scene;
  straight.cut.locks.wave_mm = 0;
  const HairPlace root{60, 0.5};
  for (const std::uint32_t family : {3u, 4u, 5u}) {
    const HairStrand waved = grow_strand(scene, root, 7, family),
                     plain = grow_strand(straight, root, 7, family);
    // Where rings lie at even steps in one and by the turn in the other only their ends are the same.
    const glm::dvec3 &tip = waved.points.back(), &foot = plain.points.back(), &out = plain.outs.back();
    const double wave = compute_wave(scene, compute_hair_place(scene.chart, foot));
    const double wanted_mm =
        0.5 * scene.cut.locks.wave_mm * scene.chart.size * (1 + std::cos(2 * std::numbers::pi * wave));
    EXPECT_NEAR(glm::dot(tip - foot, out), wanted_mm, 0.3) << family;
  }
}

TEST(hair_locks, come_up_strand_by_strand) {
  constexpr double kRoot = 4;  // of the grain: up to there strands begin (materials.inc)
  const HairScene scene = build_scene("long");
  const HairStrand strand = grow_strand(scene, {60, 0.5}, 7, 7);
  HeadPart at_once, slowly;
  append_lock(at_once, find_seat(scene, strand.root), strand, 3, 0.5, 7, {});
  append_lock(slowly, find_seat(scene, strand.root), strand, 3, 0.5, 7, {.comes_up = 0.3});
  const std::vector<double> ways = compute_ways(strand);
  for (std::size_t v = 0; v < slowly.part.grain.size(); ++v) {
    const double way = ways[v / 2];
    if (way > 0 && way < 0.3) {
      EXPECT_LE(slowly.part.grain[v].y, kRoot);
      EXPECT_LT(slowly.part.grain[v].y, at_once.part.grain[v].y);
    } else {
      EXPECT_EQ(slowly.part.grain[v].y, at_once.part.grain[v].y);
    }
  }
}

// Streaks across it would be the rungs of a ladder.
TEST(hair_mass, edges_that_run_down_have_one_grain) {
  constexpr std::size_t kColumns = 120, kRows = 30;
  for (const char* name : {"long", "wavy"}) {
    const std::vector<HeadPart> parts = build_hair(adult(), name, Look{}, false);
    const auto mass = std::find_if(parts.begin(), parts.end(),
                                   [](const HeadPart& part) { return part.part.name == "hair_mass"; });
    ASSERT_NE(mass, parts.end());
    int steep = 0;
    const auto find_end = [&](std::size_t column) { return 1 + column * kRows + kRows - 1; };
    for (std::size_t column = 0; column + 1 < kColumns; ++column) {
      const std::size_t a = find_end(column), b = find_end(column + 1);
      const float down_mm = std::abs(mass->part.rest.positions[a].y - mass->part.rest.positions[b].y);
      const double azimuth_deg = std::abs(360 * (static_cast<double>(column) + 1) / kColumns - 180);
      if (down_mm < 25 || azimuth_deg > 82) continue;  // behind that it ends in tips
      ++steep;
      EXPECT_LT(std::abs(mass->part.grain[a].x - mass->part.grain[b].x), 3) << name << " " << column;
    }
    EXPECT_GE(steep, 2) << name;
  }
}

}  // namespace
}  // namespace mien

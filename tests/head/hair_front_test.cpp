// Where hair meets the face: a curtain from a part, a fringe, the border of short hair.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "head/hair_comb.hpp"
#include "head/hair_locks.hpp"
#include "head/hair_mass.hpp"
#include "head/hair_strand.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

NeutralHead build(const char* age) {
  HeadSpec spec;
  spec.age = {{age, 1.0}};
  return build_neutral_head(shipped().heads, spec);
}

HairScene build_scene(const NeutralHead& head, const char* cut) {
  return build_hair_scene(head, shipped().stock.head->hair.cuts.at(cut));
}

HeadPart grow_locks(const HairScene& scene) {
  HeadPart part;
  append_locks(part, scene);
  return part;
}

// Beyond a border, mm along a meridian; less than 0 within it.
double measure_beyond_mm(const HairScene& scene, const HairBorder& border, const HairPlace& place) {
  return (place.way - sample_border(border, place.azimuth_deg)) * scene.chart.drop_mm;
}

// Combed from a part it goes along the border where it ends: over it the face would have strands, and far
// within it a flat board above a bare hairline.
TEST(hair_front, runs_along_its_border_over_an_open_forehead) {
  constexpr double kForehead_deg = 42, kCurtain_deg = 30, kBeyond_mm = 7, kWithin_mm = 9;
  constexpr int kBins = 5;  // of either side
  for (const char* name : {"long", "wavy"})
    for (const char* age : {"infant", "child", "adult", "old"}) {
      const NeutralHead head = build(age);
      HairScene scene = build_scene(head, name);
      scene.cut.locks.wave_mm = 0;
      std::vector<HairPlace> roots = spread_front_roots(scene, 80);
      for (const HairPlace& root : spread_part_roots(scene, 120)) roots.push_back(root);
      std::vector<int> near(static_cast<std::size_t>(2) * kBins, 0);
      for (std::uint32_t i = 0; i < roots.size(); ++i)
        for (const glm::dvec3& point : grow_strand(scene, roots[i], i, i).points) {
          const HairPlace place = compute_hair_place(scene.chart, point);
          if (std::abs(place.azimuth_deg) > kForehead_deg) continue;
          const double beyond_mm = measure_beyond_mm(scene, scene.ends, place);
          EXPECT_LT(beyond_mm, kBeyond_mm * scene.chart.size)
              << name << ' ' << age << ' ' << place.azimuth_deg;
          const int bin = kBins + static_cast<int>(std::floor(place.azimuth_deg * kBins / kCurtain_deg));
          if (beyond_mm > -kWithin_mm && bin >= 0 && bin < 2 * kBins) ++near[static_cast<std::size_t>(bin)];
        }
      EXPECT_GT(*std::ranges::min_element(near), 0) << name << ' ' << age << ": there it does not reach it";
    }
}

// Teeth of the mass would stand in the forehead beside the locks.
TEST(hair_front, has_a_mass_that_ends_evenly_where_hair_grows) {
  constexpr std::size_t kColumns = 120, kRows = 30;
  constexpr double kForehead_deg = 44, kStep_mm = 6;
  for (const char* name : {"long", "wavy"})
    for (const char* age : {"infant", "child", "adult", "old"}) {
      const NeutralHead head = build(age);
      const HairScene scene = build_scene(head, name);
      const std::vector<HeadPart> parts = build_hair(head, name, Look{}, false);
      const auto mass =
          std::ranges::find_if(parts, [](const HeadPart& part) { return part.part.name == "hair_mass"; });
      ASSERT_NE(mass, parts.end());
      double before_mm = 0;
      int asked = 0;
      for (std::size_t column = 0; column < kColumns; ++column) {
        if (std::abs(360 * (static_cast<double>(column) + 0.5) / kColumns - 180) > kForehead_deg) continue;
        const glm::dvec3 end(mass->part.rest.positions[1 + column * kRows + kRows - 1]);
        const double beyond_mm =
            measure_beyond_mm(scene, scene.hairline, compute_hair_place(scene.chart, end));
        EXPECT_LT(beyond_mm, 0.2) << name << ' ' << age << ' ' << column;
        if (asked++ > 0) {
          EXPECT_NEAR(beyond_mm, before_mm, kStep_mm) << name << ' ' << age << ' ' << column;
        }
        before_mm = beyond_mm;
      }
      EXPECT_EQ(asked, 30) << name;
    }
}

// The share of a line at a height that no lock crosses, before the face within `half_mm` of its middle.
double measure_bare(const Mesh& locks, double high_mm, double half_mm) {
  constexpr double kCell_mm = 0.1;
  std::vector<bool> is_bare(static_cast<std::size_t>(2 * half_mm / kCell_mm), true);
  for (const Triangle& t : locks.triangles) {
    double left = 1e9, right = -1e9;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 a(locks.positions[t[k]]), b(locks.positions[t[(k + 1) % 3]]);
      if ((a.y > high_mm) == (b.y > high_mm) || a.z < 0) continue;
      const double x = std::lerp(a.x, b.x, (high_mm - a.y) / (b.y - a.y));
      left = std::min(left, x);
      right = std::max(right, x);
    }
    for (double x = std::max(left, -half_mm); x < std::min(right, half_mm - kCell_mm); x += kCell_mm)
      is_bare[static_cast<std::size_t>((x + half_mm) / kCell_mm)] = false;
  }
  return static_cast<double>(std::ranges::count(is_bare, true)) / static_cast<double>(is_bare.size());
}

// From its tips, which are apart, up to where the mass begins.
TEST(hair_front, of_a_fringe_is_full) {
  constexpr double kHalf_mm = 32, kMost = 0.04;
  double bare = 0;
  int heights = 0;
  for (const char* age : {"infant", "child", "adult", "old"}) {
    const NeutralHead head = build(age);
    const HairScene scene = build_scene(head, "bob");
    const Mesh locks = grow_locks(scene).part.rest;
    for (double above_mm = 6; above_mm < 16; ++above_mm, ++heights) {
      const HairPlace at{0, sample_border(scene.ends, 0) - above_mm * scene.chart.size / scene.chart.drop_mm};
      const double high_mm = compute_hair_point(scene.chart, at, compute_ground_mm(scene, at)).y;
      bare += measure_bare(locks, high_mm, kHalf_mm * scene.chart.size);
    }
  }
  EXPECT_LT(bare / heights, kMost);
}

TEST(hair_front, of_short_hair_runs_out_in_single_hairs) {
  for (const char* name : {"crop", "side_part"}) {
    const NeutralHead head = build("adult");
    const HairScene scene = build_scene(head, name);
    const HeadPart part = grow_locks(scene);
    double at_border = 0, within = 0;
    int many = 0, more = 0;
    for (const Binding& lock : part.bindings) {
      const std::vector<glm::vec3>& points = part.part.rest.positions;
      const double inside_mm =
          compute_inside_mm(scene, compute_hair_place(scene.chart, glm::dvec3(points[lock.first])));
      double width_mm = 0;
      for (std::uint32_t v = lock.first; v + 2 < lock.first + lock.count; v += 2)
        width_mm = std::max(width_mm, double(glm::distance(points[v], points[v + 1])));
      if (inside_mm < 3) at_border += width_mm, ++many;
      if (inside_mm > 14 && inside_mm < 26) within += width_mm, ++more;
    }
    ASSERT_GT(many, 40) << name;
    ASSERT_GT(more, 40) << name;
    EXPECT_LT(at_border / many, 0.5 * within / more) << name;
  }
}

}  // namespace
}  // namespace mien

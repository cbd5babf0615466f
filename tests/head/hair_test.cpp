#include "head/hair.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <functional>
#include <map>
#include <numeric>
#include <utility>

#include <algorithm>
#include <cmath>

#include "config/words.hpp"
#include "core/conventions.hpp"
#include "core/data.hpp"
#include "core/error.hpp"
#include "core/holes.hpp"
#include "frames/figure.hpp"
#include "head/beard.hpp"
#include "head/cage.hpp"
#include "head/hair_chart.hpp"
#include "head/hair_comb.hpp"
#include "head/hair_edge.hpp"
#include "head/hair_flow.hpp"
#include "head/hair_growth.hpp"
#include "head/hair_lines.hpp"
#include "head/hair_strand.hpp"
#include "head/lids.hpp"
#include "head/skin_tint.hpp"
#include "head/strands.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

NeutralHead build(const char* age, const char* skull = "average") {
  HeadSpec spec;
  spec.age = {{age, 1.0}};
  spec.skull = {{skull, 1.0}};
  return build_neutral_head(shipped().heads, spec);
}

const NeutralHead& adult() {
  static const NeutralHead head = build("adult");
  return head;
}

const HeadPart* find_part(const std::vector<HeadPart>& parts, std::string_view name) {
  for (const HeadPart& part : parts)
    if (part.part.name == name) return &part;
  return nullptr;
}

Names sort(Names names) {
  std::sort(names.begin(), names.end());
  return names;
}

// What holds for every thread of hair: bound once and in order, finite, of unit normals and known shades.
void expect_sound(const NeutralHead& head, const HeadPart& part, const std::string& what) {
  const Mesh& mesh = part.part.rest;
  EXPECT_EQ(part.mount, Mount::strands) << what;
  EXPECT_FALSE(part.part.is_printed) << what;
  ASSERT_FALSE(mesh.triangles.empty()) << what;
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size()) << what;
  std::uint32_t next = 0;
  for (const Binding& binding : part.bindings) {
    ASSERT_EQ(binding.first, next) << what;
    ASSERT_LT(binding.triangle, head.skin.triangles.size()) << what;
    next += binding.count;
  }
  ASSERT_EQ(next, mesh.positions.size()) << what;
  for (const std::uint16_t shade : part.part.shade) ASSERT_LT(shade, part.part.palette.size()) << what;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    ASSERT_NEAR(glm::length(mesh.normals[v]), 1, 1e-3) << what;
    ASSERT_TRUE(std::isfinite(mesh.positions[v].x + mesh.positions[v].y + mesh.positions[v].z)) << what;
  }
}

std::vector<std::array<float, 3>> list_places(const Mesh& mesh, float hand) {
  std::vector<std::array<float, 3>> places;
  for (const glm::vec3& p : mesh.positions) places.push_back({hand * p.x + 0.0f, p.y, p.z});
  std::sort(places.begin(), places.end());
  return places;
}

TEST(hair, words_are_those_of_the_file_and_none) {
  Names cuts{"none"}, beards{"none"};
  for (const auto& [name, cut] : shipped().stock.head->hair.cuts) cuts.push_back(name);
  for (const auto& [name, beard] : shipped().stock.head->hair.beards.beards) beards.push_back(name);
  EXPECT_EQ(sort(kHairs), sort(cuts));
  EXPECT_EQ(sort(kBeards), sort(beards));
  EXPECT_GE(cuts.size(), 7u);  // six cuts, and none
}

TEST(hair, is_none_unless_asked_for) {
  EXPECT_TRUE(build_hair(adult(), HeadSpec{}.hair, Look{}, false).empty());
  EXPECT_TRUE(build_beard(adult(), Look{}).empty());
  EXPECT_TRUE(paint_scalp(adult(), "none").empty());
  try {
    build_hair(adult(), "mohawk", Look{}, false);
    FAIL();
  } catch (const RunError& e) {
    EXPECT_STREQ(e.what(), "templates/head/hair.yaml has no cut 'mohawk'");
  }
  Look look;
  look.beard = "goatee";
  try {
    build_beard(adult(), look);
    FAIL();
  } catch (const RunError& e) {
    EXPECT_STREQ(e.what(), "templates/head/hair.yaml has no beard 'goatee'");
  }
}

TEST(hair, is_sound_on_all_heads_and_of_closed_masses) {
  for (const char* age : {"infant", "child", "adult"}) {
    const NeutralHead head = build(age, age == std::string_view("child") ? "square" : "average");
    for (const auto& [name, cut] : shipped().stock.head->hair.cuts) {
      const std::string what = std::string(age) + " " + name;
      const std::vector<HeadPart> parts = build_hair(head, name, Look{}, false);
      ASSERT_FALSE(parts.empty()) << what;
      for (const HeadPart& part : parts) expect_sound(head, part, what + " " + part.part.name);
      const HeadPart* mass = find_part(parts, "hair_mass");
      EXPECT_EQ(mass != nullptr, cut.mass > 0) << what;
      if (mass == nullptr) continue;
      EXPECT_EQ(count_open_edges(mass->part.rest.triangles), 0u) << what;
      for (const Mesh& piece : split_pieces(mass->part.rest))
        EXPECT_GT(compute_volume_mm3(piece), 1000) << what;
    }
  }
}

NeutralHead build_comic(const char* age) {
  HeadSpec spec;
  spec.age = {{age, 1.0}};
  spec.design = {{"comic", 1.0}};
  return build_neutral_head(shipped().heads, spec);
}

TEST(hair, that_is_drawn_is_one_mass_and_nothing_that_is_loose) {
  for (const char* age : {"infant", "adult"}) {
    const NeutralHead head = build_comic(age);
    for (const auto& [name, cut] : shipped().stock.head->hair.cuts) {
      const std::vector<HeadPart> drawn = build_hair(head, name, Look{}, true);
      const std::string what = std::string(age) + " " + name;
      if (cut.mass <= 0 && cut.ink.mass <= 0) {
        EXPECT_TRUE(drawn.empty()) << what << ": paint alone";
        continue;
      }
      ASSERT_EQ(drawn.size(), 1u) << what;
      EXPECT_EQ(drawn[0].part.name, "hair_mass") << what;
      expect_sound(head, drawn[0], what);
      EXPECT_EQ(count_open_edges(drawn[0].part.rest.triangles), 0u) << what;
      const std::size_t more = (cut.bun_radius_mm > 0 ? 1u : 0u) + (cut.tail.radius_mm > 0 ? 3u : 0u),
                        strays = cut.locks.curl_mm > 0 || name == "side_part" ? 0u : 2u;  // combed: none
      const std::vector<Mesh> pieces = split_pieces(drawn[0].part.rest);
      EXPECT_EQ(pieces.size(), 1 + more + strays) << what << ": no sliver by itself";
      std::size_t large = 0;
      for (const Mesh& piece : pieces) {
        EXPECT_GT(compute_volume_mm3(piece), 25) << what;
        large += compute_volume_mm3(piece) > 3000 ? 1 : 0;
      }
      EXPECT_EQ(large, 1 + more) << what;
    }
  }
}

// Of the locks that an edge is cut into none is a sliver, and all of them end in one point.
TEST(hair, that_is_drawn_ends_in_a_few_pointed_locks) {
  constexpr double kLeast_mm = 9, kMost = 34;
  for (const char* age : {"infant", "child", "adult"}) {
    const NeutralHead head = build_comic(age);
    for (const auto& [name, cut] : shipped().stock.head->hair.cuts) {
      const HairScene scene = build_hair_scene(head, find_drawn_cut(head, name));
      const std::vector<DrawnLock> locks = list_drawn_locks(scene);
      const std::string what = std::string(age) + " " + name;
      EXPECT_EQ(locks.empty(), cut.ink.lock_mm <= 0) << what;
      if (locks.empty()) continue;
      EXPECT_LT(static_cast<double>(locks.size()), kMost) << what;
      for (std::size_t i = 0; i < locks.size(); ++i) {
        const DrawnLock& lock = locks[i];
        EXPECT_LT(lock.from_deg, lock.tip_deg) << what;
        EXPECT_LT(lock.tip_deg, lock.to_deg) << what;
        EXPECT_GT((lock.to_deg - lock.from_deg) * kRadiansPerDegree * 95, kLeast_mm) << what << ' ' << i;
        const DrawnLock& next = locks[(i + 1) % locks.size()];
        EXPECT_NEAR(std::remainder(next.from_deg - lock.to_deg, 360), 0, 1e-9) << what;
        EXPECT_EQ(next.from_mm, lock.to_mm) << what;
        EXPECT_LE(lock.tip_mm, std::min(lock.from_mm, lock.to_mm)) << what << ' ' << i;
      }
      EXPECT_NEAR(locks.back().to_deg - locks.front().from_deg, 360, 1e-9) << what;
      // Seen along the edge, it goes down to each tip and up again, and nowhere else.
      const std::vector<DrawnEdge> edge = trace_drawn_edge(scene);
      std::size_t tips = 0;
      for (std::size_t i = 0; i < edge.size(); ++i) {
        const double before = edge[(i + edge.size() - 1) % edge.size()].way, here = edge[i].way,
                     after = edge[(i + 1) % edge.size()].way;
        tips += here > before && here >= after ? 1 : 0;
      }
      EXPECT_LE(tips, locks.size()) << what;
    }
  }
}

// Broad ones and narrow ones, long ones and short ones: no two beside each other are alike.
TEST(hair, that_is_drawn_has_locks_unlike_each_other) {
  const NeutralHead head = build_comic("adult");
  for (const char* cut : {"bob", "crop", "pixie"}) {
    const std::vector<DrawnLock> locks = list_drawn_locks(build_hair_scene(head, find_drawn_cut(head, cut)));
    std::size_t alike = 0;
    double least = 1e9, most = 0;
    for (std::size_t i = 0; i < locks.size(); ++i) {
      const auto measure = [](const DrawnLock& lock) { return lock.to_deg - lock.from_deg; };
      const double wide = measure(locks[i]), next = measure(locks[(i + 1) % locks.size()]);
      least = std::min(least, wide);
      most = std::max(most, wide);
      alike += std::abs(wide - next) < 0.08 * wide ? 1 : 0;
    }
    EXPECT_GT(most, 2 * least) << cut;
    EXPECT_LT(6 * alike, locks.size()) << cut;
  }
}

// The ring of light is a strip of its triangles, whose lower edge goes up and down, and nowhere is it in two.
TEST(hair, that_is_drawn_has_a_ring_of_light_that_is_no_smooth_band) {
  const NeutralHead head = build_comic("adult");
  for (const char* cut : {"bob", "crop", "side_part", "long", "wavy", "curls", "bun"}) {
    const Part part = build_hair(head, cut, Look{}, true)[0].part;
    ASSERT_EQ(part.triangle_shade.size(), part.rest.triangles.size()) << cut;
    ASSERT_EQ(part.palette.size(), 2u) << cut;
    std::vector<Triangle> lit;
    for (std::size_t i = 0; i < part.rest.triangles.size(); ++i)
      if (part.triangle_shade[i] == 1) lit.push_back(part.rest.triangles[i]);
    EXPECT_GT(lit.size(), 60u) << cut;
    EXPECT_LT(8 * lit.size(), part.rest.triangles.size()) << cut;
    // Heights along the front of the lower one of each triangle's corners turn often.
    std::map<float, float> low;
    for (const Triangle& t : lit)
      for (const std::uint32_t v : t) {
        const glm::vec3& p = part.rest.positions[v];
        if (p.z < 0) continue;
        const auto [entry, is_new] = low.try_emplace(std::round(p.x / 4), p.y);
        entry->second = std::min(entry->second, p.y);
      }
    int turns = 0;
    for (auto at = std::next(low.begin()); std::next(at) != low.end(); ++at)
      turns += (at->second - std::prev(at)->second) * (std::next(at)->second - at->second) < 0 ? 1 : 0;
    EXPECT_GT(turns, 5) << cut;
  }
}

// A few lines that lie on the mass, none of them on another.
TEST(hair, that_is_drawn_has_a_few_lines_that_do_not_cross) {
  constexpr float kOff_mm = 3.5;
  for (const char* age : {"infant", "adult"}) {
    const NeutralHead head = build_comic(age);
    for (const auto& [name, cut] : shipped().stock.head->hair.cuts) {
      const std::string what = std::string(age) + " " + name;
      if (cut.mass <= 0 && cut.ink.mass <= 0) {
        EXPECT_TRUE(list_hair_lines(head, name, Mesh{}).empty()) << what;
        continue;
      }
      const Mesh mass = build_hair(head, name, Look{}, true)[0].part.rest;
      std::vector<std::vector<glm::vec3>> ways;
      for (const HairLine& line : list_hair_lines(head, name, mass)) {
        ASSERT_GT(line.places.size(), 1u) << what;
        EXPECT_GT(line.width, 0.3) << what;
        std::vector<glm::vec3> way;
        for (const MeshPlace& place : line.places) {
          EXPECT_NEAR(place.shares.x + place.shares.y + place.shares.z, 1, 1e-4f) << what;
          glm::vec3 at(0);
          for (int i = 0; i < 3; ++i) at += place.shares[i] * mass.positions.at(place.vertices[i]);
          way.push_back(at);
        }
        if (line.ends == 0) ways.push_back(way);  // else it is the edge
      }
      EXPECT_GT(ways.size(), 5u) << what;
      EXPECT_LT(ways.size(), 46u) << what;
      for (std::size_t i = 0; i < ways.size(); ++i)
        for (std::size_t j = i + 1; j < ways.size(); ++j)
          for (const glm::vec3& a : ways[i])
            for (const glm::vec3& b : ways[j]) ASSERT_GT(glm::distance(a, b), kOff_mm) << what;
    }
  }
}

// Seen from the side, nothing hangs over an ear that a cut leaves free.
TEST(hair, that_is_drawn_keeps_off_free_ears) {
  constexpr float kNear_mm = 2.5f;
  for (const char* age : {"infant", "adult"}) {
    const NeutralHead head = build_comic(age);
    for (const auto& [name, cut] : shipped().stock.head->hair.cuts) {
      if (cut.covers_ears || cut.ink.mass <= 0) continue;
      const std::vector<HeadPart> drawn = build_hair(head, name, Look{}, true);
      for (const char* point : {"er5_2", "er5_4", "er5_6", "er5_8", "er5_10", "er8_4", "er8_8", "er9_6"}) {
        const glm::vec3 ear = find_named_point(head, point);
        for (const glm::vec3& p : drawn[0].part.rest.positions)
          EXPECT_FALSE(p.x > ear.x && std::hypot(p.y - ear.y, p.z - ear.z) < kNear_mm)
              << age << ' ' << name << ' ' << point;
      }
    }
  }
}

TEST(hair, keeps_within_its_share_of_a_frame) {
  for (const auto& [name, cut] : shipped().stock.head->hair.cuts) {
    std::size_t count = 0;
    for (const HeadPart& part : build_hair(adult(), name, Look{}, false))
      count += part.part.rest.positions.size();
    EXPECT_LT(count, 45000u) << name;
  }
}

TEST(hair, mirrors_itself_to_the_bit_where_it_is_not_parted) {
  int mirrored = 0;
  for (const auto& [name, cut] : shipped().stock.head->hair.cuts)
    for (const HeadPart& part : build_hair(adult(), name, Look{}, false)) {
      const bool is_even = cut.comb.side_mm == 0 || cut.comb.scalp_mm == 0;  // no groove at a side
      const bool is_mass = part.part.name == "hair_mass" && is_even;
      const bool is_locks = part.part.name == "hair" || part.part.name == "hair_back";
      const bool is_coil = cut.bun_radius_mm > 0 && is_locks;  // it turns one way
      if ((!cut.is_mirrored && !is_mass) || is_coil) continue;
      ++mirrored;
      EXPECT_EQ(list_places(part.part.rest, 1), list_places(part.part.rest, -1))
          << name << " " << part.part.name;
    }
  EXPECT_GE(mirrored, 10);
}

TEST(hair, before_its_middle_is_a_part_and_behind_it_another) {
  std::size_t split = 0;
  for (const auto& [name, cut] : shipped().stock.head->hair.cuts) {
    const std::vector<HeadPart> parts = build_hair(adult(), name, Look{}, false);
    const HeadPart *front = find_part(parts, "hair"), *back = find_part(parts, "hair_back");
    if (cut.locks.count == 0) continue;
    ASSERT_NE(front, nullptr) << name;
    ASSERT_NE(back, nullptr) << name;
    const auto list_middles = [](const HeadPart& part) {
      std::vector<double> middles;
      for (const Binding& lock : part.bindings) {
        double sum = 0;
        for (std::uint32_t v = 0; v < lock.count; ++v) sum += part.part.rest.positions[lock.first + v].z;
        middles.push_back(sum / lock.count);
      }
      return middles;
    };
    const std::vector<double> before = list_middles(*front), behind = list_middles(*back);
    const double middle = (std::accumulate(before.begin(), before.end(), 0.0) +
                           std::accumulate(behind.begin(), behind.end(), 0.0)) /
                          static_cast<double>(before.size() + behind.size());
    // But for the pieces of a parting, which hang together.
    std::ptrdiff_t astray = 0;
    for (const double z : before) astray += z < middle - 0.01 ? 1 : 0;
    for (const double z : behind) astray += z > middle + 0.01 ? 1 : 0;
    EXPECT_LE(astray, cut.comb.scalp_mm > 0 ? 40 : 0) << name;
    for (const HeadPart* part : {front, back}) {
      std::vector<bool> is_used(part->part.rest.positions.size(), false);
      for (const Triangle& triangle : part->part.rest.triangles)
        for (const std::uint32_t v : triangle) {
          ASSERT_LT(v, is_used.size()) << name;
          is_used[v] = true;
        }
      EXPECT_TRUE(std::ranges::all_of(is_used, std::identity{})) << name << " " << part->part.name;
    }
    EXPECT_GT(before.size(), 40u) << name;
    EXPECT_GT(behind.size(), 40u) << name;
    ++split;
  }
  EXPECT_GE(split, 8u);
}

TEST(hair, never_falls_over_the_face) {
  for (const char* age : {"infant", "adult"}) {
    const NeutralHead head = build(age);
    const glm::vec3 brow = find_named_point(head, "E5_4"), corner = find_named_point(head, "E1_8");
    const glm::vec3 chin = find_named_point(head, "m12_D1");
    for (const auto& [name, cut] : shipped().stock.head->hair.cuts)
      for (const bool is_drawn : {false, true})
        for (const HeadPart& part : build_hair(head, name, Look{}, is_drawn)) {
          int count = 0;
          for (const glm::vec3& p : part.part.rest.positions)
            if (p.z > corner.z - 5 && std::abs(p.x) < corner.x && p.y < brow.y && p.y > chin.y) ++count;
          EXPECT_EQ(count, 0) << age << " " << name << " " << part.part.name << " " << is_drawn;
        }
  }
}

TEST(hair, ends_near_the_border_that_its_cut_names) {
  const HairScene scene = build_hair_scene(adult(), shipped().stock.head->hair.cuts.at("bob"));
  const std::vector<HeadPart> parts = build_hair(adult(), "bob", Look{}, false);
  const double chin = find_named_point(adult(), "m12_D1").y;
  float low = 1000;
  for (const glm::vec3& p : find_part(parts, "hair")->part.rest.positions) low = std::min(low, p.y);
  EXPECT_NEAR(low, chin, 35);
  EXPECT_GT(sample_border(scene.ends, 120),
            sample_border(scene.ends, 0) + 0.4);  // long at the side, a fringe before
}

TEST(hair, that_is_combed_from_a_part_begins_beside_it_and_has_no_short_stubs) {
  for (const char* name : {"long", "wavy"}) {
    const HairCut& cut = shipped().stock.head->hair.cuts.at(name);
    const HairScene scene = build_hair_scene(adult(), cut);
    const std::vector<HairPlace> roots = spread_roots(scene, 120, 0, false);
    int beside = 0;
    for (std::uint32_t i = 0; i < roots.size(); ++i) {
      const HairPlace start = trace_to_part(scene, roots[i], i);
      const glm::dvec3 at = compute_hair_point(scene.chart, start, compute_ground_mm(scene, start));
      beside += compute_part_arm(scene, at).distance_mm < 22 ? 1 : 0;
      EXPECT_GT(grow_strand(scene, start, i, i).length_mm, 120) << name << " " << i;
    }
    EXPECT_GT(beside, 110) << name;
  }
}

TEST(hair, that_falls_beside_a_face_grows_along_its_hairline) {
  for (const char* name : {"bob", "long", "wavy"})
    for (const char* age : {"infant", "child", "adult"}) {
      const HairScene scene = build_hair_scene(build(age), shipped().stock.head->hair.cuts.at(name));
      const std::vector<HairPlace> roots = spread_border_roots(scene, 60);
      ASSERT_EQ(roots.size(), 60u);
      double across_deg = 0;
      for (const HairPlace& root : roots) {
        across_deg += root.azimuth_deg;
        EXPECT_LT(std::abs(root.azimuth_deg), 90) << name;
        EXPECT_GT(compute_inside_mm(scene, root), 0) << name << " " << root.azimuth_deg;
        // A fringe's begin one behind the other, or it has two tiers.
        EXPECT_LT(compute_inside_mm(scene, root), sample_border(scene.hangs, 0) > 0.5 ? 36 : 14)
            << name << " " << root.azimuth_deg;
      }
      EXPECT_NEAR(across_deg, 0, 1e-9) << name << ": as many on both sides";
    }
}

// Along the ground, nothing lies further inside than it is away from the hairline, level or steep.
TEST(hair, over_an_open_forehead_begins_at_its_border) {
  for (const char* name : {"long", "wavy"})
    for (const char* age : {"infant", "child", "adult"}) {
      const HairScene scene = build_hair_scene(build(age), shipped().stock.head->hair.cuts.at(name));
      const std::vector<HairPlace> roots = spread_front_roots(scene, 60);
      ASSERT_EQ(roots.size(), 60u);
      double across_deg = 0;
      int near = 0;
      for (const HairPlace& root : roots) {
        across_deg += root.azimuth_deg;
        EXPECT_LT(std::abs(root.azimuth_deg), 60) << name;
        EXPECT_GT(compute_inside_mm(scene, root), 0) << name << " " << root.azimuth_deg;
        EXPECT_LT(compute_inside_mm(scene, root), 36) << name << " " << root.azimuth_deg;
        near += compute_inside_mm(scene, root) < 9 ? 1 : 0;
      }
      EXPECT_NEAR(across_deg, 0, 1e-9) << name << ": as many on both sides";
      EXPECT_GT(near, 12) << name << ": no bare edge";
    }
}

TEST(hair, begins_evenly_beside_the_part_of_an_open_forehead) {
  for (const char* name : {"long", "wavy"})
    for (const char* age : {"infant", "child", "adult"}) {
      const HairScene scene = build_hair_scene(build(age), shipped().stock.head->hair.cuts.at(name));
      const std::vector<HairPlace> roots = spread_part_roots(scene, 120);
      EXPECT_GT(roots.size(), 80u) << name << ": before the hairline there are none";
      int left = 0;
      double along_mm = -1e9;
      for (const HairPlace& root : roots) {
        const PartArm arm =
            compute_part_arm(scene, compute_hair_point(scene.chart, root, compute_ground_mm(scene, root)));
        EXPECT_GT(compute_inside_mm(scene, root), 0) << name << " " << age;
        EXPECT_LT(arm.distance_mm, 6) << name << " " << age << " " << root.azimuth_deg;
        EXPECT_TRUE(along_mm < -1e8 || std::abs(arm.along_mm - along_mm) < 5)
            << name << " " << age << ": a bare strip at " << arm.along_mm;
        along_mm = arm.along_mm;
        left += arm.aside > 0 ? 1 : 0;
      }
      EXPECT_NEAR(left, 0.5 * static_cast<double>(roots.size()), 2) << name << " " << age;
      const HairPlace last = compute_part_place(scene, 1);
      const PartArm end =
          compute_part_arm(scene, compute_hair_point(scene.chart, last, compute_ground_mm(scene, last)));
      EXPECT_NEAR(along_mm, end.along_mm, 5) << name << " " << age << ": all of it";
    }
}

// Beside a part hair lies side by side, and does not meet in single places like the bones of a fish.
TEST(hair, leaves_its_part_side_by_side) {
  for (const char* name : {"side_part", "long", "wavy"}) {
    const HairScene scene = build_hair_scene(adult(), shipped().stock.head->hair.cuts.at(name));
    constexpr int kPlaces = 120;
    double worst_deg = 0;
    glm::dvec3 before(0);
    for (int i = 0; i < kPlaces; ++i) {
      const HairPlace part = compute_part_place(scene, 0.2 + 0.6 * i / kPlaces);
      if (part.way > sample_border(scene.hairline, part.azimuth_deg)) continue;
      const glm::dvec3 on = compute_hair_point(scene.chart, part, compute_ground_mm(scene, part));
      const HairPlace beside = compute_hair_place(scene.chart, on + glm::dvec3(4, 0, 0));
      const glm::dvec3 way = compute_comb_way(scene, beside);
      if (before != glm::dvec3(0))
        worst_deg = std::max(worst_deg, std::acos(std::min(1.0, glm::dot(way, before))) / kRadiansPerDegree);
      before = way;
    }
    EXPECT_LT(worst_deg, 5) << name;
  }
}

// What tells strands of the mass apart goes on evenly from place to place, or its streaks zigzag.
TEST(hair, of_the_mass_runs_in_even_streaks) {
  for (const char* name : {"bob", "long"}) {
    const HairScene scene = build_hair_scene(adult(), shipped().stock.head->hair.cuts.at(name));
    double worst_mm = 0;
    for (const double azimuth : {12.0, 25.0, 55.0, 80.0, 120.0}) {
      std::vector<double> across;
      for (double way = 0.42; way < 0.8; way += 0.015)
        across.push_back(compute_hair_flow(scene, {azimuth, way}).across_mm);
      for (std::size_t i = 2; i < across.size(); ++i)
        worst_mm = std::max(worst_mm, std::abs(across[i] - 2 * across[i - 1] + across[i - 2]));
    }
    EXPECT_LT(worst_mm, 1.2) << name;
  }
}

// What is seen of the mass between locks and from inside has tips as they do.
TEST(hair, long_and_straight_has_a_mass_that_ends_in_tips) {
  const std::vector<HeadPart> parts = build_hair(adult(), "long", {}, false);
  const auto mass = std::ranges::find(parts, "hair_mass", [](const HeadPart& p) { return p.part.name; });
  ASSERT_NE(mass, parts.end());
  // The lowest vertices, in slices round the nape: neighbours end at heights of their own.
  std::map<int, float> lowest;
  for (const glm::vec3& p : mass->part.rest.positions)
    if (p.z < -20) {
      const auto [slice, is_new] = lowest.try_emplace(static_cast<int>(std::floor(p.x / 6)), p.y);
      if (!is_new) slice->second = std::min(slice->second, p.y);
    }
  double steps_mm = 0;
  int count = 0;
  for (auto next = std::next(lowest.begin()); next != lowest.end(); ++next, ++count)
    steps_mm += std::abs(next->second - std::prev(next)->second);
  ASSERT_GT(count, 8);
  EXPECT_GT(steps_mm / count, 4);
}

TEST(hair, bends_in_arcs_and_has_no_elbows) {
  for (const char* name : {"crop", "side_part", "pixie", "long", "wavy"}) {
    const HairCut& cut = shipped().stock.head->hair.cuts.at(name);
    const HairScene scene = build_hair_scene(adult(), cut);
    std::vector<HairPlace> roots = spread_roots(scene, 5000, 0, false);
    for (const HairPlace& root : spread_part_roots(scene, 400)) roots.push_back(root);
    if (!scene.ends.empty())
      for (const HairPlace& root : spread_front_roots(scene, 400)) roots.push_back(root);
    double worst_deg = 0;
    for (std::uint32_t i = 0; i < roots.size(); ++i) {
      const HairStrand strand = grow_strand(scene, roots[i], i, i);
      EXPECT_LE(static_cast<int>(strand.points.size()), cut.locks.rings);
      // Along the head: how they come out of the skin is another thing.
      const auto run = [&](std::size_t k) {
        const glm::dvec3 way = strand.points[k] - strand.points[k - 1], &out = strand.outs[k - 1];
        return glm::normalize(way - out * glm::dot(way, out));
      };
      for (std::size_t k = 2; k < strand.points.size(); ++k)
        worst_deg = std::max(
            worst_deg, std::acos(std::clamp(glm::dot(run(k - 1), run(k)), -1.0, 1.0)) / kRadiansPerDegree);
    }
    EXPECT_LT(worst_deg, 48) << name;
  }
}

TEST(hair, that_is_short_is_fine) {
  const HairCut& cut = shipped().stock.head->hair.cuts.at("crop");
  const std::vector<HeadPart> parts = build_hair(adult(), "crop", {}, false);
  const auto part = std::ranges::find(parts, "hair", [](const HeadPart& p) { return p.part.name; });
  ASSERT_NE(part, parts.end());
  ASSERT_GT(cut.locks.widest, 0);
  int fewest = 1000;
  for (const Binding& lock : part->bindings) {
    const auto* at = &part->part.rest.positions[lock.first];
    const std::uint32_t rings = (lock.count + 1) / 2;
    double length_mm = 0, width_mm = 0;
    for (std::uint32_t r = 0; r + 1 < rings; ++r) {
      const glm::vec3 here = 0.5f * (at[2 * r] + at[2 * r + 1]);
      const glm::vec3 next = r + 2 < rings ? 0.5f * (at[2 * r + 2] + at[2 * r + 3]) : at[2 * r + 2];
      length_mm += glm::distance(here, next);
      width_mm = std::max<double>(width_mm, glm::distance(at[2 * r], at[2 * r + 1]));
    }
    EXPECT_LT(width_mm, 1.25 * cut.locks.widest * length_mm) << lock.first;
    fewest = std::min(fewest, static_cast<int>(rings));
  }
  EXPECT_EQ(fewest, 3) << "and takes few points";
}

TEST(hair, distances_from_the_hairline_are_as_long_as_the_ground) {
  for (const char* age : {"child", "adult"}) {
    const HairScene scene = build_hair_scene(build(age), shipped().stock.head->hair.cuts.at("long"));
    for (double azimuth = 0; azimuth < 100; azimuth += 2) {
      const double border = sample_border(scene.hairline, azimuth);
      const auto at = [&](double turn_deg, double way) {
        const HairPlace place{azimuth + turn_deg, border + way};
        const glm::dvec3 point = compute_hair_point(scene.chart, place, compute_ground_mm(scene, place));
        return std::pair(compute_inside_mm(scene, place), point);
      };
      const auto [inside_mm, here] = at(0, 0);
      EXPECT_EQ(inside_mm, 0);
      for (const auto& [turn_deg, way] : {std::pair{2.0, 0.0}, {-2.0, 0.0}, {0.0, 0.03}, {0.0, -0.03}}) {
        const auto [other_mm, there] = at(turn_deg, way);
        EXPECT_LT(std::abs(other_mm), 2.2 * glm::distance(here, there) / scene.chart.size + 0.5)
            << age << " " << azimuth << " " << turn_deg;
      }
    }
  }
}

TEST(hair, of_a_fringe_lies_down_toward_its_tips) {
  const HairScene scene = build_hair_scene(adult(), shipped().stock.head->hair.cuts.at("bob"));
  for (const double azimuth : {0.0, 15.0, 30.0}) {
    const double tips = sample_border(scene.ends, azimuth), root = sample_border(scene.hairline, azimuth);
    EXPECT_LT(compute_thickness_mm(scene, {azimuth, tips}), 6.5) << azimuth;
    EXPECT_GT(compute_thickness_mm(scene, {azimuth, 0.6 * root}), 10) << azimuth;
  }
  EXPECT_GT(compute_thickness_mm(scene, {90, sample_border(scene.ends, 90)}), 8) << "over the ears";
}

TEST(hair, roots_lie_within_the_hairline_as_many_before_as_behind) {
  for (const char* name : {"crop", "bun"}) {
    const HairScene scene = build_hair_scene(adult(), shipped().stock.head->hair.cuts.at(name));
    const std::vector<HairPlace> roots = spread_roots(scene, 1000, 0, false);
    ASSERT_EQ(roots.size(), 1000u);
    int left = 0;
    for (const HairPlace& root : roots) {
      EXPECT_LE(root.way, sample_border(scene.hairline, root.azimuth_deg));
      left += root.azimuth_deg > 0 ? 1 : 0;
    }
    EXPECT_NEAR(left, 500, 60) << name;
  }
}

TEST(hair, moves_little_when_age_moves_little) {
  HeadSpec young;
  young.age = {{"child", 0.5}, {"adult", 0.5}};
  HeadSpec older;
  older.age = {{"child", 0.47}, {"adult", 0.53}};
  const NeutralHead a = build_neutral_head(shipped().heads, young);
  const NeutralHead b = build_neutral_head(shipped().heads, older);
  for (const char* name : {"crop", "long", "ponytail"}) {
    const std::vector<HeadPart> one = build_hair(a, name, Look{}, false),
                                two = build_hair(b, name, Look{}, false);
    const Mesh &first = find_part(one, "hair_mass")->part.rest,
               &second = find_part(two, "hair_mass")->part.rest;
    ASSERT_EQ(first.positions.size(), second.positions.size());
    float most = 0;
    for (std::size_t v = 0; v < first.positions.size(); ++v)
      most = std::max(most, glm::distance(first.positions[v], second.positions[v]));
    EXPECT_LT(most, 8) << name;
    const double locks = static_cast<double>(find_part(one, "hair")->bindings.size());
    EXPECT_NEAR(static_cast<double>(find_part(two, "hair")->bindings.size()) / locks, 1, 0.05) << name;
  }
}

TEST(hair, rides_on_the_skin) {
  for (const char* cut : {"crop", "bob"}) {
    HeadSpec spec;
    spec.hair = cut;
    spec.look.beard = "short";
    const Figure figure = build_figure(shipped().heads, spec);
    Pose pose;
    for (const char* side : {"left", "right"})
      pose.values[*find_move(Area::brow, std::string_view(side) == "left" ? Side::left : Side::right, "up")] =
          1;
    pose.values[*find_move(Area::chin, Side::none, "down")] = 0.6;
    DeformBuffers buffers;
    Drawing drawing;
    deform_figure(figure, pose, TurnKey{}, buffers, drawing);
    for (std::size_t i = 0; i < figure.model.parts.size(); ++i) {
      const Part& part = figure.model.parts[i];
      if (!part.name.starts_with("hair") && part.name != "beard") continue;
      double most = 0;
      for (std::size_t v = 0; v < part.rest.positions.size(); ++v)
        most = std::max<double>(most, glm::distance(drawing.parts[i].positions[v], part.rest.positions[v]));
      if (part.name == "beard") {
        EXPECT_GT(most, 8) << cut;  // it goes with the chin
      } else {
        EXPECT_LT(most, 8) << cut << " " << part.name;  // the scalp moves a little with the brows
      }
    }
  }
}

TEST(hair, paints_the_scalp_and_not_the_face) {
  const auto at = [&](const std::vector<float>& covers, const char* name) {
    return covers[find_point(adult().cage, name)];
  };
  const std::vector<float> covers = paint_scalp(adult(), "crop");
  ASSERT_EQ(covers.size(), adult().skin.positions.size());
  EXPECT_GT(at(covers, "s9_F2"), 0.7f);
  EXPECT_GT(at(covers, "cap_2_2"), 0.7f);
  for (const char* name : {"p_tip", "p_F1", "M6_12", "q11_C4", "er6_3", "m12_N1"})
    EXPECT_EQ(at(covers, name), 0) << name;
  for (std::size_t v = 0; v < covers.size(); ++v)
    EXPECT_NEAR(covers[v], covers[adult().surface->mirror.size() > v ? adult().surface->mirror[v] : v],
                0.02f);
}

TEST(hair, that_is_worn_is_its_parts_and_its_scalp) {
  for (const char* name : {"crop", "ponytail"}) {
    const WornHair worn = build_worn_hair(adult(), name, Look{});
    const std::vector<HeadPart> parts = build_hair(adult(), name, Look{}, false);
    EXPECT_EQ(worn.scalp, paint_scalp(adult(), name));
    ASSERT_EQ(worn.parts.size(), parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      EXPECT_EQ(worn.parts[i].part.name, parts[i].part.name);
      EXPECT_EQ(worn.parts[i].part.rest.positions, parts[i].part.rest.positions);
    }
  }
  EXPECT_TRUE(build_worn_hair(adult(), "none", Look{}).parts.empty());
}

TEST(brows, are_painted_where_their_hairs_are) {
  const std::vector<float> covers = paint_brows(adult(), shipped().stock.head->parts.brow);
  EXPECT_GT(covers[find_point(adult().cage, "E5_4")], 0.3f);
  for (const char* name : {"p_g", "E5_12", "p_F2", "p_tip"})
    EXPECT_EQ(covers[find_point(adult().cage, name)], 0) << name;
}

TEST(beard, grows_on_men_where_beards_grow) {
  for (const auto& [name, beard] : shipped().stock.head->hair.beards.beards) {
    Look look;
    look.beard = name;
    EXPECT_TRUE(build_beard(build("infant"), look).empty()) << name;
    EXPECT_TRUE(build_beard(build("child"), look).empty()) << name;
    const std::vector<HeadPart> parts = build_beard(adult(), look);
    ASSERT_EQ(parts.size(), 1u) << name;
    expect_sound(adult(), parts[0], name);
    EXPECT_GT(parts[0].bindings.size(), 300u) << name;
    EXPECT_EQ(list_places(parts[0].part.rest, 1), list_places(parts[0].part.rest, -1)) << name;
    const std::vector<float> covers = paint_beard(adult(), name);
    const auto at = [&](const char* point) { return covers[find_point(adult().cage, point)]; };
    EXPECT_GT(at("MA_3"), 0.5f) << name;
    for (const char* bare : {"p_tip", "M2_3", "M2_9", "q12_C3", "E3_12", "s9_F2", "m12_N3"})
      EXPECT_LT(at(bare), 0.05f) << name << " " << bare;
    for (const float cover : covers) ASSERT_TRUE(cover >= 0 && cover <= 1.001f) << name;
  }
}

// Where two of its areas meet, or a light seam would run from the corner of the mouth to the jaw.
TEST(beard, is_as_dense_between_its_areas_as_in_them) {
  const std::vector<glm::vec3>& skin = adult().skin.positions;
  for (const char* name : {"stubble", "short"}) {
    const std::vector<float> covers = paint_beard(adult(), name);
    for (const auto& [one, other] : {std::pair{"M6_7", "q12_C7"},
                                     {"M6_8", "q12_C8"},
                                     {"M6_9", "q12_C9"},
                                     {"m8_D1", "q12_D1"},
                                     {"q11_D1", "q11_D2"},
                                     {"s1_D1", "s1_D2"},
                                     {"m10_D1", "m10_D2"}}) {
      const std::uint32_t a = find_point(adult().cage, one), b = find_point(adult().cage, other);
      const glm::vec3 between = 0.5f * (skin[a] + skin[b]);
      const auto nearest =
          std::ranges::min_element(skin, {}, [&](const glm::vec3& p) { return glm::distance(p, between); });
      const float cover = covers[static_cast<std::size_t>(nearest - skin.begin())];
      EXPECT_GT(cover, 0.9f * std::min(covers[a], covers[b])) << name << " " << one << " " << other;
    }
  }
}

TEST(beard, stands_on_the_skin) {
  Look look;
  look.beard = "stubble";
  const std::vector<HeadPart> parts = build_beard(adult(), look);
  for (const Binding& binding : parts[0].bindings) {
    const SkinFrame root = compute_skin_frame(adult().skin.positions, adult().skin.normals,
                                              adult().skin.triangles[binding.triangle], binding.barycentric);
    const glm::vec3 foot = parts[0].part.rest.positions[binding.first];
    ASSERT_LT(glm::distance(foot, root.origin), 0.5f);
  }
}

TEST(skin_tint, mixes_a_colour_into_what_it_covers) {
  Part skin{.name = "skin",
            .material = "skin",
            .rest = {},
            .palette = {{glm::vec3(1), 0.5f}},
            .shade = {0, 0, 0},
            .grain = {}};
  tint_skin(skin, {0, 0.5f, 1}, glm::vec3(0));
  EXPECT_EQ(skin.shade[0], 0);
  EXPECT_NEAR(skin.palette[skin.shade[1]].srgb.x, 0.5f, 0.01f);
  EXPECT_NEAR(skin.palette[skin.shade[2]].srgb.x, 0, 0.01f);
  EXPECT_LT(skin.palette[skin.shade[2]].gloss, 0.5f);
}

}  // namespace
}  // namespace mien

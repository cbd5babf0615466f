// Both halves at once: the same bits as one vertex after the other, and from every kind of processor.
#include "head/pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "core/data.hpp"
#include "frames/figure.hpp"
#include "poses.hpp"
#include "shipped.hpp"

#pragma GCC diagnostic ignored "-Wpsabi"

namespace mien {
namespace {

using Float8 = float __attribute__((vector_size(32)));

// The loops as a processor without wide registers has them.
namespace plain {
#include "head/pairs_work.inl"
}

const Figure& adult() {
  static const Figure figure = build_figure(shipped().heads, HeadSpec{});
  return figure;
}

std::vector<Pose> list_poses() {
  std::mt19937 random(9);
  std::vector<Pose> poses(1);
  for (int i = 0; i < 5; ++i) poses.push_back(build_random_pose(random));
  return poses;
}

std::vector<glm::dvec3> pose_points(const Pose& pose) {
  std::vector<glm::dvec3> points;
  pose_cage(adult().head, adult().face, pose, points);
  return points;
}

bool is_same(const std::vector<Twin>& a, const std::vector<Twin>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Twin)) == 0;
}

TEST(pairs, every_vertex_has_one_slot) {
  for (const auto& [pairs, count] :
       {std::pair{adult().head.surface->pairs, adult().head.surface->vertex_count()},
        std::pair{adult().folds.skin.pairs, adult().folds.skin.vertex_count()}}) {
    std::vector<int> slots(count, 0);
    for (const MirrorPair& pair : pairs) {
      ++slots[pair.left];
      if (!pair.is_middle()) ++slots[pair.right];
      EXPECT_EQ(adult().folds.skin.mirror[pair.left], pair.right);
    }
    EXPECT_EQ(slots, std::vector<int>(count, 1));
  }
}

// One vertex after the other, in the order of sums that the paired loops promise.
std::vector<glm::vec3> place_one_by_one(const Surface& surface, const std::vector<Float4>& points) {
  std::vector<glm::vec3> places;
  for (std::uint32_t v = 0; v < surface.vertex_count(); ++v) {
    const bool is_middle = surface.mirror[v] == v;
    Float4 even{}, odd{};
    for (std::uint32_t k = surface.first[v], i = 0; k < surface.first[v + 1]; ++k, ++i) {
      const std::uint32_t point = surface.point[k];
      if (is_middle && surface.mirror[point] != point) {
        even += surface.weight[k] * (points[point] + points[surface.point[k + 1]]);
        ++k;
      } else {
        (is_middle || i % 2 == 0 ? even : odd) += surface.weight[k] * points[point];
      }
    }
    places.push_back(unpack(even + odd));
  }
  return places;
}

std::vector<glm::vec3> shade_one_by_one(const Surface& surface, const std::vector<glm::vec3>& places) {
  std::vector<Float4> sums(places.size(), Float4{});
  const auto find_area = [&](const Quad& q) {
    return cross(pack(places[q[2]]) - pack(places[q[0]]), pack(places[q[3]]) - pack(places[q[1]]));
  };
  for (std::size_t q = 0; q < surface.quads.size(); q += 2) {
    const Quad &left = surface.quads[q], &right = surface.quads[q + 1];
    const Float4 here = find_area(left), there = find_area(right);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t v = left[i], image = right[(4 - i) % 4];
      if (v == image) {
        sums[v] += here + there;
      } else {
        sums[v] += here;
        sums[image] += there;
      }
    }
  }
  std::vector<glm::vec3> normals;
  for (const Float4& sum : sums) normals.push_back(unpack(normalize(sum, 1e-20f, Float4{0, 0, 1, 0})));
  return normals;
}

TEST(pairs, are_the_sums_of_one_vertex_after_the_other) {
  const Surface& surface = *adult().head.surface;
  for (const Pose& pose : list_poses()) {
    std::vector<Float4> packed;
    pack_points(pose_points(pose), packed);
    std::vector<glm::vec3> places, normals;
    deform_surface(surface, packed, places);
    update_surface_normals(surface, places, normals);
    EXPECT_TRUE(places == place_one_by_one(surface, packed));
    EXPECT_TRUE(normals == shade_one_by_one(surface, places));

    const FineSkin& fine = adult().folds.skin;
    append_fine_points(fine, places, normals);
    ASSERT_EQ(places.size(), fine.vertex_count());
    for (std::size_t i = 0; i < fine.parents.size(); ++i) {
      const auto [a, b] = fine.parents[i];
      const Float4 pa = pack(places[a]), pb = pack(places[b]), na = pack(normals[a]), nb = pack(normals[b]);
      const Float4 lift = dot(pb - pa, nb) * nb - dot(pb - pa, na) * na;
      ASSERT_TRUE(places[fine.base_count + i] == unpack(0.5f * (pa + pb) + 0.125f * lift)) << i;
      ASSERT_TRUE(normals[fine.base_count + i] == unpack(normalize(na + nb, 1e-12f, na))) << i;
    }
  }
}

TEST(pairs, any_processor_works_them_alike) {
  const Surface& surface = *adult().head.surface;
  const FineSkin& fine = adult().folds.skin;
  const Folds& folds = adult().folds;
  std::mt19937 random(10);
  std::uniform_real_distribution<float> height(-0.5f, 0.5f);
  for (const Pose& pose : list_poses()) {
    std::vector<Twin> points, places, normals;
    pair_points(pose_points(pose), surface.mirror, points);
    deform_pairs(surface, points, places);
    std::vector<Twin> own_places(places.size()), own_normals(places.size(), Twin{});
    plain::deform(surface, points.data(), own_places.data());
    EXPECT_TRUE(is_same(places, own_places));

    update_pair_normals(surface, places, normals);
    plain::add_areas(surface, places.data(), own_normals.data());
    plain::normalize_all(own_normals.data(), own_normals.size());
    EXPECT_TRUE(is_same(normals, own_normals));

    append_fine_pairs(fine, places, normals);
    own_places.resize(fine.pairs.size());
    own_normals.resize(fine.pairs.size());
    plain::append_fine(fine, own_places.data(), own_normals.data());
    EXPECT_TRUE(is_same(places, own_places));
    EXPECT_TRUE(is_same(normals, own_normals));

    std::vector<glm::vec3> all(fine.vertex_count()), all_normals(fine.vertex_count());
    unpack_pairs(fine.pairs, places, 0, all);
    unpack_pairs(fine.pairs, normals, 0, all_normals);
    FoldPlaces folded;
    pack_pairs(folds.vertices, all, folded.places);
    pack_pairs(folds.vertices, all_normals, folded.normals);
    for (const MirrorPair& pair : folds.vertices) {
      const float left = height(random);
      folded.heights.push_back(left);
      folded.heights.push_back(pair.is_middle() ? left : height(random));
    }
    FoldPlaces own = folded;
    press_pairs(folds.vertices, folds.triangles, 0.5f, folded);
    for (std::size_t i = 0; i < own.places.size(); ++i) {
      own.places[i].left[3] = own.heights[2 * i];
      own.places[i].right[3] = own.heights[2 * i + 1];
    }
    own.slopes.assign(own.places.size(), Twin{});
    plain::press(folds.vertices, folds.triangles, 0.5f, own);
    EXPECT_TRUE(is_same(folded.places, own.places));
    EXPECT_TRUE(is_same(folded.normals, own.normals));
  }
}

}  // namespace
}  // namespace mien

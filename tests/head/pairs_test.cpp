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

    FoldPlaces folded;
    for (std::size_t i = 0; i < folds.vertices.size(); ++i) {
      Twin& place = folded.places.emplace_back(places[folds.slots[i]]);
      place.left[3] = height(random);
      place.right[3] = folds.vertices[i].is_middle() ? place.left[3] : height(random);
      folded.normals.push_back(normals[folds.slots[i]]);
    }
    FoldPlaces own = folded;
    press_pairs(folds.vertices, folds.triangles, 0.5f, folded);
    own.slopes.assign(own.places.size(), Twin{});
    plain::press(folds.vertices, folds.triangles, 0.5f, own);
    EXPECT_TRUE(is_same(folded.places, own.places));
    EXPECT_TRUE(is_same(folded.normals, own.normals));
  }
}

// A hair keeps its shape and stands in the frame of its place on the skin.
TEST(pairs, hairs_stand_as_one_after_the_other_would) {
  const Figure& figure = adult();
  const NeutralHead& head = figure.head;
  for (const Pose& pose : list_poses()) {
    std::vector<Twin> points, places, normals;
    pair_points(pose_points(pose), head.surface->mirror, points);
    deform_pairs(*head.surface, points, places);
    update_pair_normals(*head.surface, places, normals);
    std::vector<glm::vec3> skin(head.surface->vertex_count()), shading = skin;
    unpack_pairs(head.surface->pairs, places, skin);
    unpack_pairs(head.surface->pairs, normals, shading);
    for (std::size_t p = 0; p < figure.parts.size(); ++p) {
      if (figure.parts[p].mount != Mount::strands) continue;
      const Mesh& rest = figure.model.parts[p].rest;
      std::vector<glm::vec3> placed(rest.positions.size()), shaded = placed, own = placed,
                                                            own_shaded = placed;
      place_hairs(figure.roots[p], places, normals, placed.data(), shaded.data());
      plain::place_hairs(figure.roots[p], places.data(), normals.data(), own.data(), own_shaded.data());
      ASSERT_TRUE(placed == own && shaded == own_shaded);
      for (const Binding& binding : figure.parts[p].bindings) {
        const auto frame_on = [&](const std::vector<glm::vec3>& at, const std::vector<glm::vec3>& up) {
          return compute_skin_frame(at, up, head.skin.triangles[binding.triangle], binding.barycentric);
        };
        const SkinFrame from = frame_on(head.skin.positions, head.skin.normals), to = frame_on(skin, shading);
        const glm::mat3 turn = to.axes * glm::transpose(from.axes);
        for (std::uint32_t i = binding.first; i < binding.first + binding.count; ++i) {
          const glm::vec3 arm = rest.positions[i] - from.origin, up = rest.normals[i];
          ASSERT_EQ(placed[i], to.origin + (turn[0] * arm.x + turn[1] * arm.y + turn[2] * arm.z));
          ASSERT_EQ(shaded[i], turn[0] * up.x + turn[1] * up.y + turn[2] * up.z);
        }
      }
    }
  }
}

TEST(pairs, of_hairs_whose_number_is_odd_none_is_left_out) {
  bool has_odd = false;
  for (std::size_t p = 0; p < adult().parts.size(); ++p) {
    const HairRoots& roots = adult().roots[p];
    const std::size_t count = adult().parts[p].bindings.size();
    has_odd = has_odd || count % 2 == 1;
    EXPECT_EQ(roots.corners.size(), count + count % 2);
    if (count == 0) continue;
    EXPECT_EQ(roots.arms.size(), adult().model.parts[p].rest.positions.size());
  }
  EXPECT_TRUE(has_odd);
}

// A skin that is pressed to a point has frames as well.
TEST(pairs, hairs_on_a_collapsed_skin_stay_finite) {
  const Figure& figure = adult();
  const std::vector<Twin> nothing(figure.head.surface->pairs.size(), Twin{});
  for (std::size_t p = 0; p < figure.parts.size(); ++p) {
    std::vector<glm::vec3> placed(figure.roots[p].arms.size()), shaded = placed;
    place_hairs(figure.roots[p], nothing, nothing, placed.data(), shaded.data());
    for (const glm::vec3& v : placed) ASSERT_TRUE(std::isfinite(v.x + v.y + v.z));
    for (const glm::vec3& v : shaded) ASSERT_TRUE(std::isfinite(v.x + v.y + v.z));
  }
}

}  // namespace
}  // namespace mien

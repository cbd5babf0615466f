#include "core/thin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <set>

#include "solids.hpp"

namespace mien {
namespace {

// A closed tube round the z axis with flat ends: 40 rings of 24 vertices, bent in its second pose.
struct Tube {
  std::vector<std::vector<glm::vec3>> poses{2};
  std::vector<Triangle> triangles;
};

Tube build_tube() {
  constexpr int kRings = 40, kSides = 24;
  Tube tube;
  for (int r = 0; r < kRings; ++r)
    for (int s = 0; s < kSides; ++s) {
      const float turn = 6.2831853f * float(s) / kSides, z = float(r);
      const glm::vec3 p(5 * std::cos(turn), 5 * std::sin(turn), z);
      tube.poses[0].push_back(p);
      const float bend = r > 20 ? float(r - 20) : 0;
      tube.poses[1].push_back(p + glm::vec3(0.05f * bend * bend, 0, 0));
    }
  const auto at = [&](int r, int s) { return std::uint32_t(r * kSides + s % kSides); };
  for (int r = 0; r + 1 < kRings; ++r)
    for (int s = 0; s < kSides; ++s) {
      tube.triangles.push_back({at(r, s), at(r, s + 1), at(r + 1, s + 1)});
      tube.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r + 1, s)});
    }
  for (const int r : {0, kRings - 1}) {
    const auto middle = std::uint32_t(tube.poses[0].size());
    for (auto& pose : tube.poses) pose.push_back(0.5f * (pose[at(r, 0)] + pose[at(r, kSides / 2)]));
    for (int s = 0; s < kSides; ++s)
      tube.triangles.push_back(r == 0 ? Triangle{middle, at(r, s + 1), at(r, s)}
                                      : Triangle{middle, at(r, s), at(r, s + 1)});
  }
  return tube;
}

TEST(thin_posed, keeps_a_closed_surface_closed_and_its_volume_in_every_pose) {
  const Tube tube = build_tube();
  ASSERT_EQ(count_open_edges(tube.triangles), 0U);
  const auto thin = thin_posed(tube.poses, tube.triangles, std::vector<bool>(tube.poses[0].size()), 500);
  EXPECT_LE(thin.size(), 500U);
  EXPECT_EQ(count_open_edges(thin), 0U);
  for (const auto& pose : tube.poses)
    EXPECT_NEAR(compute_volume_mm3({pose, {}, thin}) / compute_volume_mm3({pose, {}, tube.triangles}), 1,
                0.02);
}

TEST(thin_posed, takes_most_where_no_pose_bends) {
  const Tube tube = build_tube();
  const auto thin = thin_posed(tube.poses, tube.triangles, std::vector<bool>(tube.poses[0].size()), 800);
  std::set<std::uint32_t> straight, bent;
  for (const Triangle& t : thin)
    for (const std::uint32_t v : t)
      if (v < 40 * 24) (v < 20 * 24 ? straight : bent).insert(v);
  EXPECT_LT(2 * straight.size(), bent.size());
}

// Two flat nets: nothing costs anything, and what is sound in one pose may fold over in the other. The first
// is shaken, the second stirred: there large triangles fold where small ones only shear.
TEST(thin_posed, turns_nothing_over_in_any_pose) {
  constexpr int kSide = 24;
  const auto at = [](int x, int y) { return std::uint32_t(y * (kSide + 1) + x); };
  std::vector<Triangle> triangles;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  const auto count_turned = [&](const std::vector<Triangle>& mesh, const std::vector<glm::vec3>& pose) {
    return std::ranges::count_if(mesh, [&](const Triangle& t) {
      return glm::cross(pose[t[1]] - pose[t[0]], pose[t[2]] - pose[t[0]]).z <= 0;
    });
  };
  std::mt19937 random(4);
  std::uniform_real_distribution<float> shift(-0.3f, 0.3f);
  const auto shake = [&](glm::vec2 p) { return p + glm::vec2(shift(random), shift(random)); };
  const auto stir = [](glm::vec2 p) {
    const glm::vec2 arm = p - glm::vec2(0.5f * kSide);
    const float turn = 2.5f * std::exp(-glm::dot(arm, arm) / 40);
    return glm::vec2(0.5f * kSide) + glm::vec2(std::cos(turn) * arm.x - std::sin(turn) * arm.y,
                                               std::sin(turn) * arm.x + std::cos(turn) * arm.y);
  };
  const std::array<std::function<glm::vec2(glm::vec2)>, 2> ways{shake, stir};
  for (const auto& way : ways) {
    std::vector<std::vector<glm::vec3>> poses(2);
    for (int y = 0; y <= kSide; ++y)
      for (int x = 0; x <= kSide; ++x) {
        const bool is_inner = x > 0 && y > 0 && x < kSide && y < kSide;
        const glm::vec2 p(x, y);
        poses[0].emplace_back(p, 0);
        poses[1].emplace_back(is_inner ? way(p) : p, 0);
      }
    for (const auto& pose : poses) ASSERT_EQ(count_turned(triangles, pose), 0);
    const auto thin = thin_posed(poses, triangles, std::vector<bool>(poses[0].size()), 120);
    EXPECT_LT(thin.size(), triangles.size() / 2);
    for (const auto& pose : poses) EXPECT_EQ(count_turned(thin, pose), 0);
  }
}

TEST(thin_posed, leaves_locked_vertices_and_open_edges) {
  Tube tube = build_tube();
  tube.triangles.resize(39 * 24 * 2);  // without its ends
  std::vector<bool> is_locked(tube.poses[0].size(), false);
  for (int s = 0; s < 24; ++s) is_locked[10 * 24 + s] = true;
  const auto thin = thin_posed(tube.poses, tube.triangles, is_locked, 100);
  std::set<std::uint32_t> kept;
  for (const Triangle& t : thin) kept.insert(t.begin(), t.end());
  for (const int ring : {0, 10, 39})
    for (int s = 0; s < 24; ++s) EXPECT_TRUE(kept.contains(std::uint32_t(ring * 24 + s))) << ring << ' ' << s;
}

TEST(thin_posed, does_nothing_where_there_is_little) {
  const Tube tube = build_tube();
  EXPECT_EQ(thin_posed(tube.poses, tube.triangles, {}, tube.triangles.size()), tube.triangles);
  EXPECT_EQ(thin_posed({}, tube.triangles, {}, 3), tube.triangles);
}

}  // namespace
}  // namespace mien

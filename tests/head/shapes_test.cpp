#include "head/shapes.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/error.hpp"
#include "core/monotone.hpp"
#include "core/text.hpp"
#include "head/cage.hpp"
#include "places.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

TEST(shapes, guide_lines_stand_where_the_head_has_them) {
  HeadSpec spec;
  const auto adult = measure_guide_heights(build_neutral_head(shipped().heads, spec));
  std::vector<std::string> names;
  for (const auto& [name, y] : adult) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"chin", "mouth_line", "nose_base", "eye_line", "brow_line",
                                             "hairline", "crown"}));
  EXPECT_NEAR(adult[3].second, 0, 1e-6);  // the origin is at the height of the pupils
  for (const char* age : {"infant", "child", "teenager"}) {
    spec.age = {{age, 1.0}};
    const NeutralHead head = build_neutral_head(shipped().heads, spec);
    const auto heights = measure_guide_heights(head);
    EXPECT_NEAR(heights[3].second, head.eye.centre.y, 1e-6) << age;
    EXPECT_NEAR(heights.back().second, compute_bounds(head.skin.positions).high.y, 1e-4) << age;
    for (std::size_t i = 1; i < heights.size(); ++i)
      EXPECT_GT(heights[i].second, heights[i - 1].second + 5) << age << heights[i].first;
  }
}

TEST(shapes, moved_guide_lines_are_measured_where_they_were_moved) {
  HeadSpec spec;
  spec.guides = {{"eye_line", 0.46}, {"hairline", 0.8}, {"mouth_line", 0.22}};
  const auto heights = measure_guide_heights(build_neutral_head(shipped().heads, spec));
  const double chin = heights.front().second, height = heights.back().second - chin;
  for (const auto& [name, y] : heights)
    if (spec.guides.contains(name)) {
      EXPECT_NEAR((y - chin) / height, spec.guides.at(name), 0.002) << name;
    }
}

// At half its strength, on the adult: no feature pulls against another, and none yields.
// A ball that is made smaller looks out of its socket as far as before.
TEST(shapes, the_front_of_the_eye_stays_where_it_is) {
  const Cage& cage = shipped().heads.adult;
  for (const double share : {0.7, 1.0, 1.2}) {
    Warp warp;
    warp.height = build_monotone_curve({{-300, -300}, {300, 300}});
    warp.eye = share;
    const HeadForm warped = apply_warp(cage, Eye{}, warp);
    EXPECT_NEAR(warped.eye.radius_mm, share * Eye{}.radius_mm, 1e-9);
    EXPECT_NEAR(warped.eye.centre.z + warped.eye.radius_mm, Eye{}.centre.z + Eye{}.radius_mm, 1e-9) << share;
  }
}

TEST(shapes, features_move_their_points_by_what_the_table_says) {
  const HeadStock& stock = shipped().heads;
  const HeadShapes& shapes = shipped().stock.head->shapes.heads;
  std::size_t count = 0;
  for (const auto& [name, feature] : shapes.features) {
    HeadSpec spec;
    spec.features = {{name, 0.5}};
    HeadForm form{stock.adult.points, Eye{}};
    shape_head(shapes, spec, stock.adult, form);
    for (const auto& [point, move] : feature.handles) {
      if (point[0] == 'E' || point[0] == 'M') continue;  // lids go with the ball, and lips touch anew
      const std::uint32_t i = find_point(stock.adult, point);
      EXPECT_LT(glm::distance(form.points[i] - stock.adult.points[i], 0.5 * move),
                0.02 * glm::length(move) + 1e-3)
          << name << " " << point;
      ++count;
    }
  }
  EXPECT_GT(count, 100u);
}

// Two that move a point the same way move it less than both together would, and further than either.
TEST(shapes, features_that_pull_the_same_way_yield) {
  const HeadStock& stock = shipped().heads;
  const HeadShapes& shapes = shipped().stock.head->shapes.heads;
  std::size_t count = 0;
  for (const auto& [one, first] : shapes.features)
    for (const auto& [other, second] : shapes.features)
      for (const auto& [point, move] : first.handles) {
        const auto also = second.handles.find(point);
        if (one >= other || also == second.handles.end() || point[0] == 'E' || point[0] == 'M') continue;
        const double alone = std::max(glm::length(move), glm::length(also->second));
        const double both = glm::length(move + also->second);
        if (alone < 1 || both < 1.3 * alone) continue;
        HeadSpec spec;
        spec.features = {{one, 1.0}, {other, 1.0}};
        HeadForm form{stock.adult.points, Eye{}};
        shape_head(shapes, spec, stock.adult, form);
        const std::uint32_t i = find_point(stock.adult, point);
        const double way = glm::distance(form.points[i], stock.adult.points[i]);
        EXPECT_LT(way, both - 0.4 * (both - alone)) << one << ' ' << other << ' ' << point;
        EXPECT_GT(way, alone - 0.1) << one << ' ' << other << ' ' << point;
        ++count;
        break;
      }
  EXPECT_GT(count, 0u);
}

TEST(shapes, character_is_a_feature_too) {
  HeadSpec key, feature;
  key.character = -0.75;
  feature.features = {{"character", -0.75}};
  EXPECT_EQ(build_neutral_head(shipped().heads, key).cage.points,
            build_neutral_head(shipped().heads, feature).cage.points);
}

TEST(shapes, features_tell_their_meaning_and_view) {
  for (const FeatureInfo& feature : shipped().stock.head->shapes.features) {
    EXPECT_FALSE(feature.meaning.empty()) << feature.name;
    EXPECT_FALSE(feature.around.empty()) << feature.name;
    EXPECT_TRUE(shipped().stock.head->shapes.heads.features.contains(feature.name)) << feature.name;
  }
}

}  // namespace
}  // namespace mien

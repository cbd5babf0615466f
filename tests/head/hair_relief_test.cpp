// Hair as a body: higher than the skin by what prints, and never hanging over more steeply than that.
#include "head/hair_relief.hpp"

#include <gtest/gtest.h>

#include "core/conventions.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

constexpr double kFine_mm = 4;  // of the head for one of the print: a bust of 80 mm

NeutralHead make_head() {
  HeadSpec spec;
  spec.design = {{"comic", 1.0}};
  return build_neutral_head(shipped().heads, spec);
}

double measure_over_mm(const HairRelief& relief, const HairPlace& place) {
  return sample_hair_relief(relief, place) - sample_hair_chart(relief.chart, relief.chart.skin_mm, place);
}

TEST(hair_relief, ends_in_a_step_that_prints) {
  constexpr double kWay = 0.005, kReach_mm = 3 * kFine_mm;
  const NeutralHead head = make_head();
  for (const char* cut : {"crop", "side_part", "pixie", "bob", "long", "wavy", "curls", "ponytail", "bun"}) {
    ASSERT_TRUE(has_hair_mass(head, cut));
    const HairRelief relief = build_hair_relief(head, cut, {}, kFine_mm);
    for (int azimuth = -30; azimuth <= 30; azimuth += 5) {  // the forehead
      double end = 0.2;
      while (end < 1.5 && measure_over_mm(relief, {double(azimuth), end}) > 0) end += kWay;
      double most = 0;
      for (double way = end; way > end - kReach_mm / relief.chart.drop_mm; way -= kWay)
        most = std::max(most, measure_over_mm(relief, {double(azimuth), way}));
      EXPECT_GT(most / kFine_mm, 1.2) << cut << ' ' << azimuth;
    }
  }
}

TEST(hair_relief, hangs_over_no_more_than_half_a_right_angle) {
  constexpr double kStep = HairChart::kLongest / (HairRelief::kWays - 1);
  const NeutralHead head = make_head();
  for (const char* cut : {"bob", "long", "ponytail", "bun", "crop"}) {
    const HairRelief relief = build_hair_relief(head, cut, {}, kFine_mm);
    for (int azimuth = -180; azimuth < 180; azimuth += 3)
      for (int row = 1; row < HairRelief::kWays; ++row) {
        const HairPlace above{double(azimuth), (row - 1) * kStep}, here{double(azimuth), row * kStep};
        if (above.way < 1 || measure_over_mm(relief, above) < 0 || measure_over_mm(relief, here) < 0)
          continue;
        EXPECT_LT(sample_hair_relief(relief, above) - sample_hair_relief(relief, here),
                  kStep * relief.chart.drop_mm)
            << cut << ' ' << azimuth << ' ' << here.way;
      }
  }
}

TEST(hair_relief, leaves_brows_and_the_chest_free) {
  const NeutralHead head = make_head();
  const HairChart chart = build_hair_relief(head, "bob", {}, kFine_mm).chart;
  HairSurroundings around;
  for (double azimuth = 5; azimuth < 40; azimuth += 2)
    around.face.emplace_back(compute_hair_point(chart, {azimuth, 0.6}, 100));
  const HairRelief relief = build_hair_relief(head, "bob", around, kFine_mm);
  for (double azimuth = 10; azimuth < 34; azimuth += 2)
    EXPECT_LT(measure_over_mm(relief, {azimuth, 0.6}), 0) << azimuth;
  EXPECT_GT(measure_over_mm(relief, {-20, 0.6}), 0);
}

TEST(hair_relief, of_painted_cuts_is_none) {
  const NeutralHead head = make_head();
  EXPECT_FALSE(has_hair_mass(head, "none"));
  EXPECT_FALSE(has_hair_mass(head, "buzz"));
}

}  // namespace
}  // namespace mien

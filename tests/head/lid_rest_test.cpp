#include "head/lid_rest.hpp"

#include <gtest/gtest.h>

#include "config/words.hpp"
#include "head/contact.hpp"
#include "head/form.hpp"
#include "places.hpp"
#include "random_heads.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

const HeadStock& stock() {
  static const HeadStock made = shipped().heads;
  return made;
}

IrisCover measure(const Cage& cage, const Eye& eye) {
  return measure_iris_cover(*stock().surface, cage, shipped().stock.head->parts.eye, eye);
}

// Seating a lid on the ball afterwards shifts its edge a little.
constexpr double kShift_mm = 0.12;

void expect_rest(const HeadSpec& spec, const std::string& name) {
  const HeadForm form = build_form(stock(), spec);
  Cage cage = stock().adult;
  cage.points = form.points;
  const IrisCover cover = measure(cage, form.eye);
  EXPECT_GT(cover.upper_mm, kUpperLidRest.least_mm - kShift_mm) << name;
  EXPECT_LT(cover.upper_mm, kUpperLidRest.most_mm + kShift_mm) << name;
  EXPECT_GT(cover.lower_mm, kLowerLidRest.least_mm - kShift_mm) << name;
  EXPECT_LT(cover.lower_mm, kLowerLidRest.most_mm + kShift_mm) << name;
}

TEST(lid_rest, hides_the_top_of_the_iris_at_every_age_and_on_every_skull) {
  for (const std::string& age : kAges)
    for (const std::string& skull : kSkulls)
      for (const double character : {-1.0, 0.0, 1.0}) {
        HeadSpec spec;
        spec.age = {{age, 1.0}};
        spec.skull = {{skull, 1.0}};
        spec.character = character;
        expect_rest(spec, describe_spec(spec));
      }
}

TEST(lid_rest, hides_the_top_of_the_iris_on_random_heads) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const HeadSpec spec = build_random_spec(seed, stock().data->shapes.heads);
    expect_rest(spec, describe_spec(spec));
  }
}

// The margin of the upper lid `mm` higher than the adult's.
Cage raise_upper_lid(double mm) {
  Cage cage = stock().adult;
  for (std::size_t i = 0; i < cage.names.size(); ++i)
    for (int column = 1; column < 8; ++column)
      for (const char* ring : {"EB_", "E0_", "E1_", "E2_", "E3_"})
        if (strip_side(cage.names[i]) == ring + std::to_string(column)) cage.points[i].y += mm;
  return cage;
}

TEST(lid_rest, measures_what_a_lid_leaves_free) {
  const double at_rest = measure(stock().adult, Eye{}).upper_mm;
  EXPECT_NEAR(measure(raise_upper_lid(2), Eye{}).upper_mm, at_rest - 2, 0.1);
  Eye larger;  // whose numbers count as on an eye of the adult's size
  larger.radius_mm *= 1.1;
  EXPECT_GT(measure(stock().adult, larger).upper_mm, at_rest + 0.3);
}

TEST(lid_rest, brings_a_startled_lid_down_and_leaves_a_resting_one) {
  const EyeNumbers numbers = shipped().stock.head->parts.eye;
  Cage startled = raise_upper_lid(2.5);
  EXPECT_LT(measure(startled, Eye{}).upper_mm, 0) << "white over the iris";
  const Cage before = startled;
  rest_lids(*stock().surface, numbers, Eye{}, startled);
  EXPECT_NEAR(measure(startled, Eye{}).upper_mm, kUpperLidRest.least_mm, 0.02);
  for (const char* corner : {"E0_0", "E1_0", "E0_8", "E1_8", "E5_4"}) {
    const std::uint32_t point = find_point(startled, corner);
    EXPECT_EQ(startled.points[point], before.points[point]) << corner;
  }
  for (std::size_t i = 0; i < startled.points.size(); ++i)
    EXPECT_EQ(startled.points[startled.mirror[i]], startled.points[i] * glm::dvec3(-1, 1, 1));
  const Cage rested = startled;
  rest_lids(*stock().surface, numbers, Eye{}, startled);
  EXPECT_EQ(startled.points, rested.points);
}

}  // namespace
}  // namespace mien

#include "head/design.hpp"

#include <gtest/gtest.h>

#include "config/words.hpp"
#include "core/conventions.hpp"
#include "head/cage.hpp"
#include "head/contact.hpp"
#include "head/form.hpp"
#include "head/least_squares.hpp"
#include "head/lens.hpp"
#include "head/surface.hpp"
#include "random_heads.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

const HeadStock& stock() { return shipped().heads; }

HeadSpec make_spec(const std::string& age, const std::string& design) {
  HeadSpec spec;
  spec.age = {{age, 1.0}};
  spec.design = {{design, 1.0}};
  return spec;
}

double measure_opening_mm(const HeadForm& form) {
  const auto height = [&](const char* point) {
    return sample_row(compute_limit_row(*stock().surface, find_point(stock().adult, point)), form.points).y;
  };
  return height("E1_4") - height("E1_12");
}

void expect_mirrored(const HeadForm& form, const std::string& name) {
  for (std::size_t i = 0; i < form.points.size(); ++i)
    ASSERT_EQ(form.points[stock().adult.mirror[i]], form.points[i] * glm::dvec3(-1, 1, 1))
        << name << ' ' << i;
}

TEST(design, real_is_the_head_bit_for_bit) {
  HeadSpec spec;
  spec.age = {{"child", 1.0}};
  const HeadForm plain = build_form(stock(), spec);
  spec.design = {{"comic", 1.0}};
  EXPECT_NE(build_form(stock(), spec).points, plain.points);
  spec.design = {{kReal, 1.0}};
  EXPECT_EQ(build_form(stock(), spec).points, plain.points);
}

TEST(design, comic_eyes_are_wide_open_on_every_age_and_mouths_low) {
  for (const std::string& age : kAges) {
    const HeadForm real = build_form(stock(), make_spec(age, kReal)),
                   comic = build_form(stock(), make_spec(age, "comic"));
    EXPECT_GT(measure_opening_mm(comic), 1.7 * measure_opening_mm(real)) << age;
    EXPECT_GT(comic.eye.radius_mm, (age == "infant" ? 1.3 : 1.45) * real.eye.radius_mm) << age;
    expect_mirrored(comic, age);
    const auto lips = [&](const HeadForm& form) {
      return form.points[find_point(stock().adult, "M3_0")].y -
             form.points[find_point(stock().adult, "M3_12")].y;
    };
    EXPECT_LT(lips(comic), 0.7 * lips(real)) << age;
  }
}

// As far as a lid may be in the ball, or off it, against the size of the eye: a real head's bounds.
TEST(design, lids_touch_the_ball_on_every_design_and_age) {
  for (const Design& design : stock().data->designs)
    for (const std::string& age : kAges) {
      const HeadForm form = build_form(stock(), make_spec(age, design.name));
      const double size = form.eye.radius_mm / Eye{}.radius_mm;
      Cage cage = stock().adult;
      cage.points = form.points;
      for (const MarginVertex& margin : compute_lid_ring(*stock().surface, cage)) {
        if (!touches_eye(margin.at)) continue;
        const glm::dvec3 place = sample_row(compute_limit_row(*stock().surface, margin.vertex), form.points);
        const double off = compute_standoff_mm(stock().data->parts.eye, form.eye, place);
        EXPECT_GT(off, -0.1 * size) << design.name << ' ' << age << ' ' << margin.at;
        EXPECT_LT(off, 0.5 * size) << design.name << ' ' << age << ' ' << margin.at;
      }
    }
}

TEST(design, half_a_design_lies_between) {
  HeadSpec spec;
  spec.design = {{kReal, 0.5}, {"comic", 0.5}};
  const double real = measure_opening_mm(build_form(stock(), make_spec("adult", kReal)));
  const double half = measure_opening_mm(build_form(stock(), spec));
  const double comic = measure_opening_mm(build_form(stock(), make_spec("adult", "comic")));
  EXPECT_GT(half, real + 0.2 * (comic - real));
  EXPECT_LT(half, real + 0.8 * (comic - real));
}

// What a square skull has of its own, a caricature has more than twice.
TEST(design, a_caricature_exaggerates_what_is_not_average) {
  const auto measure = [&](const std::string& skull, const std::string& design) {
    HeadSpec spec = make_spec("adult", design);
    spec.skull = {{skull, 1.0}};
    const HeadForm form = build_form(stock(), spec);
    return form.points[find_point(stock().adult, "m12_D1")].y -
           form.points[find_point(stock().adult, "M1_0")].y;
  };
  const double real = std::abs(measure("square", kReal) - measure("round", kReal));
  EXPECT_GT(std::abs(measure("square", "caricature") - measure("round", "caricature")), 1.7 * real);
}

TEST(lens, leaves_what_is_far_and_mirrors_to_the_last_bit) {
  NeutralHead head;
  head.design.lens_height = 1.4;
  head.design.lens_flat = 0.25;
  const Lens lens = build_lens(head);
  ASSERT_TRUE(lens.is_on());
  EXPECT_EQ(bend(lens, {31.5, 200, 69.5}), glm::dvec3(31.5, 200, 69.5));
  EXPECT_EQ(bend(lens, {31.5, 0, -80}), glm::dvec3(31.5, 0, -80));
  EXPECT_NEAR(bend(lens, {31.5, 10, 79.5}).y, 14, 1e-9);  // within the ball all is stretched alike
  for (double y = -60; y <= 60; y += 3.7)
    for (double x = 0; x <= 70; x += 2.9)
      for (double z = 40; z <= 95; z += 7.1) {
        const glm::dvec3 left = bend(lens, {x, y, z}), right = bend(lens, {-x, y, z});
        EXPECT_EQ(left * glm::dvec3(-1, 1, 1), right);
        // Nothing turns over: what was above stays above.
        EXPECT_GT(bend(lens, {x, y + 0.5, z}).y, left.y);
      }
  EXPECT_FALSE(build_lens(NeutralHead{}).is_on());
}

}  // namespace
}  // namespace mien

// Limits that are told as lengths, by our names and by the thesis's.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "config/load_spec.hpp"
#include "core/error.hpp"
#include "face/limits.hpp"
#include "frames/figure.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

HeadSpec load_limits(const std::string& age, const std::string& limits) {
  return load_spec("limits.yaml", fmt::format("mien: 1\nhead: {{age: {}, limits: {{{}}}}}\n", age, limits),
                   *shipped().stock.language)
      .head;
}

double measure(const Figure& figure, const std::string& name, bool in_mm = true) {
  for (const Limit& limit : measure_limits(figure.head, figure.face, figure.limits))
    if (limit.name->name == name) return in_mm ? limit.mm : limit.value;
  ADD_FAILURE() << name;
  return 0;
}

TEST(limit_lengths, are_reached_on_every_head) {
  for (const char* age : {"infant", "adult"}) {
    const Figure figure =
        build_figure(shipped().heads, load_limits(age,
                                                  "brow.left.up: 6mm, corners.out: 0.4cm, chin.down: 15mm, "
                                                  "lid.right.lower: 2mm, eyes.up: 3mm"));
    EXPECT_NEAR(measure(figure, "brow.left.up"), 6, 0.001) << age;
    EXPECT_NEAR(measure(figure, "corner.left.out"), 4, 0.001) << age;
    EXPECT_NEAR(measure(figure, "corner.right.out"), 4, 0.001) << age;
    EXPECT_NEAR(measure(figure, "chin.down"), 15, 0.001) << age;
    EXPECT_NEAR(measure(figure, "lid.right.lower"), 2, 0.001) << age;
    EXPECT_NEAR(measure(figure, "eye.left.up"), 3, 0.001) << age;
  }
}

TEST(limit_lengths, in_face_units_are_the_same_share_of_every_face) {
  for (const char* age : {"infant", "adult"}) {
    const Figure figure = build_figure(
        shipped().heads, load_limits(age, "brows.up: 0.2eye_nose, lips.upper_up: 0.2 mouth_nose"));
    EXPECT_NEAR(measure(figure, "brow.right.up", false), 0.2, 1e-5) << age;
    EXPECT_NEAR(measure(figure, "lips.upper_up", false), 0.2, 1e-5) << age;
  }
}

TEST(limit_lengths, have_the_names_of_the_thesis) {
  // Its left is the viewer's, which is the character's right; our own name stands above it.
  const HeadSpec head = load_limits("adult",
                                    "EYEBROW_L_U_VERT_LIMIT: 5mm, EYEBROW_R_U_VERT_LIMIT: 0.5, "
                                    "EYEBROW_ROTATE_RANGE: 0.7, brow.left.turn_up: 0.4, CHIN_D_LIMIT: 0");
  EXPECT_EQ(head.limit_lengths.at("brow.right.up").value, 5);
  EXPECT_EQ(head.limits.at("brow.left.up"), 0.5);
  EXPECT_EQ(head.limits.at("brow.right.turn_down"), 0.7);
  EXPECT_EQ(head.limits.at("brow.left.turn_up"), 0.4);
  EXPECT_EQ(head.limits.at("chin.down"), 0);
}

TEST(limit_lengths, that_no_face_reaches_are_told_at_their_place) {
  try {
    build_figure(shipped().heads, load_limits("adult", "brow.left.up: 50mm"));
    FAIL();
  } catch (const InputError& error) {
    const std::string told = error.what();
    EXPECT_TRUE(told.starts_with("limits.yaml:2:")) << told;
    EXPECT_NE(told.find("'brow.left.up' goes "), told.npos) << told;
    EXPECT_NE(told.find(" mm at most on this head; expected no more than that"), told.npos) << told;
  }
}

}  // namespace
}  // namespace mien

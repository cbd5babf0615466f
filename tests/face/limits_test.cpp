// Limits by name: what they say is what the skin does.
#include "face/limits.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/data.hpp"
#include "frames/figure.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

Figure build(const std::string& age, const std::string& skull, std::map<std::string, double> limits = {}) {
  HeadSpec spec;
  spec.age = {{age, 1.0}};
  spec.skull = {{skull, 1.0}};
  spec.limits = std::move(limits);
  return build_figure(shipped().heads, spec);
}

std::vector<Limit> measure(const Figure& figure) {
  return measure_limits(figure.head, figure.face, figure.limits);
}

const Limit& find(const std::vector<Limit>& limits, const std::string& name) {
  return *std::find_if(limits.begin(), limits.end(), [&](const Limit& l) { return l.name->name == name; });
}

glm::dvec3 travel(const Figure& figure, const Limit& limit) {
  Pose pose;
  pose.values[limit.name->move] = limit.name->sign;
  std::vector<glm::dvec3> points;
  pose_cage(figure.head, figure.face, apply_limits(figure.limits, pose), points);
  const std::uint32_t i = figure.head.cage.index.find(limit.point)->second;
  return points[i] - figure.head.cage.points[i];
}

// Toward the match level the lips meet before their limit.
bool is_contact(const Limit& limit) { return limit.name->thesis == "LIPS_MATCH_LEVEL"; }

// Lids, lips, corners, cheeks, jaw to the sides and forward, mouth, nose.
constexpr int kBeyond = 2 * 2 + 7 + 2 * 3 + 2 * 2 + 2 + 1 + 2 + 2 * 1;

TEST(limits, are_the_way_that_their_point_goes_on_every_head) {
  for (const auto& [age, skull] :
       {std::pair{"adult", "average"}, {"infant", "round"}, {"teenager", "square"}}) {
    const Figure figure = build(age, skull);
    int count = 0;
    for (const Limit& limit : measure(figure)) {
      if (limit.point == "pupil" || limit.point == kTonguePlace || is_contact(limit)) continue;
      ++count;
      const glm::dvec3 way = travel(figure, limit);
      const double mm = limit.axis < 0 ? glm::length(way) : std::abs(way[limit.axis]);
      EXPECT_NEAR(mm, limit.mm, 0.01 * limit.mm) << age << " " << limit.name->name;
      EXPECT_GT(limit.mm, 0.5) << age << " " << limit.name->name;
    }
    EXPECT_EQ(count, 2 * (6 + 2 + 4) + 2 + 2 + kBeyond);
  }
}

TEST(limits, of_an_eye_are_the_way_that_its_pupil_goes) {
  const Figure figure = build("adult", "average");
  int count = 0;
  for (const Limit& limit : measure(figure)) {
    const MoveInfo& info = kMoves[limit.name->move];
    if (info.area != "eye") continue;
    ++count;
    Pose pose;
    pose.values[limit.name->move] = limit.name->sign;
    const glm::dvec3 ahead(0, 0, figure.head.eye.radius_mm);
    const glm::dvec3 looking = compute_gaze(figure.face, pose, info.side) * ahead;
    EXPECT_NEAR(limit.mm, glm::distance(looking, ahead), 1e-6) << limit.name->name;
  }
  EXPECT_EQ(count, 8);
}

TEST(limits, tell_how_far_the_skin_goes) {
  const Figure figure = build("adult", "average");
  DeformBuffers buffers;
  Drawing drawing;
  for (const Limit& limit : measure(figure)) {
    if (limit.point == "pupil" || limit.point == kTonguePlace) continue;
    Pose pose;
    pose.values[limit.name->move] = limit.name->sign;
    buffers.has_folds = false;
    deform_figure(figure, pose, TurnKey{}, buffers, drawing);
    const std::uint32_t i = figure.head.cage.index.find(limit.point)->second;
    const double mm = glm::distance(drawing.parts.front().positions[i], figure.head.skin.positions[i]);
    EXPECT_NEAR(limit.skin_mm, mm, 1e-3) << limit.name->name;
    EXPECT_GT(limit.skin_mm, 0.5) << limit.name->name;
  }
}

TEST(limits, are_the_same_in_face_units_on_every_head) {
  const auto adult = measure(build("adult", "average")), infant = measure(build("infant", "round"));
  for (std::size_t i = 0; i < adult.size(); ++i) {
    EXPECT_NEAR(adult[i].value, infant[i].value, 1e-12) << adult[i].name->name;
    EXPECT_EQ(adult[i].unit, infant[i].unit);
  }
  EXPECT_LT(find(infant, "brow.left.up").mm, find(adult, "brow.left.up").mm);
}

TEST(limits, are_scaled_by_the_head_on_their_side_alone) {
  const Figure plain = build("adult", "average");
  const Figure scaled =
      build("adult", "average", {{"brow.left.up", 0.8}, {"chin.down", 0.5}, {"lips.lower_down", 0}});
  const auto before = measure(plain), after = measure(scaled);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const std::string& name = before[i].name->name;
    const double share = name == "brow.left.up"      ? 0.8
                         : name == "chin.down"       ? 0.5
                         : name == "lips.lower_down" ? 0
                                                     : 1;
    EXPECT_NEAR(after[i].value, share * before[i].value, 1e-12) << name;
    if (before[i].point == "pupil") continue;
    const glm::dvec3 way = travel(scaled, before[i]), full = travel(plain, before[i]);
    if (before[i].axis >= 0 && !is_contact(before[i])) {
      EXPECT_NEAR(way[before[i].axis], share * full[before[i].axis], 1e-9) << name;
    }
    if (share == 1) {
      EXPECT_EQ(way, full) << name;
    }
  }
}

TEST(limits, have_the_names_of_the_thesis_whose_left_is_the_viewers) {
  std::map<std::string, std::string> thesis;
  std::set<std::string> names;
  for (const LimitName& limit : list_limits()) {
    thesis[limit.name] = limit.thesis;
    names.insert(limit.thesis);
  }
  EXPECT_EQ(thesis.size(), list_limits().size());
  EXPECT_EQ(thesis["brow.left.up"], "EYEBROW_R_U_VERT_LIMIT");
  EXPECT_EQ(thesis["brow.left.out"], "EYEBROW_R_R_HORT_LIMIT");
  EXPECT_EQ(thesis["brow.right.in"], "EYEBROW_L_R_HORT_LIMIT");
  EXPECT_EQ(thesis["lid.right.lower"], "EYELID_LD_U_VERT_LIMIT");
  EXPECT_EQ(thesis["corner.left.in"], "MOUTH_CORNER_R_L_HORT_LIMIT");
  EXPECT_EQ(thesis["chin.down"], "CHIN_D_LIMIT");
  for (const char* side : {"L", "R"}) {
    const std::string s(side);
    for (const std::string& name :
         {"EYEBROW_" + s + "_U_VERT_LIMIT", "EYEBROW_" + s + "_D_VERT_LIMIT",
          "EYEBROW_" + s + "_L_HORT_LIMIT", "EYEBROW_" + s + "_R_HORT_LIMIT",
          "EYELID_" + s + "U_U_VERT_LIMIT", "EYELID_" + s + "D_U_VERT_LIMIT",
          "MOUTH_CORNER_" + s + "_U_VERT_LIMIT", "MOUTH_CORNER_" + s + "_D_VERT_LIMIT",
          "MOUTH_CORNER_" + s + "_L_HORT_LIMIT", "MOUTH_CORNER_" + s + "_R_HORT_LIMIT"})
      EXPECT_TRUE(names.contains(name)) << name;
  }
  for (const char* name :
       {"EYEBROW_ROTATE_RANGE", "LIP_U_VERT_LIMIT", "LIP_D_VERT_LIMIT", "LIPS_MATCH_LEVEL"})
    EXPECT_TRUE(names.contains(name)) << name;
}

TEST(limits, lifted_by_exaggerate_leave_lids_sound_and_every_point_finite) {
  const Figure figure = build("adult", "average");
  Pose pose;
  for (std::size_t i = 0; i < kMoveCount; ++i) pose.values[i] = kMoves[i].high * 1.5;
  std::vector<glm::dvec3> points;
  pose_cage(figure.head, figure.face, pose, points);
  for (const glm::dvec3& p : points)
    EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  for (int column = 1; column < 8; ++column) {
    const auto at = [&](int c) {
      return points[figure.head.cage.index.find("E1_" + std::to_string(c))->second];
    };
    EXPECT_GT(at(column).y, at(16 - column).y) << column;
  }
}

}  // namespace
}  // namespace mien

// Muscles after Waters (1987) and units after Ahlberg (2001) as fields of a head.
#include "face/doctrine.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "config/doctrine_data.hpp"
#include "head/cage.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

struct Subject {
  NeutralHead head;
  Face face;
};

Subject build(const std::string& age) {
  HeadSpec spec;
  spec.age = {{age, 1.0}};
  Subject subject;
  subject.head = build_neutral_head(shipped().heads, spec);
  subject.face = build_face(subject.head);
  return subject;
}

const Subject& adult() {
  static const Subject subject = build("adult");
  return subject;
}

std::size_t find(std::string_view name, Side side = Side::none) {
  for (const std::string_view key : {kMusclesKey, kCandideKey})
    if (const auto found = find_channel(key, side, name)) return *found;
  throw std::runtime_error(std::string(name));
}

std::vector<glm::dvec3> place(const Subject& s, const Pose& asked) {
  std::vector<glm::dvec3> points;
  pose_cage(s.head, s.face, resolve_channels(s.head.data->doctrines, asked), points);
  return points;
}

glm::dvec3 travel(const Subject& s, const Pose& pose, const char* point) {
  const std::uint32_t i = find_point(s.head.cage, point);
  return place(s, pose)[i] - s.head.cage.points[i];
}

Pose pose_of(std::string_view name, double value = 1) {
  Pose pose;
  for (const Side side : {Side::none, Side::left, Side::right})
    for (const std::string_view key : {kMusclesKey, kCandideKey})
      if (const auto found = find_channel(key, side, name)) pose.values[*found] = value;
  return pose;
}

TEST(doctrine, pulls_by_the_angle_and_the_distance_of_waters) {
  const glm::dvec3 skin(0, -10, 0);
  const double quarter = std::numbers::pi / 2, half = 45 * std::numbers::pi / 180;
  // On the axis: all of it where the pull is greatest, a cosine on both sides of it, nothing at the bone.
  EXPECT_DOUBLE_EQ(compute_pull({0, -8, 0}, skin, half, 0.8, 1.6), 1);
  EXPECT_NEAR(compute_pull({0, -4, 0}, skin, half, 0.8, 1.6), std::cos(0.5 * quarter), 1e-12);
  EXPECT_NEAR(compute_pull({0, -12, 0}, skin, half, 0.8, 1.6), std::cos(0.5 * quarter), 1e-12);
  EXPECT_EQ(compute_pull({0, 0, 0}, skin, half, 0.8, 1.6), 0);
  EXPECT_EQ(compute_pull({0, -16, 0}, skin, half, 0.8, 1.6), 0);
  // Off it: a cosine of the share of the cone, nothing from its rim on and behind the bone.
  const double a = half / 3;
  EXPECT_NEAR(compute_pull({8 * std::sin(a), -8 * std::cos(a), 0}, skin, half, 0.8, 1.6),
              std::cos(quarter / 3), 1e-12);
  EXPECT_EQ(compute_pull({8, -8, 0}, skin, half - 1e-9, 0.8, 1.6), 0);
  EXPECT_EQ(compute_pull({0, 8, 0}, skin, half, 0.8, 1.6), 0);
}

TEST(doctrine, has_a_field_or_a_move_for_each_muscle_and_unit) {
  const DoctrineData& data = adult().head.data->doctrines;
  EXPECT_EQ(data.linear.size() + data.rings.size() + 4,
            kMuscleRows.size());  // four only turn: a lid, the jaw
  EXPECT_EQ(data.units.size() + 6, kUnitRows.size());
  for (std::size_t i = kMoveCount; i < kChannelCount; ++i) {
    Pose pose;
    pose.values[i] = 1;
    if (kChannels[i].move == "masseter" || kChannels[i].move == "temporalis")
      pose.values[find("pterygoids")] = 1;
    const std::vector<glm::dvec3> points = place(adult(), pose);
    double most = 0;
    for (std::size_t k = 0; k < points.size(); ++k)
      most = std::max(most, glm::distance(points[k], adult().head.cage.points[k]));
    EXPECT_GT(most, 1.5) << kChannels[i].move;
    EXPECT_LT(most, 50) << kChannels[i].move;
  }
}

TEST(doctrine, draws_skin_toward_its_bone) {
  const Subject& s = adult();
  for (const LinearMuscle& muscle : s.head.data->doctrines.linear) {
    Pose pose;
    pose.values[muscle.channel] = 1;
    const glm::dvec3 bone = s.head.cage.points[find_point(s.head.cage, muscle.from)] + muscle.off_mm;
    const glm::dvec3 skin = s.head.cage.points[find_point(s.head.cage, muscle.to)];
    std::vector<glm::dvec3> points = s.head.cage.points;
    for (const DrivenField& field : s.face.doctrines->get_muscles(s.head)) {
      if (field.drivers.front().move != muscle.channel) continue;
      double most = 0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3& way = field.field[i];
        most = std::max(most, glm::length(way));
        if (glm::length(way) == 0) continue;
        EXPECT_NEAR(glm::dot(glm::normalize(way), glm::normalize(bone - points[i])), 1, 1e-9);
      }
      EXPECT_LE(most, muscle.most_mm + 1e-9) << kChannels[muscle.channel].move;
      EXPECT_GT(most, 0.6 * muscle.most_mm) << kChannels[muscle.channel].move;
    }
    EXPECT_GT(glm::length(skin - bone), 15) << kChannels[muscle.channel].move;
  }
}

TEST(doctrine, goes_where_its_name_says) {
  const Subject& s = adult();
  EXPECT_GT(travel(s, pose_of("zygomatic_major"), "M1_6").y, 4);
  EXPECT_GT(travel(s, pose_of("zygomatic_major"), "M1_6").x, 3);
  EXPECT_LT(travel(s, pose_of("angular_depressor"), "M1_6").y, -4);
  EXPECT_GT(travel(s, pose_of("risorius"), "M1_6").x, 4);
  EXPECT_GT(travel(s, pose_of("frontalis_inner"), "E5_2").y, 5);
  EXPECT_LT(travel(s, pose_of("frontalis_inner"), "E5_6").y, 2);
  EXPECT_GT(travel(s, pose_of("frontalis_outer"), "E5_6").y, 5);
  EXPECT_LT(travel(s, pose_of("lateral_corrugator"), "E5_3").x, -3);
  EXPECT_GT(travel(s, pose_of("labi_nasi"), "M3_3").y, 3);
  EXPECT_LT(travel(s, pose_of("depressor_labii"), "M3_9").y, -3);
  EXPECT_LT(travel(s, pose_of("orbicularis_oris"), "M1_6").x, -4);
  EXPECT_GT(travel(s, pose_of("orbicularis_oris"), "M3_0").z, 4);
  EXPECT_GT(travel(s, pose_of("orbicularis_oculi"), "E5_12").y, 1);
  // Ahlberg's shares of the face units, within what the soft solve leaves of them.
  EXPECT_NEAR(travel(s, pose_of("inner_brow_raiser"), "E5_2").y, 0.2 * s.face.units.eye_nose, 0.4);
  EXPECT_NEAR(travel(s, pose_of("outer_brow_raiser"), "E5_5").y, 0.29 * s.face.units.eye_nose, 0.4);
  EXPECT_NEAR(travel(s, pose_of("lip_stretcher"), "M1_6").x, 0.18 * s.face.units.mouth_width, 0.4);
  EXPECT_NEAR(travel(s, pose_of("lip_corner_depressor", -1), "M1_6").y,
              -travel(s, pose_of("lip_corner_depressor", 1), "M1_6").y, 0.8);
}

TEST(doctrine, adds_up_in_proportion_and_in_any_order) {
  const Subject& s = adult();
  const Field& brow = s.face.doctrines->get_muscles(s.head).front().field;
  const std::uint32_t point = find_point(s.head.cage, "E5_2");
  EXPECT_GT(glm::length(brow[point]), 1);
  const glm::dvec3 whole = travel(s, pose_of("frontalis_major"), "E5_4");
  const glm::dvec3 half = travel(s, pose_of("frontalis_major", 0.5), "E5_4");
  EXPECT_LT(glm::distance(half, 0.5 * whole), 0.05);
}

TEST(doctrine, mirrors_to_the_last_bit) {
  const Subject& s = adult();
  std::mt19937_64 random(7);
  for (int round = 0; round < 20; ++round) {
    Pose pose, mirrored;
    for (std::size_t i = kMoveCount; i < kChannelCount; ++i) {
      if (kChannels[i].move == "jaw_side") continue;
      pose.values[i] = std::uniform_real_distribution<double>(kChannels[i].low, kChannels[i].high)(random);
      mirrored.values[find_twin(i)] = pose.values[i];
    }
    const std::vector<glm::dvec3> here = place(s, pose), there = place(s, mirrored);
    for (std::size_t i = 0; i < here.size(); ++i) {
      const glm::dvec3& image = there[s.head.cage.mirror[i]];
      ASSERT_EQ(here[i].y, image.y) << s.head.cage.names[i];
      ASSERT_EQ(here[i].z, image.z) << s.head.cage.names[i];
      ASSERT_EQ(here[i].x, 0 - image.x) << s.head.cage.names[i];
    }
  }
}

TEST(doctrine, lies_on_heads_of_every_age) {
  for (const char* age : {"infant", "child", "old"}) {
    const Subject s = build(age);
    const double size = s.face.units.mouth_width / adult().face.units.mouth_width;
    for (const char* name : {"zygomatic_major", "angular_depressor", "risorius"}) {
      const double here = glm::length(travel(s, pose_of(name), "M1_6")),
                   grown = glm::length(travel(adult(), pose_of(name), "M1_6"));
      EXPECT_GT(here / grown, 0.75 * size) << age << " " << name;
      EXPECT_LT(here / grown, 1.35 * size) << age << " " << name;
    }
  }
}

TEST(doctrine, leaves_the_areas_poses_as_they_are) {
  Pose pose;
  pose.values[*find_move(Area::brow, Side::left, "up")] = 0.7;
  const DoctrineData& data = adult().head.data->doctrines;
  EXPECT_EQ(resolve_channels(data, pose), pose);
  EXPECT_EQ(resolve_folds(data, pose), pose);
}

TEST(doctrine, opens_the_jaw_by_what_the_shutting_muscles_leave) {
  const DoctrineData& data = adult().head.data->doctrines;
  const std::size_t chin = *find_move(Area::chin, Side::none, "down");
  Pose pose = pose_of("pterygoids", 0.8);
  EXPECT_DOUBLE_EQ(resolve_channels(data, pose).values[chin], 0.8);
  pose.values[find("masseter")] = pose.values[find("temporalis")] = 0.5;
  EXPECT_NEAR(resolve_channels(data, pose).values[chin], 0.3, 1e-12);
  pose.values[find("masseter")] = pose.values[find("temporalis")] = 1;
  EXPECT_EQ(resolve_channels(data, pose).values[chin], 0);
  // What an area has is added to, up to its limit.
  pose = pose_of("levator_palpebrae");
  const std::size_t lid = *find_move(Area::lid, Side::left, "upper");
  pose.values[lid] = -0.25;
  EXPECT_DOUBLE_EQ(resolve_channels(data, pose).values[lid], 0.75);
  pose.values[lid] = 0.5;
  EXPECT_DOUBLE_EQ(resolve_channels(data, pose).values[lid], 1);
  pose.values[lid] = 1.3;  // exaggerated
  EXPECT_DOUBLE_EQ(resolve_channels(data, pose).values[lid], 1.3);
}

}  // namespace
}  // namespace mien

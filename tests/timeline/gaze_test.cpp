#include "timeline/gaze.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/conventions.hpp"
#include "core/seeded.hpp"
#include "timeline/head_turn.hpp"
#include "timeline/performance.hpp"

namespace mien {
namespace {

double find_value(const Pose& pose, Side side, std::string_view move) {
  return pose.values[*find_move(Area::eye, side, move)];
}

ClipSpec build_clip(std::vector<GazeKey> keys, double length_s = 4) {
  ClipSpec clip;
  clip.length_s = length_s;
  clip.gaze.keys = std::move(keys);
  return clip;
}

GazeKey look_aside(double at_s, double side_deg, double up_deg = 0) {
  return {at_s, LookAt::direction, side_deg, up_deg};
}

// Where an eye of the plain adult looks in the room: a direction of length 1.
glm::dvec3 find_sight(const Moment& moment, Side side) {
  const EyeRig rig;
  const double yaw = find_value(moment.pose, side, "side") * rig.left.left_deg * kRadiansPerDegree;
  const double up = find_value(moment.pose, side, "up");
  const double pitch = up * (up > 0 ? rig.left.up_deg : rig.left.down_deg) * kRadiansPerDegree;
  const glm::dvec3 in_head(std::cos(pitch) * std::sin(yaw), std::sin(pitch), std::cos(pitch) * std::cos(yaw));
  return glm::dmat3(compute_turn(rig.pivot_mm, moment.turn, 1)) * in_head;
}

glm::dvec3 compute_eye(const Moment& moment, Side side) {
  const EyeRig rig;
  const glm::dvec3 centre = rig.left_mm * glm::dvec3(side == Side::left ? 1 : -1, 1, 1);
  return glm::dvec3(compute_turn(rig.pivot_mm, moment.turn, 1) * glm::dvec4(centre, 1));
}

double compute_angle_deg(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) / kRadiansPerDegree;
}

TEST(gaze, leaves_a_clip_without_it_as_it_is) {
  Pose pose;
  pose.values.fill(0.3);
  const Pose before = pose;
  aim_eyes(build_gaze({}, 10), {}, 1, {0, {}, 20, 0, 0}, {}, pose);
  EXPECT_EQ(pose, before);
}

TEST(gaze, is_at_a_key_at_its_time) {
  const Performance performance =
      build_performance(build_clip({look_aside(0, 0), look_aside(1, 15, 10), look_aside(2, -30, -15)}));
  const auto expect_eyes = [&](double time_s, double side, double up) {
    const Pose pose = sample_performance(performance, time_s).pose;
    for (const Side eye : {Side::left, Side::right}) {
      EXPECT_NEAR(find_value(pose, eye, "side"), side, 1e-12) << time_s;
      EXPECT_NEAR(find_value(pose, eye, "up"), up, 1e-12) << time_s;
    }
  };
  expect_eyes(0.5, 0, 0);
  expect_eyes(1, 0.5, 0.4);
  expect_eyes(1.8, 0.5, 0.4);
  expect_eyes(2, -1, -0.5);
  expect_eyes(3.9, -1, -0.5);
}

// The main sequence, measured on samples of a thousandth of a second: 21 + 2.2 A ms, which at 24 frames a
// second are one to three; the first half of the time takes most of the way.
TEST(gaze, saccades_take_the_time_that_peoples_take) {
  for (const double amplitude_deg : {5.0, 10.0, 20.0, 30.0}) {
    const Performance performance =
        build_performance(build_clip({look_aside(0, 0), look_aside(2, amplitude_deg)}));
    const auto side_at = [&](double time_s) {
      return find_value(sample_performance(performance, time_s).pose, Side::left, "side") * 30;
    };
    int moving_ms = 0;
    double fastest_degps = 0, last = 0;
    for (int ms = 1500; ms <= 2100; ++ms) {
      const double now = side_at(ms / 1000.0);
      moving_ms += now != last;
      fastest_degps = std::max(fastest_degps, (now - last) * 1000);
      EXPECT_GE(now, last);
      last = now;
    }
    EXPECT_NEAR(moving_ms, 21 + 2.2 * amplitude_deg, 1.5);
    EXPECT_GT(fastest_degps, amplitude_deg * 10) << "peak of 10 deg: some 400 deg/s";
    EXPECT_LT(fastest_degps, 800) << "no eye is faster";
    const double length_s = compute_saccade_s(amplitude_deg);
    EXPECT_LE(length_s * 24, 3);
    EXPECT_GT(side_at(2 - length_s / 2), 0.6 * amplitude_deg) << "no slow start";
  }
}

TEST(gaze, both_eyes_meet_at_a_point) {
  for (const glm::dvec3 point :
       {glm::dvec3(0, 0, 400), glm::dvec3(120, -40, 500), glm::dvec3(-60, 30, 300)}) {
    const Performance performance =
        build_performance(build_clip({{.at_s = 0, .look = LookAt::point, .point_mm = point}}));
    const Moment moment = sample_performance(performance, 0);
    for (const Side side : {Side::left, Side::right})
      EXPECT_LT(compute_angle_deg(find_sight(moment, side), point - compute_eye(moment, side)), 1e-6);
    EXPECT_LT(find_value(moment.pose, Side::left, "side"), find_value(moment.pose, Side::right, "side"));
  }
}

TEST(gaze, stays_on_the_camera_while_head_and_camera_move) {
  ClipSpec clip = build_clip({{0, LookAt::camera}});
  clip.turn = {{0, Easing::in_out, -15, -6, 5}, {4, Easing::in_out, 18, 8, -4}};
  clip.camera.resize(2);
  clip.camera[0].angle_deg = -5;
  clip.camera[1].at_s = 4;
  clip.camera[1].angle_deg = 12;
  clip.camera[1].height_deg = 6;
  clip.camera[1].distance = 0.8;
  const Performance performance = build_performance(clip);
  for (double time_s = 0; time_s <= 4; time_s += 0.1) {
    const Moment moment = sample_performance(performance, time_s);
    const double angle = moment.camera.angle_deg * kRadiansPerDegree;
    const double height = moment.camera.height_deg * kRadiansPerDegree;
    const EyeRig rig;
    const glm::dvec3 camera =
        rig.camera_target_mm + rig.camera_mm * moment.camera.distance *
                                   glm::dvec3(std::sin(angle) * std::cos(height), std::sin(height),
                                              std::cos(angle) * std::cos(height));
    for (const Side side : {Side::left, Side::right})
      EXPECT_LT(compute_angle_deg(find_sight(moment, side), camera - compute_eye(moment, side)), 0.01)
          << time_s;
  }
}

TEST(gaze, ahead_goes_with_the_head) {
  ClipSpec clip = build_clip({{0, LookAt::ahead}});
  clip.turn = {{0, Easing::in_out, 30, 10, 5}};
  const Pose pose = sample_performance(build_performance(clip), 1).pose;
  EXPECT_EQ(pose, Pose{});
}

TEST(gaze, is_added_to_what_the_face_says_of_the_eyes) {
  ClipSpec clip = build_clip({look_aside(0, 9)});
  clip.keys.emplace_back();
  for (const Side side : {Side::left, Side::right}) {
    clip.keys[0].pose.values[*find_move(Area::eye, side, "side")] = 0.2;
    clip.keys[0].pose.values[*find_move(Area::eye, side, "up")] = -0.5;
  }
  const Pose pose = sample_performance(build_performance(clip), 0).pose;
  EXPECT_NEAR(find_value(pose, Side::left, "side"), 0.5, 1e-12);
  EXPECT_NEAR(find_value(pose, Side::right, "up"), -0.5, 1e-12);
}

TEST(gaze, turns_no_eye_past_its_limit_wherever_it_looks) {
  std::mt19937_64 random(5);
  const auto any = [&](double most) { return sample_uniform(random, -most, most); };
  for (int i = 0; i < 300; ++i) {
    ClipSpec clip =
        build_clip({look_aside(0, any(90), any(60)),
                    {.at_s = 1, .look = LookAt::point, .point_mm = {any(300), any(300), any(300)}},
                    {2, LookAt::camera}});
    clip.turn = {{0, Easing::in_out, any(60), any(40), any(30)},
                 {2, Easing::in_out, any(60), any(40), any(30)}};
    clip.gaze.wander = 1;
    const Performance performance = build_performance(clip);
    for (const double time_s : {0.0, 0.5, 0.97, 1.0, 1.5, 2.0, 3.0})
      for (const double value : sample_performance(performance, time_s).pose.values) {
        EXPECT_TRUE(std::isfinite(value));
        EXPECT_LE(std::abs(value), 1);
      }
  }
  // A point in the very middle of an eye is no direction; it is no error either.
  const Performance inside =
      build_performance(build_clip({{.at_s = 0, .look = LookAt::point, .point_mm = EyeRig{}.left_mm}}));
  for (const double value : sample_performance(inside, 0).pose.values) EXPECT_TRUE(std::isfinite(value));
}

TEST(gaze, wanders_in_small_fixations_that_its_seed_decides) {
  GazeSpec spec;
  spec.wander = 1;
  const Gaze gaze = build_gaze(spec, 600);
  const auto count = static_cast<double>(gaze.fixations.size());
  EXPECT_NEAR(600 / count, 1.1, 0.15);
  for (std::size_t i = 1; i < gaze.fixations.size(); ++i)
    EXPECT_GE(gaze.fixations[i].at_s - gaze.fixations[i - 1].at_s, 0.2);
  for (const Fixation& fixation : gaze.fixations) {
    EXPECT_LE(std::abs(fixation.side_deg), 8);
    EXPECT_LE(std::abs(fixation.up_deg), 4);
  }
  const auto sides = [](const Gaze& g) {
    std::vector<double> values;
    for (const Fixation& fixation : g.fixations) values.push_back(fixation.side_deg);
    return values;
  };
  EXPECT_EQ(sides(gaze), sides(build_gaze(spec, 600)));
  spec.seed = 2;
  EXPECT_NE(sides(gaze), sides(build_gaze(spec, 600)));
  spec.wander = 0.5;
  for (const Fixation& fixation : build_gaze(spec, 60).fixations) EXPECT_LE(std::abs(fixation.side_deg), 4);
}

TEST(gaze, tells_great_shifts_and_quick_turns) {
  const std::vector<TurnKey> turn{{0, {}, 0, 0, 0}, {1, {}, 40, 0, 0}, {9, {}, -40, 0, 0}};
  const auto shifts = list_shifts({{look_aside(0, 0), look_aside(3, 25)}}, turn, {});
  ASSERT_EQ(shifts.size(), 2u) << "the slow turn back is none";
  EXPECT_NEAR(shifts[0].at_s, 0.5, 1e-9);
  EXPECT_NEAR(shifts[0].amplitude_deg, 40, 1e-9);
  EXPECT_NEAR(shifts[1].at_s, 3 - compute_saccade_s(25) / 2, 1e-9);
  EXPECT_NEAR(shifts[1].amplitude_deg, 25, 1e-9);
}

}  // namespace
}  // namespace mien

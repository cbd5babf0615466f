#include "face/face.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <random>

#include "core/data.hpp"
#include "core/error.hpp"
#include "head/surface.hpp"
#include "poses.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

struct Subject {
  NeutralHead head;
  Face face;
};

Subject build(const std::string& age = "adult", const std::string& skull = "average") {
  HeadSpec spec;
  spec.age = {{age, 1.0}};
  spec.skull = {{skull, 1.0}};
  Subject subject;
  subject.head = build_neutral_head(shipped().heads, spec);
  subject.face = build_face(subject.head);
  return subject;
}

const Subject& adult() {
  static const Subject subject = build();
  return subject;
}

void set(Pose& pose, const char* area, Side side, const char* move, double value) {
  pose.values.at(*find_move(area, side, move)) = value;
}

glm::dvec3 travel(const Subject& s, const Pose& pose, const char* point) {
  std::vector<glm::dvec3> points;
  pose_cage(s.head, s.face, pose, points);
  const std::uint32_t i = s.head.cage.index.find(point)->second;
  return points[i] - s.head.cage.points[i];
}

double distance_to_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const double t = glm::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
  return glm::distance(p, glm::mix(a, b, t));
}

// The height of one eye's lower margin above the place x.
double lower_height(const Subject& s, const std::vector<glm::dvec3>& points, const std::string& side,
                    double x) {
  const auto at = [&](int column) {
    return points[s.head.cage.index.find(side + "E1_" + std::to_string(column % 16))->second];
  };
  for (int k = 8; k < 16; ++k) {
    const glm::dvec3 a = at(k), b = at(k + 1);
    if ((a.x - x) * (b.x - x) <= 0 && a.x != b.x) return glm::mix(a.y, b.y, (x - a.x) / (b.x - a.x));
  }
  return -1e9;
}

Pose mirror(const Pose& pose) {
  Pose mirrored;
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    const MoveInfo& m = kMoves[i];
    const Side other = m.side == Side::none ? Side::none : m.side == Side::left ? Side::right : Side::left;
    const double sign = m.move == "side" ? -1 : 1;
    mirrored.values[*find_move(m.area, other, m.move)] = sign * pose.values[i];
  }
  return mirrored;
}

TEST(face, neutral_pose_is_the_neutral_head_to_the_last_bit) {
  std::vector<glm::dvec3> points;
  pose_cage(adult().head, adult().face, Pose{}, points);
  EXPECT_TRUE(points == adult().head.cage.points);
}

TEST(face, reaches_its_limits) {
  struct Limit {
    const char *area, *move, *point;
    Side side;
    double value;
    int axis;
    double mm;
  };
  const Limit limits[] = {
      {"brow", "up", "E5_4", Side::left, 1, 1, 12.6},   {"brow", "up", "E5_4", Side::left, -1, 1, -5.4},
      {"lips", "upper", "M1_2", Side::none, 1, 1, 7.3}, {"lips", "lower", "M1_10", Side::none, -1, 1, -6.7},
      {"corner", "out", "M1_6", Side::left, 1, 0, 7.6}, {"corner", "out", "M1_6", Side::left, -1, 0, -8.7},
      {"corner", "up", "M1_6", Side::left, 1, 1, 10.7}, {"corner", "up", "M1_6", Side::left, -1, 1, -6.3}};
  for (const Limit& limit : limits) {
    Pose pose;
    set(pose, limit.area, limit.side, limit.move, limit.value);
    const double mm = travel(adult(), pose, limit.point)[limit.axis];
    EXPECT_NEAR(mm / limit.mm, 1, 0.03) << limit.area << "." << limit.move << " " << limit.value;
  }
}

TEST(face, a_sided_move_leaves_the_far_side_alone) {
  for (const char* area : {"brow", "corner"}) {
    Pose pose;
    set(pose, area, Side::left, "up", 1);
    std::vector<glm::dvec3> points;
    pose_cage(adult().head, adult().face, pose, points);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (adult().head.cage.points[i].x < -20) {
        EXPECT_LT(glm::length(points[i] - adult().head.cage.points[i]), 1.0)
            << area << " " << adult().head.cage.names[i];
      }
  }
}

TEST(face, left_is_the_characters_own) {
  Pose wink;
  set(wink, "lid", Side::left, "upper", -1);
  EXPECT_LT(travel(adult(), wink, "E1_4").y, -5);  // x > 0: the character's left
  EXPECT_EQ(travel(adult(), wink, "R:E1_4").y, 0);
}

TEST(face, mirrored_poses_give_mirrored_heads_to_the_last_bit) {
  std::mt19937 random(5);
  for (int round = 0; round < 20; ++round) {
    const Pose pose = build_random_pose(random);
    std::vector<glm::dvec3> here, there;
    pose_cage(adult().head, adult().face, pose, here);
    pose_cage(adult().head, adult().face, mirror(pose), there);
    for (std::size_t i = 0; i < here.size(); ++i)
      ASSERT_EQ(here[i] * glm::dvec3(-1, 1, 1), there[adult().head.cage.mirror[i]])
          << adult().head.cage.names[i];
  }
}

// Where the cage's points come to lie on the skin: lids meet there, their control points stay apart or cross.
std::vector<glm::dvec3> compute_on_skin(const Subject& s, const std::vector<glm::dvec3>& points) {
  std::vector<Float4> packed;
  std::vector<glm::vec3> skin;
  pack_points(points, packed);
  deform_surface(*s.head.surface, packed, skin);
  return {skin.begin(), skin.begin() + static_cast<std::ptrdiff_t>(points.size())};
}

TEST(face, shut_lids_meet_and_open_ones_never_cross) {
  for (const char* age : {"infant", "child", "adult"}) {
    const Subject s = build(age);
    const double size = s.head.eye.radius_mm / 13;
    Pose shut;
    for (const Side side : {Side::left, Side::right}) set(shut, "lid", side, "upper", -1);
    std::vector<glm::dvec3> points;
    pose_cage(s.head, s.face, shut, points);
    points = compute_on_skin(s, points);
    const auto at = [&](int column) {
      return points[s.head.cage.index.find("E1_" + std::to_string(column % 16))->second];
    };
    for (int i = 1; i < 8; ++i) {  // the upper margin lies on the line of the lower one, not on its points
      double gap = 1e9;
      for (int k = 8; k < 16; ++k) gap = std::min(gap, distance_to_segment(at(i), at(k), at(k + 1)));
      EXPECT_LT(gap, 0.3 * size) << age << " column " << i;
      EXPECT_LT(std::abs(at(i).y - lower_height(s, points, "", at(i).x)), 0.3 * size)
          << age << " column " << i;
    }
    std::mt19937 random(8);
    for (int round = 0; round < 100; ++round) {
      pose_cage(s.head, s.face, build_random_pose(random), points);
      points = compute_on_skin(s, points);
      for (const std::string side : {"", "R:"})
        for (int i = 2; i < 7; ++i) {
          const glm::dvec3 upper = points[s.head.cage.index.find(side + "E1_" + std::to_string(i))->second];
          EXPECT_GT(upper.y - lower_height(s, points, side, upper.x), -0.1) << age << side << " column " << i;
        }
    }
  }
}

// The ring of muscle about the eye hangs on the nose's side; the corners stay.
TEST(face, shutting_lids_slide_toward_the_nose) {
  const auto slide_mm = [](double shut, const char* point) {
    Pose pose;
    set(pose, "lid", Side::left, "upper", -shut);
    std::vector<glm::dvec3> points;
    pose_cage(adult().head, adult().face, pose, points);
    const std::uint32_t v = adult().head.cage.index.find(point)->second;
    return compute_on_skin(adult(), adult().head.cage.points)[v].x - compute_on_skin(adult(), points)[v].x;
  };
  EXPECT_NEAR(slide_mm(1, "E1_12"), 2.5, 0.5);
  EXPECT_NEAR(slide_mm(1, "E1_4"), 1.6, 0.5);
  EXPECT_NEAR(slide_mm(0.5, "E1_12"), 0.5 * slide_mm(1, "E1_12"), 0.2);
  // And the lid is drawn out flat: what lies over the margin comes down as far.
  Pose shut;
  set(shut, "lid", Side::left, "upper", -1);
  EXPECT_GT(travel(adult(), shut, "E2_4").y / travel(adult(), shut, "E1_4").y, 0.85);
  for (const char* corner : {"E1_0", "E1_8"}) EXPECT_NEAR(slide_mm(1, corner), 0, 0.35) << corner;
}

TEST(face, lips_that_are_drawn_out_pale) {
  const auto pale = [](const std::vector<std::tuple<const char*, const char*, double>>& moves) {
    Pose pose;
    for (const auto& [area, move, value] : moves)
      for (std::size_t m = 0; m < kMoveCount; ++m)
        if (kMoves[m].area == area && kMoves[m].move == move) pose.values[m] = value;
    std::vector<glm::dvec3> points;
    pose_cage(adult().head, adult().face, pose, points);
    return compute_paling(adult().face.red_border, points);
  };
  EXPECT_EQ(pale({}), 0);
  EXPECT_EQ(pale({{"corner", "out", -1}}), 0) << "a kiss";
  const double smile = pale({{"corner", "out", 0.8}, {"corner", "up", 0.7}});
  EXPECT_GT(smile, 0.15);
  EXPECT_GT(pale({{"corner", "out", 0.8}, {"corner", "up", 0.7}, {"chin", "down", 0.8}}), smile + 0.1);
}

// Nobody rolls a lip in between shut teeth: the lower ones part behind the chin, which stays.
TEST(face, a_lower_lip_that_rolls_in_finds_the_teeth_apart) {
  Pose rolled;
  set(rolled, "lips", Side::none, "roll_lower", 1);
  const glm::dvec4 incisors(0, -75, 90, 1);
  const glm::dvec3 way =
      glm::dvec3(compute_jaw(adult().face, rolled) * incisors - compute_jaw(adult().face, Pose{}) * incisors);
  EXPECT_LT(way.y, -3);
  EXPECT_LT(way.z, -2);
  EXPECT_LT(glm::length(travel(adult(), rolled, "m12_D1")), 1.5);
}

TEST(face, lids_never_enter_the_ball) {
  std::mt19937 random(21);
  std::vector<glm::dvec3> points;
  std::vector<Float4> packed;
  std::vector<glm::vec3> skin;
  const Subject& s = adult();
  for (int round = 0; round < 100; ++round) {
    pose_cage(s.head, s.face, build_random_pose(random), points);
    pack_points(points, packed);
    deform_surface(*s.head.surface, packed, skin);
    for (const char* ring : {"E1_", "E2_", "E3_"})
      for (int i = 0; i < 16; ++i) {
        const std::uint32_t v = s.head.cage.index.find(ring + std::to_string(i))->second;
        EXPECT_GT(glm::length(glm::dvec3(skin[v]) - s.head.eye.centre), s.head.eye.radius_mm) << ring << i;
      }
  }
}

// Pressed ones, and ones that stay shut, close the slit that resting ones leave, and no more than that.
TEST(face, lips_never_cross) {
  std::mt19937 random(34);
  std::vector<glm::dvec3> points;
  const Subject& s = adult();
  for (int round = 0; round < 200; ++round) {
    const Pose pose = build_random_pose(random);
    const double press = std::max(pose.values[*find_move(Area::lips, Side::none, "press")],
                                  pose.values[*find_move(Area::lips, Side::none, "shut")]);
    pose_cage(s.head, s.face, pose, points);
    for (const LipColumn& column : s.face.lips)
      EXPECT_GT(points[column.upper_contact].y - points[column.lower_contact].y,
                column.rest_gap_mm - press * column.rest_skin_gap_mm - 1e-6);
  }
}

TEST(face, values_move_the_skin_without_pops) {
  std::mt19937 random(55);
  const Subject& s = adult();
  std::vector<glm::dvec3> here, there;
  for (int round = 0; round < 50; ++round) {
    Pose pose = build_random_pose(random);
    const std::size_t move = random() % kMoveCount;
    pose.values[move] = std::min(pose.values[move], kMoves[move].high - 0.001);
    pose_cage(s.head, s.face, pose, here);
    pose.values[move] += 0.001;
    pose_cage(s.head, s.face, pose, there);
    for (std::size_t i = 0; i < here.size(); ++i)
      ASSERT_LT(glm::distance(here[i], there[i]), 0.12) << kMoves[move].area << "." << kMoves[move].move;
  }
}

// One corrective at a time: what two moves do together grows past their limits as each of them does.
TEST(face, correctives_grow_no_faster_than_their_drivers_past_the_limits) {
  const NeutralHead& head = adult().head;
  const auto reach_mm = [&](const Face& face, const DrivenField& driven, double value) {
    Pose pose;
    for (const SignedMove& driver : driven.drivers) pose.values[driver.move] = driver.sign * value;
    const double size = 1e-3;  // so little that no contact has a say
    Face alone = face;
    alone.fields = {driven};
    alone.jaw.open_rad = 0;
    alone.jaw.forward = glm::dvec3(0);
    for (glm::dvec3& move : alone.fields[0].field) move *= size;
    for (glm::dvec3& move : alone.fields[0].mirror_field) move *= size;
    Face none = alone;
    none.fields.clear();
    std::vector<glm::dvec3> with, without;
    pose_cage(head, alone, pose, with);
    pose_cage(head, none, pose, without);
    double most = 0;
    for (std::size_t i = 0; i < with.size(); ++i) most = std::max(most, glm::distance(with[i], without[i]));
    return most / size;
  };
  int count = 0;
  for (const DrivenField& driven : adult().face.fields) {
    if (driven.drivers.size() < 2) continue;
    const double whole = reach_mm(adult().face, driven, 1);
    if (whole < 0.3) continue;
    ++count;
    EXPECT_LE(reach_mm(adult().face, driven, 2), 2.02 * whole) << kMoves[driven.drivers[0].move].area;
  }
  EXPECT_GT(count, 2);
}

TEST(face, gaze_and_jaw_turn_the_way_the_words_say) {
  Pose pose;
  set(pose, "eye", Side::left, "side", 1);
  set(pose, "eye", Side::left, "up", 0.5);
  const glm::dvec3 look = compute_gaze(adult().face, pose, Side::left) * glm::dvec3(0, 0, 1);
  EXPECT_GT(look.x, 0.4);  // toward the character's left
  EXPECT_GT(look.y, 0.1);
  const Face& face = adult().face;
  ASSERT_NE(face.eye_up_rad, face.eye_down_rad);
  for (const Side side : {Side::left, Side::right})
    for (const double up : {1.0, -1.0}) {
      Pose looking;
      set(looking, "eye", side, "up", up);
      const glm::dvec3 to = compute_gaze(face, looking, side) * glm::dvec3(0, 0, 1);
      EXPECT_NEAR(std::asin(to.y), up > 0 ? face.eye_up_rad : -face.eye_down_rad, 1e-9);
    }
  set(pose, "chin", Side::none, "down", 1);
  const glm::dvec4 chin = compute_jaw(adult().face, pose) * glm::dvec4(0, -110, 90, 1);
  EXPECT_LT(chin.y, -130);
  EXPECT_LT(chin.z, 80);
}

// A drawn face and the same one with one dial as a real head has it.
Subject build_comic(double DesignNumbers::*dial = nullptr) {
  HeadSpec spec;
  spec.design = {{"comic", 1}};
  Subject subject;
  subject.head = build_neutral_head(shipped().heads, spec);
  if (dial != nullptr) subject.head.design.*dial = 1;
  subject.face = build_face(subject.head);
  return subject;
}

TEST(face, a_design_moves_the_mouth_further_and_the_cheeks_hardly) {
  const Subject drawn = build_comic(), plain = build_comic(&DesignNumbers::corner_gain);
  Pose pose;
  set(pose, "corner", Side::left, "up", 1);
  const auto measure_gain = [&](const char* point) {
    return glm::length(travel(drawn, pose, point)) / glm::length(travel(plain, pose, point));
  };
  const double gain = drawn.head.design.corner_gain;
  EXPECT_NEAR(measure_gain("M1_6"), gain, 0.1);
  for (const char* cheek : {"q11_C3", "q10_C4", "s1_C5"}) {
    EXPECT_GT(measure_gain(cheek), 1) << cheek;
    EXPECT_LT(measure_gain(cheek), 1 + 0.3 * (gain - 1)) << cheek;
  }
  // Nostrils, whose sides are near each other, go no further.
  for (const char* nostril : {"nr_0", "ni_3", "k_it"}) EXPECT_NEAR(measure_gain(nostril), 1, 1e-9) << nostril;
}

TEST(face, rings_of_flat_lips_move_against_each_other_as_much_less) {
  const Subject flat = build_comic(), full = build_comic(&DesignNumbers::lip_height);
  Pose pose;
  set(pose, "lips", Side::none, "upper", 1);
  const double share = flat.head.design.lip_height;
  for (const char* column : {"_1", "_3", "_9"}) {
    const auto measure = [&](const Subject& subject, const char* ring) {
      return travel(subject, pose, (std::string(ring) + column).c_str());
    };
    for (const char* ring : {"M2", "M3"}) {
      const glm::dvec3 own = measure(flat, ring) - measure(flat, "M1"),
                       without = measure(full, ring) - measure(full, "M1");
      EXPECT_LT(glm::distance(own, share * without), 0.02) << ring << column;
    }
  }
}

}  // namespace
}  // namespace mien

// What the moves of two areas do to each other's skin: lips on the teeth and on each other, nostrils, the
// cords of the neck, the cheek below the lid.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/data.hpp"
#include "face/face.hpp"
#include "head/lip_sheet.hpp"
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

struct Value {
  const char *area, *move;
  double value;
};

// Sided areas get the value on both sides.
Pose build_pose(std::initializer_list<Value> values) {
  Pose pose;
  for (const auto& [area, move, value] : values)
    for (const Side side : {Side::none, Side::left, Side::right})
      if (const auto found = find_move(area, side, move)) pose.values[*found] = value;
  return pose;
}

// Where the skin of a point of the cage lies.
glm::dvec3 find_skin(const Subject& s, const Pose& pose, const std::string& name) {
  std::vector<glm::dvec3> points;
  pose_cage(s.head, s.face, pose, points);
  const std::uint32_t v = s.head.cage.index.find(name)->second;
  glm::dvec3 sum(0);
  for (std::uint32_t k = s.head.surface->first[v]; k < s.head.surface->first[v + 1]; ++k)
    sum += static_cast<double>(s.head.surface->weight[k]) * points[s.head.surface->point[k]];
  return sum;
}

glm::dvec3 compute_way(const Subject& s, const Pose& pose, const std::string& name) {
  return find_skin(s, pose, name) - find_skin(s, Pose{}, name);
}

const Subject& adult() {
  static const Subject subject = build("adult");
  return subject;
}

TEST(contact, a_kiss_brings_the_lips_forward_and_keeps_their_red) {
  const Pose kiss = build_pose({{"corner", "out", -1}, {"lips", "press", 0.6}});
  for (const char* border : {"M3_0", "M3_12"}) {
    EXPECT_GT(compute_way(adult(), kiss, border).z, 7) << border;
    EXPECT_LT(compute_way(adult(), kiss, border).z, 9) << border;
  }
  const auto red = [&](const Pose& pose) {
    return find_skin(adult(), pose, "M3_0").y - find_skin(adult(), pose, "M1_0").y;
  };
  EXPECT_GT(red(kiss), 0.9 * red(Pose{}));
}

// People's lips over an open jaw: the lower one stays, and the skin below it is drawn out down to the chin.
TEST(contact, lips_that_stay_shut_are_shut_over_an_open_jaw) {
  for (const char* age : {"infant", "adult", "old"}) {
    const Subject s = build(age);
    for (const double down : {0.15, 0.5, 1.0}) {
      const Pose open = build_pose({{"chin", "down", down}}),
                 shut = build_pose({{"chin", "down", down}, {"lips", "shut", 1}});
      for (const int column : {0, 2, 4}) {
        const std::string upper = fmt::format("M1_{}", column), lower = fmt::format("M1_{}", 12 - column);
        const auto gap = [&](const Pose& pose) {
          return find_skin(s, pose, upper).y - find_skin(s, pose, lower).y;
        };
        EXPECT_LT(gap(shut), gap(Pose{}) + 0.3) << age << " " << down << " " << column;
        EXPECT_GT(gap(shut), gap(Pose{}) - 0.7) << age << " " << down << " " << column;
        EXPECT_GT(gap(open), gap(Pose{}) + 2) << age << " " << down << " " << column;
      }
      EXPECT_LT(glm::length(compute_way(s, shut, "M1_0")), 4) << age << " " << down;
      EXPECT_GT(-compute_way(s, shut, "m12_D1").y, -0.8 * compute_way(s, open, "m12_D1").y)
          << age << " " << down;
    }
  }
}

// The side that it leaves is drawn forward over the teeth, the other one goes back along them.
TEST(contact, a_mouth_that_goes_aside_goes_round_the_teeth) {
  for (const double side : {1.0, -1.0}) {
    const Pose aside = build_pose({{"mouth", "side", side}});
    const std::string to = side > 0 ? "" : "R:", from = side > 0 ? "R:" : "";
    EXPECT_LT(compute_way(adult(), aside, to + "M3_6").z, -2) << side;
    EXPECT_GT(compute_way(adult(), aside, from + "M3_6").z, 3) << side;
    EXPECT_GT(side * compute_way(adult(), aside, from + "M3_6").x, 8) << side;
  }
}

TEST(contact, each_lip_rolls_in_alone) {
  for (const auto& [move, own, other] :
       {std::tuple{"roll_upper", "M3_0", "M3_12"}, {"roll_lower", "M3_12", "M3_0"}}) {
    const Pose rolled = build_pose({{"lips", move, 1}});
    EXPECT_LT(compute_way(adult(), rolled, own).z, -3) << move;
    EXPECT_LT(glm::length(compute_way(adult(), rolled, other)), 3) << move;
  }
}

TEST(contact, lips_are_pursed_forward_and_pushed_up) {
  const Pose kiss = build_pose({{"lips", "pucker", 1}}), upper = build_pose({{"lips", "shrug_upper", 1}}),
             lower = build_pose({{"lips", "shrug_lower", 1}});
  EXPECT_GT(compute_way(adult(), kiss, "M3_0").z, 5);
  EXPECT_GT(compute_way(adult(), kiss, "M3_12").z, 5);
  EXPECT_LT(compute_way(adult(), kiss, "M3_6").x, -3);
  EXPECT_GT(compute_way(adult(), upper, "M3_0").y, 4);
  EXPECT_LT(glm::length(compute_way(adult(), upper, "M3_6")), 1);
  EXPECT_LT(glm::length(compute_way(adult(), upper, "M3_12")), 0.5);
  EXPECT_GT(compute_way(adult(), lower, "M3_12").y, 4);
  EXPECT_GT(compute_way(adult(), lower, "M6_12").y, 6);
}

// The skin above the lid goes with a look down; that of a shut eye is down already.
TEST(contact, the_skin_above_a_lid_follows_a_look_down) {
  const Pose down = build_pose({{"eye", "up", -1}}), shut = build_pose({{"lid", "upper", -1}}),
             both = build_pose({{"eye", "up", -1}, {"lid", "upper", -1}});
  EXPECT_LT(compute_way(adult(), down, "E3_4").y, -3);
  EXPECT_NEAR(compute_way(adult(), both, "E3_4").y, compute_way(adult(), shut, "E3_4").y, 1.5);
}

TEST(contact, a_lip_is_drawn_away_from_the_other_on_one_side) {
  const auto find = [](const char* move) {
    Pose pose;
    pose.values[*find_move(Area::corner, Side::left, move)] = 1;
    return pose;
  };
  EXPECT_GT(compute_way(adult(), find("lift"), "M3_3").y, 4);
  EXPECT_LT(compute_way(adult(), find("lift"), "R:M3_3").y, 1.5);
  EXPECT_LT(compute_way(adult(), find("bare"), "M3_9").y, -3);
  EXPECT_GT(compute_way(adult(), find("bare"), "R:M3_9").y, -1.5);
  EXPECT_LT(compute_way(adult(), find("dimple"), "M3_6").z, -5);
}

TEST(contact, a_smile_thins_the_red_of_both_lips) {
  const Pose smile = build_pose({{"corner", "out", 0.8}, {"corner", "up", 0.95}});
  const auto red = [&](const Pose& pose, const char* border, const char* edge) {
    return std::abs(find_skin(adult(), pose, border).y - find_skin(adult(), pose, edge).y);
  };
  EXPECT_LT(red(smile, "M3_0", "M1_0"), 0.6667 * red(Pose{}, "M3_0", "M1_0"));
  EXPECT_LT(red(smile, "M3_12", "M1_12"), 0.6667 * red(Pose{}, "M3_12", "M1_12"));
}

TEST(contact, anger_and_fear_flare_both_nostrils_alike) {
  for (const Pose& pose : {build_pose({{"brow", "out", -1}, {"brow", "turn", -1}}),
                           build_pose({{"brow", "out", -1}, {"lid", "upper", 1}})}) {
    EXPECT_GT(compute_way(adult(), pose, "k_tip").x, 1);
    EXPECT_LT(compute_way(adult(), pose, "k_tip").x, 2);
    EXPECT_EQ(compute_way(adult(), pose, "k_tip").x, -compute_way(adult(), pose, "R:k_tip").x);
  }
}

TEST(contact, a_shout_raises_a_cord_on_each_side_of_the_neck) {
  const Pose shout = build_pose({{"chin", "down", 1}, {"lips", "lower", -1}});
  const Pose open = build_pose({{"chin", "down", 1}});
  const auto rise = [&](const char* name) {
    return find_skin(adult(), shout, name).z - find_skin(adult(), open, name).z;
  };
  EXPECT_GT(rise("m9_N1"), rise("m11_N1") + 1);
  EXPECT_GT(rise("m9_N1"), rise("m8_N1") + 0.5);
}

TEST(contact, a_cheek_that_is_pushed_up_bulges_below_the_lid_and_never_passes_it) {
  const Pose laugh = build_pose({{"lid", "lower", 1}, {"corner", "up", 1}, {"lips", "upper", 1}});
  for (const char* age : {"infant", "adult", "old"}) {
    const Subject s = build(age);
    std::vector<glm::dvec3> points;
    pose_cage(s.head, s.face, laugh, points);
    const double least = s.face.give_way.least;
    for (const GiveWayLine& line : s.face.give_way.lines)
      for (std::size_t i = 0; i < line.ways.size(); ++i)
        EXPECT_GT(glm::dot(points[line.points[i + 1]] - points[line.points[i]], line.ways[i]),
                  0.9 * least * line.rest_mm[i])
            << age << " " << s.head.cage.names[line.points[i + 1]];
  }
}

// The line of the lips is steep there, and the skin between two columns is what meets first.
TEST(contact, lips_do_not_cross_beside_a_corner_that_is_drawn_in_and_down) {
  for (const char* age : {"infant", "adult", "old"}) {
    const Subject s = build(age);
    const Pose pose =
        build_pose({{"corner", "out", -1}, {"corner", "up", -1}, {"lips", "press", 1}, {"chin", "up", 0.7}});
    std::vector<glm::dvec3> points, upper, lower;
    pose_cage(s.head, s.face, pose, points);
    for (const Side side : {Side::left, Side::right}) {
      place_lip(s.face.upper_lip, points, side, upper);
      place_lip(s.face.lower_lip, points, side, lower);
      LipShortfalls shortfalls{};
      compute_lip_shortfalls(s.face.upper_lip, upper, s.face.lower_lip, lower, 0, shortfalls);
      EXPECT_LT(*std::ranges::max_element(shortfalls), 0.05) << age;
    }
  }
}

TEST(contact, sheets_that_overlap_are_told_by_how_much_and_where) {
  const Subject& s = adult();
  std::vector<glm::dvec3> upper, lower;
  place_lip(s.face.upper_lip, s.head.cage.points, Side::left, upper);
  place_lip(s.face.lower_lip, s.head.cage.points, Side::left, lower);
  LipShortfalls shortfalls{};
  compute_lip_shortfalls(s.face.upper_lip, upper, s.face.lower_lip, lower, 0, shortfalls);
  EXPECT_LE(*std::ranges::max_element(shortfalls), 0);
  for (glm::dvec3& p : lower) p.y += 1;
  compute_lip_shortfalls(s.face.upper_lip, upper, s.face.lower_lip, lower, 0, shortfalls);
  EXPECT_GT(shortfalls[0], 0.3);
  EXPECT_LE(*std::ranges::max_element(shortfalls), 1);
}

}  // namespace
}  // namespace mien

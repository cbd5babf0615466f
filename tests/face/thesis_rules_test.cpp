// The rules of Yen (1990), 5.3, on heads that follow them, by number.
#include "face/thesis_rules.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "config/load_spec.hpp"
#include "core/conventions.hpp"
#include "frames/figure.hpp"
#include "head/landmarks.hpp"
#include "head/surface.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

constexpr std::array kHeads{"age: adult", "age: infant", "age: old, character: female"};

const Figure& build(const std::string& words) {
  static std::map<std::string, Figure> figures;
  if (const auto found = figures.find(words); found != figures.end()) return found->second;
  const HeadSpec head =
      load_spec("rules.yaml", fmt::format("mien: 1\nhead: {{{}}}\n", words), *shipped().stock.language).head;
  return figures.emplace(words, build_figure(shipped().heads, head, FigureUse::print)).first->second;
}

const Figure& build_ruled(const std::string& words) { return build("rules: thesis, " + words); }

void set(Pose& pose, const char* area, Side side, const char* move, double value) {
  pose.values.at(*find_move(area, side, move)) = value;
}

double draw(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 8) / static_cast<double>(1 << 24);
}

std::vector<glm::dvec3> pose_points(const Figure& figure, const Pose& pose) {
  std::vector<glm::dvec3> points;
  pose_cage(figure.head, figure.face, apply_limits(figure.limits, pose), points);
  return points;
}

// The skin at a point of the cage.
glm::dvec3 find_skin(const Figure& figure, const std::vector<glm::dvec3>& points, const std::string& name) {
  const Surface& surface = *figure.head.surface;
  const std::uint32_t vertex = figure.head.cage.index.at(name);
  glm::dvec3 at(0);
  for (std::uint32_t k = surface.first[vertex]; k < surface.first[vertex + 1]; ++k)
    at += static_cast<double>(surface.weight[k]) * points[surface.point[k]];
  return at;
}

glm::dvec3 find_way(const Figure& figure, const Pose& pose, const std::string& name) {
  return find_skin(figure, pose_points(figure, pose), name) -
         find_skin(figure, figure.head.cage.points, name);
}

double find_brow_height(const Figure& figure, const Pose& pose, const std::string& side, bool is_highest) {
  const std::vector<glm::dvec3> points = pose_points(figure, pose);
  std::vector<double> heights;
  for (int i = 2; i <= 6; ++i)
    heights.push_back(find_skin(figure, points, fmt::format("{}E5_{}", side, i)).y);
  return is_highest ? std::ranges::max(heights) : std::ranges::min(heights);
}

double find_brow_angle(const Figure& figure, const Pose& pose) {
  const std::vector<glm::dvec3> points = pose_points(figure, pose);
  const glm::dvec3 way = find_skin(figure, points, "E5_6") - find_skin(figure, points, "E5_2");
  return std::atan2(way.y, way.x) / kRadiansPerDegree;
}

TEST(thesis_rules, a_brow_turns_about_its_end) {
  for (const char* words : kHeads) {
    const Figure& figure = build_ruled(words);
    const Figure& house = build(words);
    for (const std::string side : {"", "R:"})
      for (const double value : {0.3, 1.0}) {
        Pose up, down;
        set(up, "brow", side.empty() ? Side::left : Side::right, "turn", value);
        set(down, "brow", side.empty() ? Side::left : Side::right, "turn", -value);
        // Of the character's right brow, which is the viewer's left: its inner end up is counter-clockwise,
        // and its leftmost end is the outer one.
        EXPECT_LT(glm::length(find_way(figure, up, side + "E5_6")), 0.2) << words << value;
        EXPECT_GT(find_way(figure, up, side + "E5_2").y, 2.5 * value) << words << value;
        EXPECT_LT(glm::length(find_way(figure, down, side + "E5_2")), 0.2) << words << value;
        EXPECT_GT(find_way(figure, down, side + "E5_6").y, 2.5 * value) << words << value;
      }
    for (const double value : {-1.0, 1.0}) {
      Pose pose;
      set(pose, "brow", Side::left, "turn", value);
      EXPECT_NEAR(find_brow_angle(figure, pose), find_brow_angle(house, pose), 1) << words;
    }
  }
}

TEST(thesis_rules, a_brow_stays_in_its_rectangle_by_its_highest_and_lowest_points) {
  std::mt19937 random(5);
  for (const char* words : kHeads) {
    const Figure& figure = build_ruled(words);
    for (const auto& [side, prefix] : {std::pair{Side::left, ""}, std::pair{Side::right, "R:"}}) {
      Pose highest, lowest;
      set(highest, "brow", side, "up", 1);
      set(lowest, "brow", side, "up", -1);
      const double top = find_brow_height(figure, highest, prefix, true),
                   bottom = find_brow_height(figure, lowest, prefix, false);
      double reached = -1000;
      for (int i = 0; i < 60; ++i) {
        Pose pose;
        for (const char* move : {"up", "out", "turn"}) set(pose, "brow", side, move, draw(random, -1, 1));
        if (i == 0) set(pose, "brow", side, "up", 1), set(pose, "brow", side, "turn", 1);
        EXPECT_LE(find_brow_height(figure, pose, prefix, true), top + 1e-4) << words;
        EXPECT_GE(find_brow_height(figure, pose, prefix, false), bottom - 1e-4) << words;
        reached = std::max(reached, find_brow_height(figure, pose, prefix, true));
      }
      EXPECT_NEAR(reached, top, 0.01) << words;  // held at it, not below
    }
  }
}

TEST(thesis_rules, the_rectangle_is_that_of_the_heads_limits) {
  const Figure& figure = build_ruled("limits: {brows.up: 0.5}");
  Pose half, both;
  set(half, "brow", Side::left, "up", 1);
  set(both, "brow", Side::left, "up", 1);
  set(both, "brow", Side::left, "turn", 1);
  EXPECT_LT(find_brow_height(figure, half, "", true),
            find_brow_height(build_ruled(kHeads[0]), half, "", true) - 3);
  EXPECT_LE(find_brow_height(figure, both, "", true), find_brow_height(figure, half, "", true) + 1e-4);
}

TEST(thesis_rules, a_flat_rectangle_holds_the_turn_as_well) {
  const Figure& figure = build_ruled("limits: {brows.up: 0.1, brows.down: 0.1}");
  Pose highest, lowest;
  set(highest, "brow", Side::left, "up", 1);
  set(lowest, "brow", Side::left, "up", -1);
  for (const double turn : {-1.0, 1.0})
    for (const double up : {-1.0, 0.0, 1.0}) {
      Pose pose;
      set(pose, "brow", Side::left, "turn", turn);
      set(pose, "brow", Side::left, "up", up);
      EXPECT_LE(find_brow_height(figure, pose, "", true), find_brow_height(figure, highest, "", true) + 1e-4);
      EXPECT_GE(find_brow_height(figure, pose, "", false),
                find_brow_height(figure, lowest, "", false) - 1e-4);
    }
}

TEST(thesis_rules, tell_which_point_of_a_brow_reached_which_limit) {
  const Figure& figure = build_ruled(kHeads[0]);
  Pose pose;
  set(pose, "brow", Side::left, "up", 1);
  set(pose, "brow", Side::left, "turn", -1);
  const std::vector<BrowHold> holds = find_brow_holds(figure.face, figure.limits, pose);
  ASSERT_EQ(holds.size(), 1u);
  const std::string told = describe_hold(holds.front());
  EXPECT_TRUE(told.starts_with("brow.left.up is 1; its outer ")) << told;
  EXPECT_NE(told.find(" reaches EYEBROW_R_U_VERT_LIMIT, and it goes to 0."), told.npos) << told;
  EXPECT_TRUE(
      find_brow_holds(build(kHeads[0]).face, {}, pose).empty());  // the house's brows have no rectangle
}

TEST(thesis_rules, mirrored_poses_give_mirrored_faces_to_the_last_bit) {
  const Figure& figure = build_ruled("limits: {LIPS_MATCH_LEVEL: 1mm}");
  std::mt19937 random(8);
  Pose pose, mirrored;
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    const MoveInfo& info = kMoves[i];
    if (info.side == Side::right || info.low < 0 ? info.side == Side::right : false) continue;
    const double value = draw(random, info.low, 1);
    if (info.side == Side::none) {
      if (info.move != "side") pose.values[i] = mirrored.values[i] = value;
      continue;
    }
    pose.values[i] = value;
    mirrored.values[*find_move(info.area, Side::right, info.move)] =
        info.area == "eye" && info.move == "side" ? -value : value;
  }
  const std::vector<glm::dvec3> points = pose_points(figure, pose), others = pose_points(figure, mirrored);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec3& other = others[figure.head.cage.mirror[i]];
    ASSERT_EQ(points[i], glm::dvec3(-other.x, other.y, other.z)) << figure.head.cage.names[i];
  }
}

TEST(thesis_rules, corners_of_eyes_stay_and_a_shut_lid_ends_where_the_lower_one_rests) {
  std::mt19937 random(6);
  for (const char* words : kHeads) {
    const Figure& figure = build_ruled(words);
    for (int i = 0; i < 40; ++i) {
      Pose pose;
      set(pose, "lid", Side::left, "upper", draw(random, -1, 1));
      set(pose, "lid", Side::left, "lower", draw(random, 0, 1));
      for (const char* corner : {"E1_0", "E1_8"})
        EXPECT_LT(glm::length(find_way(figure, pose, corner)), 0.1) << words;
    }
    Pose shut;
    set(shut, "lid", Side::left, "upper", -1);
    const std::vector<glm::dvec3> points = pose_points(figure, shut);
    EXPECT_LT(std::abs(find_way(figure, shut, "E1_12").y), 0.15) << words;
    EXPECT_NEAR(find_skin(figure, points, "E1_4").y, find_skin(figure, figure.head.cage.points, "E1_12").y,
                0.3)
        << words;
  }
}

TEST(thesis_rules, eyeballs_end_at_the_lids_outline_at_rest) {
  for (const char* words : kHeads) {
    const Figure& figure = build_ruled(words);
    const glm::dvec3 eye = figure.head.eye.centre;
    const auto& [pupil_mm, pupil_z] = figure.head.data->parts.eye.iris_inner_mm;
    const double pupil = std::atan2(pupil_mm, pupil_z);
    // The pupil's top and bottom edges, as one sees them from before, against the margins' middles.
    const auto pitch = [&](const char* point) {
      const glm::dvec3 way = find_skin(figure, figure.head.cage.points, point) - eye;
      return std::atan2(way.y, way.z);
    };
    const double top = std::max({pitch("E1_3"), pitch("E1_4"), pitch("E1_5")}),
                 bottom = std::min({pitch("E1_11"), pitch("E1_12"), pitch("E1_13")});
    EXPECT_LE(figure.face.eye_up_rad + pupil, top + 0.01) << words;
    EXPECT_GE(figure.face.eye_up_rad + pupil, top - 0.09) << words;
    EXPECT_GE(-figure.face.eye_down_rad - pupil, bottom - 0.01) << words;
    EXPECT_LE(-figure.face.eye_down_rad - pupil, bottom + 0.09) << words;
    EXPECT_GT(figure.face.eye_side_rad, 0.2) << words;
    EXPECT_LT(figure.face.eye_up_rad, build(words).face.eye_up_rad) << words;
  }
}

// How far the middle of a lip is from where the lips meet at rest.
double find_lip_mm(const Figure& figure, const Pose& pose, const char* point) {
  const auto& at = figure.head.cage.index;
  const std::vector<glm::dvec3> points = pose_points(figure, pose);
  return points[at.at(point)].y - figure.head.cage.points[at.at(point)].y;
}

TEST(thesis_rules, one_level_stops_both_lips_and_the_chin) {
  std::mt19937 random(7);
  for (const auto& [level, at_mm] : {std::pair{"0mm", 0.0}, std::pair{"-1mm", -1.0}, std::pair{"3mm", 3.0}}) {
    const double low = std::min(0.0, at_mm), high = std::max(0.0, at_mm);
    const Figure& figure = build_ruled(fmt::format("limits: {{LIPS_MATCH_LEVEL: {}}}", level));
    constexpr double kContact_mm = 0.25;  // of the skins of both lips that touch
    for (int i = 0; i < 60; ++i) {
      Pose pose;
      set(pose, "lips", Side::none, "upper", draw(random, -1, 1));
      set(pose, "lips", Side::none, "lower", draw(random, -1, 1));
      set(pose, "chin", Side::none, "up", draw(random, 0, 1));
      EXPECT_GE(find_lip_mm(figure, pose, "M1_0"), low - kContact_mm) << level << " " << i;
      EXPECT_LE(find_lip_mm(figure, pose, "M1_12"), high + kContact_mm) << level << " " << i;
    }
    Pose down, up, chin;
    set(down, "lips", Side::none, "upper", -1);
    set(up, "lips", Side::none, "lower", 1);
    set(chin, "chin", Side::none, "up", 1);
    EXPECT_GE(find_lip_mm(figure, down, "M1_0"), low - kContact_mm) << level;
    // Above the lips the level lets the lower one rise, which goes along with the upper one's way down.
    if (at_mm <= 0) {
      EXPECT_LE(find_lip_mm(figure, down, "M1_0"), low + kContact_mm) << level;
    }
    EXPECT_NEAR(find_lip_mm(figure, up, "M1_12"), at_mm, kContact_mm) << level;
    EXPECT_NEAR(find_lip_mm(figure, chin, "M1_12"), at_mm, kContact_mm) << level;
  }
}

TEST(thesis_rules, a_level_alone_leaves_the_other_rules_to_the_house) {
  const Figure& figure = build("limits: {LIPS_MATCH_LEVEL: 0.1mouth_nose}");
  EXPECT_FALSE(figure.face.follows_thesis);
  EXPECT_NEAR(*figure.face.match_level_mm, 0.1 * figure.face.units.mouth_nose, 1e-12);
}

TEST(thesis_rules, a_straight_chin_goes_down_alone) {
  const Figure& figure = build(kHeads[0]);
  Pose pose;
  set(pose, "chin", Side::none, "straight", 1);
  const glm::dvec3 way = find_way(figure, pose, "M6_12");
  EXPECT_NEAR(way.x, 0, 1e-9);
  EXPECT_NEAR(way.z, 0, 1e-6);
  EXPECT_LT(way.y, -20);
  const glm::dmat4 jaw = compute_jaw(figure.face, pose);
  EXPECT_EQ(glm::dmat3(jaw), glm::dmat3(1));
  EXPECT_NEAR(jaw[3].y, -figure.face.jaw.straight_mm, 1e-9);
  // Its limit is the chin's one limit: a jaw that is open all the way has none of it left.
  set(pose, "chin", Side::none, "down", 1);
  Pose open;
  set(open, "chin", Side::none, "down", 1);
  EXPECT_EQ(pose_points(figure, pose), pose_points(figure, open));
}

TEST(thesis_rules, are_those_of_the_library_where_a_head_says_none) {
  const auto follows = [](const std::string& text) {
    return load_spec("rules.yaml", "mien: 1\n" + text, *shipped().stock.language).head.follows_thesis;
  };
  EXPECT_FALSE(follows("title: none\n"));
  EXPECT_TRUE(follows("head: {rules: thesis}\n"));
  EXPECT_TRUE(follows("library: tezuka\n"));
  EXPECT_FALSE(follows("library: tezuka\nhead: {rules: house}\n"));
  EXPECT_FALSE(follows("library: emfacs\n"));
}

}  // namespace
}  // namespace mien

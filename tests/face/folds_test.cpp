#include "face/folds.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include "core/data.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "face/fold_tracks.hpp"
#include "frames/figure.hpp"
#include "head/cage.hpp"
#include "poses.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;

Figure build(const std::string& age) {
  HeadSpec spec;
  spec.age = {{age, 1.0}};
  return build_figure(shipped().heads, spec);
}

const Figure& adult() {
  static const Figure figure = build("adult");
  return figure;
}

// All that folds at once is no face; this is the most that one half of them asks for.
Pose build_folded_pose() {
  Pose pose;
  const auto set = [&](const char* area, const char* move, double value) {
    for (const Side side : {Side::none, Side::left, Side::right})
      if (const auto found = find_move(area, side, move)) pose.values[*found] = value;
  };
  set("brow", "up", 1);
  set("brow", "turn", 1);
  set("lips", "upper", 1);
  set("corner", "up", 1);
  set("corner", "out", 1);
  set("lid", "lower", 1);
  return pose;
}

PartShape draw_skin(const Figure& figure, const Pose& pose, bool has_folds) {
  DeformBuffers buffers;
  buffers.has_folds = has_folds;
  Drawing drawing;
  deform_figure(figure, pose, TurnKey{}, buffers, drawing);
  return drawing.parts.front();
}

double find_deepest_mm(const Figure& figure, const Pose& pose) {
  const PartShape folded = draw_skin(figure, pose, true), smooth = draw_skin(figure, pose, false);
  double deepest_mm = 0;
  for (std::size_t v = 0; v < folded.positions.size(); ++v)
    deepest_mm = std::max<double>(deepest_mm, glm::distance(folded.positions[v], smooth.positions[v]));
  return deepest_mm;
}

TEST(fine_skin, has_the_edges_of_the_skin_and_no_others) {
  const FineSkin& fine = adult().folds.skin;
  EXPECT_GT(fine.parents.size(), 2000U);
  EXPECT_LT(fine.parents.size(), 14000U);  // else scenes grow by half
  EXPECT_EQ(count_open_edges(fine.triangles), count_open_edges(adult().head.skin.triangles));
  ASSERT_EQ(fine.mirror.size(), fine.vertex_count());
  for (std::uint32_t v = 0; v < fine.vertex_count(); ++v) ASSERT_EQ(fine.mirror[fine.mirror[v]], v);
  for (std::size_t i = 0; i < fine.parents.size(); ++i)
    for (const std::uint32_t parent : fine.parents[i]) ASSERT_LT(parent, fine.base_count + i);
}

TEST(fine_skin, is_the_same_for_every_age) {
  const Figure infant = build("infant");
  EXPECT_EQ(infant.folds.skin.parents, adult().folds.skin.parents);
  EXPECT_EQ(infant.folds.skin.triangles, adult().folds.skin.triangles);
}

// A line along y at x = -20, seen from before: its left is the character's right, -x.
struct StraightFold {
  FoldSet set;
  FoldUnevenness even;
  std::vector<Track> tracks;

  StraightFold() {
    set.depth_mm = 2;
    set.width_mm = 1;
    set.spread = 3;
    set.rolls = {0.5, 0};
    set.uneven = 0;
    Track& track = tracks.emplace_back();
    track.set = &set;
    track.uneven = &even;
    for (int i = 0; i <= 20; ++i) {
      track.points.emplace_back(-20, i, 0);
      track.normals.emplace_back(0, 0, 1);
      track.depths.push_back(1);
    }
    track.reach_mm = 8;
    track.box = {{-30, -10, -10}, {-10, 30, 10}};
  }
  StraightFold(const StraightFold&) = delete;
};

TEST(folds, are_a_groove_with_a_roll_on_the_side_that_the_table_says) {
  const StraightFold fold;
  const auto height_mm = [&](double x) { return compute_heights_mm(fold.tracks, fold.set, {x, 10, 0})[0]; };
  EXPECT_NEAR(height_mm(-20), -2, 1e-3);
  EXPECT_GT(height_mm(-23), 0.5);
  EXPECT_LT(height_mm(-17), 0.01);
  EXPECT_EQ(height_mm(-11), 0) << "out of reach";
}

TEST(fine_skin, is_fine_in_a_groove_coarser_in_its_rolls_and_as_it_was_beside_them) {
  StraightFold fold;
  const EdgeLimit limit = limit_edges(fold.tracks, 0.5);
  EXPECT_DOUBLE_EQ(limit({-20, 10, 0}), 0.5);
  EXPECT_DOUBLE_EQ(limit({-21.5f, 10, 0}), 0.5);
  EXPECT_DOUBLE_EQ(limit({-23, 10, 0}), 1.7 * 0.5);
  EXPECT_GT(limit({-25, 10, 0}), 1e6);
  fold.set.edge = 0.6;
  EXPECT_DOUBLE_EQ(limit({-20, 10, 0}), 0.6 * 0.5);
}

TEST(folds, of_two_moves_come_with_both_of_them) {
  FoldField field;
  field.drives = {{1, {{"brow", "up", 1}, {"lips", "upper", 1}}}};
  Pose brow, lips, both;
  brow.values[*find_move(Area::brow, Side::left, "up")] = 1;
  lips.values[*find_move(Area::lips, Side::none, "upper")] = 1;
  both.values = brow.values;
  both.values[*find_move(Area::lips, Side::none, "upper")] = 1;
  EXPECT_EQ(compute_fold_amount(field, brow, Side::left), 0);
  EXPECT_EQ(compute_fold_amount(field, lips, Side::left), 0);
  EXPECT_EQ(compute_fold_amount(field, both, Side::left), 1);
  EXPECT_EQ(compute_fold_amount(field, both, Side::right), 0);
}

const FoldField& find_field(const Figure& figure, const std::string& name) {
  const std::vector<FoldSet>& sets = figure.head.data->folds.sets;
  const auto found =
      std::find_if(sets.begin(), sets.end(), [&](const FoldSet& set) { return set.name == name; });
  return figure.folds.fields.at(static_cast<std::size_t>(found - sets.begin()));
}

// Which vertices of the skin the crease of the upper lids reaches.
std::vector<bool> list_upper_lids(const Figure& figure) {
  std::vector<bool> is_lid(figure.folds.skin.vertex_count(), false);
  for (const FoldedVertex& v : find_field(figure, "upper_lid").vertices) {
    is_lid[figure.folds.vertices[v.slot].left] = true;
    is_lid[figure.folds.vertices[v.slot].right] = true;
  }
  return is_lid;
}

TEST(folds, the_neutral_pose_is_smooth_to_the_last_bit_but_where_its_upper_lids_go_in) {
  const PartShape folded = draw_skin(adult(), Pose{}, true), smooth = draw_skin(adult(), Pose{}, false);
  const std::vector<bool> is_lid = list_upper_lids(adult());
  int lids = 0;
  for (std::size_t v = 0; v < smooth.positions.size(); ++v) {
    if (is_lid[v]) {
      if (folded.positions[v] != smooth.positions[v]) ++lids;
    } else {
      ASSERT_TRUE(folded.positions[v] == smooth.positions[v]) << v;
    }
  }
  EXPECT_GT(lids, 100);
}

TEST(folds, the_upper_lid_goes_in_at_every_age_while_the_eye_is_open_and_hardly_when_it_is_shut) {
  const auto pose = [](double upper) {
    Pose posed;
    for (const Side side : {Side::left, Side::right})
      posed.values[*find_move(Area::lid, side, "upper")] = upper;
    return posed;
  };
  for (const char* age : {"infant", "child", "teenager", "young_adult", "adult", "old"}) {
    const Figure figure = build(age);
    const FoldField& field = find_field(figure, "upper_lid");
    const auto amount = [&](double upper) { return compute_fold_amount(field, pose(upper), Side::left); };
    EXPECT_NEAR(amount(0), 0.85, 1e-9) << age;
    EXPECT_NEAR(amount(1), 1, 1e-9) << age;
    EXPECT_LT(amount(-1), 0.4 * amount(0)) << age;
    EXPECT_GT(amount(-1), 0.2 * amount(0)) << age;
    for (double upper = -0.95; upper < 1.01; upper += 0.05)
      EXPECT_GE(amount(upper), amount(upper - 0.05)) << age << ' ' << upper;
  }
}

TEST(folds, only_the_old_have_lines_at_rest_and_the_more_the_older) {
  HeadSpec spec;
  const auto compute_rest = [&](const Mix& age) {
    spec.age = age;
    double sum = 0;
    const Figure figure = build_figure(shipped().heads, spec);
    for (const FoldField& field : figure.folds.fields) {
      if (&field == &find_field(figure, "upper_lid")) continue;
      EXPECT_GE(compute_fold_amount(field, Pose{}, Side::left), field.rest);
      sum += compute_fold_amount(field, Pose{}, Side::left);
    }
    return sum;
  };
  for (const char* age : {"infant", "child", "teenager", "young_adult", "adult"})
    EXPECT_EQ(compute_rest({{age, 1.0}}), 0) << age;
  const double half = compute_rest({{"adult", 0.5}, {"old", 0.5}}), old = compute_rest({{"old", 1.0}});
  EXPECT_GT(half, 0.5);
  EXPECT_NEAR(2 * half, old, 1e-9);
}

// The shipped folds, as uneven as asked.
Folds build_uneven(const FoldUnevenness& uneven) {
  auto data = std::make_shared<HeadData>(*adult().head.data);
  data->folds.uneven = uneven;
  NeutralHead head = adult().head;
  head.data = data;
  return build_folds(head, HeadSpec{});
}

TEST(folds, mirrored_poses_fold_a_mirrored_skin_alike_to_the_last_bit_where_none_is_uneven) {
  const Folds folds = build_uneven({});
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    const Pose pose = build_random_pose(random);
    Pose image;
    for (std::size_t i = 0; i < kMoveCount; ++i) {
      const MoveInfo& move = kMoves[i];
      const Side other = move.side == Side::left ? Side::right : Side::left;
      const double sign = move.move == "side" ? -1 : 1;
      image.values[move.side == Side::none ? i : *find_move(move.area, other, move.move)] =
          sign * pose.values[i];
    }
    PartShape here = draw_skin(adult(), pose, false), there = here;
    for (std::size_t v = 0; v < here.positions.size(); ++v) {
      there.positions[folds.skin.mirror[v]] = here.positions[v] * glm::vec3(-1, 1, 1);
      there.normals[folds.skin.mirror[v]] = here.normals[v] * glm::vec3(-1, 1, 1);
    }
    FoldBuffers buffers;
    const auto press = [&](const Pose& folding, PartShape& skin) {
      std::vector<Twin> places, normals;
      pack_pairs(folds.skin.pairs, skin.positions, places);
      pack_pairs(folds.skin.pairs, skin.normals, normals);
      press_folds(folds, folding, buffers, places, normals);
      unpack_pairs(folds.skin.pairs, places, skin.positions);
      unpack_pairs(folds.skin.pairs, normals, skin.normals);
    };
    press(pose, here);
    press(image, there);
    for (std::size_t v = 0; v < here.positions.size(); ++v) {
      const std::uint32_t m = folds.skin.mirror[v];
      ASSERT_TRUE(here.positions[v] == there.positions[m] * glm::vec3(-1, 1, 1)) << v;
      ASSERT_TRUE(here.normals[v] == there.normals[m] * glm::vec3(-1, 1, 1)) << v;
    }
  }
}

TEST(folds, are_unlike_on_both_sides_and_meet_in_the_middle) {
  const Folds& folds = adult().folds;
  for (const FoldField& field : folds.fields) {
    double most_mm = 0, unlike_mm = 0;
    for (const FoldedVertex& folded : field.vertices) {
      const double unlike = std::abs(folded.near_mm - folded.image_near_mm);
      most_mm = std::max<double>(most_mm, std::abs(folded.near_mm));
      unlike_mm = std::max(unlike_mm, unlike);
      if (folds.vertices[folded.slot].is_middle()) {
        ASSERT_EQ(unlike, 0);
      }
    }
    EXPECT_GT(unlike_mm, 0.1 * most_mm);  // least across the nose's root, where both sides are one
  }
}

TEST(folds, of_another_seed_are_others_and_of_the_same_the_same) {
  const auto sum = [](const Folds& folds) {
    double heights_mm = 0;
    for (const FoldField& field : folds.fields)
      for (const FoldedVertex& folded : field.vertices) heights_mm += std::abs(folded.near_mm);
    return heights_mm;
  };
  const FoldUnevenness first{1, 11, 1, 0.7, 9}, second{2, 11, 1, 0.7, 9};
  const double one = sum(build_uneven(first));
  EXPECT_EQ(sum(build_uneven(first)), one);
  EXPECT_NE(sum(build_uneven(second)), one);
}

TEST(folds, one_brow_folds_its_own_side) {
  Pose pose;
  pose.values[*find_move(Area::brow, Side::left, "up")] = 1;
  const PartShape folded = draw_skin(adult(), pose, true), smooth = draw_skin(adult(), pose, false);
  const std::vector<bool> is_lid = list_upper_lids(adult());
  double left_mm = 0, right_mm = 0;
  for (std::size_t v = 0; v < folded.positions.size(); ++v) {
    if (is_lid[v]) continue;
    double& side_mm = smooth.positions[v].x > 0 ? left_mm : right_mm;
    if (std::abs(smooth.positions[v].x) > 15)
      side_mm = std::max<double>(side_mm, glm::distance(folded.positions[v], smooth.positions[v]));
  }
  EXPECT_GT(left_mm, 0.5);
  EXPECT_EQ(right_mm, 0);
}

TEST(folds, grow_without_a_jerk) {
  constexpr int kSteps = 200;
  constexpr double kSteepest = 6;  // of an amount against a move; the eye takes more for a pop
  for (const FoldField& field : adult().folds.fields) {
    double before = field.rest, slope_before = 0;
    for (int i = 0; i <= kSteps; ++i) {
      Pose pose = build_folded_pose();
      for (const FoldDrive& drive : field.drives)
        for (const Driver& driver : drive.drivers)
          for (const Side side : {Side::none, Side::left})
            if (const auto move = find_move(driver.area, side, driver.move))
              pose.values[*move] = driver.sign * static_cast<double>(i) / kSteps;
      const double now = compute_fold_amount(field, pose, Side::left), slope = (now - before) * kSteps;
      EXPECT_LE(std::abs(slope), kSteepest);
      EXPECT_LE(std::abs(slope - slope_before), i > 0 ? 0.6 : 0.0);
      before = now;
      slope_before = i > 0 ? slope : 0;
    }
  }
}

TEST(folds, turn_no_part_of_the_skin_over) {
  std::mt19937 random(5);
  for (int round = 0; round < 12; ++round) {
    const Pose pose = round == 0 ? build_folded_pose() : build_random_pose(random);
    const PartShape folded = draw_skin(adult(), pose, true), smooth = draw_skin(adult(), pose, false);
    int turned = 0;
    std::string where;
    for (const auto& [a, b, c] : adult().folds.skin.triangles) {
      const auto area = [&, a = a, b = b, c = c](const std::vector<glm::vec3>& p) {
        return glm::cross(p[b] - p[a], p[c] - p[a]);
      };
      if (glm::dot(area(folded.positions), area(smooth.positions)) >= 0) continue;
      ++turned;
      where = fmt::format("{:.0f}, {:.0f}, {:.0f}", smooth.positions[a].x, smooth.positions[a].y,
                          smooth.positions[a].z);
    }
    EXPECT_EQ(turned, 0) << "round " << round << ", the last at " << where;
    for (const glm::vec3& n : folded.normals) ASSERT_NEAR(glm::length(n), 1, 1e-3);
  }
}

TEST(folds, are_deep_on_an_adult_and_hardly_seen_on_an_infant) {
  const double adult_mm = find_deepest_mm(adult(), build_folded_pose());
  EXPECT_GT(adult_mm, 0.8);
  EXPECT_LT(adult_mm, 3.0);
  EXPECT_LT(find_deepest_mm(build("child"), build_folded_pose()), 0.4 * adult_mm);
  EXPECT_LT(find_deepest_mm(build("infant"), build_folded_pose()), 0.15 * adult_mm);
}

}  // namespace
}  // namespace mien
